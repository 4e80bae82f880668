#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "common/config/allowed.hpp"
#include "common/config/nearest.hpp"
#include "common/runner/memory.hpp"
#include "common/runner/runner.hpp"
#include "components/scan/scan_config.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/scan_report.hpp"
#include "tools/eval/scan_set_reader.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

constexpr const char* kAll = "all";

struct ScanOptions {
  std::filesystem::path scans;
  std::filesystem::path truth;  ///< empty: the one beside the scans
  std::filesystem::path config = default_config_directory() / "scan.json";
  std::vector<std::string> overrides;
  std::vector<std::string> methods;  ///< empty: the configuration's
  int repetitions = 20;
  bool dump = false;
};

ScanSet read_set(const ScanOptions& options) {
  ScanSet set = read_scans(options.scans);
  if (!options.truth.empty()) {
    read_truth(options.truth, set);
  } else if (const auto beside = default_truth_file(options.scans)) {
    read_truth(*beside, set);
  } else {
    std::fprintf(stderr, "pico-eval: no truth beside %s: times and counts only\n",
                 options.scans.c_str());
  }
  return set;
}

scan::ScanParameters read_parameters(const ScanOptions& options) {
  ScanConfig config;
  config::load({.file = options.config, .robot_file = {}, .overrides = options.overrides},
               [&](config::Fields& fields) { describe(fields, config); });
  return config.scan;
}

[[noreturn]] void fail_unknown_method(const std::string& name) {
  std::vector<std::string> known = {kAll};
  for (const auto& [word, method] : scan::method_names()) known.push_back(word);
  throw config::Error("--method " + name + ": unknown; did you mean \"" +
                      config::nearest(name, known) + "\"? Must be " + config::allowed_word(known));
}

/// Throws config::Error for a name that is no method's.
std::vector<NamedMethod> chosen_methods(const std::vector<std::string>& names,
                                        scan::ScanMethod configured) {
  std::vector<NamedMethod> chosen;
  for (const auto& [word, method] : scan::method_names()) {
    const bool is_asked_for =
        names.empty() ? method == configured
                      : std::ranges::count(names, word) > 0 || std::ranges::count(names, kAll) > 0;
    if (is_asked_for) chosen.push_back({word, method});
  }
  for (const std::string& name : names) {
    const bool is_known = name == kAll || std::ranges::count(chosen, name, &NamedMethod::name) > 0;
    if (!is_known) fail_unknown_method(name);
  }
  return chosen;
}

int score_scans(const ScanOptions& options) {
  const scan::ScanParameters parameters = read_parameters(options);
  const auto methods = chosen_methods(options.methods, parameters.method);
  const ScanSet set = read_set(options);
  keep_freed_memory();
  const ScanEvaluation evaluation = [&] {
    Progress progress("scans", static_cast<std::int64_t>(set.scans.size() * (methods.size() + 1)));
    return evaluate(set, parameters, methods, options.repetitions,
                    [&](std::int64_t done) { progress.at(done); });
  }();
  if (options.dump) std::fputs(scan_dump(set, evaluation).c_str(), stdout);
  std::fputs(scan_table(evaluation).c_str(), options.dump ? stderr : stdout);
  return kExitOk;
}

}  // namespace

Command add_scan_command(CLI::App& app) {
  const auto options = std::make_shared<ScanOptions>();
  CLI::App* scan = app.add_subcommand(
      "scan", "walls and corners extracted from single scans: against the truth, and how fast");
  scan->add_option("FILE", options->scans, "scans, an lxscan text file (.scan, .scan.gz)")
      ->required();
  scan->add_option("--truth", options->truth,
                   "the truth about them; default: the file beside, .truth for .scan");
  scan->add_option("--method", options->methods,
                   "how walls are found; several, or all; default: the configuration's")
      ->delimiter(',')
      ->allow_extra_args(false);
  scan->add_option("--config", options->config, "JSON file of the scan component")
      ->capture_default_str();
  scan->add_option("--set", options->overrides,
                   "key=value: overrides one key of it (pico-scan --help lists them)")
      ->allow_extra_args(false);
  scan->add_option("--repeat", options->repetitions, "runs for each scan and method")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  scan->add_flag("--dump", options->dump,
                 "print the walls and corners (E id x1 y1 x2 y2, C id x y kind), and the table on "
                 "standard error");
  scan->footer(std::string(kScanColumns) +
               "Examples:\n"
               "  pico-eval scan tune.scan.gz --method all\n"
               "  pico-eval scan tune.scan.gz --set wall.min_beams=8 --repeat 100\n"
               "  pico-eval scan tune.scan.gz --dump > found.txt");
  return {scan, [options] { return score_scans(*options); }};
}

}  // namespace perceptor
