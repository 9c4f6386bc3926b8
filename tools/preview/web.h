/// WebViewer: a render on a local web page, served by threads of its own to browsers on this machine.
///   GET /              the page
///   GET /state.json    state_json() of the latest state
///   GET /picture.png   the picture so far; ?exposure=EV brightens it beyond the film's own exposure
#pragma once
#include <condition_variable>
#include <map>
#include <mutex>

#include "tools/preview/viewer.h"

namespace brandung {

class WebViewer : public PreviewViewer {
public:
    /// Listens at 127.0.0.1, on any free port for 0. Throws SceneError if the port is taken.
    explicit WebViewer(int port);
    ~WebViewer() override;

    std::string url() const;
    /// While somebody waits for one.
    bool wants_picture() const override;
    void show(const SharedState &state) override;
    /// Whether a page has asked for the state in the last two seconds.
    bool watched() const;

private:
    struct Server;
    SharedState asked_for_state();
    SharedState state_with_fresh_picture();
    std::string png(const PreviewState &state, float exposure);

    mutable std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    SharedState state_;
    bool wants_picture_ = false;
    std::optional<std::chrono::steady_clock::time_point> asked_;  ///< for the state

    std::mutex encoding_;  ///< of what follows
    std::shared_ptr<const Picture> encoded_;
    float encoded_exposure_ = 0;
    std::string png_;  ///< of that picture with that exposure

    std::unique_ptr<Server> server_;
};

}  // namespace brandung
