#include <sstream>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "components/globalmap/globalmap_component.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor {
namespace {

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
