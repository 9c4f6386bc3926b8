/// DistinctFiles: a command writes none of its files over another, nor over what it reads.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace brandung {

class DistinctFiles {
public:
    /// `inputs` are read.
    explicit DistinctFiles(const std::vector<std::string> &inputs);
    /// Throws CLI::ValidationError if the file, however it is spelt, is an input or has been added already.
    void add_output(const std::string &option, const std::string &file);

private:
    struct Known {
        std::string name, role;
    };
    std::map<std::filesystem::path, Known> known_;  ///< by the one name that each has, however it is spelt
};

}  // namespace brandung
