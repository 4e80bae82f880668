#include "components/localize/localize_component.hpp"

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/validate.hpp"

namespace perceptor {
namespace {

/// The component between two ends of a bus inside this process.
class LocalizeComponentTest : public testing::Test {
 protected:
  LocalizeComponentTest() {
    lcm_.subscribe(channel::world_position, &LocalizeComponentTest::keep, this);
  }

  static LocalizeConfig config() {
    LocalizeConfig config;
    config.config_dir = std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config";
    return config;
  }

  static pico::laser_scan_t scan(std::int64_t seq) {
    pico::laser_scan_t message{};
    message.utime = 1'000'000 + 25'000 * seq;
    message.session = 42;
    message.seq = seq;
    message.angle_min = -1.0;
    message.angle_max = 1.0;
    message.angle_increment = 0.02;
    message.valid_min = 0.1;
    message.valid_max = 10.0;
    message.range_sigma = 0.01;
    message.ranges.assign(101, 2.0F);
    message.num_ranges = 101;
    return message;
  }

  static pico::map_t map(std::int64_t seq, const char* frame = "robot") {
    pico::map_t message = make_map_message(frame, Map{});
    message.utime = 1'000'000 + 25'000 * seq;
    message.session = 42;
    message.seq = seq;
    message.zero_utime = 500'000;
    return message;
  }

  template <class Message>
  void send(const char* name, const Message& message) {
    lcm_.publish(name, &message);
    while (lcm_.handleTimeout(0) > 0) {
    }
  }

  void send_scan(std::int64_t seq) {
    send(channel::laser, scan(seq));
    send(channel::current_map, map(seq));
  }

  std::vector<std::int64_t> seqs() const {
    std::vector<std::int64_t> seqs;
    for (const auto& position : received_) seqs.push_back(position.seq);
    return seqs;
  }

  std::int64_t rejected(const std::string& on) {
    std::int64_t sum = 0;
    for (const auto& reject : status_.message(0, false).rejects)
      if (reject.channel == on) sum += reject.count;
    return sum;
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"localize", 1};
  Bus bus_{lcm_, lcm_, status_};
  LocalizeComponent component_{config(), bus_};
  std::vector<pico::world_position_t> received_;

 private:
  void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
            const pico::world_position_t* message) {
    received_.push_back(*message);
  }
};

using Seqs = std::vector<std::int64_t>;

TEST_F(LocalizeComponentTest, OnePositionForEachScanWithItsMap) {
  for (std::int64_t seq = 1; seq <= 3; ++seq) {
    send_scan(seq);
    send(channel::local_map, map(seq));
  }
  ASSERT_EQ(seqs(), (Seqs{1, 2, 3}));
  EXPECT_EQ(received_[0].state, pico::world_position_t::SEARCHING);
  EXPECT_EQ(received_[0].zero_utime, 500'000);
  EXPECT_GT(received_[0].map_id, 0);
  EXPECT_EQ(messages::validate(received_[0]), "");
}

TEST_F(LocalizeComponentTest, WhichComesFirstDoesNotMatter) {
  send(channel::local_map, map(1));
  send(channel::local_map, map(2));
  EXPECT_TRUE(received_.empty());
  send_scan(1);
  send_scan(2);
  EXPECT_EQ(seqs(), (Seqs{1, 2}));
}

TEST_F(LocalizeComponentTest, WallsOfTheScanAreWaitedFor) {
  send(channel::local_map, map(1));
  send(channel::laser, scan(1));
  EXPECT_TRUE(received_.empty());
  send(channel::current_map, map(1));
  EXPECT_EQ(seqs(), (Seqs{1}));
}

TEST_F(LocalizeComponentTest, MapWhoseWallsWereLostIsCounted) {
  send(channel::laser, scan(1));
  send(channel::local_map, map(1));
  send_scan(2);
  send(channel::local_map, map(2));
  EXPECT_EQ(seqs(), (Seqs{2}));
  EXPECT_EQ(rejected(channel::local_map), 1);
}

TEST_F(LocalizeComponentTest, ScanWithoutAMapIsPassedOver) {
  for (const std::int64_t seq : {1, 2, 3}) send_scan(seq);
  send(channel::local_map, map(3));
  EXPECT_EQ(seqs(), (Seqs{3}));
}

TEST_F(LocalizeComponentTest, MapWhoseScanWasLostIsCounted) {
  send(channel::local_map, map(1));
  send_scan(2);
  send(channel::local_map, map(2));
  EXPECT_EQ(seqs(), (Seqs{2}));
  EXPECT_EQ(rejected(channel::local_map), 1);
}

TEST_F(LocalizeComponentTest, MapOfAnotherFrameIsTurnedDown) {
  send_scan(1);
  send(channel::local_map, map(1, "local"));
  EXPECT_TRUE(received_.empty());
  EXPECT_EQ(rejected(channel::local_map), 1);
}

TEST_F(LocalizeComponentTest, GlobalMapOfAnotherBuildingIsCounted) {
  send_scan(1);
  send(channel::local_map, map(1));
  pico::map_t global = map(1, "world");
  global.map_id = received_.at(0).map_id;
  send(channel::global_map, global);
  EXPECT_EQ(rejected(channel::global_map), 0);
  ++global.utime;
  ++global.seq;
  ++global.map_id;
  send(channel::global_map, global);
  EXPECT_EQ(rejected(channel::global_map), 1);
}

TEST_F(LocalizeComponentTest, StartAreaHasToBeOnTheMap) {
  LocalizeConfig start = config();
  start.start.from = LocalizeConfig::Start::start_area;
  start.map = "office";
  EXPECT_THROW(LocalizeComponent(start, bus_), config::Error);
}

TEST(LocalizeConfig, FileHoldsTheDefaults) {
  LocalizeConfig defaults;
  LocalizeConfig read;
  read.map = "another";
  config::load_file(std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config" / "localize.json",
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](LocalizeConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

TEST(LocalizeConfig, FileForScannedMapsFollowsByBeams) {
  LocalizeConfig read;
  config::load_file(
      std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config" / "localize_scanned_map.json",
      [&read](config::Fields& fields) { describe(fields, read); });
  EXPECT_EQ(read.localize.track_by, localize::TrackBy::beams);
  EXPECT_GT(read.localize.search.followed, 0);
}

}  // namespace
}  // namespace perceptor
