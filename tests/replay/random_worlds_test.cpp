/// What merge and identify find in random worlds of the simulator, against the truth: rooms,
/// doorways, furniture, wheels that slip, people who walk. The medians over the worlds: what one
/// corner closely before a wall can look like is not promised.

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"
#include "tools/eval/map_score.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor::test {
namespace {

struct Asked {
  const char* name;
  const char* sigma;
  const char* outliers;
  double walls_found;
  double walls_right;
  double doors_right;
  double doors_found;
};

void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.name; }

constexpr int kWorlds = 7;  // an odd number has a middle

MapScore score_of(const std::filesystem::path& world, const ScratchFolder& scratch) {
  const std::filesystem::path simulated = scratch / "in.lcmlog";
  const std::filesystem::path perceived = scratch / "out.lcmlog";
  for (const auto& command :
       {std::vector<std::string>{program("pico-bridge"), "--world", world, "--speed", "0",
                                 "--duration", "60", "--lcm-url",
                                 "file://" + simulated.string() + "?mode=w"},
        std::vector<std::string>{program("pico-replay"), simulated, perceived}}) {
    const Finished finished = run(command, Seconds(300));
    EXPECT_EQ(finished.exit_code, 0) << finished.output;
  }
  MapScorer scorer;
  LogReader reader(perceived);
  while (const auto event = reader.next()) scorer.take(*event);
  return scorer.score();
}

class RandomWorlds : public ::testing::TestWithParam<Asked> {};

TEST_P(RandomWorlds, WallsCornersAndDoorsAreThere) {
  const Asked& asked = GetParam();
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch / "made";
  const Finished made =
      run({program("pico-eval"), "worlds", folder, "--worlds", std::to_string(kWorlds), "--seed",
           "20261125", "--sigma", asked.sigma, "--outliers", asked.outliers});
  ASSERT_EQ(made.exit_code, 0) << made.output;

  std::vector<MapScore> scores;
  for (const auto& world : std::filesystem::directory_iterator(folder / "worlds")) {
    scores.push_back(score_of(world.path(), scratch));
    EXPECT_GT(scores.back().maps, 0) << world.path();
    EXPECT_EQ(scores.back().doubles, 0) << world.path();
  }
  ASSERT_EQ(scores.size(), kWorlds);
  const auto median = [&](const auto& of) {
    std::vector<double> values;
    for (const MapScore& score : scores) values.push_back(of(score));
    return quantile(values, 0.5);
  };
  EXPECT_GE(median([](const MapScore& s) { return value(s.walls); }), asked.walls_found);
  EXPECT_GE(median([](const MapScore& s) { return value(s.right); }), asked.walls_right);
  EXPECT_LE(median([](const MapScore& s) { return s.corners.rms(); }), 0.02);
  EXPECT_LE(median([](const MapScore& s) { return value(s.corners.confused); }), 0.01);
  EXPECT_GE(median([](const MapScore& s) { return value(s.doors.right); }), asked.doors_right);
  EXPECT_GE(median([](const MapScore& s) { return value(s.doors.found); }), asked.doors_found);
  EXPECT_LE(median([](const MapScore& s) { return quantile(s.doors.delays, 0.5); }), 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, RandomWorlds,
                         ::testing::Values(Asked{"quiet", "0.01", "0", 0.95, 0.98, 0.97, 0.95},
                                           Asked{"loud", "0.03", "0.01", 0.90, 0.95, 0.95, 0.90}),
                         [](const auto& asked) { return std::string(asked.param.name); });

}  // namespace
}  // namespace perceptor::test
