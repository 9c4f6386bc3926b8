/// Pictures that cannot be written and devices that cannot be used: one line on standard error, exit 1, nothing left behind.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tools/bad_input.h"
#include "tests/tools/scenes.h"

TEST(BadOutput, UnknownPictureType) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    expect_render_fails(folder, scene, {"-o", folder.path("out.xyz")}, 1, {folder.path("out.xyz"), "xyz"});
    expect_render_fails(folder, scene, {"-o", folder.path("out")}, 1, {folder.path("out") + ": cannot write a picture: the name has no extension"});
    expect_render_fails(folder, scene, {"-o", "/tmp"}, 1, {"/tmp: cannot write there: it is a folder"});
    for (const char *name : {"out.zfile", "out.null", "out.term"})
        expect_render_fails(folder, scene, {"-o", folder.path(name)}, 1, {folder.path(name), "cannot write"});
    expect_render_fails(folder, scene, {"-o", folder.path("good.png"), "-o", folder.path("out.xyz")}, 1, {folder.path("out.xyz")});
}

TEST(BadOutput, FolderThatIsNotThere) {
    const TemporaryFolder folder;
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {"-o", folder.path("nowhere/out.png")}, 1,
                        {folder.path("nowhere/out.png"), "folder"});
}

TEST(BadOutput, NamesThatAreTooLong) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene()), name = folder.path(std::string(300, 'x'));
    expect_render_fails(folder, scene, {"-o", name + ".png"}, 1, {name + ".png: cannot write there: File name too long"});
    expect_render_fails(folder, scene, {"--stats", name}, 1, {name + ": cannot write there: File name too long"});
    expect_render_fails(folder, name + ".json", {}, 1, {name + ".json: cannot be read: File name too long"});
}

TEST(BadOutput, StandardOutputThatTakesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    RunOptions options;
    options.out_file = "/dev/full";
    for (const std::vector<std::string> &arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"devices"}, {"info", scene}, {"info", scene, "--json"}})
        expect_failure(run_program(arguments, options), 1, {"standard output"});
    expect_render_fails(folder, scene, {"--explain"}, 1, {"standard output"}, options);
}

TEST(BadOutput, NameOfAFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("out.png"));
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {folder.path("out.png"), "folder"});
}

TEST(BadOutput, FolderWithoutPermission) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    // Not even root can make files in /proc.
    expect_render_fails(folder, scene, {"-o", "/proc/out.png"}, 1, {"/proc/out.png"});
}

/// Not after a render of hours.
TEST(BadOutput, StatisticsThatCannotBeWrittenAreRefusedBeforeRendering) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    for (const std::string &stats : {folder.path("nowhere/stats.json"), std::string("/proc/stats.json"), folder.path("")})
        expect_render_fails(folder, scene, {"--stats", stats}, 1, {stats});
}

namespace {

/// Files may have 1 MiB, as on a full disk; PoCL needs more than half of that to start kernels that it has built before.
RunOptions full_disk() {
    RunOptions options;
    options.largest_file = 1 << 20;
    return options;
}

/// A picture that none of the formats below packs into 1 MiB.
const std::vector<std::string> big = {"--size", "1200x1200", "--set", "camera.fov=25"};

}  // namespace

TEST(BadOutput, FullDiskLeavesTheOldPictureAndNoHalfOne) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    for (const char *name : {"out.exr", "out.tif", "out.hdr"}) {
        SCOPED_TRACE(name);
        std::vector<std::string> arguments = big;
        arguments.insert(arguments.end(), {"-o", folder.path(name)});
        std::vector<std::string> all = {"render", scene, "--quiet"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        ASSERT_EQ(run_program(all).status, 0) << "fills the kernel cache";
        const std::string old = read_file(folder.path(name));
        ASSERT_GT(old.size(), full_disk().largest_file) << "the test tests something";
        expect_render_fails(folder, scene, arguments, 1, {folder.path(name)}, full_disk());
        EXPECT_EQ(read_file(folder.path(name)) == old, true);
    }
}

// ---- device ----------------------------------------------------------------------------------------------------------------------------------

TEST(BadDevice, NoneAtAllNamesThePackageToInstall) {
    const TemporaryFolder folder, no_drivers;
    RunOptions options;
    options.environment["OCL_ICD_VENDORS"] = no_drivers.path("");
    expect_failure(run_program({"devices"}, options), 1, {"pocl-opencl-icd"});
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {"pocl-opencl-icd"}, options);
}

TEST(BadDevice, UnknownOneIsAnsweredWithThoseThatThereAre) {
    const TemporaryFolder folder;
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {"--device", "abacus"}, 1, {"abacus", "pthread"});
}

TEST(BadDevice, AFaultyDriverDoesNotKeepTheOtherDevicesFromBeingUsed) {
    const TemporaryFolder folder, drivers;
    for (const auto &driver : std::filesystem::directory_iterator("/etc/OpenCL/vendors"))
        drivers.write(driver.path().filename().string(), read_file(driver.path().string()));
    drivers.write("faulty.icd", FAULTY_DRIVER "\n");
    RunOptions options;
    options.environment["OCL_ICD_VENDORS"] = drivers.path("");
    const Finished listed = run_program({"devices"}, options);
    EXPECT_EQ(listed.status, 0) << listed.err;
    EXPECT_NE(listed.out.find("  broken accelerator |"), std::string::npos) << listed.out;
    EXPECT_NE(listed.out.find("cannot be used: it cannot be described: clGetDeviceInfo failed with CL_OUT_OF_RESOURCES"), std::string::npos)
        << listed.out;
    const std::string scene = folder.write("scene.json", native_scene());
    EXPECT_EQ(run_program({"info", scene}, options).status, 0);
    expect_render_fails(folder, scene, {"--device", "broken"}, 1, {"'broken accelerator' cannot be described"}, options);
}

TEST(BadDevice, KernelFolderThatIsNotThere) {
    const TemporaryFolder folder;
    RunOptions options;
    options.environment["KERNEL_DIR"] = folder.path("nowhere");
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {" in KERNEL_DIR=" + folder.path("nowhere")}, options);
}

/// Where PoCL finds no device without its cache, and where it finds one but cannot build.
TEST(BadDevice, KernelCacheThatCannotBeWrittenIsNamed) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene()), file = folder.write("file", "");
    RunOptions options;
    options.environment["POCL_CACHE_DIR"] = file + "/cache";
    expect_render_fails(folder, scene, {}, 1, {"PoCL cannot write its kernel cache " + file + "/cache (Not a directory)"}, options);
    options.environment["POCL_CACHE_DIR"] = "/proc";
    expect_render_fails(folder, scene, {}, 1, {"cannot be built", "PoCL cannot write its kernel cache /proc ("}, options);
}
