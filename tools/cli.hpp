/// @file What all command-line tools do alike: errors become one line and an exit code.
#pragma once

#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "common/runner/runner.hpp"

namespace perceptor {

/// Parses, then runs `body`, whose result is the exit code. A fault of the command line or of a
/// configuration gives kExitUsage, any other exception kExitFailed.
inline int run_tool(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  app.set_version_flag("--version", app.get_name() + " " + PERCEPTOR_VERSION);
  try {
    app.parse(argc, argv);
    return body();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  } catch (const config::Error& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return kExitUsage;
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return kExitFailed;
  }
}

}  // namespace perceptor
