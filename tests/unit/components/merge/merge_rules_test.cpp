/// Ten thousand random messages, good and bad: what holds of merge whatever came.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "components/merge/merge_component.hpp"
#include "tests/unit/components/merge/scene.hpp"

namespace perceptor {
namespace {

constexpr int kSteps = 10'000;
constexpr std::size_t kMostWalls = 100;  // that a room of four walls and rubbish may come to

class MergeRules : public testing::Test {
 protected:
  MergeRules() { lcm_.subscribe(channel::local_map, &MergeRules::check, this); }

  double draw(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// A good scan of the room, from somewhere in it.
  pico::map_t good() {
    robot_.x = std::clamp(robot_.x + draw(-0.1, 0.1), 0.5, 3.5);
    robot_.y = std::clamp(robot_.y + draw(-0.1, 0.1), 0.5, 2.5);
    robot_ = compose(robot_, {0.0, 0.0, draw(-0.1, 0.1)});
    Map walls = merge::draw(merge::room());
    for (Point& point : walls.points)
      point.location += Vector2(draw(-0.005, 0.005), draw(-0.005, 0.005));
    pico::map_t message = make_map_message("robot", transform(walls, inverse(robot_)));
    set_stamp(message, {utime_ += 25'000, session_, seq_++});
    message.zero_utime = 1;
    message.robot_in_zero = to_message(robot_);
    return message;
  }

  /// One thing about it is not as it should be. Some of these are still good messages.
  pico::map_t strange() {
    pico::map_t message = good();
    auto& point = message.points[random_() % message.points.size()];
    auto& object = message.objects[random_() % message.objects.size()];
    switch (random_() % 14) {
      case 0:
        point.x = std::numeric_limits<double>::quiet_NaN();
        break;
      case 1:
        point.y = std::numeric_limits<double>::infinity();
        break;
      case 2:
        point.x = 1e300;
        break;
      case 3:
        message.utime -= static_cast<std::int64_t>(random_() % 4'000'000);
        break;
      case 4:
        message.frame = "world";
        break;
      case 5:
        message.parts = 3;
        break;
      case 6:
        object.points[0] = static_cast<std::int32_t>(random_() % 1000);
        break;
      case 7:
        object.points[1] = object.points[0];
        break;
      case 8:
        message.robot_in_zero.x = draw(-1000.0, 1000.0);
        break;
      case 9:
        message.robot_in_zero.a = 40.0;
        break;
      case 10:
        message.zero_utime = utime_;
        break;
      case 11:
        message.session = ++session_;
        break;
      case 12:
        object.type = static_cast<std::int8_t>(random_() % 256);
        break;
      default:
        message = rubbish(message);
        break;
    }
    return message;
  }

  /// Walls that are nowhere.
  pico::map_t rubbish(const pico::map_t& like) {
    Map walls;
    for (int i = 0; i < 10; ++i)
      merge::add_wall(walls, merge::wall(draw(-9, 9), draw(-9, 9), draw(-9, 9), draw(-9, 9)));
    pico::map_t message = make_map_message("robot", walls);
    set_stamp(message, stamp_of(like));
    message.zero_utime = like.zero_utime;
    message.robot_in_zero = like.robot_in_zero;
    return message;
  }

  void send(const pico::map_t& message) {
    last_ = stamp_of(message);
    const auto bytes = messages::encode(message);
    lcm_.publish(channel::current_map, bytes.data(), static_cast<unsigned>(bytes.size()));
    while (lcm_.handleTimeout(0) > 0) {
    }
    ++sent_;
  }

  void check(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/) {
    pico::map_t map;
    const Bus::Bytes bytes(static_cast<const std::uint8_t*>(buffer->data), buffer->data_size);
    ASSERT_EQ(detail::decode(bytes, map), "") << "what comes out is a good message";
    EXPECT_EQ(map.utime, last_.utime) << "of the message that went in";
    EXPECT_EQ(map.seq, last_.seq);
    EXPECT_EQ(map.session, last_.session);
    std::size_t walls = 0;
    for (const pico::map_object_t& object : map.objects)
      if (object.type == pico::map_object_t::WALL) ++walls;
    EXPECT_LE(walls, kMostWalls);
    ++published_;
  }

  std::mt19937_64 random_{20261126};
  lcm::LCM lcm_{"memq://"};
  Status status_{"merge", 1};
  Bus bus_{lcm_, lcm_, status_};
  MergeComponent component_{MergeConfig{}, bus_};
  Position robot_{2.0, 1.5, 0.0};
  std::int64_t utime_ = 10'000'000;
  std::int64_t session_ = 1;
  std::int64_t seq_ = 0;
  Stamp last_;
  std::int64_t sent_ = 0;
  std::int64_t published_ = 0;
};

TEST_F(MergeRules, HoldWhateverComes) {
  for (int i = 0; i < kSteps; ++i) {
    send(random_() % 4 == 0 ? strange() : good());
    ASSERT_FALSE(HasFailure()) << "step " << i;
    const pico::status_t status = status_.message(0, false);
    ASSERT_EQ(status.inputs.at(0).received, sent_);
    ASSERT_EQ(status.inputs.at(0).rejected + published_, sent_) << "step " << i;
  }
  EXPECT_GT(published_, kSteps / 2);
  EXPECT_LT(published_, kSteps);
}

}  // namespace
}  // namespace perceptor
