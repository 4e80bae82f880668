#include "components/bridge/sim/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

constexpr std::int64_t second = 1'000'000;

/// Everything that a while of simulation measured.
struct Record {
  std::vector<OdometryReading> odometry;
  std::vector<Sweep> sweeps;
  std::vector<std::int64_t> completed;  ///< of both, in the order of coming
};

void add(Record& record, const OdometryReading& reading) {
  record.odometry.push_back(reading);
  record.completed.push_back(reading.utime);
}

void add(Record& record, const Sweep& sweep) {
  record.sweeps.push_back(sweep);
  record.completed.push_back(sweep.completed);
}

Record run(Simulator& simulator, double seconds) {
  Record record;
  const auto end = simulator.utime() + static_cast<std::int64_t>(seconds * 1e6);
  while (simulator.utime() < end)
    for (const Measurement& measurement : simulator.advance())
      std::visit([&](const auto& measured) { add(record, measured); }, measurement);
  return record;
}

Record run(const SimulatorParameters& parameters, double seconds) {
  Simulator simulator(parameters);
  return run(simulator, seconds);
}

bool same_bytes(const std::vector<float>& p, const std::vector<float>& q) {
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(float)) == 0;
}

/// A tour in the room, with slip and noise, boxes and a person.
SimulatorParameters lively() {
  SimulatorParameters parameters = exact_simulator();
  parameters.drive = Drive::automatic;
  parameters.tour.points = {{{2.0, 0.0}}, {{2.0, 2.0}, 1.0}, {{-2.0, 1.0}}};
  parameters.odometry = {};
  parameters.odometry.start_in_odometry = {5.0, 5.0, 3.1};
  parameters.laser.noise_sigma = 0.01;
  parameters.laser.missed = 0.01;
  parameters.laser.missed_value = MissedValue::nan;
  parameters.world.boxes = {{{-3.0, -3.0, 0.3}, 0.5, 0.4}};
  PersonParameters person;
  person.path = {{-3.0, 3.0}, {3.0, 3.0}};
  parameters.world.people = {person};
  return parameters;
}

TEST(Simulator, MeasurementsComeAtTheirRatesWithoutDrift) {
  SimulatorParameters parameters = exact_simulator();
  parameters.laser.beams = 10;
  parameters.laser.rate = 30.0;  // 33 333.3 us apart
  const Record record = run(parameters, 100.0);
  ASSERT_EQ(record.odometry.size(), 5001U);
  ASSERT_GE(record.sweeps.size(), 2999U);
  EXPECT_EQ(record.odometry.front().utime, second);
  EXPECT_EQ(record.odometry.back().utime, 101 * second);
  for (std::size_t i = 0; i < record.sweeps.size(); ++i)
    EXPECT_EQ(record.sweeps[i].utime, second + std::llround(static_cast<double>(i) * 1e6 / 30.0));
}

TEST(Simulator, MeasurementsComeInTheOrderOfCompletion) {
  const Record record = run(lively(), 5.0);
  EXPECT_TRUE(std::is_sorted(record.completed.begin(), record.completed.end()));
  for (const Sweep& sweep : record.sweeps) EXPECT_EQ(sweep.completed - sweep.utime, 20'000);
}

TEST(Simulator, KnowsWhenTheNextMeasurementIsDue) {
  Simulator simulator(exact_simulator());
  for (int i = 0; i < 500; ++i) {
    const std::int64_t due = simulator.next_due();
    const auto measured = simulator.advance();
    EXPECT_EQ(measured.empty(), simulator.utime() < due);
  }
}

TEST(Simulator, StandingRobotSeesTheRoomAsItIs) {
  const Record record = run(exact_simulator(), 1.0);
  EXPECT_EQ(record.sweeps.size(), 40U);
  for (const Sweep& sweep : record.sweeps) {
    // Beams 500 of 1000 over [-2, 2] lies half a step left of straight ahead.
    EXPECT_NEAR(sweep.ranges[500], 4.0 / std::cos(0.5 * 4.0 / 999.0), 1e-5);
    EXPECT_EQ(sweep.truth.robot_in_world, Position{});
  }
}

TEST(Simulator, TurningRobotsSweepIsTheOneOfEachBeamsTime) {
  SimulatorParameters parameters = exact_simulator();
  Simulator simulator(parameters);
  Record record;
  for (int i = 0; i < 100; ++i) {
    simulator.command({0.0, 0.0, 1.2}, {});
    record = run(simulator, 0.025);
  }
  ASSERT_EQ(record.sweeps.size(), 1U);
  const Sweep& sweep = record.sweeps[0];
  EXPECT_NEAR(sweep.truth.twist.va, 1.2, 1e-9);
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    const double share = static_cast<double>(i) / 999.0;
    const double heading = sweep.truth.robot_in_world.a + (1.2 * 0.02 * share);
    const double bearing = heading - 2.0 + (4.0 * share);
    const double range = 4.0 / std::max(std::abs(std::cos(bearing)), std::abs(std::sin(bearing)));
    EXPECT_NEAR(sweep.ranges[i], range, 1e-5);
  }
}

