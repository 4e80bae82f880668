/// @file pico-convert: recordings of other formats to LCM event logs.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "tools/cli.hpp"
#include "tools/convert/conversion.hpp"
#include "tools/progress.hpp"

namespace {

using perceptor::ConversionOptions;
using perceptor::RecordingFormat;

constexpr int kExitNothing = 1;

constexpr const char* kSummary =
    "Converts a recording to an LCM event log with PICO_LASER and PICO_ODOMETRY.\n"
    "Reads the text logs of this project (ODOM, LASER, LASERA lines), CARMEN logs (ODOM, FLASER,\n"
    "ROBOTLASER1) and ROS bags (LaserScan, Odometry). Says on stderr what was written and what\n"
    "was dropped.";

constexpr const char* kExamples =
    "Examples:\n"
    "  pico-convert office.log office.lcmlog\n"
    "  xz -dc office.log.xz | pico-convert - office.lcmlog\n"
    "  pico-convert --still --sigma 0.005 doorway.log doorway.lcmlog\n"
    "                                    a standing robot that recorded no odometry\n"
    "  pico-convert --valid-max 30 csail.carmen csail.lcmlog\n"
    "  pico-convert --laser-topic /scan --odometry-topic /odom drive.bag drive.lcmlog\n"
    "  pico-logcheck office.lcmlog       is it whole?\n"
    "  lcm-logplayer -e 'PICO_.*' office.lcmlog   play it to running components\n"
    "\n"
    "Exit: 0 something was written, 1 nothing was, 2 wrong usage or an input that is no\n"
    "recording.";

int fail(int code, const std::string& what) {
  std::cerr << "pico-convert: " << what << '\n';
  return code;
}

int run(const std::string& in_name, const std::string& out_name, const ConversionOptions& options) {
  namespace fs = std::filesystem;
  const bool is_standard_input = in_name == "-";
  std::error_code error;
  if (!is_standard_input && fs::equivalent(in_name, out_name, error))
    return fail(perceptor::kExitUsage, "input and output are the same file");
  std::ifstream file;
  std::uintmax_t size = 0;
  if (!is_standard_input) {
    if (!fs::exists(in_name)) return fail(perceptor::kExitUsage, "there is no file " + in_name);
    if (fs::is_directory(in_name)) return fail(perceptor::kExitUsage, in_name + " is a folder");
    file.open(in_name, std::ios::binary);
    if (!file) return fail(perceptor::kExitUsage, "cannot read " + in_name);
    if (fs::is_regular_file(in_name)) size = fs::file_size(in_name, error);
  }
  std::ios::sync_with_stdio(false);
  try {
    perceptor::Progress progress("converting", static_cast<std::int64_t>(size));
    const auto show = [&](std::int64_t bytes) { progress.at(bytes); };
    const auto summary = !is_standard_input && perceptor::is_bag(in_name)
                             ? perceptor::convert_bag(in_name, out_name, options, show)
                             : perceptor::convert(is_standard_input ? std::cin : file, in_name,
                                                  out_name, options, show);
    print(std::cerr, summary);
    if (summary.is_useful()) return perceptor::kExitOk;
  } catch (const perceptor::NotARecording& failure) {
    return fail(perceptor::kExitUsage, failure.what());
  }
  return fail(kExitNothing, "nothing to convert in " + in_name);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(kSummary, "pico-convert");
  app.footer(kExamples);
  std::string in_name;
  std::string out_name;
  ConversionOptions options;
  app.add_option("IN", in_name, "the recording; - is standard input")->required();
  app.add_option("OUT", out_name, "the LCM event log to write")->required();
  std::string format = "auto";
  app.add_option("--format", format, "auto, text or carmen")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "text", "carmen"}));
  app.add_flag("--still", options.events.still,
               "the robot stood still: write an odometry of zeros around every scan, instead of "
               "what was recorded");
  app.add_option("--sigma", options.events.range_sigma, "[m] standard deviation of a valid range")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 10.0));
  app.add_option("--session", options.events.session,
                 "number of the session; default: the first stamp in microseconds")
      ->check(CLI::PositiveNumber);
  app.add_option("--time-increment", options.events.time_increment,
                 "[s] from beam to beam; 0: all beams at once; default: as recorded")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--valid-min", options.events.valid_min,
                 "[m] a shorter range is no return; default: as recorded, else 0.05")
      ->check(CLI::NonNegativeNumber);
  app.add_option(
         "--valid-max", options.events.valid_max,
         "[m] a longer range is no return; default: as recorded, else 1 % below the laser's most")
      ->check(CLI::PositiveNumber);
  app.add_option("--laser-topic", options.topics.laser, "of a bag: sensor_msgs/LaserScan")
      ->capture_default_str();
  app.add_option("--odometry-topic", options.topics.odometry, "of a bag: nav_msgs/Odometry")
      ->capture_default_str();
  return perceptor::run_tool(app, argc, argv, [&] {
    if (format == "text") options.format = RecordingFormat::text;
    if (format == "carmen") options.format = RecordingFormat::carmen;
    return run(in_name, out_name, options);
  });
}
