/// What must hold of every run that fails: one line on standard error, and nothing left behind.
#pragma once
#include <string>
#include <vector>

#include "tests/tools/program.h"

/// Its one line contains all of `parts`.
void expect_failure(const Finished &run, int status, const std::vector<std::string> &parts);
/// Renders `scene` to out.png in `folder` with these arguments more; afterwards the folder has only what it had before.
void expect_render_fails(const TemporaryFolder &folder, const std::string &scene, const std::vector<std::string> &more, int status,
                         const std::vector<std::string> &parts, const RunOptions &options = {});
