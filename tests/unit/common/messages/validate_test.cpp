#include "common/messages/validate.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/message_samples.hpp"

namespace perceptor::messages {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The reason for which a good message is turned down once it is edited.
template <class Message, class Edit>
std::string fault_after(Edit edit) {
  auto message = sample<Message>();
  edit(message);
  return std::string(validate(message));
}

template <class Message>
class Validate : public testing::Test {};

using Messages = testing::Types<pico::laser_scan_t, pico::odometry_t, pico::sonar_t,
                                pico::velocity_t, pico::open_door_t, pico::speak_t, pico::truth_t,
                                pico::position_t, pico::proximity_t, pico::map_t, pico::entrance_t,
                                pico::world_position_t, pico::status_t>;

struct TypeName {
  template <class Message>
  static std::string GetName(int) {
    return Message::getTypeName();
  }
};

TYPED_TEST_SUITE(Validate, Messages, TypeName);

TYPED_TEST(Validate, TakesAGoodMessage) { EXPECT_EQ(validate(sample<TypeParam>()), ""); }

TYPED_TEST(Validate, TakesNoTimeThatIsNone) {
  const auto fault_at = [](std::int64_t utime) {
    return fault_after<TypeParam>([utime](auto& m) { m.utime = utime; });
  };
  EXPECT_EQ(fault_at(0), "");
  EXPECT_EQ(fault_at(-1), "utime out of range");
  EXPECT_EQ(fault_at(std::numeric_limits<std::int64_t>::min()), "utime out of range");
  EXPECT_EQ(fault_at(std::numeric_limits<std::int64_t>::max()), "utime out of range");
}

TYPED_TEST(Validate, TakesNoSequenceNumberThatWasNeverCounted) {
  const auto fault_at = [](std::int64_t seq) {
    return fault_after<TypeParam>([seq](auto& m) { m.seq = seq; });
  };
  EXPECT_EQ(fault_at(0), "");
  EXPECT_EQ(fault_at(-1), "sequence number out of range");
  EXPECT_EQ(fault_at(std::numeric_limits<std::int64_t>::max()), "sequence number out of range");
}

/// Of one field of a message that is a number: what it may not be.
template <class Message, class Pick>
void expect_turned_down(Pick pick, const std::vector<double>& values, const char* reason) {
  for (const double value : values) {
    EXPECT_EQ(fault_after<Message>([&](Message& m) { pick(m) = value; }), reason) << value;
  }
}

const std::vector<double> kNoNumbers = {kNan, kInfinity, -kInfinity, 1e300};
const std::vector<double> kNoLengths = {kNan, kInfinity, -kInfinity, 1e300, -1.0};
const std::vector<double> kNoRatios = {kNan, kInfinity, -0.01, 1.01};

template <class Message, class Pick>
void expect_pose_is_checked(Pick pick, const char* reason) {
  expect_turned_down<Message>([&](Message& m) -> double& { return pick(m).x; }, kNoNumbers, reason);
  expect_turned_down<Message>([&](Message& m) -> double& { return pick(m).y; }, kNoNumbers, reason);
  expect_turned_down<Message>([&](Message& m) -> double& { return pick(m).a; }, kNoNumbers, reason);
}

using pico::laser_scan_t;

void set_beams(laser_scan_t& scan, std::int32_t beams) {
  scan.num_ranges = beams;
  scan.ranges.assign(static_cast<std::size_t>(beams), 1.0F);
  scan.angle_max = scan.angle_min + (beams - 1) * scan.angle_increment;
}

void make_irregular(laser_scan_t& scan, std::int32_t beams) {
  set_beams(scan, beams);
  scan.angle_min = scan.angle_max = scan.angle_increment = 0.0;
  scan.num_bearings = beams;
  scan.bearings.assign(static_cast<std::size_t>(beams), 0.5F);
}

TEST(ValidateScan, HasOneToTenThousandBeams) {
  const auto fault_of = [](std::int32_t beams) {
    return fault_after<laser_scan_t>([beams](auto& m) {
      m.angle_increment = 1e-4;
      set_beams(m, beams);
    });
  };
  EXPECT_EQ(fault_of(0), "no beams");
  EXPECT_EQ(fault_of(1), "");
  EXPECT_EQ(fault_of(10'000), "");
  EXPECT_EQ(fault_of(10'001), "too many beams");
}

TEST(ValidateScan, AnIrregularOneHasUpToSevenThousandBeams) {
  const auto fault_of = [](std::int32_t beams) {
    return fault_after<laser_scan_t>([beams](auto& m) { make_irregular(m, beams); });
  };
  EXPECT_EQ(fault_of(1), "");
  EXPECT_EQ(fault_of(7'000), "");
  EXPECT_EQ(fault_of(7'001), "too many beams");
}

TEST(ValidateScan, HasAsManyBeamsAsItsAnglesSay) {
  const char* reason = "number of beams does not match the angles";
  const auto fault_with = [](double angle_min, double angle_max, double angle_increment) {
    return fault_after<laser_scan_t>([=](auto& m) {
      m.angle_min = angle_min;
      m.angle_max = angle_max;
      m.angle_increment = angle_increment;
    });
  };
  EXPECT_EQ(fault_with(-0.2, 0.2, 0.1), "");
  EXPECT_EQ(fault_with(0.2, -0.2, -0.1), "") << "clockwise";
  EXPECT_EQ(fault_with(-0.2, 0.21, 0.1), "") << "rounded";
  EXPECT_EQ(fault_with(-0.2, 0.3, 0.1), reason);
  EXPECT_EQ(fault_with(-0.2, 0.1, 0.1), reason);
  EXPECT_EQ(fault_with(-0.2, 0.2, -0.1), reason);
  EXPECT_EQ(fault_with(-0.2, 0.2, 0.0), reason);
  EXPECT_EQ(fault_with(0.2, 0.2, 0.0), reason) << "one beam, where five came";
  EXPECT_EQ(fault_with(kNan, 0.2, 0.1), "angles out of range");
  EXPECT_EQ(fault_with(-0.2, kInfinity, 0.1), "angles out of range");
  EXPECT_EQ(fault_with(-0.2, 0.2, kNan), "angles out of range");
}

TEST(ValidateScan, HasAsManyBearingsAsRanges) {
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) {
              make_irregular(m, 5);
              m.num_bearings = 4;
              m.bearings.pop_back();
              m.bearings.pop_back();
              m.bearings.push_back(0.0F);
            }),
            "number of beams does not match the bearings");
}

TEST(ValidateScan, HasFiniteBearings) {
  for (const double bearing : kNoNumbers) {
    EXPECT_EQ(fault_after<laser_scan_t>([bearing](auto& m) {
                make_irregular(m, 5);
                m.bearings[3] = static_cast<float>(bearing);
              }),
              "bearing out of range");
  }
}

TEST(ValidateScan, MayHaveAnyRanges) {
  for (const float range : {std::numeric_limits<float>::quiet_NaN(), -1.0F, 0.0F, 81.91F,
                            std::numeric_limits<float>::infinity()})
    EXPECT_EQ(fault_after<laser_scan_t>([range](auto& m) { m.ranges.assign(5, range); }), "");
}

TEST(ValidateScan, HasAValidRangeThatIsOne) {
  const char* reason = "valid range out of range";
  expect_turned_down<laser_scan_t>([](auto& m) -> double& { return m.valid_min; }, kNoLengths,
                                   reason);
  expect_turned_down<laser_scan_t>([](auto& m) -> double& { return m.valid_max; }, kNoLengths,
                                   reason);
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { m.valid_min = m.valid_max; }), reason);
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { m.valid_min = 0.0; }), "");
}

TEST(ValidateScan, HasAPositiveSigma) {
  const auto sigma = [](auto& m) -> double& { return m.range_sigma; };
  expect_turned_down<laser_scan_t>(sigma, kNoLengths, "range_sigma out of range");
  expect_turned_down<laser_scan_t>(sigma, {0.0, 1e-300}, "range_sigma out of range");
}

TEST(ValidateScan, SweepsInUnderASecond) {
  const auto increment = [](auto& m) -> double& { return m.time_increment; };
  expect_turned_down<laser_scan_t>(increment, kNoLengths, "time_increment out of range");
  expect_turned_down<laser_scan_t>(increment, {0.25}, "time_increment out of range");
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { m.time_increment = 0.249; }), "");
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { m.time_increment = 0.0; }), "");
}

