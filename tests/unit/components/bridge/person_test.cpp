#include "components/bridge/sim/person.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace perceptor::sim {
namespace {

constexpr double tick = 0.005;  // [s]
const Vector2 far_away{100.0, 100.0};

PersonParameters walker() {
  PersonParameters parameters;
  parameters.path = {{0.0, 0.0}, {4.0, 0.0}};
  parameters.speed = 1.0;
  return parameters;
}

Person person_of(const PersonParameters& parameters) {
  Random gait = make_stream(1, Stream::gait);
  return {parameters, gait};
}

void walk(Person& person, double seconds, const Vector2& robot = far_away) {
  for (double time = 0.0; time < seconds - (tick / 2); time += tick) person.advance(tick, robot);
}

TEST(Person, WalksThereAndBackAtTheirSpeed) {
  Person person = person_of(walker());
  walk(person, 2.0);
  EXPECT_NEAR(person.body().centre.x(), 2.0, 0.01);
  EXPECT_NEAR(person.velocity().x(), 1.0, 1e-9);
  walk(person, 4.0);
  EXPECT_NEAR(person.body().centre.x(), 2.0, 0.02);
  EXPECT_NEAR(person.velocity().x(), -1.0, 1e-9);
  walk(person, 4.0);
  EXPECT_NEAR(person.velocity().x(), 1.0, 1e-9);
}

TEST(Person, WaitsForARobotAheadAndTurnsBackAtLast) {
  Person person = person_of(walker());
  const Vector2 robot{2.0, 0.0};
  walk(person, 2.0, robot);
  EXPECT_NEAR(person.body().centre.x(), 1.0, 0.01);  // waits_within 1 m
  EXPECT_EQ(person.velocity(), Vector2(0.0, 0.0));
  walk(person, 2.5, robot);  // 3 s of patience
  EXPECT_LT(person.body().centre.x(), 0.9);
}

TEST(Person, TurnsBackOnAWayPointToo) {
  PersonParameters parameters = walker();
  parameters.path = {{0.0, 0.0}, {2.0, 0.0}, {4.0, 0.0}};
  Person person = person_of(parameters);
  const Vector2 way_point{2.0, 0.0};
  for (int i = 0; i < 1000 && person.body().centre != way_point; ++i) walk(person, tick);
  ASSERT_EQ(person.body().centre, way_point);
  walk(person, 4.0, {2.5, 0.0});
  EXPECT_LT(person.body().centre.x(), 1.1);
}

TEST(Person, AtTheEndOfThePathThereIsNowhereToTurn) {
  Person person = person_of(walker());
  walk(person, 10.0, {0.5, 0.0});
  EXPECT_EQ(person.body().centre, Vector2(0.0, 0.0));
  walk(person, 1.0);
  EXPECT_NEAR(person.body().centre.x(), 1.0, 0.01);
}

TEST(Person, DoesNotCareForARobotBehind) {
  Person person = person_of(walker());
  walk(person, 2.0, {-0.3, 0.0});
  EXPECT_NEAR(person.body().centre.x(), 2.0, 0.01);
}

TEST(Person, LegsStandApartAndSwing) {
  Person person = person_of(walker());
  double farthest_ahead = 0.0;
  for (int i = 0; i < 400; ++i) {
    person.advance(tick, far_away);
    const auto legs = person.legs();
    ASSERT_EQ(legs.size(), 2U);
    EXPECT_NEAR(legs[0].centre.y() - legs[1].centre.y(), 0.3, 1e-9);
    EXPECT_EQ(legs[0].radius, 0.09);
    farthest_ahead = std::max(farthest_ahead, legs[0].centre.x() - person.body().centre.x());
  }
  EXPECT_NEAR(farthest_ahead, 0.3, 0.01);
}

TEST(Person, MayBeSeenAsOneBody) {
  PersonParameters parameters = walker();
  parameters.two_legs = false;
  const Person person = person_of(parameters);
  ASSERT_EQ(person.legs().size(), 1U);
  EXPECT_EQ(person.legs()[0].radius, parameters.radius);
}

TEST(Person, StandsOnASinglePoint) {
  PersonParameters parameters = walker();
  parameters.path = {{1.0, 2.0}};
  Person person = person_of(parameters);
  walk(person, 5.0);
  EXPECT_EQ(person.body().centre, Vector2(1.0, 2.0));
}

}  // namespace
}  // namespace perceptor::sim
