#include "common/ros1/ros1_messages.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#include "common/time/stamp.hpp"

namespace perceptor::ros1 {
namespace {

static_assert(std::endian::native == std::endian::little, "as ROS's messages are");

constexpr std::string_view kTooShort = "shorter than its lengths say";
constexpr std::string_view kTooLong = "longer than its lengths say";
constexpr std::size_t kCovariance = 36;  // doubles
constexpr std::size_t kTwist = 6 + 36;   // doubles

/// Takes values off the front of a message. Once the bytes are too few, it gives zeros.
class Wire {
 public:
  explicit Wire(Bytes bytes) : rest_(bytes) {}

  template <class Number>
  void number(Number& value) {
    const Bytes bytes = take(sizeof(Number), 1);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(Number));
  }

  void text(std::string& value) {
    const Bytes bytes = array(1);
    value.assign(bytes.begin(), bytes.end());
  }

  void floats(std::vector<float>& values) {
    const Bytes bytes = array(sizeof(float));
    values.resize(bytes.size() / sizeof(float));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  }

  void skip_doubles(std::size_t count) { take(sizeof(double), count); }
  void skip_floats() { array(sizeof(float)); }

  std::string_view fault() const {
    if (is_too_short_) return kTooShort;
    return rest_.empty() ? std::string_view{} : kTooLong;
  }

 private:
  Bytes array(std::size_t element) {
    std::uint32_t length = 0;
    number(length);
    return take(element, length);
  }

  Bytes take(std::size_t element, std::size_t count) {
    is_too_short_ = is_too_short_ || count > rest_.size() / element;
    if (is_too_short_) return {};
    const Bytes taken = rest_.first(element * count);
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

  Bytes rest_;
  bool is_too_short_ = false;
};

void read(Wire& wire, Header& header) {
  constexpr std::int64_t nanoseconds_in_one = 1000;
  std::uint32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  wire.number(header.seq);
  wire.number(seconds);
  wire.number(nanoseconds);
  wire.text(header.frame);
  const std::int64_t rounded =
      (std::int64_t{nanoseconds} + nanoseconds_in_one / 2) / nanoseconds_in_one;
  header.utime = std::int64_t{seconds} * kMicrosecondsPerSecond + rounded;
}

}  // namespace

std::string_view decode(Bytes bytes, LaserScan& scan) {
  Wire wire(bytes);
  float scan_time = 0.0F;
  read(wire, scan.header);
  for (float* number : {&scan.angle_min, &scan.angle_max, &scan.angle_increment,
                        &scan.time_increment, &scan_time, &scan.range_min, &scan.range_max})
    wire.number(*number);
  wire.floats(scan.ranges);
  wire.skip_floats();  // intensities
  return wire.fault();
}

std::string_view decode(Bytes bytes, Odometry& odometry) {
  Wire wire(bytes);
  std::string child_frame;
  double height = 0.0;
  double x = 0.0;  // of the quaternion
  double y = 0.0;
  double z = 0.0;
  double w = 0.0;
  read(wire, odometry.header);
  wire.text(child_frame);
  for (double* number : {&odometry.pose.x, &odometry.pose.y, &height, &x, &y, &z, &w})
    wire.number(*number);
  wire.skip_doubles(kCovariance + kTwist);
  if (const auto fault = wire.fault(); !fault.empty()) return fault;

  constexpr double far_from_one = 0.01;
  const double norm = x * x + y * y + z * z + w * w;
  const bool is_rotation = std::abs(norm - 1.0) < far_from_one;
  if (!is_rotation) return "orientation is no rotation";
  odometry.pose.a = std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
  return {};
}

std::optional<double> last_angle(const LaserScan& scan) {
  const double increment = scan.angle_increment;
  const double steps = static_cast<double>(scan.ranges.size()) - 1.0;
  const double last = scan.angle_min + steps * increment;
  constexpr double beams_off = 1.5;
  const bool is_one_beam = scan.ranges.size() == 1;
  const bool is_meant = std::abs(scan.angle_max - last) < beams_off * std::abs(increment);
  return is_meant || is_one_beam ? std::optional(last) : std::nullopt;
}

bool is_same_frame(std::string_view one, std::string_view other) {
  const auto bare = [](std::string_view name) {
    return name.starts_with('/') ? name.substr(1) : name;
  };
  return bare(one) == bare(other);
}

}  // namespace perceptor::ros1
