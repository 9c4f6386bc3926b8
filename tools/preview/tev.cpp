#include "tools/preview/tev.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "scene/error.h"

namespace brandung {
namespace {

/// That tev may take for a packet, and for what is left to send after the render.
constexpr std::chrono::seconds patience(5);

Connection connect(const PreviewTarget &target) try { return Connection(target.host, target.port); } catch (const std::runtime_error &error) {
    throw SceneError(fmt::format("--preview: no tev at {}:{}: {}; start it first", target.host, target.port, error.what()));
}

}  // namespace

TevViewer::TevViewer(const PreviewTarget &target, const std::string &name, uint width, uint height)
    : place_(fmt::format("{}:{}", target.host, target.port)),
      name_(name),
      connection_(connect(target)),
      sent_{width, height, std::vector<vec3>(std::size_t{width} * height, vec3(0)), {}} {
    try {
        send_packet(close_image_packet(name_));
        send_packet(create_image_packet(name_, width, height));
    } catch (const std::runtime_error &error) {
        throw SceneError(fmt::format("--preview: tev at {}: {}", place_, error.what()));
    }
    sender_ = std::thread([this] { send_pictures(); });
}

TevViewer::~TevViewer() { flush(); }

void TevViewer::flush() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        deadline_ = Connection::Clock::now() + patience;
    }
    changed_.notify_one();
    if (sender_.joinable()) sender_.join();
}

bool TevViewer::wants_picture() const {
    const std::lock_guard lock(mutex_);
    return !busy_ && !next_ && !ending_;
}

void TevViewer::show(const SharedState &state) {
    const std::lock_guard lock(mutex_);
    if (ending_ || state->picture == latest_) return;
    latest_ = next_ = state->picture;
    changed_.notify_one();
}

std::optional<std::string> TevViewer::take_fault() {
    const std::lock_guard lock(mutex_);
    return std::exchange(fault_, std::nullopt);
}

/// The next picture to send; null at the end.
std::shared_ptr<const Picture> TevViewer::next_picture() {
    std::unique_lock lock(mutex_);
    busy_ = false;
    changed_.wait(lock, [this] { return next_ || ending_; });
    busy_ = next_ != nullptr;
    return std::exchange(next_, nullptr);
}

void TevViewer::send_pictures() try {
    while (const auto picture = next_picture()) send(*picture);
} catch (const std::runtime_error &error) {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    fault_ = fmt::format("--preview: tev at {} is gone: {}", place_, error.what());
}

/// Only what has changed.
void TevViewer::send(const Picture &picture) {
    for (const Tile &tile : tiles_of(picture.width, picture.height))
        if (!same_tile(picture, sent_, tile)) send_packet(update_image_packet(name_, picture, tile));
    sent_ = picture;
}

void TevViewer::send_packet(const Packet &packet) {
    const auto packet_deadline = Connection::Clock::now() + patience;
    const auto deadline = [&] {
        const std::lock_guard lock(mutex_);
        return std::min(packet_deadline, deadline_);
    }();
    connection_.send(packet, deadline);
}

}  // namespace brandung
