#include "components/viewer/newest.hpp"

#include <gmock/gmock.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::viewer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kSecond = kMicrosecondsPerSecond;

pico::position_t position(std::int64_t utime, const Position& robot_in_zero,
                          std::int64_t session = 1) {
  pico::position_t message{};
  set_stamp(message, {utime, session, 0});
  message.robot_in_zero = to_message(robot_in_zero);
  return message;
}

pico::laser_scan_t scan(std::int64_t utime) {
  pico::laser_scan_t message{};
  set_stamp(message, {utime, 1, 0});
  message.angle_min = -0.1;
  message.angle_max = 0.1;
  message.angle_increment = 0.1;
  message.valid_max = 10.0;
  message.ranges = {2.0F, 2.0F, 2.0F};
  message.num_ranges = 3;
  return message;
}

pico::map_t wall_map(const char* frame, std::int64_t utime, const Position& robot_in_local = {}) {
  Map map;
  add_segment(map, {{1.0, -1.0}, {1.0, 1.0}}, ObjectType::wall);
  pico::map_t message = make_map_message(frame, map);
  set_stamp(message, {utime, 1, 0});
  message.robot_in_zero = message.robot_in_local = to_message(robot_in_local);
  return message;
}

pico::world_position_t place(std::int64_t utime, std::int8_t state, const Position& robot) {
  pico::world_position_t message{};
  set_stamp(message, {utime, 1, 0});
  message.state = state;
  message.robot_in_world = to_message(robot);
  return message;
}

TEST(Newest, SaysThatNothingHasCome) {
  const Scene scene = Newest().scene();
  EXPECT_THAT(scene.notes, Contains(HasSubstr("nothing has come yet")));
  for (const LayerScene& layer : scene.layers) EXPECT_THAT(layer.items, IsEmpty());
}

TEST(Newest, ALaserAloneIsShownAroundTheRobot) {
  Newest newest;
  newest.take(scan(kSecond));
  const Scene shown = newest.scene();
  EXPECT_EQ(shown.frame, SceneFrame::robot);
  EXPECT_EQ(shown.utime, kSecond);
  EXPECT_EQ(shown[Layer::beams].items.size(), 2U);
  EXPECT_THAT(shown.notes, IsEmpty());
}

TEST(Newest, AMapOfTheRobotFrameIsLaidWhereTheRobotWas) {
  Newest newest;
  newest.take(channel::local_map, wall_map("robot", kSecond, {10.0, 0.0, 0.0}));
  const Scene shown = newest.scene();
  EXPECT_EQ(shown.frame, SceneFrame::local);
  EXPECT_EQ(shown[Layer::local_map].items.at(0).points.at(0), Vector2(11.0, -1.0));
}

TEST(Newest, TheBuildingIsShownAloneOrWhereTheRobotIsFoundInIt) {
  Newest newest;
  newest.take(channel::global_map, wall_map("world", 99 * kSecond));
  EXPECT_EQ(newest.scene()[Layer::global_map].items.size(), 1U);

  newest.take(position(kSecond, {}));
  newest.take(place(kSecond, pico::world_position_t::SEARCHING, {}));
  EXPECT_THAT(newest.scene()[Layer::global_map].items, IsEmpty());
  EXPECT_THAT(newest.scene().notes, Contains(HasSubstr("searching for the robot")));

  newest.take(channel::local_map, wall_map("robot", 2 * kSecond));
  newest.take(place(2 * kSecond, pico::world_position_t::TRACKING, {3.0, 4.0, 0.0}));
  const Scene shown = newest.scene();
  EXPECT_EQ(shown.frame, SceneFrame::world);
  EXPECT_EQ(shown[Layer::global_map].items.size(), 1U);
  EXPECT_EQ(shown.robot_in_scene.location(), Vector2(3.0, 4.0));
}

TEST(Newest, AllPartsOfAMapAreShown) {
  Newest newest;
  for (std::int32_t part = 0; part < 2; ++part) {
    pico::map_t message = wall_map("world", kSecond + part);
    message.map_id = 5;
    message.part = part;
    message.parts = 2;
    newest.take(channel::global_map, message);
  }
  EXPECT_EQ(newest.scene()[Layer::global_map].items.size(), 2U);
}

