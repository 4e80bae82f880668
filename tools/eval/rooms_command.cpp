#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/room_set.hpp"
#include "tools/eval/scan_set_writer.hpp"
#include "tools/progress.hpp"

namespace perceptor {

namespace {

struct RoomsOptions {
  std::filesystem::path out;  ///< the scans; the truth goes beside
  RoomScanParameters parameters;
};

int make_rooms(const RoomsOptions& options) {
  const std::size_t scans = options.parameters.scans;
  ScanSet set;
  set.has_truth = true;
  {
    Progress progress("making", static_cast<std::int64_t>(scans));
    for (std::size_t number = 0; number < scans; ++number) {
      set.scans.push_back(make_room_scan(options.parameters, number));
      progress.at(static_cast<std::int64_t>(number) + 1);
    }
  }
  write_scan_set(set, options.out);
  std::size_t pieces = 0;
  std::size_t corners = 0;
  for (const LabelledScan& scan : set.scans) {
    pieces += scan.pieces.size();
    corners += scan.corners.size();
  }
  std::printf("%zu scans, %zu pieces of walls, %zu corners\n", scans, pieces, corners);
  return kExitOk;
}

}  // namespace

Command add_rooms_command(CLI::App& app) {
  const auto options = std::make_shared<RoomsOptions>();
  CLI::App* rooms = app.add_subcommand("rooms", "makes scans in random rooms, with exact truth");
  RoomLaser& laser = options->parameters.laser;
  rooms->add_option("OUT", options->out, "a file OUT.scan; the truth goes to OUT.truth")
      ->required()
      ->check([](const std::string& name) {
        return name.ends_with(".scan") ? std::string() : "the name has to end in .scan";
      });
  rooms->add_option("--scans", options->parameters.scans, "how many, each in a room of its own")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  rooms->add_option("--beams", laser.beams, "of one scan")
      ->check(CLI::Range(2, 100'000))
      ->capture_default_str();
  rooms->add_option("--fov", laser.fov, "[rad] from the first beam to the last")
      ->check(CLI::Range(0.001, 2.0 * std::numbers::pi))
      ->capture_default_str();
  rooms->add_option("--sigma", laser.sigma, "[m] standard deviation of a range")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  rooms->add_option("--outliers", laser.outliers, "share of beams that measure anything")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  rooms->add_option("--dropouts", laser.dropouts, "share of beams without a return")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  rooms->add_option("--seed", options->parameters.seed, "the same seed, the same bytes")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  return {rooms, [options] { return make_rooms(*options); }};
}

}  // namespace perceptor
