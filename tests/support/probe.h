/// Probe: a kernel of some lines, written in a test, that applies one device function to arrays.
#pragma once
#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/opencl/kernel.h"

namespace brandung {

/// The process's one device: programs are built once per test executable. With BRANDUNG_AS_GPU in the environment it has the kernels of GPUs.
Device &test_device();

class Probe {
public:
    /// `text` is a file that defines `kernel void probe(const global A *a, ..., global R *results)`, for one item per work-item; it may include
    /// kernel files, and those of `generated`. Throws BuildError with lines of "probe.cl".
    explicit Probe(const std::string &text, Sources generated = {});

    /// Runs as many work-items as the longest vector has elements, and gives the result of each. Every argument is a buffer: a vector, or a single
    /// trivially copyable record, which becomes a buffer of one element. Buffers are as long as the longest vector; what a shorter one lacks is zero.
    template <class R, class... Arguments> std::vector<R> run(const Arguments &...arguments) {
        const std::size_t count = std::max({std::size_t{1}, size(arguments)...});
        const std::size_t padded = kernel_.work_items(count);
        const auto buffers = std::make_tuple(buffer(arguments, padded)...);
        Buffer<R> results(test_device(), padded);
        results.fill_zero();
        std::apply([&](const auto &...buffer) { kernel_(count, buffer..., results); }, buffers);
        return results.read(0, count);
    }

private:
    template <class T> static std::size_t size(const std::vector<T> &items) { return items.size(); }
    template <class T> static std::size_t size(const T &) { return 1; }
    template <class T> static Buffer<T> buffer(const std::vector<T> &items, std::size_t padded) {
        Buffer<T> result(test_device(), std::max(items.size(), padded));
        result.fill_zero();
        result.write(items);
        return result;
    }
    template <class T> static Buffer<T> buffer(const T &item, std::size_t) { return Buffer<T>(test_device(), std::span(&item, 1)); }

    Kernel kernel_;
};

}  // namespace brandung
