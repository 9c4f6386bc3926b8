#include "tests/tools/preview/tev_reader.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace {

/// Fields of one packet; this machine is little endian, as the packets are.
class Fields {
public:
    explicit Fields(std::string_view bytes) : bytes_(bytes) {}

    template <class Number> Number number() {
        Number value{};
        if (bytes_.size() < sizeof value) throw std::runtime_error("a packet is too short");
        std::memcpy(&value, bytes_.data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }
    std::string text() {
        const std::size_t end = bytes_.find('\0');
        if (end == bytes_.npos) throw std::runtime_error("a text does not end");
        const std::string text(bytes_.substr(0, end));
        bytes_.remove_prefix(end + 1);
        return text;
    }
    std::vector<std::string> texts() {
        std::vector<std::string> texts(static_cast<std::size_t>(number<std::int32_t>()));
        for (std::string &one : texts) one = text();
        return texts;
    }
    template <class Number> std::vector<Number> numbers(std::size_t count) {
        std::vector<Number> numbers(count);
        for (Number &one : numbers) one = number<Number>();
        return numbers;
    }
    std::size_t left() const { return bytes_.size(); }

private:
    std::string_view bytes_;
};

void expect(bool condition, const char *what) {
    if (!condition) throw std::runtime_error(what);
}

void create(Fields &fields, TevPicture &picture) {
    expect(fields.number<std::uint8_t>() == 1, "a new picture comes to the front");
    picture.name = fields.text();
    picture.width = fields.number<std::int32_t>(), picture.height = fields.number<std::int32_t>();
    picture.channels = fields.texts();
    picture.values.assign(picture.channels.size() * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
}

void update(Fields &fields, TevPicture &picture) {
    expect(fields.number<std::uint8_t>() == 0, "an update leaves the order of pictures as it is");
    expect(fields.text() == picture.name, "an update is of the picture that was opened");
    expect(fields.texts() == picture.channels, "an update has all channels");
    const std::size_t channels = picture.channels.size();
    const auto place = fields.numbers<std::int32_t>(4);
    const int x = place[0], y = place[1], width = place[2], height = place[3];
    expect(x >= 0 && y >= 0 && x + width <= picture.width && y + height <= picture.height, "an update lies within the picture");
    const auto offsets = fields.numbers<std::int64_t>(channels), strides = fields.numbers<std::int64_t>(channels);
    const auto data = fields.numbers<float>(fields.left() / sizeof(float));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (std::size_t c = 0; c < channels; ++c)
                picture.values[channels * static_cast<std::size_t>((y + row) * picture.width + x + column) + c] =
                    data.at(static_cast<std::size_t>(offsets[c] + (row * width + column) * strides[c]));
    ++picture.updates;
}

void read_packet(Fields fields, TevPicture &picture) {
    const int type = fields.number<std::uint8_t>();
    if (type == 2) {
        picture.closed = fields.text();
    } else if (type == 4) {
        create(fields, picture);
    } else if (type == 6) {
        update(fields, picture);
    } else {
        throw std::runtime_error("a packet of type " + std::to_string(type));
    }
    expect(fields.left() == 0 || type == 6, "a packet is too long");
}

}  // namespace

TevReader::TevReader(std::size_t bytes) {
    listener_ = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr *>(&address), size) != 0 || listen(listener_, 1) != 0) throw std::runtime_error("cannot listen");
    getsockname(listener_, reinterpret_cast<sockaddr *>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this, bytes] { receive(bytes); });
}

TevReader::~TevReader() {
    shutdown(listener_, SHUT_RDWR);  // where nobody came
    if (thread_.joinable()) thread_.join();
    close(listener_);
}

void TevReader::receive(std::size_t bytes) {
    const int connection = accept(listener_, nullptr, nullptr);
    char part[65536];
    for (ssize_t got = 1; connection >= 0 && got > 0 && received_.size() < bytes;) {
        got = recv(connection, part, std::min(sizeof part, bytes - received_.size()), 0);
        if (got > 0) received_.append(part, static_cast<std::size_t>(got));
    }
    if (connection >= 0) close(connection);
}

TevPicture TevReader::finish() {
    thread_.join();
    TevPicture picture;
    try {
        for (std::size_t first = 0; first < received_.size();) {
            const std::size_t length = Fields(std::string_view(received_).substr(first)).number<std::uint32_t>();
            expect(length > 4 && first + length <= received_.size(), "the last packet is whole");
            read_packet(Fields(std::string_view(received_).substr(first + 4, length - 4)), picture);
            first += length;
        }
    } catch (const std::exception &error) {
        picture.fault = error.what();
    }
    return picture;
}
