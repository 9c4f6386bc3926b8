/// Bands: something per pixel of a window, in several allocations where one would be too large.
#pragma once
#include <algorithm>
#include <vector>

#include "kernels/core/params.h"
#include "runtime/opencl/buffer.h"
#include "scene/window.h"

namespace brandung {

template <class Pixel> struct Band {
    FilmBand params;
    Buffer<Pixel> pixels;  ///< row by row from the top
};

/// Whole rows of a window per band, from the top, all zero at first.
template <class Pixel> class Bands {
public:
    /// No band is larger than `largest` [bytes], unless one row is.
    Bands(Device &device, const Window &window, std::size_t largest) {
        const uint rows_at_most = rows(window, largest);
        for (uint row = window.top; row < window.bottom; row += rows_at_most) {
            const uint rows = std::min(rows_at_most, window.bottom - row);
            bands_.push_back({{row, rows, window.left, window.width()}, Buffer<Pixel>(device, std::size_t{window.width()} * rows)});
            bands_.back().pixels.fill_zero();
        }
    }
    /// Of the largest band.
    static uint rows(const Window &window, std::size_t largest) {
        return static_cast<uint>(std::clamp<std::size_t>(largest / (window.width() * sizeof(Pixel)), 1, window.height()));
    }

    void clear() {
        for (Band<Pixel> &band : bands_) band.pixels.fill_zero();
    }
    std::size_t size() const { return bands_.size(); }
    Band<Pixel> &operator[](std::size_t i) { return bands_[i]; }
    const Band<Pixel> &operator[](std::size_t i) const { return bands_[i]; }
    auto begin() { return bands_.begin(); }
    auto end() { return bands_.end(); }
    auto begin() const { return bands_.begin(); }
    auto end() const { return bands_.end(); }
    /// All pixels of the window.
    std::vector<Pixel> read() const {
        std::vector<Pixel> all;
        for (const Band<Pixel> &band : bands_) {
            const std::vector<Pixel> pixels = band.pixels.read();
            all.insert(all.end(), pixels.begin(), pixels.end());
        }
        return all;
    }
    std::size_t bytes() const {
        std::size_t bytes = 0;
        for (const Band<Pixel> &band : bands_) bytes += band.pixels.bytes();
        return bytes;
    }

private:
    std::vector<Band<Pixel>> bands_;
};

}  // namespace brandung
