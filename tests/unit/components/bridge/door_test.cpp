#include "components/bridge/sim/door.hpp"

#include <gtest/gtest.h>

namespace perceptor::sim {
namespace {

constexpr double tick = 0.01;  // [s]

DoorParameters door_of(DoorMode mode) {
  DoorParameters parameters;
  parameters.opening = {{1.0, 0.0}, {2.0, 0.0}};
  parameters.mode = mode;
  return parameters;
}

/// Lets time pass from `from` to `to` [s].
void wait(Door& door, double from, double to, bool occupied = false) {
  for (double time = from; time < to - (tick / 2); time += tick) door.advance(time, tick, occupied);
}

TEST(Door, OpenDoorHasNoLeaf) {
  Door door(door_of(DoorMode::open));
  wait(door, 0.0, 1.0);
  EXPECT_EQ(door.open_ratio(), 1.0);
  EXPECT_FALSE(door.leaf().has_value());
}

TEST(Door, ShutLeafIsFlushWithTheJambs) {
  Door door(door_of(DoorMode::shut));
  wait(door, 0.0, 1.0);
  ASSERT_TRUE(door.leaf().has_value());
  EXPECT_EQ(door.leaf()->a, Vector2(1.0, 0.0));
  EXPECT_EQ(door.leaf()->b, Vector2(2.0, 0.0));
  EXPECT_FALSE(door.request(1.0));
}

TEST(Door, RecessedLeafIsSetBackToTheLeft) {
  DoorParameters parameters = door_of(DoorMode::recessed);
  parameters.recess = 0.15;
  const Door door(parameters);
  EXPECT_NEAR(door.leaf()->a.y(), 0.15, 1e-12);
  EXPECT_NEAR(door.leaf()->b.y(), 0.15, 1e-12);
}

TEST(Door, OpensOverItsTravelTimeWhenAskedAndShutsAgain) {
  DoorParameters parameters = door_of(DoorMode::on_request);
  parameters.travel_time = 2.0;
  parameters.open_for = 5.0;
  Door door(parameters);
  wait(door, 0.0, 1.0);
  EXPECT_EQ(door.open_ratio(), 0.0);
  EXPECT_TRUE(door.request(1.0));
  wait(door, 1.0, 2.0);
  EXPECT_NEAR(door.open_ratio(), 0.5, 0.01);
  EXPECT_NEAR(door.leaf()->a.x(), 1.5, 0.01);  // the half by the first jamb is free
  wait(door, 2.0, 3.1);
  EXPECT_FALSE(door.leaf().has_value());
  wait(door, 3.1, 8.1);  // open for 5 s, then 2 s of shutting
  EXPECT_NEAR(door.open_ratio(), 0.0, 1e-9);
}

TEST(Door, DoesNotShutUponWhatStandsInIt) {
  DoorParameters parameters = door_of(DoorMode::on_request);
  parameters.open_for = 3.0;
  Door door(parameters);
  door.request(0.0);
  wait(door, 0.0, 2.5);
  wait(door, 2.5, 10.0, true);
  EXPECT_EQ(door.open_ratio(), 1.0);
  wait(door, 10.0, 12.1);
  EXPECT_NEAR(door.open_ratio(), 0.0, 1e-9);
}

TEST(Door, TimedDoorFollowsItsPeriod) {
  DoorParameters parameters = door_of(DoorMode::timed);
  parameters.travel_time = 1.0;
  parameters.open_for = 4.0;
  parameters.period = 10.0;
  Door door(parameters);
  for (const double period : {0.0, 10.0, 20.0}) {
    wait(door, period, period + 3.0);
    EXPECT_EQ(door.open_ratio(), 1.0);
    wait(door, period + 3.0, period + 10.0);
    EXPECT_NEAR(door.open_ratio(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace perceptor::sim
