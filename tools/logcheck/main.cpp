/// @file pico-logcheck: does a log hold everything that was published?

#include <filesystem>
#include <iostream>
#include <string>

#include "common/log/event_log.hpp"
#include "tools/cli.hpp"
#include "tools/logcheck/log_check.hpp"
#include "tools/logcheck/report.hpp"
#include "tools/progress.hpp"

namespace {

constexpr const char* kSummary =
    "Says for each channel of an LCM event log whether it is complete, what is missing, or\n"
    "why completeness cannot be proven.";

constexpr const char* kHow =
    "How it knows: PICO_* and SIM_* count seq from 0 without gaps within a session. What is\n"
    "computed keeps the seq of its measurement, so the number of messages is compared with\n"
    "what the publisher counted in its STATUS, from its first to its last word. A log without\n"
    "the last STATUS of a publisher (killed, or the logger stopped too early) proves nothing\n"
    "about the end.\n"
    "\n"
    "Examples:\n"
    "  pico-logcheck run.lcmlog\n"
    "  pico-logcheck run.lcmlog --json | jq .verdict\n"
    "\n"
    "Exit: 0 all complete and the file undamaged, 1 something is missing or damaged, 2 wrong\n"
    "usage or an unreadable file, 3 nothing is missing but something is not provable.";

int run(const std::string& file, bool as_json) {
  try {
    perceptor::LogReport report;
    {
      std::error_code error;
      const auto size = std::filesystem::file_size(file, error);
      perceptor::Progress progress("reading", error ? 0 : static_cast<std::int64_t>(size));
      report = perceptor::check_log(
          file, [&progress](std::int64_t done, std::int64_t) { progress.at(done); });
    }
    if (as_json)
      std::cout << to_json(report);
    else
      print(std::cout, report);
    return exit_code(report);
  } catch (const perceptor::LogError& error) {
    std::cerr << "pico-logcheck: " << error.what() << '\n';
    return perceptor::kExitUsage;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(kSummary, "pico-logcheck");
  app.footer(kHow);
  std::string file;
  bool as_json = false;
  app.add_option("LOG", file, "an LCM event log")->required();
  app.add_flag("--json", as_json, "print the report as JSON, for programs");
  return perceptor::run_tool(app, argc, argv, [&] { return run(file, as_json); });
}