TEST(ValidateScan, HasALaserPose) {
  expect_pose_is_checked<laser_scan_t>(
      [](auto& m) -> auto& { return m.laser_in_robot; }, "laser_in_robot out of range");
}

TEST(ValidateOdometry, HasAPose) {
  expect_pose_is_checked<pico::odometry_t>(
      [](auto& m) -> auto& { return m.robot_in_odometry; }, "robot_in_odometry out of range");
}

TEST(ValidatePosition, HasTwoPosesAndANamedFrame) {
  using pico::position_t;
  expect_pose_is_checked<position_t>(
      [](auto& m) -> auto& { return m.zero_in_odometry; }, "zero_in_odometry out of range");
  expect_pose_is_checked<position_t>(
      [](auto& m) -> auto& { return m.robot_in_zero; }, "robot_in_zero out of range");
  EXPECT_EQ(fault_after<position_t>([](auto& m) { m.zero_utime = -1; }), "zero_utime out of range");
  EXPECT_EQ(fault_after<position_t>([](auto& m) { m.bridged = -1; }), "bridged is negative");
}

TEST(ValidateSonar, ChecksItsRing) {
  using pico::sonar_t;
  expect_pose_is_checked<sonar_t>(
      [](auto& m) -> auto& { return m.sonar_in_robot[1]; }, "sonar_in_robot out of range");
  expect_turned_down<sonar_t>([](auto& m) -> double& { return m.valid_max; }, kNoLengths,
                              "valid range out of range");
  expect_turned_down<sonar_t>([](auto& m) -> double& { return m.field_of_view; }, kNoLengths,
                              "field_of_view out of range");
  expect_turned_down<sonar_t>([](auto& m) -> double& { return m.field_of_view; }, {0.0},
                              "field_of_view out of range");
  EXPECT_EQ(fault_after<sonar_t>([](auto& m) { m.distances[0] = kNan; }), "") << "no return";
}

