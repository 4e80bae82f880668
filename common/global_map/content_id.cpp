#include "common/global_map/content_id.hpp"

#include <cmath>
#include <limits>
#include <string_view>

namespace perceptor::global_map {
namespace {

/// Fowler, Noll and Vo's hash, variant 1a, 64 bits.
class Hash {
 public:
  void add(std::int64_t number) {
    auto bits = static_cast<std::uint64_t>(number);
    for (int i = 0; i < 8; ++i, bits >>= 8U) add_byte(static_cast<std::uint8_t>(bits));
  }
  void add(std::string_view text) {
    add(static_cast<std::int64_t>(text.size()));
    for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
  }
  void add_length(double metres) { add(static_cast<std::int64_t>(std::llround(metres * 1e6))); }

  std::uint64_t value() const { return value_; }

 private:
  void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::int64_t content_id(const Map& map) {
  Hash hash;
  for (const Object& object : map.objects) {
    hash.add(static_cast<std::int64_t>(object.type));
    hash.add(object.name);
    hash.add(static_cast<std::int64_t>(object.free_side));
    hash.add(static_cast<std::int64_t>(object.points.size()));
    for (const Index index : object.points) {
      const Point& point = map.points[static_cast<std::size_t>(index)];
      hash.add_length(point.location.x());
      hash.add_length(point.location.y());
      hash.add(static_cast<std::int64_t>(point.property));
      hash.add(point.connected);
    }
  }
  const auto positive = static_cast<std::int64_t>(hash.value() >> 1U);
  return positive == 0 ? 1 : positive;
}

}  // namespace perceptor::global_map
