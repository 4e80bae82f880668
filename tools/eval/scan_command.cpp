#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "common/runner/memory.hpp"
#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/scan_input.hpp"
#include "tools/eval/scan_report.hpp"
#include "tools/eval/scan_views.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

struct ScanOptions {
  ScanInput input;
  int repetitions = 20;
  bool dump = false;
  std::filesystem::path sheet;  ///< empty: none
  std::optional<std::size_t> every;
  std::optional<std::int64_t> explained;  ///< a scan's id
  Question question;                      ///< its `scan` is `explained`
};

int score_scans(const ScanOptions& options, const ScanSet& set,
                const scan::ScanParameters& parameters, const std::vector<NamedMethod>& methods) {
  if (!set.has_truth)
    std::fprintf(stderr, "pico-eval: no truth about %s: times and counts only\n",
                 options.input.scans.c_str());
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

int run_scan(const ScanOptions& options) {
  const ScanConfig config = read_scan_config(options.input);
  const auto methods = chosen_methods(options.input.methods, config.scan.method);
  const ScanSet set = read_scan_set(options.input, config.robot);
  scan::ScanParameters parameters = config.scan;
  parameters.method = methods.front().method;
  if (options.explained) {
    Question question = options.question;
    question.scan = *options.explained;
    std::fputs(explain(set, parameters, question).c_str(), stdout);
  } else if (!options.sheet.empty()) {
    const std::string file = options.input.scans.filename().string();
    draw_scans(set, parameters, {file, methods.front().name}, options.every, options.sheet);
  } else {
    return score_scans(options, set, config.scan, methods);
  }
  return kExitOk;
}

/// What shows the walls instead of scoring them.
void add_view_options(CLI::App& scan, ScanOptions& options) {
  CLI::Option* dump = scan.get_option("--dump");
  CLI::Option* sheet =
      scan.add_option("--sheet", options.sheet,
                      "draw the scans with what is found in them into this SVG file, and score "
                      "nothing: 24 of them, spread evenly; of several methods the first")
          ->excludes(dump);
  scan.add_option("--every", options.every, "draw each N-th scan from the first, not 24")
      ->needs(sheet)
      ->check(CLI::Range(1, 1000000));
  CLI::Option* explained =
      scan.add_option("--explain", options.explained,
                      "print what became of the beams of the scan with this id, and score "
                      "nothing; of several methods the first's")
          ->excludes(sheet)
          ->excludes(dump);
  CLI::Option* beam = scan.add_option("--beam", options.question.beam,
                                      "of this beam alone (from 0, in order of measurement)")
                          ->needs(explained)
                          ->check(CLI::Range(0, 1000000));
  scan.add_option("--bearing", options.question.bearing,
                  "[rad] of the beam nearest to it, laser frame")
      ->needs(explained)
      ->excludes(beam);
}

}  // namespace

Command add_scan_command(CLI::App& app) {
  const auto options = std::make_shared<ScanOptions>();
  CLI::App* scan = app.add_subcommand(
      "scan", "walls and corners extracted from single scans: against the truth, and how fast");
  scan->add_option(
          "FILE", options->input.scans,
          "scans, an lxscan text file (.scan, .scan.gz), or an LCM event log: its PICO_LASER\n"
          "messages, numbered from 0, as if the robot stood still; the robot of\n"
          "robot.json does not see itself")
      ->required();
  scan->add_option("--truth", options->input.truth,
                   "the truth about them; default: the file beside, .truth for .scan");
  scan->add_option("--method", options->input.methods,
                   "how walls are found; several, or all; default: the configuration's")
      ->delimiter(',')
      ->allow_extra_args(false);
  scan->add_option("--config", options->input.config, "JSON file of the scan component")
      ->capture_default_str();
  scan->add_option("--set", options->input.overrides,
                   "key=value: overrides one key of it (pico-scan --help lists them)")
      ->allow_extra_args(false);
  scan->add_option("--repeat", options->repetitions, "runs for each scan and method")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  scan->add_flag("--dump", options->dump,
                 "print the walls and corners (E id x1 y1 x2 y2, C id x y kind), and the table on "
                 "standard error");
  add_view_options(*scan, *options);
  scan->footer(std::string(kScanColumns) +
               "Examples:\n"
               "  pico-eval scan tune.scan.gz --method all\n"
               "  pico-eval scan tune.scan.gz --set wall.min_beams=8 --repeat 100\n"
               "  pico-eval scan tune.scan.gz --dump > found.txt\n"
               "  pico-eval scan drive.lcmlog --sheet walls.svg --every 100\n"
               "                            look at what is found in a recorded drive\n"
               "  pico-eval scan drive.lcmlog --explain 1200 --bearing 0.3\n"
               "                            why is there no wall ahead to the left?");
  return {scan, [options] { return run_scan(*options); }};
}

}  // namespace perceptor
