/// TevViewer: the growing picture in the viewer tev, sent by a thread of its own.
#pragma once
#include <condition_variable>
#include <mutex>
#include <thread>

#include "tools/preview/connection.h"
#include "tools/preview/target.h"
#include "tools/preview/tev_packets.h"
#include "tools/preview/viewer.h"

namespace brandung {

class TevViewer : public PreviewViewer {
public:
    /// Opens a black picture of that name, in place of one that tev has already. Throws SceneError if nobody listens there.
    TevViewer(const PreviewTarget &target, const std::string &name, uint width, uint height);
    ~TevViewer() override;

    /// When the one before has been sent.
    bool wants_picture() const override;
    void show(const SharedState &state) override;
    void flush() override;
    std::optional<std::string> take_fault() override;

private:
    void send_pictures();
    void send(const Picture &picture);
    void send_packet(const Packet &packet);
    std::shared_ptr<const Picture> next_picture();

    const std::string place_, name_;
    Connection connection_;
    Picture sent_;  ///< what tev has

    mutable std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    std::shared_ptr<const Picture> latest_, next_;  ///< that was shown; that is to be sent
    bool busy_ = false, ending_ = false;
    Connection::Clock::time_point deadline_ = Connection::Clock::time_point::max();  ///< of everything
    std::optional<std::string> fault_;

    std::thread sender_;
};

}  // namespace brandung
