#include "tools/eval/log_explanation.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/unit/tools/eval/walls.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kFirst = 10'000'000;
constexpr std::int64_t kPeriod = 100'000;

template <class Message>
LogEvent event(const std::string& channel, Message message, std::int64_t seq) {
  set_stamp(message, {kFirst + seq * kPeriod, 7, seq});
  return {0, 0, channel, messages::encode(message)};
}

/// Three beams ahead, all 2 m long; 0.05 s from beam to beam.
LogEvent scan(std::int64_t seq) {
  pico::laser_scan_t message{};
  message.time_increment = 0.05;
  message.angle_min = -0.1;
  message.angle_max = 0.1;
  message.angle_increment = 0.1;
  message.valid_min = 0.1;
  message.valid_max = 8.0;
  message.range_sigma = 0.01;
  message.num_ranges = 3;
  message.ranges = {2.0F, 2.0F, 2.0F};
  return event(channel::laser, message, seq);
}

/// Walls across, at these distances ahead; each was seen in this scan.
LogEvent map(const char* channel, std::int64_t seq, const std::vector<double>& ahead) {
  Map map;
  for (const double x : ahead)
    testing::add_wall(map, {{x, -1.0}, {x, 1.0}}, kFirst + seq * kPeriod);
  return event(channel, make_map_message("robot", map), seq);
}

/// Of a robot that drives ahead at 1.2 m/s.
LogEvent position(std::int64_t seq) {
  pico::position_t message{};
  message.zero_utime = kFirst;
  message.robot_in_zero.x = 1.2e-6 * static_cast<double>(seq * kPeriod);
  return event(channel::position, message, seq);
}

LogExplanation explain(const std::vector<LogEvent>& events, const LogExplainer::Sink& sink = {}) {
  LogExplainer explainer({}, sink);
  for (const LogEvent& event : events) explainer.take(event);
  return explainer.result();
}

TEST(LogExplanation, ComparesAScanWithItsTwoMaps) {
  const LogExplanation log =
      explain({scan(0), map(channel::current_map, 0, {2.0}), map(channel::local_map, 0, {5.0})});
  EXPECT_EQ(log.scans, 1);
  EXPECT_EQ(log.compared, 1);
  EXPECT_EQ(log.by_current.whole, 3);
  EXPECT_EQ(log.by_current.part, 3);
  EXPECT_EQ(log.by_local.whole, 3);
  EXPECT_EQ(log.by_local.part, 0);
  EXPECT_EQ(log.undecodable, 0);
}

TEST(LogExplanation, WhateverTheOrder) {
  const LogExplanation log = explain(
      {map(channel::local_map, 0, {2.0}), map(channel::current_map, 0, {2.0}), scan(0), scan(1),
       scan(2), map(channel::current_map, 2, {2.0}), map(channel::local_map, 2, {2.0})});
  EXPECT_EQ(log.scans, 3);
  EXPECT_EQ(log.compared, 2);
  EXPECT_EQ(log.by_local.part, 6);
}

TEST(LogExplanation, BeamsEndWhereTheLaserWasWhenItMeasuredThem) {
  // Each beam is measured 0.06 m further on: they end 1.99, 2.06 and 2.11 m ahead.
  const std::vector<LogEvent> maps = {scan(1), map(channel::current_map, 1, {2.0}),
                                      map(channel::local_map, 1, {2.1})};
  const LogExplanation standing = explain(maps);
  EXPECT_EQ(standing.moved, 0);
  EXPECT_EQ(standing.by_current.part, 3);

  std::vector<LogEvent> driving = {position(0), position(1), position(2)};
  driving.insert(driving.end(), maps.begin(), maps.end());
  const LogExplanation moved = explain(driving);
  EXPECT_EQ(moved.moved, 1);
  EXPECT_EQ(moved.by_current.part, 1);
  EXPECT_EQ(moved.by_local.part, 2);
}

TEST(LogExplanation, CountsDoubleWallsOfTheLocalMap) {
  std::vector<MapExplanation> each;
  const LogExplanation log = explain(
      {scan(0), map(channel::current_map, 0, {2.0, 2.1}), map(channel::local_map, 0, {2.0}),
       scan(1), map(channel::current_map, 1, {2.0}), map(channel::local_map, 1, {2.0, 2.1, 2.2})},
      [&](const MapExplanation& map) { each.push_back(map); });
  EXPECT_EQ(log.doubles, 3);
  EXPECT_EQ(log.most_doubles, 3U);
  EXPECT_EQ(log.maps_with_doubles, 1);
  ASSERT_EQ(each.size(), 2U);
  EXPECT_EQ(each[0].doubles, 0U);
  EXPECT_EQ(each[1].stamp.seq, 1);
  EXPECT_EQ(each[1].doubles, 3U);
}

TEST(LogExplanation, CountsWhatCannotBeDecoded) {
  LogEvent broken = scan(0);
  broken.data.pop_back();
  const LogExplanation log = explain({broken, map(channel::local_map, 0, {2.0})});
  EXPECT_EQ(log.undecodable, 1);
  EXPECT_EQ(log.scans, 0);
  EXPECT_EQ(log.local_maps, 1);
  EXPECT_EQ(log.compared, 0);
}

}  // namespace
}  // namespace perceptor
