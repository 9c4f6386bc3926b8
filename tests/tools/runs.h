/// Runs that many tests begin with, and what must hold of those that succeed.
#pragma once
#include <string>
#include <vector>

#include "tests/tools/program.h"

void expect_success(const Finished &run);
/// Runs `brandung render --quiet ARGUMENTS...`, which must succeed and say nothing.
void render_quietly(const std::vector<std::string> &arguments);
/// Runs `brandung render SCENE ARGUMENTS...` on native_scene() in `folder`.
Finished render_native(const TemporaryFolder &folder, const std::vector<std::string> &arguments);
