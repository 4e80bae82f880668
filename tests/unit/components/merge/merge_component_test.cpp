#include "components/merge/merge_component.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/unit/components/merge/scene.hpp"

namespace perceptor {
namespace {

/// The component between two ends of a bus inside this process.
class MergeComponentTest : public testing::Test {
 protected:
  MergeComponentTest() { lcm_.subscribe(channel::local_map, &MergeComponentTest::keep, this); }

  static pico::map_t current_map(const std::vector<merge::Drawn>& scene, std::int64_t seq) {
    const Position robot_in_zero{2.0, 1.5, 0.3};
    pico::map_t message =
        make_map_message("robot", transform(merge::draw(scene), inverse(robot_in_zero)));
    message.utime = 1'000'000 + merge::kScanPeriod * seq;
    message.session = 42;
    message.seq = seq;
    message.map_id = seq;
    message.zero_utime = 500'000;
    message.robot_in_zero = to_message(robot_in_zero);
    return message;
  }

  const std::vector<pico::map_t>& send(const pico::map_t& message) {
    lcm_.publish(channel::current_map, &message);
    while (lcm_.handleTimeout(0) > 0) {
    }
    return received_;
  }

  void send_room(int from_seq, int to_seq) {
    for (int seq = from_seq; seq <= to_seq; ++seq) send(current_map(merge::room(), seq));
  }

  std::size_t last_walls() const {
    std::size_t walls = 0;
    for (const pico::map_object_t& object : received_.back().objects)
      if (object.type == pico::map_object_t::WALL) ++walls;
    return walls;
  }

  const pico::map_object_t* last_object(std::int8_t type) const {
    for (const pico::map_object_t& object : received_.back().objects)
      if (object.type == type) return &object;
    return nullptr;
  }

  const pico::map_point_t& last_point(const pico::map_object_t& object, std::size_t i) const {
    return received_.back().points[static_cast<std::size_t>(object.points[i])];
  }

 private:
  void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
            const pico::map_t* map) {
    received_.push_back(*map);
  }

  lcm::LCM lcm_{"memq://"};

 protected:
  Status status_{"merge", 1};
  std::vector<pico::map_t> received_;

