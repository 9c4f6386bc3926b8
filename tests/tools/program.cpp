#include "tests/tools/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
    Pipe() {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
        read = ends[0], write = ends[1];
    }
    int read = -1, write = -1;
};

[[noreturn]] void become_program(const std::vector<std::string> &arguments, const RunOptions &options, const Pipe &out, const Pipe &err) {
    const int nothing = open("/dev/null", O_RDONLY);
    const int standard_output = options.out_file.empty() ? out.write : open(options.out_file.c_str(), O_WRONLY);
    dup2(nothing, STDIN_FILENO), dup2(standard_output, STDOUT_FILENO), dup2(err.write, STDERR_FILENO);
    for (const int end : {nothing, out.read, out.write, err.read, err.write}) close(end);
    for (const auto &[name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
    if (options.largest_file > 0) {
        std::signal(SIGXFSZ, SIG_IGN);  // so that writing fails, which it would do on a full disk
        const rlimit limit = {options.largest_file, options.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::string name = BRANDUNG_PROGRAM;
    std::vector<char *> words = {name.data()};
    std::vector<std::string> copies = arguments;
    for (std::string &copy : copies) words.push_back(copy.data());
    words.push_back(nullptr);
    execv(name.c_str(), words.data());
    _exit(127);
}

/// Appends what can be read; false at the end of the stream.
bool read_some(int end, std::string &text) {
    char part[4096];
    const ssize_t bytes = read(end, part, sizeof part);
    if (bytes > 0) text.append(part, static_cast<std::size_t>(bytes));
    return bytes > 0;
}

/// Reads both streams until both have ended or time is up.
void collect(pid_t child, const RunOptions &options, int out, int err, Finished &finished) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(options.seconds);
    std::array<pollfd, 2> ends = {pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
    int signals_left = options.signals;
    auto next_signal = Clock::now();
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        if (Clock::now() > deadline) {
            finished.timed_out = true;
            kill(child, SIGKILL);
            return;
        }
        poll(ends.data(), ends.size(), 50);
        if (ends[0].revents != 0 && !read_some(out, finished.out)) ends[0].fd = -1;
        if (ends[1].revents != 0 && !read_some(err, finished.err)) ends[1].fd = -1;
        const bool may_signal = options.signal_when && signals_left > 0 && Clock::now() >= next_signal;
        if (const int signal = may_signal ? options.signal_when(finished.err) : 0) {
            --signals_left;
            next_signal = Clock::now() + std::chrono::milliseconds(200);
            kill(child, signal);
        }
    }
}

}  // namespace

Finished run_program(const std::vector<std::string> &arguments, const RunOptions &options) {
    const Pipe out, err;
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0) become_program(arguments, options, out, err);
    close(out.write), close(err.write);
    Finished finished;
    collect(child, options, out.read, err.read, finished);
    close(out.read), close(err.read);
    int ending = 0;
    waitpid(child, &ending, 0);
    if (WIFEXITED(ending)) finished.status = WEXITSTATUS(ending);
    if (WIFSIGNALED(ending)) finished.signal = WTERMSIG(ending);
    return finished;
}

TemporaryFolder::TemporaryFolder() {
    static int made = 0;
    folder_ = std::filesystem::temp_directory_path() / ("brandung_" + std::to_string(getpid()) + "_" + std::to_string(made++));
    if (!std::filesystem::create_directory(folder_)) throw std::runtime_error("no temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::string TemporaryFolder::write(const std::string &name, const std::string &text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read_file(const std::string &path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const std::string &text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}
