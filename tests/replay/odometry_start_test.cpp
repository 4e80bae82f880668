/// Where the odometry happened to stand when the session began changes nothing.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <pico/map_t.hpp>
#include <pico/odometry_t.hpp>

#include "common/bus/channels.hpp"
#include "common/geometry/angle.hpp"
#include "common/messages/convert.hpp"
#include "common/runner/runner.hpp"
#include "tests/process/harness.hpp"
#include "tools/replay/pipeline.hpp"

namespace perceptor::test {
namespace {

/// The identified maps of a log whose odometry counts from `start` instead.
std::vector<pico::map_t> identified_from(const std::filesystem::path& log, const Position& start) {
  std::vector<pico::map_t> maps;
  Pipeline pipeline(load_pipeline_config(default_config_directory(), {}), 0,
                    [&](const std::string& channel, Pipeline::Bytes payload) {
                      if (channel != channel::identified_map) return;
                      pico::map_t map;
                      ASSERT_EQ(detail::decode(payload, map), "");
                      maps.push_back(map);
                    });
  LogReader reader(log);
  while (const auto event = reader.next()) {
    if (event->channel == channel::odometry) {
      pico::odometry_t odometry;
      EXPECT_EQ(detail::decode(event->data, odometry), "");
      odometry.robot_in_odometry = to_message(compose(start, to_model(odometry.robot_in_odometry)));
      pipeline.feed(event->channel, messages::encode(odometry));
    } else if (event->channel == channel::laser) {
      pipeline.feed(event->channel, event->data);
    }
  }
  return maps;
}

void expect_same(const pico::map_t& expected, const pico::map_t& actual) {
  constexpr double kTolerance = 1e-6;  // [m]
  ASSERT_EQ(actual.num_points, expected.num_points) << "at scan " << expected.seq;
  ASSERT_EQ(actual.num_objects, expected.num_objects) << "at scan " << expected.seq;
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    const auto& p = expected.points[i];
    const auto& q = actual.points[i];
    ASSERT_NEAR(q.x, p.x, kTolerance) << "at scan " << expected.seq;
    ASSERT_NEAR(q.y, p.y, kTolerance) << "at scan " << expected.seq;
    ASSERT_EQ(q.property, p.property);
    ASSERT_EQ(q.connected_point, p.connected_point);
    ASSERT_EQ(q.parents, p.parents);
  }
  for (std::size_t i = 0; i < expected.objects.size(); ++i) {
    ASSERT_EQ(actual.objects[i].type, expected.objects[i].type);
    ASSERT_EQ(actual.objects[i].points, expected.objects[i].points);
  }
}

TEST(OdometryStart, ChangesNothingAlsoWithTheHeadingAcrossPi) {
  const ScratchFolder scratch;
  const auto log = scratch / "drive.lcmlog";
  const Finished simulated =
      run({program("pico-bridge"), "--lcm-url", "file://" + log.string() + "?mode=w", "--world",
           "hospital", "--speed", "0", "--duration", "25", "--set", "session=1"});
  ASSERT_EQ(simulated.exit_code, 0) << simulated.output;

  // The hospital's tour starts by turning in place, so a heading close to pi is passed.
  const auto from_zero = identified_from(log, {});
  ASSERT_GT(from_zero.size(), 900U);
  for (const Position& start : {Position{-12.5, 80.25, std::numbers::pi - 0.01},
                                Position{300.0, -7.0, -std::numbers::pi / 2.0}}) {
    const auto from_start = identified_from(log, start);
    ASSERT_EQ(from_start.size(), from_zero.size());
    for (std::size_t i = 0; i < from_zero.size(); ++i) expect_same(from_zero[i], from_start[i]);
  }
}

}  // namespace
}  // namespace perceptor::test
