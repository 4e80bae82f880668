#include "tools/convert/bag_reader.hpp"

#include <utility>

#include "common/ros1/ros1_messages.hpp"

namespace perceptor {
namespace {

constexpr std::string_view kLaserType = "sensor_msgs/LaserScan";
constexpr std::string_view kOdometryType = "nav_msgs/Odometry";

ParsedLine dropped(std::string_view reason, std::string detail = {}) {
  ParsedLine parsed;
  parsed.dropped = Dropped{reason, std::move(detail)};
  return parsed;
}

ParsedLine parse_scan(ros1::Bytes bytes) {
  ros1::LaserScan scan;
  if (const auto fault = ros1::decode(bytes, scan); !fault.empty()) return dropped(fault);
  if (!ros1::last_angle(scan)) return dropped(drop_reason::wrong_angles);
  const auto valid = ros1::valid_range(scan.range_min, scan.range_max, ros1::kMissNoise);
  ScanRecord record;
  record.utime = scan.header.utime;
  record.angle_min = scan.angle_min;
  record.angle_increment = scan.angle_increment;
  record.time_increment = scan.time_increment;
  record.range_max = scan.range_max;
  record.valid_min = valid.min;
  record.valid_max = valid.max;
  record.ranges = std::move(scan.ranges);
  ParsedLine parsed;
  parsed.scan = std::move(record);
  return parsed;
}

ParsedLine parse_odometry(ros1::Bytes bytes) {
  ros1::Odometry odometry;
  if (const auto fault = ros1::decode(bytes, odometry); !fault.empty()) return dropped(fault);
  ParsedLine parsed;
  parsed.odometry = OdometryRecord{odometry.header.utime, odometry.pose};
  return parsed;
}

}  // namespace

BagReader::BagReader(BagFile file, BagTopics topics)
    : file_(std::move(file)), topics_(std::move(topics)) {}

ParsedLine BagReader::parse(const BagMessage& message) const {
  const bool is_laser = message.topic == topics_.laser;
  if (message.type != (is_laser ? kLaserType : kOdometryType))
    return dropped(drop_reason::another_type, message.type);
  return is_laser ? parse_scan(message.bytes) : parse_odometry(message.bytes);
}

std::optional<ParsedLine> BagReader::next() {
  while (const auto message = file_.next()) {
    ++read_;
    if (!message->fault.empty()) return dropped(drop_reason::damaged, message->fault);
    if (topics_.is_wanted(message->topic)) return parse(*message);
    Skipped& skipped = skipped_[message->topic];
    skipped.type = message->type;
    ++skipped.count;
  }
  return std::nullopt;
}

std::vector<std::string> BagReader::notes() const {
  std::vector<std::string> notes;
  for (const auto& [topic, skipped] : skipped_) {
    std::string note =
        "skipped " + topic + ": " + std::to_string(skipped.count) + " of " + skipped.type;
    if (skipped.type == kLaserType) note += " (--laser-topic takes it)";
    if (skipped.type == kOdometryType) note += " (--odometry-topic takes it)";
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace perceptor
