/// brandung: the program and its subcommands.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "brandung_version.h"
#include "runtime/opencl/error.h"
#include "scene/error.h"
#include "tools/commands.h"

int main(int argc, char **argv) {
    CLI::App app{"brandung: an OpenCL wavefront ray tracer"};
    app.set_version_flag("--version", "brandung " BRANDUNG_VERSION " (" BRANDUNG_GIT ")");
    app.require_subcommand(1);
    app.fallthrough(false);
    int status = 0;
    brandung::add_render(app, status);
    brandung::add_info(app, status);
    brandung::add_devices(app, status);
    const auto is_asked_for = [&](const CLI::App *command) { return command->check_name(argv[1]); };
    const auto commands = app.get_subcommands([](const CLI::App *) { return true; });
    if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_asked_for)) {
        std::cerr << "brandung: there is no subcommand '" << argv[1] << "' (see --help)\n";
        return 2;
    }
    try {
        app.parse(argc, argv);
        return status;
    } catch (const CLI::CallForHelp &help) {
        return app.exit(help);
    } catch (const CLI::CallForAllHelp &help) {
        return app.exit(help);
    } catch (const CLI::CallForVersion &version) {
        return app.exit(version);
    } catch (const CLI::ParseError &error) {
        std::cerr << "brandung: " << error.what() << " (see --help)\n";
        return 2;
    } catch (const std::exception &error) {
        std::cerr << "brandung: " << error.what() << "\n";
        return 1;
    }
}