 private:
  Bus bus_{lcm_, lcm_, status_};
  MergeComponent component_{MergeConfig{}, bus_};
};

TEST_F(MergeComponentTest, PublishesOneLocalMapForEachCurrentMapWithItsStamp) {
  send_room(1, 3);
  ASSERT_EQ(received_.size(), 3U);
  const pico::map_t& map = received_.back();
  EXPECT_EQ(map.utime, 1'000'000 + 3 * merge::kScanPeriod);
  EXPECT_EQ(map.session, 42);
  EXPECT_EQ(map.seq, 3);
  EXPECT_EQ(map.zero_utime, 500'000);
  EXPECT_EQ(map.frame, "robot");
  EXPECT_DOUBLE_EQ(map.robot_in_zero.x, 2.0);
  EXPECT_NEAR(map.robot_in_local.x, 2.0, 1e-9);
  EXPECT_GE(map.robot_in_local_covariance[0], 0.0);
  EXPECT_FALSE(map.unobservable);
  EXPECT_EQ(last_walls(), 4U);
  EXPECT_EQ(messages::validate(map), "");
}

TEST_F(MergeComponentTest, ShowsOriginRobotAndSafeDistance) {
  send_room(1, 1);
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_EQ(messages::validate(received_.back()), "");

  const pico::map_object_t* origin = last_object(pico::map_object_t::ORIGIN);
  ASSERT_TRUE(origin && origin->num_points == 1);
  const Vector2 expected = inverse(Position{2.0, 1.5, 0.3}).location();
  EXPECT_NEAR(last_point(*origin, 0).x, expected.x(), 1e-9);
  EXPECT_NEAR(last_point(*origin, 0).y, expected.y(), 1e-9);

  const pico::map_object_t* robot = last_object(pico::map_object_t::ROBOT);
  ASSERT_TRUE(robot && robot->num_points == 8);
  EXPECT_EQ(robot->connection, pico::map_object_t::CLOSED);
  EXPECT_DOUBLE_EQ(last_point(*robot, 0).x, 0.205);

  const pico::map_object_t* safe = last_object(pico::map_object_t::SAFE_DISTANCE);
  ASSERT_TRUE(safe && safe->num_points == 8);
  EXPECT_EQ(safe->connection, pico::map_object_t::CLOSED);
  for (std::size_t i = 0; i < 8; ++i) {
    const double to_corner = std::hypot(last_point(*safe, i).x, last_point(*safe, i).y);
    EXPECT_NEAR(to_corner * std::cos(std::numbers::pi / 8.0), 0.4, 1e-12);
  }
}

TEST_F(MergeComponentTest, AnotherSessionClearsTheMap) {
  send_room(1, 5);
  EXPECT_EQ(last_walls(), 4U);
  pico::map_t anew = current_map(merge::room(), 6);
  anew.session = 43;
  send(anew);
  EXPECT_EQ(received_.size(), 6U);
  EXPECT_EQ(last_walls(), 0U);
}

TEST_F(MergeComponentTest, AnotherZeroFrameClearsTheMap) {
  send_room(1, 5);
  pico::map_t anew = current_map(merge::room(), 6);
  anew.zero_utime = 600'000;
  anew.robot_in_zero = to_message(Position{});
  send(anew);
  EXPECT_EQ(received_.size(), 6U);
  EXPECT_EQ(last_walls(), 0U);
  EXPECT_DOUBLE_EQ(received_.back().robot_in_local.x, 0.0);
}

TEST_F(MergeComponentTest, TimeFarBackClearsTheMap) {
  send_room(200, 205);
  send_room(1, 1);
  EXPECT_EQ(last_walls(), 0U);
}

TEST_F(MergeComponentTest, OtherFramesAndPartsAreRejected) {
  pico::map_t world = current_map(merge::room(), 1);
  world.frame = "world";
  send(world);
  pico::map_t part = current_map(merge::room(), 2);
  part.parts = 2;
  send(part);
  EXPECT_TRUE(received_.empty());
  EXPECT_EQ(status_.message(0, true).inputs.at(0).rejected, 2);
}

TEST_F(MergeComponentTest, CorridorSaysWhichDirectionIsUnobservable) {
  const std::vector<merge::Drawn> corridor = {merge::wall(-5, -1, 9, -1), merge::wall(9, 3, -5, 3)};
  for (int seq = 1; seq <= 5; ++seq) send(current_map(corridor, seq));
  EXPECT_TRUE(received_.back().unobservable);
  EXPECT_NEAR(received_.back().unobservable_direction, -0.3, 1e-3);
}

TEST_F(MergeComponentTest, FullMapFitsOneMessage) {
  std::vector<merge::Drawn> many;
  for (int i = 0; i < 300; ++i) many.push_back(merge::wall(0.9 * i, 0, 0.9 * i + 0.5, 0));
  for (int seq = 1; seq <= 4; ++seq) send(current_map(many, seq));
  ASSERT_EQ(received_.size(), 4U);
  EXPECT_EQ(last_walls(), 150U);
  EXPECT_LT(static_cast<std::size_t>(received_.back().getEncodedSize()), kMaxPayload);
  // 200 walls, the most that the configuration allows, fit as well.
  const double bytes_of_a_wall = received_.back().getEncodedSize() / 150.0;
  EXPECT_LT(200.0 * bytes_of_a_wall, static_cast<double>(kMaxPayload));
}

TEST(MergeConfig, FileHoldsTheDefaults) {
  MergeConfig defaults;
  MergeConfig read;
  read.merge.max_walls = 1;
  config::load_file(PERCEPTOR_CONFIG_FILE,
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](MergeConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

}  // namespace
}  // namespace perceptor