TEST(Simulator, TruthBelongsToTheFirstBeam) {
  SimulatorParameters parameters = exact_simulator();
  parameters.laser.rate = 37.0;  // first beams within ticks
  Simulator simulator(parameters);
  for (int i = 0; i < 100; ++i) {
    simulator.command({0.4, 0.0, 0.0}, {});
    for (const Sweep& sweep : run(simulator, 0.02).sweeps) {
      if (i < 50) continue;  // speeding up
      const double straight_ahead = sweep.ranges[500] * std::cos(0.5 * 4.0 / 999.0);
      const double driven_until_beam = 0.4 * 500.0 * 0.02 / 999.0;
      EXPECT_NEAR(4.0 - straight_ahead - driven_until_beam, sweep.truth.robot_in_world.x, 1e-5);
    }
  }
}

TEST(Simulator, OdometryStartsAwayFromZeroAndWraps) {
  SimulatorParameters parameters = exact_simulator();
  parameters.odometry.start_in_odometry = {1.2, -0.7, 3.1};
  Simulator simulator(parameters);
  Record record;
  for (int i = 0; i < 20; ++i) {
    simulator.command({0.0, 0.0, 1.0}, {});
    for (const OdometryReading& reading : run(simulator, 0.1).odometry) add(record, reading);
  }
  EXPECT_EQ(record.odometry.front().robot_in_odometry, (Position{1.2, -0.7, 3.1}));
  const double turned = simulator.truth().robot_in_world.a;
  EXPECT_GT(turned, 1.5);
  EXPECT_NEAR(record.odometry.back().robot_in_odometry.a, 3.1 + turned - (2.0 * std::numbers::pi),
              1e-9);
}

TEST(Simulator, ExactWheelsGiveTheTrueMotion) {
  SimulatorParameters parameters = lively();
  parameters.odometry = exact_wheels();
  parameters.odometry.start_in_odometry = {1.0, 2.0, 0.5};
  Simulator simulator(parameters);
  const Record record = run(simulator, 20.0);
  const Position expected =
      compose(parameters.odometry.start_in_odometry, simulator.truth().robot_in_world);
  const Position& read = record.odometry.back().robot_in_odometry;
  EXPECT_NEAR(read.x, expected.x, 1e-9);
  EXPECT_NEAR(read.y, expected.y, 1e-9);
  EXPECT_NEAR(read.a, expected.a, 1e-9);
}

TEST(Simulator, SameSeedSameBytes) {
  const Record first = run(lively(), 10.0);
  const Record second_run = run(lively(), 10.0);
  ASSERT_EQ(first.sweeps.size(), second_run.sweeps.size());
  for (std::size_t i = 0; i < first.sweeps.size(); ++i)
    EXPECT_TRUE(same_bytes(first.sweeps[i].ranges, second_run.sweeps[i].ranges));
  for (std::size_t i = 0; i < first.odometry.size(); ++i)
    EXPECT_EQ(first.odometry[i].robot_in_odometry, second_run.odometry[i].robot_in_odometry);
}

