#include "tools/convert/carmen_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/geometry/angle.hpp"
#include "common/messages/validate.hpp"
#include "tools/convert/words.hpp"

namespace perceptor {
namespace {

/// [m] What CARMEN itself assumes of a SICK whose line does not say.
constexpr double kSickRange = 80.0;

/// A laser does not move on its robot; two lines that differ by more mean another frame.
constexpr double kMountingTolerance = 0.05;  ///< [m] and [rad]

/// Known and of no use here: parameters, other sensors, other lasers, computed poses.
constexpr std::array<std::string_view, 20> kNotConverted = {
    "PARAM",        "SYNC",      "MARKER",      "TRUEPOS",        "SONAR",
    "BUMPER",       "IMU",       "VECTORMOVE",  "ROBOTVELOCITY",  "FOLLOWTRAJECTORY",
    "BASEVELOCITY", "RLASER",    "LASER1",      "LASER2",         "LASER3",
    "RAWLASER1",    "RAWLASER2", "ROBOTLASER2", "LASER_RELATIVE", "POS"};

bool is_not_converted(std::string_view keyword) {
  return std::ranges::find(kNotConverted, keyword) != kNotConverted.end() ||
         keyword.starts_with("GPS") || keyword.starts_with("NMEA");
}

/// Angles are not recorded in FLASER: CARMEN knows a SICK by its number of beams. Of an even
/// number the last beam was left out.
void guess_angles(ScanRecord& scan) {
  constexpr double degree = std::numbers::pi / 180.0;
  const std::size_t beams = scan.ranges.size();
  scan.angle_min = -90.0 * degree;
  if (beams == 180 || beams == 181) {
    scan.angle_increment = degree;
  } else if (beams == 360 || beams == 361) {
    scan.angle_increment = 0.5 * degree;
  } else if (beams == 400 || beams == 401) {
    scan.angle_min = -50.0 * degree;
    scan.angle_increment = 0.25 * degree;
  } else {
    const std::size_t steps = std::max<std::size_t>(beams, 2) - 1;
    scan.angle_increment = 180.0 * degree / static_cast<double>(steps);
  }
}

bool is_same_mounting(const Position& p, const Position& q) {
  return std::hypot(p.x - q.x, p.y - q.y) <= kMountingTolerance &&
         std::abs(angle_difference(p.a, q.a)) <= kMountingTolerance;
}

ParsedLine fault_of(const Words& words) {
  ParsedLine parsed;
  parsed.dropped = words.fault();
  return parsed;
}

/// The host's name and the logger's own time may be left out.
void skip_logger(Words& words) {
  words.word();
  words.word();
  words.end();
}

}  // namespace

bool is_carmen_keyword(std::string_view keyword) {
  return keyword == "ODOM" || keyword == "FLASER" || keyword == "ROBOTLASER1" ||
         is_not_converted(keyword);
}

ParsedLine CarmenLog::parse(std::string_view line) {
  const std::string_view keyword = Words(line).word();
  if (keyword.empty() || keyword.starts_with('#')) return {};
  if (keyword == "ODOM") return parse_odometry(line);
  if (keyword == "FLASER") return parse_front_laser(line);
  if (keyword == "ROBOTLASER1") return parse_robot_laser(line);
  ParsedLine parsed;
  parsed.dropped =
      Dropped{is_not_converted(keyword) ? drop_reason::not_converted : drop_reason::unknown_keyword,
              std::string(keyword.substr(0, 40))};
  return parsed;
}

ParsedLine CarmenLog::parse_odometry(std::string_view line) {
  Words words(line);
  words.word();
  OdometryRecord odometry;
  words.pose(odometry.robot_in_odometry);
  double speed = 0.0;
  double turn_rate = 0.0;
  double acceleration = 0.0;
  words.finite({&speed, &turn_rate, &acceleration});
  words.time(odometry.utime);
  skip_logger(words);
  if (!words.good()) return fault_of(words);
  has_odometry_lines_ = true;
  ParsedLine parsed;
  parsed.odometry = odometry;
  return parsed;
}

ParsedLine CarmenLog::parse_front_laser(std::string_view line) {
  Words words(line);
  words.word();
  ScanRecord scan;
  scan.range_max = kSickRange;
  scan.ranges = words.numbers(words.count(messages::kMaxBeams));
  Position laser;
  Position robot;
  words.pose(laser);
  words.pose(robot);
  words.time(scan.utime);
  skip_logger(words);
  if (!words.good()) return fault_of(words);
  guess_angles(scan);
  return finish_scan(std::move(scan), laser, robot);
}

ParsedLine CarmenLog::parse_robot_laser(std::string_view line) {
  Words words(line);
  words.word();
  ScanRecord scan;
  double type = 0.0;
  double field_of_view = 0.0;
  double accuracy = 0.0;
  double remission_mode = 0.0;
  words.finite({&type, &scan.angle_min, &field_of_view, &scan.angle_increment, &scan.range_max,
                &accuracy, &remission_mode});
  scan.ranges = words.numbers(words.count(messages::kMaxBeams));
  double remissions = 0.0;
  words.finite({&remissions});
  const bool is_count = remissions >= 0.0 && remissions <= double{messages::kMaxBeams};
  if (is_count) words.numbers(static_cast<std::size_t>(remissions));
  Position laser;
  Position robot;
  words.pose(laser);
  words.pose(robot);
  double speed = 0.0;
  double turn_rate = 0.0;
  double forward_safety = 0.0;
  double side_safety = 0.0;
  double turn_axis = 0.0;
  words.finite({&speed, &turn_rate, &forward_safety, &side_safety, &turn_axis});
  words.time(scan.utime);
  skip_logger(words);
  if (!words.good()) return fault_of(words);
  return finish_scan(std::move(scan), laser, robot);
}

ParsedLine CarmenLog::finish_scan(ScanRecord scan, const Position& laser, const Position& robot) {
  const Position laser_in_robot = relative(robot, laser);
  if (!laser_in_robot_) laser_in_robot_ = laser_in_robot;
  if (!is_same_mounting(*laser_in_robot_, laser_in_robot)) ++other_mountings_;
  scan.laser_in_robot = *laser_in_robot_;
  ParsedLine parsed;
  if (!has_odometry_lines_) parsed.odometry = OdometryRecord{scan.utime, robot};
  parsed.scan = std::move(scan);
  return parsed;
}

std::vector<std::string> CarmenLog::notes() const {
  std::vector<std::string> notes;
  if (!has_odometry_lines_ && laser_in_robot_)
    notes.emplace_back("no ODOM lines: the robot's pose in each scan line is its odometry");
  if (other_mountings_ > 0)
    notes.push_back(std::to_string(other_mountings_) +
                    " scans see the laser elsewhere on the robot than the first (a corrected "
                    "log?): the first counts");
  return notes;
}

}  // namespace perceptor
