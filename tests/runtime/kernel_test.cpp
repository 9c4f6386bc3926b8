#include "runtime/opencl/kernel.h"

#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace brandung {
namespace {

constexpr const char *fill = "kernel void fill(uint value, global uint *out) { out[get_global_id(0)] = value; }\n";

std::string message_of(auto action) {
    try {
        action();
    } catch (const Error &error) {
        return error.what();
    }
    return "no error";
}

void expect_mentions(const std::string &message, const std::vector<std::string> &parts) {
    for (const std::string &part : parts) EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

TEST(Kernel, ArgumentsArriveInOrder) {
    Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, 1);
    Buffer<uint> out(test_device(), kernel.work_items(5));
    kernel(5, 7u, out);
    EXPECT_EQ(out.read(0, 5), std::vector<uint>(5, 7));
}

TEST(Kernel, NothingIsLaunchedOverNoItems) {
    Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, 1);
    Buffer<uint> out(test_device(), kernel.work_items(1));
    out.fill_zero();
    kernel(0, 7u, out);
    EXPECT_EQ(out.read(0, 1), std::vector<uint>{0});
}

TEST(Kernel, AWrongNumberOfArgumentsIsRefused) {
    Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, 1);
    Buffer<uint> out(test_device(), 64);
    expect_mentions(message_of([&] { kernel(1, 7u); }), {"fill", "takes 2 arguments, got 1"});
    expect_mentions(message_of([&] { kernel(1, 7u, out, 8u); }), {"fill"});
}

TEST(Kernel, AnArgumentOfTheWrongSizeIsRefused) {
    Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, 1);
    Buffer<uint> out(test_device(), 64);
    expect_mentions(message_of([&] { kernel(1, vec3(0), out); }), {"argument 0 of fill", "CL_INVALID_ARG_SIZE"});
}

TEST(Kernel, AMissingFunctionIsNamed) {
    expect_mentions(message_of([] { Kernel(test_device(), "fill.cl", "fall", {{"fill.cl", fill}}, 1); }), {"fall", "fill.cl"});
}

TEST(Kernel, ABuildErrorHasTheRealFileAndLine) {
    const Sources sources = {{"broken.cl", "#include \"fine.h\"\n#include \"wrong.h\"\nkernel void broken() {}\n"},
                             {"fine.h", "#pragma once\ntypedef int fine;\n"},
                             {"wrong.h", "#pragma once\n\ntypedef fine better;\ntypedef unknown worse;\n"}};
    try {
        Kernel(test_device(), "broken.cl", "broken", sources, 1);
        FAIL() << "no error";
    } catch (const BuildError &error) {
        expect_mentions(error.log, {"wrong.h:4"});
        expect_mentions(error.what(), {"broken.cl", "wrong.h:4", test_device().info().name});
    }
    const Sources late = {{"broken.cl", "#include \"fine.h\"\nint f() { return unknown; }\nkernel void broken() {}\n"},
                          {"fine.h", "typedef int fine;\n\n\n"}};
    expect_mentions(message_of([&] { Kernel(test_device(), "broken.cl", "broken", late, 1); }), {"broken.cl:2"});
}

TEST(Kernel, AWarningIsAnError) {
    const Sources sources = {{"warn.cl", "int f() { }\nkernel void warn(global int *x) { x[0] = f(); }\n"}};
    EXPECT_THROW(Kernel(test_device(), "warn.cl", "warn", sources, 1), BuildError);
}

TEST(Kernel, EqualTextIsBuiltOnce) {
    std::vector<std::string> built;
    test_device().on_build([&](const std::string &file) { built.push_back(file); });
    const Sources sources = {{"once.cl", "kernel void a(global int *x) { x[0] = 1; }\nkernel void b(global int *x) { x[0] = 2; }\n"}};
    Kernel(test_device(), "once.cl", "a", sources, 1);
    Kernel(test_device(), "once.cl", "b", sources, 1);
    test_device().on_build({});
    EXPECT_EQ(built, std::vector<std::string>{"once.cl"});
}

TEST(Kernel, WorkItemsCoverAllItems) {
    for (const uint per_work_item : {1u, 64u, 256u}) {
        const Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, per_work_item);
        for (const std::size_t items : {1u, 63u, 64u, 65u, 255u, 256u, 257u, 100000u}) EXPECT_GE(kernel.work_items(items) * per_work_item, items);
    }
}

TEST(Device, LaunchesAreCountedUnderTheKernelsName) {
    Kernel kernel(test_device(), "counted.cl", "counted", {{"counted.cl", "kernel void counted(global int *x) {}\n"}}, 1);
    const Buffer<int> x(test_device(), 1);
    kernel(10, x), kernel(Grid(5, 3), x);
    test_device().finish();
    const KernelProfile profile = test_device().profile().at("counted");
    EXPECT_EQ(profile.launches, 2u);
    EXPECT_EQ(profile.items, 25u);
    EXPECT_GE(profile.milliseconds, 0);
}

