#include "tools/eval/scan_input.hpp"

#include <algorithm>
#include <cstdio>

#include "common/config/allowed.hpp"
#include "common/config/nearest.hpp"
#include "tools/eval/log_scans.hpp"
#include "tools/eval/scan_set_reader.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

constexpr const char* kAll = "all";

ScanSet read_log(const ScanInput& input, const Robot& robot) {
  if (!input.truth.empty())
    throw config::Error("--truth " + input.truth.string() + ": there is none about a log");
  LogScans log = [&] {
    Progress progress("reading", static_cast<std::int64_t>(file_size(input.scans)));
    return read_log_scans(input.scans, [&](std::int64_t bytes) { progress.at(bytes); });
  }();
  for (const LogDamage& damage : log.damage)
    std::fprintf(stderr, "pico-eval: %lld damaged bytes passed over at byte %lld\n",
                 static_cast<long long>(damage.size), static_cast<long long>(damage.offset));
  if (log.undecodable > 0)
    std::fprintf(stderr, "pico-eval: %lld laser messages left out; the first: %s\n",
                 static_cast<long long>(log.undecodable), log.first_fault.c_str());
  log.set.footprint = outline(robot);
  return std::move(log.set);
}

ScanSet read_text(const ScanInput& input) {
  ScanSet set = read_scans(input.scans);
  if (!input.truth.empty())
    read_truth(input.truth, set);
  else if (const auto beside = default_truth_file(input.scans))
    read_truth(*beside, set);
  return set;
}

[[noreturn]] void fail_unknown_method(const std::string& name) {
  std::vector<std::string> known = {kAll};
  for (const auto& [word, method] : scan::method_names()) known.push_back(word);
  throw config::Error("--method " + name + ": unknown; did you mean \"" +
                      config::nearest(name, known) + "\"? Must be " + config::allowed_word(known));
}

}  // namespace

ScanConfig read_scan_config(const ScanInput& input) {
  ScanConfig config;
  config::load({.file = input.config,
                .robot_file = robot_file_beside(input.config),
                .overrides = input.overrides},
               [&](config::Fields& fields) { describe(fields, config); });
  return config;
}

ScanSet read_scan_set(const ScanInput& input, const Robot& robot) {
  return is_event_log(input.scans) ? read_log(input, robot) : read_text(input);
}

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

}  // namespace perceptor
