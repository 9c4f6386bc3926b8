/// The program under test as a child process, and a folder of its own for its files.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// How a child process ended and what it wrote.
struct Finished {
    int status = -1;         ///< exit status; -1 if a signal ended it
    int signal = 0;          ///< that signal
    bool timed_out = false;  ///< it had to be killed
    std::string out, err;
};

struct RunOptions {
    double seconds = 120;  ///< after which it is killed
    std::map<std::string, std::string> environment;
    /// Called over and over while it runs, some 50 ms apart or less, with all that it has written to standard error so far, until `signals` were
    /// sent: a signal to send now, or 0.
    std::function<int(const std::string &err)> signal_when;
    int signals = 1;               ///< so many are sent at most, with 0.2 s between them
    std::size_t largest_file = 0;  ///< [bytes] that it may write to a file, as if the disk were full; 0 for no limit
    std::string out_file;          ///< gets standard output instead of `Finished::out`
};

/// Runs `brandung` with these arguments.
Finished run_program(const std::vector<std::string> &arguments, const RunOptions &options = {});

/// A new folder, removed at the end with all that is in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;

    /// The path of a file in it.
    std::string path(const std::string &name) const { return (folder_ / name).string(); }
    /// Writes a file, and gives its path.
    std::string write(const std::string &name, const std::string &text) const;
    /// Names of everything in it, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path folder_;
};

std::string read_file(const std::string &path);
std::vector<std::string> lines_of(const std::string &text);
