#include "tools/top/channel_table.hpp"

#include <gmock/gmock.h>
#include <pico/odometry_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/encode.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

using testing::HasSubstr;

std::vector<std::uint8_t> odometry(std::int64_t seq) {
  pico::odometry_t message{};
  set_stamp(message, {(seq + 1) * 10'000, 1, seq});
  return messages::encode(message);
}

TEST(ChannelTable, WithoutMessagesHasOnlyATitle) { EXPECT_EQ(ChannelTable().rows(0).size(), 1U); }

TEST(ChannelTable, CountsTheLastTwoSeconds) {
  ChannelTable table;
  for (int i = 0; i < 300; ++i)
    table.take(channel::odometry, odometry(i), std::int64_t{i} * 20'000);
  const std::vector<Row> rows = table.rows(5'980'000);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_THAT(rows[1].text, HasSubstr("PICO_ODOMETRY"));
  EXPECT_THAT(rows[1].text, HasSubstr(" 50.5 ")) << "101 messages of both ends of two seconds";
  EXPECT_EQ(rows[1].look, Row::Look::plain);
}

TEST(ChannelTable, AlarmsWhereMessagesWereMissed) {
  ChannelTable table;
  table.take(channel::odometry, odometry(0), 0);
  table.take(channel::odometry, odometry(4), 1);
  EXPECT_EQ(table.rows(1).at(1).look, Row::Look::alarm);
  EXPECT_THAT(table.rows(1).at(1).text, HasSubstr(" 3 "));
}

TEST(ChannelTable, AlarmsWhereBytesAreNoneOfTheChannelsType) {
  ChannelTable table;
  const std::vector<std::uint8_t> bytes = {1, 2, 3};
  table.take(channel::odometry, bytes, 0);
  table.take("SOMEBODY_ELSES", bytes, 0);
  EXPECT_EQ(table.rows(1).at(1).look, Row::Look::alarm);
  EXPECT_EQ(table.rows(1).at(2).look, Row::Look::plain) << "whatever it means";
}

TEST(ChannelTable, AlarmsWhereAChannelHasStopped) {
  ChannelTable table;
  table.take(channel::odometry, odometry(0), 0);
  table.take(channel::open_door, {}, 0);
  ASSERT_THAT(table.rows(0).at(1).text, HasSubstr("CMD_OPEN_DOOR"));
  EXPECT_EQ(table.rows(5'000'000).at(2).look, Row::Look::alarm);
  EXPECT_THAT(table.rows(5'000'000).at(2).text, HasSubstr(" 5.0"));
}

}  // namespace
}  // namespace perceptor
