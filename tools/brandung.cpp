/// brandung: the program and its subcommands.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>

#include "brandung_version.h"
#include "scene/spelling.h"
#include "tools/commands.h"
#include "tools/standard_output.h"

namespace {

using namespace brandung;

/// Help and version, which CLI11 handles as exceptions.
int print_help(const CLI::App &app, const CLI::Success &help) {
    std::ostringstream text;
    const int status = app.exit(help, text);
    print_result(text.str());
    return status;
}

/// "; is --spp meant?" where one of the arguments is an option of the subcommand misspelt.
std::string meant_instead(const CLI::App &app, const std::vector<std::string> &arguments) {
    std::vector<std::string> names;
    std::vector<const CLI::App *> commands = {&app};
    for (const CLI::App *command : app.get_subcommands()) commands.push_back(command);
    for (const CLI::App *command : commands)
        for (const CLI::Option *option : command->get_options())
            for (const std::string &name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string &argument : arguments) {
        if (!argument.starts_with("--")) continue;
        const std::string given = argument.substr(0, argument.find('=')), nearest = by_likeness(given, names).at(0);
        if (resembles(given, nearest)) return "; is " + nearest + " meant?";
    }
    return "";
}

int run(int argc, char **argv) {
    CLI::App app{"brandung: an OpenCL wavefront ray tracer"};
    app.set_version_flag("--version", "brandung " BRANDUNG_VERSION " (" BRANDUNG_GIT ")");
    app.require_subcommand(1);
    app.fallthrough(false);
    int status = 0;
    add_render(app, status);
    add_info(app, status);
    add_check(app, status);
    add_inspect(app, status);
    add_devices(app, status);
    add_compare(app, status);
    add_selftest(app, status);
    add_converge(app, status);
    add_bench(app, status);
    const auto is_asked_for = [&](const CLI::App *command) { return command->check_name(argv[1]); };
    const auto commands = app.get_subcommands([](const CLI::App *) { return true; });
    if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_asked_for)) {
        std::cerr << "brandung: there is no subcommand '" << argv[1] << "' (see --help)\n";
        return 2;
    }
    try {
        app.parse(argc, argv);
        return status;
    } catch (const CLI::Success &help) {
        return print_help(app, help);
    } catch (const CLI::ExtrasError &error) {
        std::cerr << "brandung: " << error.what() << meant_instead(app, app.remaining(true)) << " (see --help)\n";
        return 2;
    } catch (const CLI::ParseError &error) {
        std::cerr << "brandung: " << error.what() << " (see --help)\n";
        return 2;
    }
}

}  // namespace

int main(int argc, char **argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception &error) {
        std::cerr << "brandung: " << error.what() << "\n";
        return 1;
    }
}
