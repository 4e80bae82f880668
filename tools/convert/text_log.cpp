#include "tools/convert/text_log.hpp"

#include <utility>

#include "common/messages/validate.hpp"
#include "tools/convert/words.hpp"

namespace perceptor {
namespace {

ParsedLine dropped(std::string_view reason, std::string_view detail) {
  ParsedLine parsed;
  parsed.dropped = Dropped{reason, std::string(detail.substr(0, 40))};
  return parsed;
}

ParsedLine parse_odometry(std::string_view line) {
  Words words(line);
  words.word();
  OdometryRecord odometry;
  words.time(odometry.utime);
  words.pose(odometry.robot_in_odometry);
  words.end();
  ParsedLine parsed;
  if (words.good())
    parsed.odometry = odometry;
  else
    parsed.dropped = words.fault();
  return parsed;
}

/// bearing, range, bearing, range ... becomes two lists.
void split_pairs(const std::vector<float>& pairs, ScanRecord& scan) {
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    scan.bearings.push_back(pairs[i]);
    scan.ranges.push_back(pairs[i + 1]);
  }
}

}  // namespace

ParsedLine TextLog::parse(std::string_view line) {
  const std::string_view keyword = Words(line).word();
  if (keyword.empty()) return {};
  if (keyword.starts_with('#')) return parse_header(line.substr(line.find('#') + 1));
  in_header_ = false;
  if (keyword == "ODOM") return parse_odometry(line);
  if (keyword == "LASER") return parse_scan(line, false);
  if (keyword == "LASERA") return parse_scan(line, true);
  return dropped(drop_reason::unknown_keyword, keyword);
}

ParsedLine TextLog::parse_header(std::string_view line) {
  Words words(line);
  const std::string_view key = words.word();
  const bool is_used = key == "laser_pose" || key == "valid_min" || key == "valid_max";
  if (!is_used) return {};
  if (!in_header_) return dropped(drop_reason::late_header, key);
  Position pose;
  double bound = 0.0;
  if (key == "laser_pose")
    words.pose(pose);
  else
    words.finite({&bound});
  if (!words.good()) {
    ParsedLine parsed;
    parsed.dropped = words.fault();
    return parsed;
  }
  if (key == "laser_pose") laser_in_robot_ = pose;
  if (key == "valid_min") valid_min_ = bound;
  if (key == "valid_max") valid_max_ = bound;
  return {};
}

ParsedLine TextLog::parse_scan(std::string_view line, bool irregular) {
  Words words(line);
  words.word();
  ScanRecord scan;
  scan.laser_in_robot = laser_in_robot_;
  scan.valid_min = valid_min_;
  scan.valid_max = valid_max_;
  words.time(scan.utime);
  if (!irregular) words.finite({&scan.angle_min, &scan.angle_increment});
  words.number(scan.range_max);
  if (irregular)
    split_pairs(words.numbers(2 * words.count(messages::kMaxIrregularBeams)), scan);
  else
    scan.ranges = words.numbers(words.count(messages::kMaxBeams));
  words.end();
  ParsedLine parsed;
  if (words.good())
    parsed.scan = std::move(scan);
  else
    parsed.dropped = words.fault();
  return parsed;
}

}  // namespace perceptor
