/// A folder with files of meshes, and what reading them gives.
#pragma once
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "kernels/bsdfs/whitted.h"
#include "scene/error.h"
#include "scene/formats/format.h"
#include "scene/meshes/mesh_file.h"

namespace brandung {

class MeshFolder {
public:
    MeshFolder() : folder_(std::filesystem::temp_directory_path() / ("brandung-meshes-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~MeshFolder() { std::filesystem::remove_all(folder_); }
    MeshFolder(const MeshFolder &) = delete;

    std::string write(const std::string &name, const std::string &bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return (folder_ / name).string();
    }
    /// The parts of a file with these contents; warnings and materials are left in `scene`.
    std::vector<MeshPart> read(const std::string &name, const std::string &bytes) {
        scene = {};
        return read_mesh_file(write(name, bytes), "", scene, {});
    }
    /// The error that it gives, behind the folder; empty without one.
    std::string error(const std::string &name, const std::string &bytes) {
        try {
            read(name, bytes);
        } catch (const SceneError &error) {
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return "";
    }

    Scene scene;

private:
    std::filesystem::path folder_;
};

inline Whitted whitted_of(const Material &material) {
    Whitted view;
    std::memcpy(&view, material.words, sizeof view);
    return view;
}

/// The positions that a part's triangles name, in their order.
inline std::vector<vec3> corners_of(const MeshPart &part) {
    std::vector<vec3> corners;
    for (const uint index : part.mesh.indices) corners.push_back(part.mesh.positions.at(index));
    return corners;
}

}  // namespace brandung
