#include "components/identify/identify_component.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/unit/components/identify/scene.hpp"

namespace perceptor {
namespace {

using identify::test::doorway;
using identify::test::draw;
using identify::test::room_with_doorway;

/// The component between two ends of a bus inside this process.
class IdentifyComponentTest : public testing::Test {
 protected:
  IdentifyComponentTest() {
    lcm_.subscribe(channel::identified_map, &IdentifyComponentTest::keep, this);
    lcm_.subscribe(channel::entrance, &IdentifyComponentTest::keep_entrance, this);
  }

  /// What comes out for one local map.
  std::vector<pico::map_t> identified(const pico::map_t& local_map) {
    received_.clear();
    lcm_.publish(channel::local_map, &local_map);
    while (lcm_.handleTimeout(0) > 0) {
    }
    return received_;
  }

  /// The entrance that comes out, after the map of the same scan.
  pico::entrance_t entrance_of(const pico::map_t& local_map) {
    entrances_.clear();
    EXPECT_EQ(identified(local_map).size(), 1U);
    EXPECT_EQ(entrances_.size(), 1U);
    return entrances_.empty() ? pico::entrance_t{} : entrances_.back();
  }

  /// That of the last of many scans of one map, from `first_seq` on.
  pico::entrance_t entrance_after(int scans, pico::map_t map, std::int64_t first_seq = 1) {
    pico::entrance_t entrance{};
    for (int i = 0; i < scans; ++i) {
      map.seq = first_seq + i;
      map.utime = 1'000'000 + 25'000 * map.seq;
      entrance = entrance_of(map);
    }
    return entrance;
  }

  static pico::map_t local_map(const Map& map, std::int64_t seq = 1) {
    pico::map_t message = make_map_message("robot", map);
    message.utime = 1'000'000 + 25'000 * seq;
    message.session = 42;
    message.seq = seq;
    message.map_id = 7;
    message.zero_utime = 500'000;
    message.robot_in_zero = to_message(Position{1, 2, 0.3});
    message.robot_in_local = to_message(Position{1.1, 2.1, 0.31});
    message.unobservable = 1;
    message.unobservable_direction = 0.5;
    return message;
  }

