/// @file What localize costs in the hospital: following the robot, and looking for it everywhere.
#include <benchmark/benchmark.h>

#include "common/floorplan/floorplan.hpp"
#include "common/global_map/global_map.hpp"
#include "components/localize/combined_map.hpp"
#include "components/localize/localizer.hpp"
#include "tests/support/scene.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kScanPeriod = 25'000;  // [us]
constexpr Position kStart{1.4, 1.4, 0.0};     // a place in the first room

Map hospital() {
  return global_map::make_global_map(
             read_floorplan(PERCEPTOR_SOURCE_DIR "/config/maps/hospital.json"))
      .map;
}

/// A robot that turns in place; the local map holds all walls of the building.
class Turning {
 public:
  explicit Turning(const Map& building) : building_(building) {
    for (const Object& object : building.objects)
      if (object.type == ObjectType::wall) scene_.push_back(segment(building, object));
  }

  localize::Sight at(double heading) {
    const Position robot{kStart.x, kStart.y, heading};
    localize::Sight sight;
    sight.utime = utime_ += kScanPeriod;
    sight.robot_in_local = robot;
    sight.walls = transform(building_, inverse(robot));
    for (Object& object : sight.walls.objects) object.last_seen = sight.utime;
    sight.scan_walls = sight.walls;
    sight.ends = beam_ends(test::sweep(scene_, test::pico_laser(0.01), robot));
    return sight;
  }

 private:
  Map building_;
  test::Scene scene_;
  std::int64_t utime_ = 0;
};

/// By walls or by beams.
void LocalizeTrack(benchmark::State& state) {
  const Map building = hospital();
  Turning robot(building);
  localize::LocalizerParameters parameters;
  parameters.track_by = static_cast<localize::TrackBy>(state.range(0));
  localize::Localizer localizer(localize::World(building), parameters);
  for (double heading = 0.0; heading < 3.0; heading += 0.1) localizer.update(robot.at(heading));
  localize::Sight sight = robot.at(3.0);
  const bool is_tracking = localizer.update(sight).state == localize::State::tracking;
  for (auto _ : state) {
    sight.utime += kScanPeriod;
    for (Object& object : sight.walls.objects) object.last_seen = sight.utime;
    benchmark::DoNotOptimize(localizer.update(sight));
  }
  state.counters["tracking"] = is_tracking ? 1.0 : 0.0;
}
BENCHMARK(LocalizeTrack)
    ->ArgName("beams")
    ->Arg(static_cast<int>(localize::TrackBy::walls))
    ->Arg(static_cast<int>(localize::TrackBy::beams));

/// The combined map takes a scan in.
void LocalizeCombine(benchmark::State& state) {
  const Map building = hospital();
  Turning robot(building);
  const localize::World world(building);
  localize::CombinedMap combined(world, building, {}, {});
  const localize::Sight sight = robot.at(3.0);
  const PoseEstimate pose{sight.robot_in_local, 1e-6 * Eigen::Matrix3d::Identity()};
  std::int64_t utime = sight.utime;
  for (auto _ : state) combined.add(pose, sight.ends, utime += kScanPeriod);
  state.counters["walls"] = static_cast<double>(world.faces().size());
}
BENCHMARK(LocalizeCombine);

/// With the way rigid, or that of so many places followed.
void LocalizeSearch(benchmark::State& state) {
  const Map building = hospital();
  Turning robot(building);
  const localize::World world(building);
  localize::SearchParameters parameters;
  parameters.followed = static_cast<int>(state.range(0));
  localize::Question question;
  for (int i = 0; i < 12; ++i) {
    const localize::Sight sight = robot.at(0.25 * i);
    question.keyframes.push_back(
        {sight.robot_in_local, localize::choose_beams(sight.ends, parameters.beams.beams)});
  }
  question.walls = localize::local_walls(building, 0);
  for (auto _ : state) benchmark::DoNotOptimize(localize::search(world, question, parameters));
}
BENCHMARK(LocalizeSearch)->ArgName("followed")->Arg(0)->Arg(30)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace perceptor
