#include <sstream>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "components/globalmap/globalmap_component.hpp"
#include "components/globalmap/parts.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor {
namespace {

TEST(Parts, SmallMapIsOne) {
  Map map;
  add_segment(map, {{0.0, 0.0}, {1.0, 0.0}}, ObjectType::wall);
  EXPECT_EQ(globalmap::parts_of(map, 10, 10).size(), 1U);
  EXPECT_EQ(globalmap::parts_of({}, 10, 10).size(), 1U);
}

TEST(Parts, HoldEachObjectOnce) {
  Map map;
  for (int i = 0; i < 7; ++i) {
    const Index wall = add_segment(map, {{1.0 * i, 0.0}, {i + 1.0, 0.0}}, ObjectType::wall);
    map.objects[static_cast<std::size_t>(wall)].id = i;
    if (i > 0) connect(map, 2 * i - 1, 2 * i);
  }
  for (const auto& [objects, points] : {std::pair{3U, 100U}, std::pair{100U, 6U}}) {
    const std::vector<Map> parts = globalmap::parts_of(map, objects, points);
    ASSERT_EQ(parts.size(), 3U);
    std::int32_t next = 0;
    for (const Map& part : parts) {
      EXPECT_EQ(find_broken_reference(part), "");
      for (const Object& object : part.objects) EXPECT_EQ(object.id, next++);
    }
    EXPECT_EQ(next, 7);
    EXPECT_EQ(parts[1].points.front().connected, kNone) << "its partner is in another part";
    EXPECT_NE(parts[1].points[1].connected, kNone);
  }
}

TEST(Parts, ObjectWithMorePointsThanAPartHasOneForItself) {
  Map map;
  map.objects.resize(2);
  for (Index object : {0, 1})
    for (int i = 0; i < 5; ++i) {
      const Index point = add_point(map, {1.0 * i, 1.0 * object});
      map.points[static_cast<std::size_t>(point)].parents = {object};
      map.objects[static_cast<std::size_t>(object)].points.push_back(point);
    }
  EXPECT_EQ(globalmap::parts_of(map, 10, 3).size(), 2U);
}

/// The component at one end of a bus inside this process.
class GlobalmapComponentTest : public testing::Test {
 protected:
  GlobalmapComponentTest() {
    lcm_.subscribe(channel::global_map, &GlobalmapComponentTest::keep, this);
  }

  std::vector<pico::map_t> sent(const GlobalmapConfig& config,
                                const std::vector<std::int64_t>& steps) {
    GlobalmapComponent component(config, bus_);
    for (const std::int64_t now : steps) {
      component.step(now);
      while (lcm_.handleTimeout(0) > 0) {
      }
    }
    return received_;
  }

  static GlobalmapConfig of(const std::string& map) {
    GlobalmapConfig config;
    config.map = map;
    config.config_dir = std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config";
    return config;
  }

 private:
  void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
            const pico::map_t* message) {
    received_.push_back(*message);
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"globalmap", 1};
  Bus bus_{lcm_, lcm_, status_};
  std::vector<pico::map_t> received_;
};

TEST_F(GlobalmapComponentTest, SendsTheMapOnceASecond) {
  const auto maps = sent(of("hospital"), {5'000'000, 5'400'000, 6'000'000});
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].frame, "world");
  EXPECT_EQ(maps[0].parts, 1);
  EXPECT_GT(maps[0].map_id, 0);
  EXPECT_EQ(maps[1].map_id, maps[0].map_id);
  EXPECT_EQ(maps[1].seq, maps[0].seq + 1);
  EXPECT_GT(maps[1].utime, maps[0].utime);
  EXPECT_EQ(messages::validate(maps[0]), "");
  EXPECT_EQ(find_broken_reference(to_model(maps[0])), "");
}

TEST_F(GlobalmapComponentTest, LargeBuildingGoesInPartsThatFit) {
  std::ostringstream text;
  std::ostringstream walls;
  text << R"({"points": [)";
  int points = 0;
  for (int i = 0; i < 150; ++i) {  // rooms beside each other, none touching
    const double x = 3.0 * i;
    text << (i > 0 ? "," : "") << R"({"x":)" << x << R"(,"y":0},{"x":)" << x + 2
         << R"(,"y":0},{"x":)" << x + 2 << R"(,"y":2},{"x":)" << x << R"(,"y":2})";
    for (int k = 0; k < 4; ++k)
      walls << (points + k > 0 ? "," : "") << '[' << points + k << ',' << points + (k + 1) % 4
            << ']';
    points += 4;
  }
  const TemporaryFile file(text.str() + R"(], "walls": [)" + walls.str() + "]}", "large.json");
  const auto parts = sent(of(file.path().string()), {0});
  ASSERT_EQ(parts.size(), 5U);
  std::size_t objects = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].part, static_cast<std::int32_t>(i));
    EXPECT_EQ(parts[i].parts, 5);
    EXPECT_EQ(parts[i].map_id, parts[0].map_id);
    EXPECT_EQ(parts[i].utime, parts[0].utime + static_cast<std::int64_t>(i));
    EXPECT_LE(parts[i].getEncodedSize(), static_cast<int>(kMaxPayload));
    objects += parts[i].objects.size();
  }
  EXPECT_EQ(objects, 600U);
}

TEST_F(GlobalmapComponentTest, UnknownKeysAreReported) {
  const TemporaryFile file(
      R"({"points": [{"x":0,"y":0},{"x":2,"y":0},{"x":2,"y":2}], "walls": [[0,1],[1,2],[2,0]],
          "nodes": []})",
      "nodes.json");
  EXPECT_EQ(sent(of(file.path().string()), {0}).size(), 1U);
}

TEST_F(GlobalmapComponentTest, MapThatIsNotThereIsSaidWithThoseThatAre) {
  try {
    sent(of("nowhere"), {});
    FAIL();
  } catch (const config::Error& error) {
    const std::string text = error.what();
    for (const char* word : {"nowhere", "hospital", "office"})
      EXPECT_NE(text.find(word), std::string::npos) << text;
  }
}

TEST(GlobalmapConfig, FileHoldsTheDefaults) {
  GlobalmapConfig defaults;
  GlobalmapConfig read;
  read.map = "another";
  config::load_file(std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config" / "globalmap.json",
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](GlobalmapConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

}  // namespace
}  // namespace perceptor
