/// Connection: bytes to another program over TCP, never waiting for it longer than it was told to.
#pragma once
#include <chrono>
#include <span>
#include <string>

namespace brandung {

class Connection {
public:
    using Clock = std::chrono::steady_clock;

    /// Throws std::runtime_error, with the system's reason, if nobody takes the connection within two seconds.
    Connection(const std::string &host, int port);
    ~Connection();
    Connection(const Connection &) = delete;

    /// Throws std::runtime_error if the other side closes the connection, or has not taken all by `deadline`.
    void send(std::span<const unsigned char> bytes, Clock::time_point deadline);

private:
    int socket_ = -1;
};

}  // namespace brandung
