#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/runner/runner.hpp"
#include "components/bridge/world_file.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/localize/drive.hpp"
#include "tools/eval/localize/oracle.hpp"
#include "tools/eval/localize/outcome.hpp"
#include "tools/eval/localize/protocol_report.hpp"
#include "tools/eval/localize/trial.hpp"
#include "tools/eval/random_world.hpp"
#include "tools/eval/robot_file.hpp"
#include "tools/eval/world_writer.hpp"
#include "tools/progress.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

namespace fs = std::filesystem;

struct LocalizeOptions {
  std::vector<fs::path> maps;
  std::size_t generated = 20;
  std::size_t trials = 300;
  std::size_t only = 0;  ///< 0: all
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  ProtocolParameters protocol;
  fs::path config_dir = default_config_directory();
  std::vector<std::string> overrides;
  fs::path json;
  fs::path log;
};

/// Those named, and some that are made here, in `folder`.
std::vector<Site> make_sites(const LocalizeOptions& options, const fs::path& folder) {
  std::vector<Site> sites;
  sites.reserve(options.maps.size() + options.generated);
  for (const fs::path& map : options.maps) sites.push_back(read_site(map));
  RandomWorldParameters parameters;
  parameters.seed = options.protocol.seed;
  for (std::size_t number = 1; number <= options.generated; ++number) {
    const std::string name = "generated_" + std::to_string(number);
    write_random_world(draw_random_world(parameters, number), parameters, number, folder, name);
    sites.push_back(read_site(folder / "maps" / (name + ".json")));
  }
  if (sites.empty()) throw std::runtime_error("no map, and none to be made: nowhere to start");
  return sites;
}

std::vector<TrueView> seen_soon(const std::vector<TrueView>& views) {
  const auto late = std::ranges::find_if(views, [](const TrueView& v) { return v.time > kSoon; });
  return {views.begin(), late};
}

class Protocol {
 public:
  Protocol(const LocalizeOptions& options, const std::vector<Site>& sites)
      : options_(options),
        sites_(sites),
        robot_(read_robot(options.config_dir)),
        pipeline_(load_pipeline_config(options.config_dir, options.overrides,
                                       sites.front().file.string())) {}

  JudgedTrial run(std::size_t number) const {
    const Trial trial = draw_trial(sites_, sim::parameters_of(robot_), options_.protocol, number);
    const Site& site = sites_[trial.site];
    const Drive driven =
        drive(trial, site, options_.protocol, pipeline_, robot_.laser, options_.log);
    JudgedTrial judged{number, site.name, trial.conditions, judge(driven)};
    judged.outcome.is_ambiguous = elsewhere(site.world, driven.views).has_value();
    judged.outcome.is_ambiguous_at_first =
        judged.outcome.is_ambiguous || elsewhere(site.world, seen_soon(driven.views)).has_value();
    judged.outcome.is_ambiguous_after = elsewhere(site.world, driven.views_after).has_value();
    return judged;
  }

  /// In order of their numbers, whoever was ready first.
  std::vector<JudgedTrial> run_all() const {
    std::vector<JudgedTrial> trials(options_.trials);
    Progress progress("driving", static_cast<std::int64_t>(options_.trials));
    std::atomic<std::size_t> next = 0;
    std::int64_t done = 0;
    std::exception_ptr fault;
    std::mutex mutex;
    const auto work = [&] {
      for (std::size_t i = next++; i < trials.size(); i = next++) {
        try {
          trials[i] = run(i + 1);
          const std::lock_guard lock(mutex);
          progress.at(++done);
        } catch (...) {
          const std::lock_guard lock(mutex);
          fault = std::current_exception();
          next = trials.size();
        }
      }
    };
    {
      std::vector<std::jthread> workers;
      for (unsigned i = 0; i < options_.jobs; ++i) workers.emplace_back(work);
    }
    if (fault) std::rethrow_exception(fault);
    return trials;
  }

 private:
  const LocalizeOptions& options_;
  const std::vector<Site>& sites_;
  Robot robot_;
  PipelineConfig pipeline_;
};

int run_protocol(const LocalizeOptions& options) {
  const TemporaryFolder folder;
  const std::vector<Site> sites = make_sites(options, folder.path());
  const Protocol protocol(options, sites);
  const std::vector<JudgedTrial> trials =
      options.only > 0 ? std::vector{protocol.run(options.only)} : protocol.run_all();
  std::fputs(report(trials).c_str(), stdout);
  if (options.json.empty()) return kExitOk;
  std::ofstream out(options.json);
  out << report_json(trials, options.protocol.seed);
  out.close();
  if (!out) throw std::runtime_error(options.json.string() + ": cannot be written");
  return kExitOk;
}

}  // namespace

Command add_localize_command(CLI::App& app) {
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::App* localize = app.add_subcommand(
      "localize", "localize in known buildings, from random starts under drawn conditions");
  localize->add_option("MAP", options->maps, "map files of buildings")->check(CLI::ExistingFile);
  localize->add_option("--generated", options->generated, "random buildings beside them")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  localize->add_option("--trials", options->trials, "how many starts")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  localize->add_option("--seed", options->protocol.seed, "the same seed, the same trials")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  CLI::Option* only = localize->add_option("--only", options->only, "the number of one trial")
                          ->check(CLI::PositiveNumber);
  localize->add_option("--log", options->log, "an LCM event log of that trial")->needs(only);
  localize->add_option("--jobs", options->jobs, "trials at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  localize->add_option("--json", options->json, "the result for machines");
  localize->add_option("--config-dir", options->config_dir, "folder of the components' JSON files")
      ->capture_default_str();
  localize
      ->add_option("--set", options->overrides,
                   "component.key=value, as in localize.claim.margin=20")
      ->allow_extra_args(false);
  localize->footer(
      "Each trial draws a building, a start and one condition from each list:\n"
      "  clutter    0, 20 or 40 % of the beams end on boxes; with clutter people walk by\n"
      "  doors      open, shut flush with the walls, shut and set back\n"
      "  slip       0.2, 5 or 10 % of odometry's scale\n"
      "  noise      0.01 or 0.03 m, 1 to 5 % outliers\n"
      "  displaced  the real walls are on the map, or up to 5 cm beside it\n"
      "The robot turns in place, then drives where it can, 41 s in all; a quarter are then\n"
      "carried elsewhere. Found: tracking within 0.10 m and 2 degrees, for 10 s. Elsewhere:\n"
      "tracking, but not there, for over a second. An oracle that knows the drive looks for other\n"
      "places where it would have looked the same: ambiguous starts count apart. Clear by then:\n"
      "it says so also of what was seen in the first 10 s alone.\n"
      "Examples:\n"
      "  pico-eval localize config/maps/hospital.json --trials 300 --json result.json\n"
      "  pico-eval localize config/maps/hospital.json --only 17 --log trial.lcmlog");
  return {localize, [options] { return run_protocol(*options); }};
}

}  // namespace perceptor
