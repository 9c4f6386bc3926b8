/// Memory for as many records as a scene has primitives.
#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace brandung {

struct FreeMemory {
    void operator()(void *memory) const { std::free(memory); }
};
template <class Record> using LargeArray = std::unique_ptr<Record[], FreeMemory>;

/// Not written: what isn't used costs no memory. On huge pages where the system has them, since the first touches of small ones took a sixth of the
/// time of a build.
template <class Record> LargeArray<Record> make_large_array(std::size_t size) {
    static_assert(std::is_trivially_copyable_v<Record> && std::is_trivially_destructible_v<Record>);
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    const bool is_large = size * sizeof(Record) >= huge_page;
    const std::size_t alignment = is_large ? huge_page : 64;
    const std::size_t bytes = (size * sizeof(Record) + alignment - 1) / alignment * alignment;
    void *memory = std::aligned_alloc(alignment, bytes);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (is_large) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return LargeArray<Record>(static_cast<Record *>(memory));
}

}  // namespace brandung
