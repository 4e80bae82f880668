/// @file Gives every process the same face: command line, configuration, STATUS each second,
/// clean exit on SIGINT and SIGTERM, exit codes.
///
/// A component is a class with
///   static constexpr std::string_view kName, kSummary;
///   using Config = ...;                     // with describe(config::Fields&, Config&)
///   Component(const Config&, Bus&);         // subscribes
/// and, where it is a source that works by itself, not only when a message comes,
///   std::int64_t step(std::int64_t now);    // [us], monotonic; gives when to be called next
///   bool finished() const;                  // nothing more will come
/// and, where something outside must not go on,
///   void stop();                            // at once when it is asked to end
/// and, where it has to account for something before its last STATUS,
///   void finish();                          // nothing more will be handled
/// It may add command-line options that stand for a configuration key:
///   static constexpr std::array<std::pair<std::string_view, std::string_view>, N> kShortcuts;
/// and learn the folder of the configuration files through `Config::config_dir`.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"

namespace perceptor {

/// What a process gives back to the shell.
enum ExitCode : int {
  kExitOk = 0,      ///< finished, or asked to stop
  kExitFailed = 1,  ///< no bus, or it broke while running
  kExitUsage = 2,   ///< command line or configuration
};

/// What the command line is built from.
struct Face {
  std::string_view name;     ///< the process is pico-<name>
  std::string_view summary;  ///< one sentence
  std::vector<std::pair<std::string_view, std::string_view>> shortcuts;  ///< key, help
};

struct Options {
  std::string lcm_url;               ///< empty: LCM_DEFAULT_URL, else LCM's own default
  std::filesystem::path config_dir;  ///< of maps and worlds
};

/// Reads command line and configuration files into what `describe` binds. Gives an exit code
/// where that was all (--help, --version, --print-config, or a fault that it has printed).
std::variant<Options, ExitCode> read_command_line(int argc, char** argv, const Face& face,
                                                  const config::Describe& describe);

/// What the runner calls of a component.
struct Work {
  std::function<std::int64_t(std::int64_t now)> step;
  std::function<bool()> finished;
  std::function<void()> stop;
  std::function<void()> finish;
};

/// Opens the bus, makes the component, and handles messages until a signal comes or the
/// source has finished; then drains what still waits, and sends the last STATUS.
ExitCode run(const Face& face, const Options& options, const std::function<Work(Bus&)>& start);

/// Says on standard error that the bus cannot be opened, and what to do about it.
void print_no_bus(std::string_view program, const std::string& lcm_url);

/// The default folder of configuration files: PERCEPTOR_CONFIG where it is set, else beside
/// the installed program, else the source tree's.
std::filesystem::path default_config_directory();

/// robot.json beside a component's configuration file; a lone file takes the default robot.
std::filesystem::path robot_file_beside(const std::filesystem::path& config_file);

template <class Component>
int run_component(int argc, char** argv) {
  Face face{Component::kName, Component::kSummary, {}};
  if constexpr (requires { Component::kShortcuts; })
    face.shortcuts.assign(Component::kShortcuts.begin(), Component::kShortcuts.end());

  typename Component::Config config;
  const auto options = read_command_line(
      argc, argv, face, [&config](config::Fields& fields) { describe(fields, config); });
  if (const auto* code = std::get_if<ExitCode>(&options)) return *code;
  const auto& chosen = std::get<Options>(options);
  if constexpr (requires { config.config_dir; }) config.config_dir = chosen.config_dir;

  return run(face, chosen, [&config](Bus& bus) -> Work {
    auto component = std::make_shared<Component>(config, bus);
    Work work = {[](std::int64_t now) { return now + 3600 * kMicrosecondsPerSecond; },
                 [] { return false; }, [component] {}, [component] {}};
    if constexpr (requires { component->step(std::int64_t{}); }) {
      work.step = [component](std::int64_t now) { return component->step(now); };
      work.finished = [component] { return component->finished(); };
    }
    if constexpr (requires { component->stop(); }) work.stop = [component] { component->stop(); };
    if constexpr (requires { component->finish(); })
      work.finish = [component] { component->finish(); };
    return work;
  });
}

}  // namespace perceptor
