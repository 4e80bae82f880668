/// Robots that were driven through a building of which there is a map: found from nothing, and
/// followed. The map was made of scans, its walls are smeared over decimetres, and odometry drifts
/// by metres.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <pico/world_position_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/process/harness.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/sanitized.hpp"
#include "tools/eval/pose_reference.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor::test {
namespace {

struct KnownDrive {
  const char* name;
  double median;   ///< [m] from the reference, at most. That is good to 0.1 m, and where walls are
                   ///< smeared widest it lies 0.12 m to one side.
  double tracked;  ///< share of the scans, at least
};

void PrintTo(const KnownDrive& drive, std::ostream* out) { *out << drive.name; }

/// [m] Farthest from the reference, of a pose that is claimed.
constexpr double kFarthest = 0.5;

/// [s] between two poses of the reference.
constexpr double kGap = 3.0;

void unpack(const std::string& relative, const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << testing::unpacked(*testing::recorded(relative));
}

class KnownBuilding : public ::testing::TestWithParam<KnownDrive> {};

TEST_P(KnownBuilding, RobotIsWhereItIsSaidToBe) {
  const KnownDrive& drive = GetParam();
  const std::string log = "logs/" + std::string(drive.name);
  for (const std::string& file :
       {log + ".log.xz", log + ".derived.ref.xz", std::string("maps/wean_map.pgm.xz"),
        std::string("maps/wean_map.yaml")})
    PERCEPTOR_REQUIRE_RECORDED(file);

  const ScratchFolder scratch;
  unpack(log + ".log.xz", scratch / "drive.log");
  unpack(log + ".derived.ref.xz", scratch / "drive.ref");
  unpack("maps/wean_map.pgm.xz", scratch / "wean_map.pgm");
  unpack("maps/wean_map.yaml", scratch / "wean_map.yaml");
  const std::filesystem::path config = scratch / "config";
  std::filesystem::copy(PERCEPTOR_SOURCE_DIR "/config", config,
                        std::filesystem::copy_options::recursive);
  std::filesystem::copy_file(config / "localize_scanned_map.json", config / "localize.json",
                             std::filesystem::copy_options::overwrite_existing);
  for (const auto& command : std::vector<std::vector<std::string>>{
           {program("pico-vectorize"), scratch / "wean_map.yaml", scratch / "wean.json"},
           {program("pico-convert"), scratch / "drive.log", scratch / "in.lcmlog"},
           {program("pico-replay"), scratch / "in.lcmlog", scratch / "out.lcmlog", "--set",
            "scan.aligner.max_gap=3", "--config-dir", config, "--map", scratch / "wean.json"}}) {
    const Finished finished = run(command, Seconds(kSanitized ? 3600 : 300));
    ASSERT_EQ(finished.exit_code, 0) << finished.output;
  }

  const Trajectory reference = read_poses(scratch / "drive.ref");
  std::vector<double> off;
  double tracked = 0.0;
  double scans = 0.0;
  LogReader reader(scratch / "out.lcmlog");
  while (const auto event = reader.next()) {
    if (event->channel != channel::world_position) continue;
    pico::world_position_t position;
    ASSERT_EQ(detail::decode(event->data, position), "");
    ++scans;
    if (position.state != pico::world_position_t::TRACKING) continue;
    ++tracked;
    const auto truth = pose_at(reference, position.utime, kGap);
    if (!truth) continue;
    off.push_back(distance(to_model(position.robot_in_world).location(), truth->location()));
    EXPECT_LT(off.back(), kFarthest) << "at " << position.utime;
  }
  EXPECT_GT(tracked / scans, drive.tracked);
  ASSERT_FALSE(off.empty());
  EXPECT_LT(quantile(off, 0.5), drive.median);
}

INSTANTIATE_TEST_SUITE_P(All, KnownBuilding,
                         ::testing::Values(KnownDrive{"wean1", 0.2, 0.4},
                                           KnownDrive{"wean4", 0.15, 0.2}),
                         [](const auto& name) { return std::string(name.param.name); });

}  // namespace
}  // namespace perceptor::test