TEST(Newest, TheTrailIsThinned) {
  Newest newest({.trail_step = 0.5, .trail_points = 3});
  for (int i = 0; i < 100; ++i) newest.take(position(kSecond + i, {0.1 * i, 0.0, 0.0}));
  const std::vector<Item> trail = newest.scene()[Layer::trail].items;
  ASSERT_EQ(trail.size(), 1U);
  EXPECT_EQ(trail[0].points.size(), 3U);
  EXPECT_GE(distance(trail[0].points[0], trail[0].points[1]), 0.5);
}

TEST(Newest, ANewSessionForgetsAllButTheBuilding) {
  Newest newest;
  newest.take(channel::global_map, wall_map("world", 99 * kSecond));
  newest.take(position(kSecond, {1.0, 0.0, 0.0}, 1));
  newest.take(channel::local_map, wall_map("robot", kSecond));
  newest.take(position(2 * kSecond, {}, 2));
  EXPECT_THAT(newest.scene()[Layer::local_map].items, IsEmpty());
  newest.take(place(2 * kSecond, pico::world_position_t::TRACKING, {}));
  newest.take(channel::local_map, wall_map("robot", 2 * kSecond));
  EXPECT_EQ(newest.scene()[Layer::global_map].items.size(), 1U);
}

TEST(Newest, ALogThatBeginsAnewIsANewSession) {
  Newest newest;
  newest.take(position(100 * kSecond, {1.0, 0.0, 0.0}));
  newest.take(channel::current_map, wall_map("robot", 100 * kSecond));
  newest.take(position(kSecond, {}));
  EXPECT_THAT(newest.scene()[Layer::current_map].items, IsEmpty());
}

TEST(Newest, AChannelThatIsLateIsNoNewBeginning) {
  Newest newest;
  for (int i = 0; i < 50; ++i) newest.take(position(i * kSecond / 10, {0.2 * i, 0.0, 0.0}));
  newest.take(channel::local_map, wall_map("robot", kSecond));
  EXPECT_EQ(newest.scene()[Layer::trail].items.at(0).points.size(), 50U);
}

TEST(Newest, AnotherZeroFrameIsANewBeginning) {
  Newest newest;
  newest.take(position(kSecond, {9.0, 0.0, 0.0}));
  newest.take(channel::local_map, wall_map("robot", kSecond, {9.0, 0.0, 0.0}));
  pico::position_t restarted = position(2 * kSecond, {});
  restarted.zero_utime = 2 * kSecond;
  newest.take(restarted);
  EXPECT_THAT(newest.scene()[Layer::local_map].items, IsEmpty());
  newest.take(channel::local_map, wall_map("robot", 2 * kSecond, {9.0, 0.0, 0.0}));
  EXPECT_THAT(newest.scene()[Layer::local_map].items, IsEmpty()) << "still of the zero before";
}

TEST(Newest, APartOfManyTakesNoMoreThanItself) {
  Newest newest;
  pico::map_t message = wall_map("robot", kSecond);
  message.part = 7;
  message.parts = 1'000'000'000;
  newest.take(channel::local_map, message);
  EXPECT_EQ(newest.scene()[Layer::local_map].items.size(), 1U);
}

TEST(Newest, TellsOfAChannelThatStopped) {
  Newest newest;
  newest.take(channel::local_map, wall_map("robot", kSecond));
  newest.take(scan(kSecond));
  newest.take(position(5 * kSecond, {}));
  EXPECT_THAT(newest.scene().notes, Contains(HasSubstr("LOCAL_MAP is 4 s old")));
}

TEST(Newest, TheSameMessagesGiveTheSamePictureInAnyOrderOfChannels) {
  Newest one;
  one.take(scan(kSecond));
  one.take(position(kSecond, {1.0, 0.0, 0.0}));
  one.take(channel::local_map, wall_map("robot", kSecond, {1.0, 0.0, 0.0}));
  Newest other;
  other.take(channel::local_map, wall_map("robot", kSecond, {1.0, 0.0, 0.0}));
  other.take(position(kSecond, {1.0, 0.0, 0.0}));
  other.take(scan(kSecond));
  for (std::size_t i = 0; i < kLayers; ++i) {
    EXPECT_EQ(one.scene().layers[i].frame_in_scene, other.scene().layers[i].frame_in_scene);
    EXPECT_EQ(one.scene().layers[i].items.size(), other.scene().layers[i].items.size());
  }
}

}  // namespace
}  // namespace perceptor::viewer
