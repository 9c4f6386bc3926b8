/// Kernel: a kernel function that is called like a function.
#pragma once
#include <memory>
#include <string>
#include <type_traits>

#include "runtime/opencl/access.h"
#include "runtime/opencl/source.h"

namespace brandung {

/// How much a launch has to do: items, in one or more rows.
struct Grid {
    Grid(std::size_t items, std::size_t rows = 1) : items(items), rows(rows) {}
    std::size_t items, rows;
};

class Kernel {
public:
    /// `items_per_work_item`: 0 is the device's own for stages. The program is built here, or known already by its expanded text.
    /// Throws BuildError with the compiler's words, and Error if the file is not there or has no such kernel.
    Kernel(Device &device, const std::string &file, const std::string &name, const Sources &generated, uint items_per_work_item = 0);
    Kernel(Kernel &&) noexcept;
    ~Kernel();

    /// Launches with exactly the kernel's parameters, in order: buffers, as they are or with their Access, trivially copyable values, and things that
    /// hand out several parameters by `for_each_argument`. Returns at once. Throws Error on a wrong number of arguments or a refused launch.
    template <class... Arguments> void operator()(Grid grid, const Arguments &...arguments) {
        if (grid.items == 0 || grid.rows == 0) return;
        uint index = 0;
        traffic_ = {};
        (bind(index, arguments), ...);
        launch(grid, index);
    }
    /// Work-items that a launch over `items` items has, in one row.
    std::size_t work_items(std::size_t items) const;

private:
    template <class T> void bind(uint &index, const T &value) {
        if constexpr (std::is_same_v<T, Access>) {
            set_buffer(index++, value.buffer);
            traffic_.add(value);
        } else if constexpr (std::is_base_of_v<RawBuffer, T>) {
            bind(index, one_each(value));
        } else if constexpr (requires { value.for_each_argument([](const auto &) {}); }) {
            value.for_each_argument([&](const auto &argument) { bind(index, argument); });
        } else {
            static_assert(std::is_trivially_copyable_v<T>);
            set_value(index++, &value, sizeof value);
        }
    }
    void set_buffer(uint index, const RawBuffer &buffer);
    void set_value(uint index, const void *value, std::size_t bytes);
    void launch(Grid grid, uint arguments);

    struct Implementation;
    Device *device_;
    std::string name_;
    uint items_per_work_item_;
    Traffic traffic_;  ///< of the next launch
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace brandung
