/// A tev of the tests: takes one connection, and keeps the picture that it is told.
#pragma once
#include <sys/socket.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

/// What was received until the other side ended.
struct TevPicture {
    std::string name, closed;  ///< of the picture that was opened, and of the one closed before
    std::vector<std::string> channels;
    int width = 0, height = 0, updates = 0;
    std::vector<float> values;  ///< interleaved, row by row from the top
    std::string fault;          ///< what was wrong with the packets
};

class TevReader {
public:
    /// Listens on a free port. Takes no more than `bytes`, then closes the connection.
    explicit TevReader(std::size_t bytes = ~std::size_t{0});
    ~TevReader();
    int port() const { return port_; }
    std::string target() const { return "tev:127.0.0.1:" + std::to_string(port_); }
    /// Waits for the end of the connection.
    TevPicture finish();

private:
    void receive(std::size_t bytes);
    int listener_ = -1, port_ = 0;
    std::string received_;
    std::thread thread_;
};
