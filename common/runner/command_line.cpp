#include <cstdlib>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "common/runner/runner.hpp"

namespace perceptor {
namespace {

namespace fs = std::filesystem;

fs::path program_directory() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

std::string footer(const Face& face, const config::Describe& describe) {
  const std::string name(face.name);
  return "Configuration keys, with their defaults (config/" + name + ".json, robot.json):\n" +
         config::explain(describe) +
         "\n"
         "Examples:\n"
         "  pico-" +
         name +
         " --print-config\n"
         "  pico-" +
         name + " --config my_" + name +
         ".json --set KEY=VALUE\n"
         "  pico-" +
         name +
         " --lcm-url 'udpm://239.255.76.67:7667?ttl=0'\n"
         "Exit codes: 0 finished or stopped, 1 failed, 2 command line or configuration.";
}

/// The folder of maps and worlds: that of the configuration file, where there are any; a lone file
/// takes the default ones.
fs::path config_directory_of(const fs::path& config_file) {
  const fs::path beside = config_file.parent_path();
  const bool has_own = fs::exists(beside / "maps") || fs::exists(beside / "worlds");
  return has_own ? beside : default_config_directory();
}

}  // namespace

fs::path default_config_directory() {
  if (const char* set = std::getenv("PERCEPTOR_CONFIG")) return set;
  const fs::path installed = program_directory() / ".." / "share" / "perceptor" / "config";
  return fs::exists(installed) ? installed : fs::path(PERCEPTOR_CONFIG_DIR);
}

fs::path robot_file_beside(const fs::path& config_file) {
  const fs::path beside = config_file.parent_path() / "robot.json";
  return fs::exists(beside) ? beside : default_config_directory() / "robot.json";
}

std::variant<Options, ExitCode> read_command_line(int argc, char** argv, const Face& face,
                                                  const config::Describe& describe) {
  const std::string program = "pico-" + std::string(face.name);
  fs::path config_file = default_config_directory() / (std::string(face.name) + ".json");
  config::Sources sources;
  Options options;
  bool print_config = false;
  std::map<std::string_view, std::string> shortcuts;

  CLI::App app{std::string(face.summary), program};
  app.set_version_flag("--version", program + " " + PERCEPTOR_VERSION);
  app.add_option("--config", config_file, "JSON file of this component")->capture_default_str();
  app.add_option("--set", sources.overrides, "key=value: overrides one configuration key");
  app.add_option("--lcm-url", options.lcm_url,
                 "the bus; without it LCM_DEFAULT_URL, else LCM's own default");
  app.add_flag("--print-config", print_config, "print the configuration in force, and exit");
  for (const auto& [key, help] : face.shortcuts)
    app.add_option("--" + std::string(key), shortcuts[key],
                   std::string(help) + " (--set " + std::string(key) + "=...)");

  try {
    app.footer(footer(face, describe));
    app.parse(argc, argv);
    for (const auto& [key, value] : shortcuts)
      if (!value.empty()) sources.overrides.push_back(std::string(key) + "=" + value);
    sources.file = config_file;
    sources.robot_file = robot_file_beside(config_file);
    config::load(sources, describe);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  } catch (const config::Error& error) {
    std::cerr << program << ": " << error.what() << '\n';
    return kExitUsage;
  }
  if (print_config) {
    std::cout << config::print(describe) << '\n';
    return kExitOk;
  }
  options.config_dir = config_directory_of(config_file);
  return options;
}

}  // namespace perceptor
