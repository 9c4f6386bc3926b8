/// How far the building of an accelerator is, told while it goes on.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>

namespace brandung {

/// Builders count their work from any thread; whoever waits is told now and then, by one thread at a time. A build in several stages counts from 0 to
/// 1 once: it begins with the sum of all.
class BuildProgress {
public:
    BuildProgress() = default;
    /// `tell` gets the part that is done, from 0 to 1.
    explicit BuildProgress(std::function<void(double part)> tell) : tell_(std::move(tell)) {}

    /// So much work there will be, in the builder's own units.
    void begin(std::uint64_t total) { total_ = total, done_ = 0, next_ = total / steps; }
    void add(std::uint64_t work) {
        if (!tell_) return;
        const std::uint64_t done = done_ += work;
        if (done < next_) return;
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock || done < next_) return;
        next_ = done + total_ / steps;
        tell_(total_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total_)));
    }

private:
    static constexpr std::uint64_t steps = 100;

    std::function<void(double)> tell_;
    std::uint64_t total_ = 0;
    std::atomic<std::uint64_t> done_ = 0, next_ = 0;
    std::mutex mutex_;
};

}  // namespace brandung