TEST(ValidateCommands, AreFiniteAndBounded) {
  using pico::velocity_t;
  for (double velocity_t::*field : {&velocity_t::vx, &velocity_t::vy, &velocity_t::va})
    expect_turned_down<velocity_t>([field](auto& m) -> double& { return m.*field; }, kNoNumbers,
                                   "velocity out of range");
  EXPECT_EQ(fault_after<pico::open_door_t>([](auto& m) { m.door = -2; }), "door out of range");
  EXPECT_EQ(fault_after<pico::speak_t>([](auto& m) { m.text.assign(1000, 'a'); }), "");
  EXPECT_EQ(fault_after<pico::speak_t>([](auto& m) { m.text.assign(1001, 'a'); }), "text too long");
}

TEST(ValidateTruth, ChecksDoorsAndMovers) {
  using pico::truth_t;
  expect_pose_is_checked<truth_t>(
      [](auto& m) -> auto& { return m.robot_in_world; }, "robot_in_world out of range");
  for (double truth_t::*field : {&truth_t::vx, &truth_t::vy, &truth_t::va})
    expect_turned_down<truth_t>([field](auto& m) -> double& { return m.*field; }, kNoNumbers,
                                "velocity out of range");
  using Door = pico::door_truth_t;
  for (double Door::*field : {&Door::x1, &Door::y1, &Door::x2, &Door::y2})
    expect_turned_down<truth_t>([field](auto& m) -> double& { return m.doors[1].*field; },
                                kNoNumbers, "door out of range");
  expect_turned_down<truth_t>([](auto& m) -> double& { return m.doors[0].open_ratio; }, kNoRatios,
                              "door out of range");
  using Mover = pico::mover_truth_t;
  for (double Mover::*field : {&Mover::x, &Mover::y, &Mover::vx, &Mover::vy})
    expect_turned_down<truth_t>([field](auto& m) -> double& { return m.movers[0].*field; },
                                kNoNumbers, "mover out of range");
  expect_turned_down<truth_t>([](auto& m) -> double& { return m.movers[0].radius; }, kNoLengths,
                              "mover out of range");
}

TEST(ValidateProximity, ChecksItsSectors) {
  using pico::proximity_t;
  const std::vector<double> no_distances = {kNan, -kInfinity, -1.0};
  expect_turned_down<proximity_t>([](auto& m) -> double& { return m.radius; }, kNoLengths,
                                  "radius out of range");
  expect_turned_down<proximity_t>([](auto& m) -> double& { return m.nearest_distance; },
                                  no_distances, "distance out of range");
  expect_turned_down<proximity_t>([](auto& m) -> double& { return m.distances[2]; }, no_distances,
                                  "distance out of range");
  expect_turned_down<proximity_t>([](auto& m) -> double& { return m.nearest_bearing; }, kNoNumbers,
                                  "bearing out of range");
  expect_turned_down<proximity_t>([](auto& m) -> double& { return m.bearings[0]; }, kNoNumbers,
                                  "bearing out of range");
  EXPECT_EQ(fault_after<proximity_t>([](auto& m) { m.nearest_distance = kInfinity; }), "");
  EXPECT_EQ(fault_after<proximity_t>([](auto& m) {
              m.num_sectors = 0;
              for (auto* booleans : {&m.too_close, &m.blind, &m.contact}) booleans->clear();
              for (auto* numbers : {&m.distances, &m.bearings}) numbers->clear();
            }),
            "no sectors");
}