 private:
  void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
            const pico::map_t* map) {
    received_.push_back(*map);
  }
  void keep_entrance(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                     const pico::entrance_t* entrance) {
    EXPECT_EQ(received_.size(), 1U) << "the map comes first";
    entrances_.push_back(*entrance);
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"identify", 1};
  Bus bus_{lcm_, lcm_, status_};
  IdentifyComponent component_{IdentifyConfig{}, bus_};
  std::vector<pico::map_t> received_;
  std::vector<pico::entrance_t> entrances_;
};

constexpr int kEnough = 9;  // 60 % of 15 scans

TEST_F(IdentifyComponentTest, PublishesTheLocalMapWithItsHeaderAndItsDoor) {
  const pico::map_t in = local_map(doorway(0.9));
  const auto out = identified(in);
  ASSERT_EQ(out.size(), 1U);
  const pico::map_t& map = out[0];
  EXPECT_EQ(map.utime, in.utime);
  EXPECT_EQ(map.session, in.session);
  EXPECT_EQ(map.seq, in.seq);
  EXPECT_EQ(map.frame, "robot");
  EXPECT_EQ(map.map_id, in.map_id);
  EXPECT_EQ(map.zero_utime, in.zero_utime);
  EXPECT_EQ(map.robot_in_zero.x, in.robot_in_zero.x);
  EXPECT_EQ(map.robot_in_local.a, in.robot_in_local.a);
  EXPECT_EQ(map.unobservable, in.unobservable);
  EXPECT_EQ(map.unobservable_direction, in.unobservable_direction);
  ASSERT_EQ(map.num_objects, in.num_objects + 1);
  ASSERT_EQ(map.num_points, in.num_points + 2);
  EXPECT_EQ(map.objects.back().type, pico::map_object_t::DOOR);
  EXPECT_EQ(map.points[1].property, pico::map_point_t::CONVEX);
}

TEST_F(IdentifyComponentTest, PublishesTheEntranceInTheRobotFrameAfterEnoughScans) {
  const pico::map_t map = local_map(room_with_doorway());
  const pico::entrance_t early = entrance_after(kEnough - 1, map);
  EXPECT_FALSE(early.entrance_found);
  EXPECT_EQ(early.width, 0.0);
  const pico::entrance_t entrance = entrance_after(1, map, kEnough);
  EXPECT_EQ(messages::validate(entrance), "");
  EXPECT_EQ(entrance.utime, 1'000'000 + 25'000 * kEnough);
  EXPECT_EQ(entrance.session, map.session);
  EXPECT_EQ(entrance.seq, kEnough);
  ASSERT_TRUE(entrance.entrance_found);
  EXPECT_NEAR(entrance.middle_x, 0.0, 1e-9);
  EXPECT_NEAR(entrance.middle_y, 2.0, 1e-9);
  EXPECT_NEAR(entrance.direction, 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(entrance.width, 0.9, 1e-9);
  EXPECT_NEAR(entrance.confidence, 1.0, 1e-9);
  EXPECT_FALSE(entrance.in_hallway);
}

TEST_F(IdentifyComponentTest, EntranceBeginsAnewWithTheMap) {
  pico::map_t map = local_map(room_with_doorway());
  ASSERT_TRUE(entrance_after(2 * kEnough, map).entrance_found);
  map.zero_utime += 1;
  EXPECT_FALSE(entrance_after(kEnough - 1, map, 100).entrance_found) << "another zero frame";
  EXPECT_TRUE(entrance_after(1, map, 100 + kEnough).entrance_found);
  map.session += 1;
  EXPECT_FALSE(entrance_after(kEnough - 1, map, 200).entrance_found) << "another session";
  EXPECT_TRUE(entrance_after(1, map, 200 + kEnough).entrance_found);
  EXPECT_FALSE(entrance_after(kEnough - 1, map, 1).entrance_found) << "time stepped back";
}

TEST_F(IdentifyComponentTest, MapInPartsHasNoEntrance) {
  pico::map_t map = local_map(room_with_doorway());
  ASSERT_TRUE(entrance_after(kEnough, map).entrance_found);
  map.parts = 2;
  EXPECT_FALSE(entrance_after(1, map, 50).entrance_found);
}

TEST_F(IdentifyComponentTest, PublishesTheHallwayAtOnce) {
  Map map;
  draw(map, {{3, 0.6}, {-2, 0.6}});
  draw(map, {{-2, -0.6}, {3, -0.6}});
  const pico::entrance_t entrance = entrance_of(local_map(map));
  EXPECT_FALSE(entrance.entrance_found);
  ASSERT_TRUE(entrance.in_hallway);
  EXPECT_NEAR(entrance.centre_x1, -2.0, 1e-9);
  EXPECT_NEAR(entrance.centre_y1, 0.0, 1e-9);
  EXPECT_NEAR(entrance.centre_x2, 3.0, 1e-9);
  EXPECT_NEAR(entrance.centre_y2, 0.0, 1e-9);
  EXPECT_NEAR(entrance.hallway_width, 1.2, 1e-9);
}

TEST_F(IdentifyComponentTest, EveryMapGivesOneMap) {
  for (std::int64_t seq = 1; seq <= 300; ++seq)
    EXPECT_EQ(identified(local_map(doorway(0.004 * static_cast<double>(seq)), seq)).size(), 1U);
}

TEST_F(IdentifyComponentTest, MapWithoutWallsGoesThrough) {
  const auto out = identified(local_map(Map{}));
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].num_objects, 0);
}

TEST_F(IdentifyComponentTest, StrangeButValidMapGoesThrough) {
  Map map = doorway(0.9);
  draw(map, {{0, 2}, {0, 2}, {0, 2}});
  map.points.front().projection = 3;
  add_point(map, {1, 1});
  EXPECT_EQ(identified(local_map(map)).size(), 1U);
}

TEST_F(IdentifyComponentTest, FullMapGoesOutWithTheBestOfItsOpenings) {
  // Doorways side by side, as many as a local map can hold with no room left for all doors.
  Map map;
  pico::map_t in = local_map(map);
  for (int i = 0;; ++i) {
    const double y = 3.0 * i;
    Map more = map;
    draw(more, {{1.45, y}, {0.45, y}, {0.45, y + 0.2}});
    draw(more, {{-0.45, y + 0.2}, {-0.45, y}, {-1.45, y}});
    in = local_map(more);
    if (in.getEncodedSize() > static_cast<int>(kMaxPayload)) break;
    map = more;
  }
  in = local_map(map);
  const auto out = identified(in);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_GT(out[0].num_objects, in.num_objects - 1);
  EXPECT_LT(out[0].num_objects, in.num_objects + in.num_objects / 4);
  EXPECT_LE(out[0].getEncodedSize(), static_cast<int>(kMaxPayload));
}

TEST(IdentifyConfiguration, DescribesWhatIsInTheParameters) {
  IdentifyConfig config;
  config.identify.openings.door_min_width = 0.6;
  const std::string text =
      config::print([&config](config::Fields& fields) { describe(fields, config); });
  EXPECT_NE(text.find("\"door_min_width\": 0.6"), std::string::npos);
  EXPECT_NE(text.find("\"usual_width\""), std::string::npos);
}

TEST(IdentifyConfiguration, FileHoldsTheDefaults) {
  IdentifyConfig defaults;
  IdentifyConfig read;
  read.entrance.scans = 1;
  read.hallway.reach = 1.0;
  config::load_file(PERCEPTOR_CONFIG_FILE,
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](IdentifyConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

}  // namespace
}  // namespace perceptor
