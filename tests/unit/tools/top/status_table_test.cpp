#include "tools/top/status_table.hpp"

#include <gmock/gmock.h>

namespace perceptor {
namespace {

using testing::HasSubstr;

pico::status_t status(std::int64_t utime, std::int64_t published, double cpu_s) {
  pico::status_t message{};
  message.component = "scan";
  message.utime = utime;
  message.boot = 1;
  message.cpu_s = cpu_s;
  message.outputs.resize(1);
  message.outputs[0].published = published;
  message.inputs.resize(1);
  message.inputs[0].state = pico::status_input_t::OK;
  return message;
}

TEST(StatusTable, RatesAreThoseBetweenTheLastTwo) {
  StatusTable table;
  table.take(status(1'000'000, 10, 1.0), 0);
  table.take(status(3'000'000, 90, 1.5), 0);
  const std::vector<Row> rows = table.rows(0);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_THAT(rows[1].text, HasSubstr("scan        ok"));
  EXPECT_THAT(rows[1].text, HasSubstr(" 40.0 ")) << "80 messages in 2 s";
  EXPECT_THAT(rows[1].text, HasSubstr(" 25.0 ")) << "0.5 s of 2 s";
  EXPECT_EQ(rows[1].look, Row::Look::plain);
}

TEST(StatusTable, AProcessThatWasStartedAgainHasNoRateYet) {
  StatusTable table;
  table.take(status(1'000'000, 1000, 9.0), 0);
  pico::status_t restarted = status(2'000'000, 1, 0.1);
  restarted.boot = 2;
  table.take(restarted, 0);
  EXPECT_THAT(table.rows(0).at(1).text, HasSubstr(" 0.0 "));
}

TEST(StatusTable, SaysWhatStateAComponentIsIn) {
  StatusTable table;
  pico::status_t waiting = status(1, 0, 0.0);
  waiting.inputs[0].state = pico::status_input_t::WAITING;
  waiting.note = "waits for PICO_LASER";
  table.take(waiting, 0);
  EXPECT_THAT(table.rows(0).at(1).text, HasSubstr("waiting"));
  EXPECT_THAT(table.rows(0).at(1).text, HasSubstr("waits for PICO_LASER"));
  pico::status_t ended = status(2, 0, 0.0);
  ended.last = 1;
  table.take(ended, 0);
  EXPECT_THAT(table.rows(0).at(1).text, HasSubstr("ended"));
  EXPECT_EQ(table.rows(0).at(1).look, Row::Look::alarm);
}

TEST(StatusTable, AComponentThatSaysNothingMoreIsSilent) {
  StatusTable table;
  table.take(status(1, 0, 0.0), 0);
  EXPECT_THAT(table.rows(5'000'000).at(1).text, HasSubstr("silent"));
  EXPECT_EQ(table.rows(5'000'000).at(1).look, Row::Look::alarm);
}

TEST(StatusTable, AlarmsWhereMessagesWereTurnedDown) {
  StatusTable table;
  pico::status_t rejecting = status(1, 0, 0.0);
  rejecting.inputs[0].rejected = 2;
  table.take(rejecting, 0);
  EXPECT_EQ(table.rows(0).at(1).look, Row::Look::alarm);
}

}  // namespace
}  // namespace perceptor