TEST(Simulator, AnotherSeedIsAnotherNoise) {
  SimulatorParameters other = lively();
  other.seed = 2;
  const Record first = run(lively(), 1.0);
  const Record second_run = run(other, 1.0);
  EXPECT_FALSE(same_bytes(first.sweeps[0].ranges, second_run.sweeps[0].ranges));
}

TEST(Simulator, SwitchingTheLasersNoiseOffLeavesTheDriveAlone) {
  SimulatorParameters quiet = lively();
  quiet.laser.noise_sigma = 0.0;
  quiet.laser.missed = 0.0;
  const Record noisy_run = run(lively(), 10.0);
  const Record quiet_run = run(quiet, 10.0);
  ASSERT_EQ(noisy_run.odometry.size(), quiet_run.odometry.size());
  for (std::size_t i = 0; i < noisy_run.odometry.size(); ++i)
    EXPECT_EQ(noisy_run.odometry[i].robot_in_odometry, quiet_run.odometry[i].robot_in_odometry);
  for (std::size_t i = 0; i < noisy_run.sweeps.size(); ++i)
    EXPECT_EQ(noisy_run.sweeps[i].truth.robot_in_world, quiet_run.sweeps[i].truth.robot_in_world);
}

TEST(Simulator, CommandOlderThanThreeTenthsStopsTheRobot) {
  Simulator simulator(exact_simulator());
  simulator.command({0.5, 0.0, 0.0}, {});
  run(simulator, 0.3);
  EXPECT_GT(simulator.truth().twist.vx, 0.25);
  run(simulator, 0.5);
  EXPECT_EQ(simulator.truth().twist.vx, 0.0);
}