TEST(ValidateEntrance, ChecksTheOpeningAndTheHallway) {
  using pico::entrance_t;
  for (double entrance_t::*field :
       {&entrance_t::middle_x, &entrance_t::middle_y, &entrance_t::direction})
    expect_turned_down<entrance_t>([field](auto& m) -> double& { return m.*field; }, kNoNumbers,
                                   "opening out of range");
  expect_turned_down<entrance_t>([](auto& m) -> double& { return m.width; }, kNoLengths,
                                 "opening out of range");
  expect_turned_down<entrance_t>([](auto& m) -> double& { return m.confidence; }, kNoRatios,
                                 "confidence out of range");
  for (double entrance_t::*field : {&entrance_t::centre_x1, &entrance_t::centre_y1,
                                    &entrance_t::centre_x2, &entrance_t::centre_y2})
    expect_turned_down<entrance_t>([field](auto& m) -> double& { return m.*field; }, kNoNumbers,
                                   "hallway out of range");
  expect_turned_down<entrance_t>([](auto& m) -> double& { return m.hallway_width; }, kNoLengths,
                                 "hallway out of range");
}

TEST(ValidateStatus, ChecksWhatItCounts) {
  using pico::status_t;
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.component.clear(); }),
            "component without a name");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.inputs[0].state = 3; }), "input out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.inputs[0].state = -1; }), "input out of range");
  using Input = pico::status_input_t;
  for (std::int64_t Input::*field :
       {&Input::received, &Input::rejected, &Input::missed, &Input::restarts, &Input::last_utime})
    EXPECT_EQ(fault_after<status_t>([field](auto& m) { m.inputs[0].*field = -1; }),
              "input out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.rejects[0].count = -1; }), "reject out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.outputs[0].published = -1; }),
            "output out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.outputs[0].last_seq = -2; }),
            "output out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.processed = -1; }),
            "processing time out of range");
  const std::vector<double> no_amounts = {kNan, kInfinity, -1.0};
  for (double status_t::*field : {&status_t::p50_us, &status_t::p99_us, &status_t::max_us})
    expect_turned_down<status_t>([field](auto& m) -> double& { return m.*field; }, no_amounts,
                                 "processing time out of range");
  EXPECT_EQ(fault_after<status_t>([](auto& m) { m.rss_bytes = -1; }),
            "memory or processor time out of range");
  expect_turned_down<status_t>([](auto& m) -> double& { return m.cpu_s; }, no_amounts,
                               "memory or processor time out of range");
}

TEST(Validate, ACountIsThatOfItsArray) {
  const char* reason = "count differs from the array";
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { ++m.num_ranges; }), reason);
  EXPECT_EQ(fault_after<laser_scan_t>([](auto& m) { ++m.num_bearings; }), reason);
  EXPECT_EQ(fault_after<pico::sonar_t>([](auto& m) { m.distances.clear(); }), reason);
  EXPECT_EQ(fault_after<pico::sonar_t>([](auto& m) { m.num_sonars = -1; }), reason);
  EXPECT_EQ(fault_after<pico::truth_t>([](auto& m) { --m.num_doors; }), reason);
  EXPECT_EQ(fault_after<pico::truth_t>([](auto& m) { ++m.num_movers; }), reason);
  EXPECT_EQ(fault_after<pico::proximity_t>([](auto& m) { m.blind.pop_back(); }), reason);
  EXPECT_EQ(fault_after<pico::proximity_t>([](auto& m) { m.bearings.pop_back(); }), reason);
  EXPECT_EQ(fault_after<pico::status_t>([](auto& m) { --m.num_inputs; }), reason);
  EXPECT_EQ(fault_after<pico::status_t>([](auto& m) { --m.num_rejects; }), reason);
  EXPECT_EQ(fault_after<pico::status_t>([](auto& m) { --m.num_outputs; }), reason);
}

}  // namespace
}  // namespace perceptor::messages
