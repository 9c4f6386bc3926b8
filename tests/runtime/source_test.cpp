#include "runtime/opencl/source.h"

#include <gtest/gtest.h>

#include <fstream>

#include "runtime/opencl/embedded_kernels.h"
#include "runtime/opencl/error.h"

namespace brandung {
namespace {

TEST(ExpandSource, IncludesAreExpandedWithLinesOfTheirOwnFiles) {
    const Sources sources = {{"a.cl", "one\n#include \"b.h\"\nthree\n"}, {"b.h", "inside\n"}};
    EXPECT_EQ(expand_source("a.cl", sources), "#line 1 \"a.cl\"\none\n#line 1 \"b.h\"\ninside\n#line 3 \"a.cl\"\nthree\n");
}

TEST(ExpandSource, FilesWithPragmaOnceComeOnceAndOthersAsOftenAsTheyAreIncluded) {
    const Sources sources = {{"a.cl", "#include \"once.h\"\n#include \"often.h\"\n#include \"once.h\"\n#include \"often.h\"\n"},
                             {"once.h", "#pragma once\nONCE\n"},
                             {"often.h", "#include \"once.h\"\nOFTEN\n"}};
    const std::string text = expand_source("a.cl", sources);
    EXPECT_EQ(text.find("ONCE"), text.rfind("ONCE"));
    EXPECT_NE(text.find("OFTEN"), text.rfind("OFTEN"));
    EXPECT_EQ(text.find("#pragma once"), std::string::npos) << "it would hide the whole text";
}

TEST(ExpandSource, ANumberOfALineIsNotShiftedByPragmaOnce) {
    EXPECT_EQ(expand_source("a.h", {{"a.h", "/// Text.\n#pragma once\nthree\n"}}), "#line 1 \"a.h\"\n/// Text.\n\nthree\n");
}

TEST(ExpandSource, GivenFilesHideEmbeddedOnes) {
    EXPECT_NE(expand_source("kernels/core/portable.h", {}).find("vec3"), std::string::npos);
    EXPECT_EQ(expand_source("kernels/core/portable.h", {{"kernels/core/portable.h", "other\n"}}), "#line 1 \"kernels/core/portable.h\"\nother\n");
}

TEST(ExpandSource, WhatGeneratedFilesDefineIsThereWhereItIsUsed) {
    const Sources sources = {{"a.cl", "#include \"generated/c.h\"\n#define OF_A 1\nint a = FIRST + NOT_SECOND;\n"},
                             {"generated/c.h", "#define FIRST 1u\n#define SECOND 2u\n#define LIST(X) X(FIRST)\n"}};
    EXPECT_EQ(expand_source("a.cl", sources),
              "#line 1 \"a.cl\"\n#line 1 \"generated/c.h\"\n#define FIRST 1u\n\n\n#line 2 \"a.cl\"\n#define OF_A 1\nint a = FIRST + NOT_SECOND;\n");
}

TEST(ExpandSource, AMissingFileIsNamed) {
    for (const Sources &sources : {Sources{}, Sources{{"a.cl", "#include \"kernels/missing.h\"\n"}}}) {
        try {
            expand_source(sources.empty() ? "kernels/missing.h" : "a.cl", sources);
            FAIL() << "no error";
        } catch (const Error &error) {
            EXPECT_NE(std::string(error.what()).find("kernels/missing.h"), std::string::npos) << error.what();
        }
    }
}

TEST(EmbeddedKernels, TheyAreTheFilesOfTheSourceFolderInOrder) {
    std::string before;
    for (const EmbeddedFile &file : embedded_kernels()) {
        EXPECT_LT(before, file.path);
        before = file.path;
        std::ifstream in(BRANDUNG_SOURCE_DIR "/" + std::string(file.path));
        EXPECT_TRUE(std::string(std::istreambuf_iterator<char>(in), {}) == file.text) << file.path;
    }
    EXPECT_GT(embedded_kernels().size(), 30u);
}

}  // namespace
}  // namespace brandung
