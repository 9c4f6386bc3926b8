#include "tools/preview/web.h"

#include <fmt/format.h>
#include <httplib.h>

#include <charconv>
#include <chrono>
#include <thread>

#include "scene/error.h"
#include "tools/preview/page.h"
#include "tools/preview/state_json.h"

namespace brandung {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char *host = "127.0.0.1";
/// A page asks twice a second; a picture is there after a batch.
constexpr std::chrono::seconds still_watched(2), longest_wait(2);
constexpr float largest_exposure = 30;

/// Without the library's SO_REUSEPORT, under which two programs would share a port.
void set_socket_options(socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void refuse(httplib::Response &response, int status, const std::string &why) {
    response.status = status;
    response.set_content(why + "\n", "text/plain; charset=utf-8");
}

/// Of a request for a picture; nothing if it is no number of the range.
std::optional<float> exposure_of(const httplib::Request &request) {
    const std::string text = request.has_param("exposure") ? request.get_param_value("exposure") : "0";
    float exposure = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), exposure);
    const bool good = error == std::errc() && rest == text.data() + text.size() && std::abs(exposure) <= largest_exposure;
    return good ? std::optional(exposure) : std::nullopt;
}

/// The page may load nothing from elsewhere, and nothing is kept.
httplib::Headers headers() {
    return {{"Cache-Control", "no-store"},
            {"X-Content-Type-Options", "nosniff"},
            {"Content-Security-Policy",
             "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self' blob: data:; connect-src 'self'"}};
}

}  // namespace

struct WebViewer::Server {
    httplib::Server http;
    std::thread thread;
    int port = 0;

    explicit Server(int wanted_port) {
        http.set_socket_options(set_socket_options);
        http.set_default_headers(headers());
        http.set_keep_alive_max_count(1);  // no thread waits for a browser's next question
        http.set_keep_alive_timeout(1), http.set_read_timeout(1), http.set_write_timeout(5), http.set_payload_max_length(1024);
        http.set_pre_routing_handler([](const httplib::Request &request, httplib::Response &response) {
            if (request.method == "GET" || request.method == "HEAD") return httplib::Server::HandlerResponse::Unhandled;
            response.set_header("Allow", "GET, HEAD");
            refuse(response, 405, "only GET is answered");
            return httplib::Server::HandlerResponse::Handled;
        });
        http.set_error_handler([](const httplib::Request &, httplib::Response &response) {
            if (response.body.empty())
                refuse(response, response.status, response.status == 404 ? "there is no such page" : "this cannot be answered");
        });
        port = wanted_port == 0 ? http.bind_to_any_port(host) : http.bind_to_port(host, wanted_port) ? wanted_port : -1;
        if (port < 0) throw SceneError(fmt::format("--preview: cannot listen at {}:{}: {}", host, wanted_port, std::strerror(errno)));
    }

    void start() {
        thread = std::thread([this] { http.listen_after_bind(); });
        while (!http.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));  // before it runs it cannot be stopped
    }

    ~Server() {
        http.stop();
        if (thread.joinable()) thread.join();
    }
};

WebViewer::WebViewer(int port) : state_(std::make_shared<PreviewState>()), server_(std::make_unique<Server>(port)) {
    httplib::Server &http = server_->http;
    http.Get("/", [](const httplib::Request &, httplib::Response &response) {
        response.set_content(page_html().data(), page_html().size(), "text/html; charset=utf-8");
    });
    http.Get(R"(/state\.json)", [this](const httplib::Request &, httplib::Response &response) {
        const auto replace = nlohmann::json::error_handler_t::replace;  // a file's name need not be UTF-8
        response.set_content(state_json(*asked_for_state()).dump(-1, ' ', false, replace), "application/json");
    });
    http.Get(R"(/picture\.png)", [this](const httplib::Request &request, httplib::Response &response) {
        const auto exposure = exposure_of(request);
        if (!exposure) return refuse(response, 400, fmt::format("exposure is a number from {} to {}", -largest_exposure, largest_exposure));
        const SharedState state = state_with_fresh_picture();
        if (!state->picture) return refuse(response, 503, "there is no picture yet");
        response.set_content(png(*state, *exposure), "image/png");
    });
    server_->start();
}

WebViewer::~WebViewer() {
    {
        const std::lock_guard lock(mutex_);
        if (!state_->ended()) {  // nobody has to wait for a picture that will not come
            auto last = *state_;
            last.phase = PreviewPhase::failed;
            state_ = std::make_shared<PreviewState>(std::move(last));
        }
    }
    changed_.notify_all();
    server_.reset();
}

std::string WebViewer::url() const { return fmt::format("http://{}:{}/", host, server_->port); }

bool WebViewer::wants_picture() const {
    const std::lock_guard lock(mutex_);
    return wants_picture_;
}

void WebViewer::show(const SharedState &state) {
    {
        const std::lock_guard lock(mutex_);
        if (state->picture != state_->picture) wants_picture_ = false;
        state_ = state;
    }
    changed_.notify_all();
}

bool WebViewer::watched() const {
    const std::lock_guard lock(mutex_);
    return asked_ && Clock::now() - *asked_ < still_watched;
}

SharedState WebViewer::asked_for_state() {
    const std::lock_guard lock(mutex_);
    asked_ = Clock::now();
    return state_;
}

/// The latest state, after a while in which the render may have made a picture newer than the one there is.
SharedState WebViewer::state_with_fresh_picture() {
    std::unique_lock lock(mutex_);
    wants_picture_ = true;
    const auto old = state_->picture;
    changed_.wait_for(lock, longest_wait, [&] { return state_->picture != old || state_->ended(); });
    return state_;
}

/// The last one is kept: several browsers may want it.
std::string WebViewer::png(const PreviewState &state, float exposure) {
    const std::lock_guard lock(encoding_);
    if (encoded_ != state.picture || encoded_exposure_ != exposure) {
        PictureStyle style = state.subject.style;
        style.exposure += exposure;
        const auto bytes = png_bytes(*state.picture, style);
        png_.assign(bytes.begin(), bytes.end());
        encoded_ = state.picture, encoded_exposure_ = exposure;
    }
    return png_;
}

}  // namespace brandung