/// Twenty uints shared by pairs of items, 30 that are read and written, 12 for three children of each, and a table: 2 + 8 + 12 bytes an item, and
/// room for 4, which is where the children's array ends. In two rows an array has room for half as many.
TEST(Device, BytesAndRoomOfLaunchesFollowFromTheUseOfArrays) {
    const char *text = "kernel void moves(global uint *a, global uint *b, global uint *c, global uint *d, global uint *e) {}\n";
    Kernel kernel(test_device(), "moves.cl", "moves", {{"moves.cl", text}}, 1);
    const Buffer<uint> twenty(test_device(), 20), thirty(test_device(), 30), twelve(test_device(), 12), table(test_device(), 2),
        none(test_device(), 0);
    const auto profile_of = [&](Grid grid, const auto &...arguments) {
        const auto find = [&] { return test_device().profile().contains("moves") ? test_device().profile().at("moves") : KernelProfile(); };
        const KernelProfile before = find();
        kernel(grid, arguments...);
        test_device().finish();
        KernelProfile after = find();
        after.capacity -= before.capacity;
        if (after.bytes) *after.bytes -= *before.bytes;
        return after;
    };
    const KernelProfile known = profile_of(3, several(twenty, 0.5), updated(thirty), several(twelve, 3), shared(table), none);
    EXPECT_EQ(known.bytes, 3 * (2 + 8 + 12));
    EXPECT_EQ(known.capacity, 4);
    const KernelProfile rows = profile_of(Grid(3, 2), in_rows(twenty, 2), twelve, updated(thirty), shared(table), none);
    EXPECT_EQ(rows.bytes, 6 * (4 + 4 + 8));
    EXPECT_EQ(rows.capacity, 2 * 10) << "twenty entries are ten for each row";
    const KernelProfile unknown = profile_of(3, data_dependent(twenty), thirty, several(none, 2), shared(table), shared(twelve));
    EXPECT_FALSE(unknown.bytes);
    EXPECT_EQ(unknown.capacity, 30);
}

/// The second launch is queued long before the first has ended.
TEST(Device, ALaunchDoesNotWaitWhileTheDeviceIsBusy) {
    const char *text =
        "kernel void busy(global volatile uint *x) { for (uint i = 0; i < 200000000u; ++i) x[0] += i; }\n"
        "kernel void after(global uint *x) { x[0] += 1; }\n";
    const Sources sources = {{"busy.cl", text}};
    Kernel busy(test_device(), "busy.cl", "busy", sources, 1), after(test_device(), "busy.cl", "after", sources, 1);
    const Buffer<uint> x(test_device(), 1);
    after(1, x), test_device().finish();  // compiled
    const double before = test_device().profile().at("after").waiting_milliseconds;
    busy(1, x), after(1, x), test_device().finish();
    const KernelProfile first = test_device().profile().at("busy"), second = test_device().profile().at("after");
    EXPECT_GT(first.waiting_milliseconds, 0);
    EXPECT_GE(second.waiting_milliseconds, before);
    EXPECT_LT(second.waiting_milliseconds - before, first.milliseconds / 4);
}

TEST(Device, AnUnknownOneIsRefusedNamingThoseThereAre) {
    expect_mentions(message_of([] { Device::select("no such device"); }), {"no such device", test_device().info().name});
}

TEST(Device, ThreadsLimitItsComputeUnits) {
    const Device one = Device::select("", 1);
    EXPECT_EQ(one.info().compute_units, 1u);
}

TEST(Buffer, TooLargeOnesAreRefusedWithTheSizes) {
    const std::size_t most = test_device().info().largest_allocation;
    expect_mentions(message_of([&] { RawBuffer(test_device(), most + 1); }), {"MiB", test_device().info().name});
}

/// The device may go on meanwhile; nobody has to wait for what it has been asked.
TEST(Buffer, AReadingHasWhatWasThereWhenItStarted) {
    static_assert(!std::is_move_assignable_v<Reading<uint>>, "what another one still waits for would come into memory that is free");
    Kernel kernel(test_device(), "fill.cl", "fill", {{"fill.cl", fill}}, 1);
    const std::size_t many = 1 << 20;
    Buffer<uint> out(test_device(), kernel.work_items(many));
    kernel(many, 7u, out);
    Reading<uint> first = out.start_reading();
    const Reading<uint> unasked = out.start_reading();
    kernel(many, 8u, out);
    Reading<uint> second = std::move(first);
    EXPECT_EQ(std::vector<uint>(second.items().begin(), second.items().end()), std::vector<uint>(out.size(), 7));
    EXPECT_EQ(second.items()[many - 1], 7u) << "it may be asked again";
    EXPECT_EQ(out.start_reading().items()[many - 1], 8u);
    EXPECT_TRUE(Buffer<uint>(test_device(), 0).start_reading().items().empty());
}

TEST(Buffer, WhatIsWrittenIsReadBackAlsoInPartsAndEmpty) {
    Buffer<uint> buffer(test_device(), std::vector<uint>{1, 2, 3, 4});
    buffer.write(std::vector<uint>{7, 8}, 1);
    EXPECT_EQ(buffer.read(), (std::vector<uint>{1, 7, 8, 4}));
    EXPECT_EQ(buffer.read(2, 2), (std::vector<uint>{8, 4}));
    buffer.fill_zero();
    EXPECT_EQ(buffer.read(), std::vector<uint>(4, 0));
    EXPECT_TRUE(Buffer<uint>(test_device(), 0).read().empty());
}

}  // namespace
}  // namespace brandung
