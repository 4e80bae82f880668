#include "tools/eval/log_tracks.hpp"

#include <gtest/gtest.h>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"

namespace perceptor {
namespace {

LogEvent local_map(std::int64_t session, std::int64_t utime, std::int64_t zero_utime = 1,
                   const std::string& channel = channel::local_map) {
  pico::map_t message = make_map_message("robot", {});
  set_stamp(message, {utime, session, 0});
  message.zero_utime = zero_utime;
  message.robot_in_local = to_message(Position{1.0, 2.0, 0.5});
  message.robot_in_zero = to_message(Position{3.0, 4.0, 0.25});
  return {0, 0, channel, messages::encode(message)};
}

std::vector<Track> tracks_of(const std::vector<LogEvent>& events) {
  TrackReader reader;
  for (const LogEvent& event : events) reader.take(event);
  return reader.tracks();
}

TEST(LogTracks, HoldMergesAndOdometrysPoses) {
  const auto tracks = tracks_of({local_map(7, 100), local_map(7, 50), local_map(7, 100)});
  ASSERT_EQ(tracks.size(), 1U);
  ASSERT_EQ(tracks[0].merge.size(), 2U) << "one for each utime";
  EXPECT_EQ(tracks[0].merge[0].utime, 50);
  EXPECT_EQ(tracks[0].merge[1].pose, (Position{1.0, 2.0, 0.5}));
  EXPECT_EQ(tracks[0].odometry[1].pose, (Position{3.0, 4.0, 0.25}));
}

TEST(LogTracks, TheLongestIsThatOfMostTime) {
  const auto tracks = tracks_of({local_map(7, 100), local_map(7, 200), local_map(7, 300),
                                 local_map(8, 1000), local_map(8, 1500)});
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(longest(tracks).session, 8);
  EXPECT_DOUBLE_EQ(duration(longest(tracks)), 500e-6);
}

TEST(LogTracks, BeginAnewWithTheZeroFrame) {
  EXPECT_EQ(tracks_of({local_map(7, 100, 1), local_map(7, 200, 2)}).size(), 2U);
}

TEST(LogTracks, OnlyGoodLocalMapsCount) {
  TrackReader reader;
  LogEvent broken = local_map(7, 100);
  broken.data.pop_back();
  reader.take(broken);
  reader.take(local_map(7, 100, 1, channel::current_map));
  EXPECT_TRUE(reader.tracks().empty());
  EXPECT_EQ(reader.undecodable(), 1);
}

}  // namespace
}  // namespace perceptor
