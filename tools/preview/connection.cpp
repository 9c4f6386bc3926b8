#include "tools/preview/connection.h"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include <stdexcept>

namespace brandung {
namespace {

constexpr std::chrono::seconds patience(2);

/// Waits until the socket takes bytes; false if it does not by then.
bool wait_for(int socket, Connection::Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Connection::Clock::now()).count();
    pollfd events = {socket, POLLOUT, 0};
    return poll(&events, 1, static_cast<int>(std::max<std::int64_t>(left, 0))) == 1;
}

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses addresses_of(const std::string &host, int port) {
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    const int fault = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
    if (fault != 0) throw std::runtime_error(gai_strerror(fault));
    return {found, freeaddrinfo};
}

/// 0, or why there is no connection.
int connect_to(int socket, const addrinfo &address) {
    if (connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
    if (errno != EINPROGRESS) return errno;
    if (!wait_for(socket, Connection::Clock::now() + patience)) return ETIMEDOUT;
    int fault = 0;
    socklen_t size = sizeof fault;
    getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size);
    return fault;
}

}  // namespace

Connection::Connection(const std::string &host, int port) {
    int fault = 0;
    const Addresses addresses = addresses_of(host, port);
    for (const addrinfo *address = addresses.get(); address; address = address->ai_next) {
        socket_ = socket(address->ai_family, address->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address->ai_protocol);
        fault = socket_ < 0 ? errno : connect_to(socket_, *address);
        if (fault == 0) return;
        close(socket_);
    }
    throw std::runtime_error(std::strerror(fault));
}

Connection::~Connection() { close(socket_); }

void Connection::send(std::span<const unsigned char> bytes, Clock::time_point deadline) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(sent));
        } else if (errno != EAGAIN && errno != EINTR) {
            throw std::runtime_error(std::strerror(errno));
        } else if (!wait_for(socket_, deadline) && Clock::now() >= deadline) {
            throw std::runtime_error("it takes nothing any more");
        }
    }
}

}  // namespace brandung