TEST(Simulator, AgeCountsFromTheMeasurementThatTheCommandRestsOn) {
  Simulator simulator(exact_simulator());
  run(simulator, 1.0);
  simulator.command({0.5, 0.0, 0.0}, simulator.utime() - 310'000);
  run(simulator, 0.2);
  EXPECT_EQ(simulator.truth().twist.vx, 0.0);
  simulator.command({0.5, 0.0, 0.0}, simulator.utime() - 200'000);
  run(simulator, 0.1);
  EXPECT_GT(simulator.truth().twist.vx, 0.0);
  // A stamp from the future is worth no more than the present.
  simulator.command({0.5, 0.0, 0.0}, simulator.utime() + (100 * second));
  run(simulator, 1.0);
  EXPECT_EQ(simulator.truth().twist.vx, 0.0);
}

TEST(Simulator, TourDrivesUntilTheFirstCommand) {
  Simulator simulator(lively());
  run(simulator, 2.0);
  EXPECT_GT(simulator.truth().robot_in_world.x, 0.5);
  simulator.command({}, {});
  run(simulator, 5.0);
  const Position stopped = simulator.truth().robot_in_world;
  run(simulator, 5.0);
  EXPECT_EQ(simulator.truth().robot_in_world, stopped);
}

TEST(Simulator, TourThatIsToldToDoesNotListenToCommands) {
  SimulatorParameters parameters = lively();
  parameters.drive = Drive::tour;
  Simulator simulator(parameters);
  simulator.command({}, {});
  run(simulator, 3.0);
  EXPECT_GT(simulator.truth().robot_in_world.x, 0.5);
}

TEST(Simulator, WithoutACommandTheCommandedRobotStands) {
  Simulator simulator(exact_simulator());
  run(simulator, 2.0);
  EXPECT_EQ(simulator.truth().robot_in_world, Position{});
}

/// Two doors in front of the robot: a shut one, and behind it one that opens when asked.
SimulatorParameters with_doors() {
  SimulatorParameters parameters = exact_simulator();
  DoorParameters near;
  near.opening = {{1.0, -0.5}, {1.0, 0.5}};
  near.mode = DoorMode::on_request;
  near.travel_time = 1.0;
  near.open_for = 3.0;
  DoorParameters far = near;
  far.opening = {{3.0, -0.5}, {3.0, 0.5}};
  DoorParameters shut = near;
  shut.opening = {{-0.5, 1.0}, {0.5, 1.0}};
  shut.mode = DoorMode::shut;
  parameters.world.doors = {shut, far, near};
  return parameters;
}

double straight_ahead(const Record& record) { return record.sweeps.back().ranges[500]; }

TEST(Simulator, DoorOpensForTheLaserAndForTheTruth) {
  Simulator simulator(with_doors());
  EXPECT_NEAR(straight_ahead(run(simulator, 0.5)), 1.0, 1e-4);
  EXPECT_TRUE(simulator.request_door({}));  // the nearest of those that can
  EXPECT_NEAR(straight_ahead(run(simulator, 1.5)), 3.0, 1e-4);
  EXPECT_EQ(simulator.truth().doors[2].open_ratio, 1.0);
  EXPECT_EQ(simulator.truth().doors[1].open_ratio, 0.0);
  EXPECT_NEAR(straight_ahead(run(simulator, 3.0)), 1.0, 1e-4);
}

TEST(Simulator, DoorStopsTheRobotUntilItIsOpen) {
  Simulator simulator(with_doors());
  const auto drive = [&](double seconds) {
    for (double time = 0.0; time < seconds; time += 0.1) {
      simulator.command({0.5, 0.0, 0.0}, {});
      run(simulator, 0.1);
    }
  };
  drive(3.0);
  EXPECT_LT(simulator.truth().robot_in_world.x, 0.8);
  EXPECT_TRUE(simulator.truth().in_collision);
  EXPECT_TRUE(simulator.request_door(2));
  drive(2.5);
  EXPECT_GT(simulator.truth().robot_in_world.x, 0.9);
}

TEST(Simulator, OnlyDoorsThatOpenOnRequestTakeARequest) {
  Simulator simulator(with_doors());
  EXPECT_FALSE(simulator.request_door(0));
  EXPECT_FALSE(simulator.request_door(3));
  EXPECT_FALSE(simulator.request_door(-5));
  Simulator without_doors(exact_simulator());
  EXPECT_FALSE(without_doors.request_door({}));
}

TEST(Simulator, PersonWalkingByIsSeenAndTold) {
  SimulatorParameters parameters = exact_simulator();
  PersonParameters person;
  person.path = {{2.0, -3.0}, {2.0, 3.0}};
  person.speed = 1.0;
  person.two_legs = false;
  parameters.world.people = {person};
  Simulator simulator(parameters);
  const Record record = run(simulator, 3.05);
  const Sweep& sweep = record.sweeps.back();
  ASSERT_EQ(sweep.truth.movers.size(), 1U);
  const MoverState& mover = sweep.truth.movers[0];
  EXPECT_NEAR(mover.velocity.y(), 1.0, 1e-9);
  EXPECT_NEAR(mover.body.centre.y(), 0.0, 0.06);
  EXPECT_NEAR(sweep.ranges[500], 2.0 - 0.25, 0.02);
}

TEST(Simulator, BoxStandsInTheWay) {
  SimulatorParameters parameters = exact_simulator();
  parameters.world.boxes = {{{2.0, 0.0, 0.0}, 0.5, 0.5}};
  EXPECT_NEAR(straight_ahead(run(parameters, 0.1)), 1.75, 1e-4);
}

TEST(Simulator, SweepOfNoTimeAtAFarHigherRateThanTheTick) {
  SimulatorParameters parameters = exact_simulator();
  parameters.laser.beams = 5;
  parameters.laser.sweep_time = 0.0;
  parameters.laser.rate = 1000.0;
  const Record record = run(parameters, 1.0);
  EXPECT_EQ(record.sweeps.size(), 1000U);
  EXPECT_TRUE(std::is_sorted(record.completed.begin(), record.completed.end()));
}

}  // namespace
}  // namespace perceptor::sim
