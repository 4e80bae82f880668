#include "common/bus/bus.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/bus/channels.hpp"

namespace perceptor {
namespace {

/// One component on a private in-process bus.
class BusTest : public testing::Test {
 protected:
  void listen() {
    bus_.subscribe<pico::odometry_t>(channel::odometry, 10,
                                     [this](const pico::odometry_t& odometry, bool began_anew) {
                                       if (odometry.seq == 666) throw std::runtime_error("bug");
                                       taken_.push_back(odometry.utime);
                                       anew_ += began_anew ? 1 : 0;
                                     });
  }

  static pico::odometry_t odometry(std::int64_t utime, std::int64_t session = 1,
                                   std::int64_t seq = 0) {
    pico::odometry_t message{};
    message.utime = utime;
    message.session = session;
    message.seq = seq;
    return message;
  }

  void send(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
    lcm_.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void send(const pico::odometry_t& message) { send(channel::odometry, messages::encode(message)); }

  std::int64_t rejected(const std::string& reason) {
    for (const auto& entry : status_.message(0, false).rejects)
      if (entry.reason == reason) return entry.count;
    return 0;
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"test", 42};
  Bus bus_{lcm_, lcm_, status_};
  std::vector<std::int64_t> taken_;
  int anew_ = 0;
};

TEST_F(BusTest, HandsOnGoodMessagesInOrder) {
  listen();
  send(odometry(100, 1, 0));
  send(odometry(200, 1, 1));
  EXPECT_EQ(taken_, (std::vector<std::int64_t>{100, 200}));
  EXPECT_EQ(anew_, 1);
  const auto status = status_.message(0, false);
  ASSERT_EQ(status.num_inputs, 1);
  EXPECT_EQ(status.inputs[0].received, 2);
  EXPECT_EQ(status.inputs[0].rejected, 0);
  EXPECT_EQ(status.inputs[0].last_utime, 200);
  EXPECT_EQ(status.processed, 0) << "nothing came of them";
}

TEST_F(BusTest, TakesTheTimeOfMessagesThatLeadToOutput) {
  bus_.subscribe<pico::odometry_t>(channel::odometry, 10,
                                   [this](const pico::odometry_t& odometry, bool) {
                                     if (odometry.seq % 2 == 0)
                                       bus_.publish(channel::position, pico::position_t{});
                                   });
  for (int i = 0; i < 10; ++i) send(odometry(100 + i, 1, i));
  EXPECT_EQ(status_.message(0, false).processed, 5);
}

TEST_F(BusTest, DoesNotWaitForCommands) {
  bus_.subscribe_command<pico::velocity_t>(channel::velocity, 5, [](const pico::velocity_t&) {});
  EXPECT_EQ(status_.message(0, false).note, "");
}

TEST_F(BusTest, CountsWhatIsNoMessageOfTheTypeAndLivesOn) {
  listen();
  auto truncated = messages::encode(odometry(100));
  truncated.resize(truncated.size() - 3);
  send(channel::odometry, truncated);
  send(channel::odometry, messages::encode(pico::velocity_t{}));
  send(channel::odometry, {});
  EXPECT_TRUE(taken_.empty());
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 3);
  send(odometry(100));
  EXPECT_EQ(taken_.size(), 1U);
}

TEST_F(BusTest, CountsWhatMakesNoSense) {
  listen();
  auto nowhere = odometry(100);
  nowhere.robot_in_odometry.x = std::numeric_limits<double>::quiet_NaN();
  send(nowhere);
  EXPECT_TRUE(taken_.empty());
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 1);
}

TEST_F(BusTest, DropsASmallStepBackInTime) {
  listen();
  send(odometry(10'000'000));
  send(odometry(9'000'000));
  send(odometry(10'000'000));
  EXPECT_EQ(taken_.size(), 1U);
  EXPECT_EQ(rejected("time stepped back"), 1);
  EXPECT_EQ(rejected("time stood still"), 1);
}

TEST_F(BusTest, BeginsAnewAfterALargeStepBackAndInANewSession) {
  listen();
  send(odometry(10'000'000));
  send(odometry(1'000'000));
  send(odometry(1'000'100, 2));
  EXPECT_EQ(anew_, 3);
  EXPECT_EQ(status_.message(0, false).inputs[0].restarts, 2);
}

TEST_F(BusTest, TellsThatTwoSourcesTakeTurns) {
  listen();
  for (const std::int64_t session : {1, 2, 1}) send(odometry(100, session, 0));
  EXPECT_EQ(status_.message(0, false).note, "two sources take turns on PICO_ODOMETRY");
}

TEST_F(BusTest, CountsWhatNeverCameAlsoWhereALateOneIsTurnedDown) {
  listen();
  send(odometry(100, 1, 0));
  send(odometry(400, 1, 3));
  send(odometry(200, 1, 1));
  const pico::status_t status = status_.message(0, false);
  EXPECT_EQ(status.inputs.at(0).missed, 1);
  EXPECT_EQ(rejected("time stepped back"), 1);
}

TEST_F(BusTest, TurnsDownWhatIsTooLargeToBeAMessage) {
  listen();
  send(channel::odometry, std::vector<std::uint8_t>(kMaxReceived + 1));
  EXPECT_EQ(rejected("too large"), 1);
}

/// As in a process: what has come is checked at once, and handled one by one.
class WaitingMessagesTest : public BusTest {
 protected:
  WaitingMessagesTest() { bus_.let_messages_wait(); }

  void handle_all() {
    while (bus_.handle_next()) {
    }
  }
};

TEST_F(WaitingMessagesTest, AreCheckedAtOnceAndHandledInOrderOfArrival) {
  std::vector<std::string> order;
  for (const char* name : {channel::odometry, channel::laser})
    bus_.subscribe_command<pico::odometry_t>(
        name, 10, [&order, name](const pico::odometry_t&) { order.emplace_back(name); });
  send(channel::odometry, messages::encode(odometry(1)));
  send(channel::laser, messages::encode(odometry(2)));
  send(channel::odometry, {1, 2, 3});
  send(channel::odometry, messages::encode(odometry(3)));
  EXPECT_TRUE(order.empty());
  EXPECT_TRUE(bus_.has_waiting());
  EXPECT_EQ(status_.message(0, false).inputs.at(1).rejected, 1);
  handle_all();
  EXPECT_EQ(order,
            (std::vector<std::string>{channel::odometry, channel::laser, channel::odometry}));
  EXPECT_FALSE(bus_.has_waiting());
}

TEST_F(WaitingMessagesTest, OfTooManyTheOldestIsTurnedDownAndCounted) {
  listen();  // for ten
  for (int i = 0; i < 13; ++i) {
    send(odometry(100 + i, 1, i));
    send(channel::odometry, {1, 2, 3});
  }
  handle_all();
  ASSERT_EQ(taken_.size(), 10U);
  EXPECT_EQ(taken_.front(), 103);
  EXPECT_EQ(taken_.back(), 112);
  EXPECT_EQ(anew_, 1) << "the first that is left tells that the channel began anew";
  EXPECT_EQ(rejected("too slow for all that comes"), 3);
  EXPECT_EQ(status_.message(0, false).inputs.at(0).missed, 0);
}

TEST_F(WaitingMessagesTest, AreCheckedWhileAHandlerTakesItsTime) {
  std::vector<std::int64_t> checked_before;
  bus_.subscribe_command<pico::odometry_t>(channel::odometry, 10, [&](const pico::odometry_t&) {
    bus_.check_what_came();
    checked_before.push_back(status_.message(0, false).inputs.at(0).received);
  });
  const auto payload = messages::encode(odometry(1));
  for (int i = 0; i < 3; ++i)
    lcm_.publish(channel::odometry, payload.data(), static_cast<unsigned>(payload.size()));
  ASSERT_GT(lcm_.handle(), -1);
  handle_all();
  EXPECT_EQ(checked_before, (std::vector<std::int64_t>{3, 3, 3}));
}

TEST_F(WaitingMessagesTest, SurviveAHandlerThatThrows) {
  listen();
  send(odometry(100, 1, 666));
  send(odometry(200, 1, 667));
  handle_all();
  EXPECT_EQ(taken_, std::vector<std::int64_t>{200});
  EXPECT_EQ(rejected("failed while it was processed"), 1);
}

TEST_F(BusTest, SurvivesAHandlerThatThrows) {
  listen();
  send(odometry(100, 1, 666));
  send(odometry(200, 1, 667));
  EXPECT_EQ(taken_, std::vector<std::int64_t>{200});
  EXPECT_EQ(rejected("failed while it was processed"), 1);
}

TEST_F(BusTest, CountsWhatItSends) {
  bus_.publish(channel::odometry, odometry(100, 3, 17));
  const auto status = status_.message(0, false);
  ASSERT_EQ(status.num_outputs, 1);
  EXPECT_EQ(status.outputs[0].channel, "PICO_ODOMETRY");
  EXPECT_EQ(status.outputs[0].published, 1);
  EXPECT_EQ(status.outputs[0].session, 3);
  EXPECT_EQ(status.outputs[0].last_seq, 17);
}

TEST_F(BusTest, DoesNotSendWhatNeedsMoreThanOneDatagram) {
  pico::laser_scan_t scan{};
  scan.ranges.assign(20'000, 1.0F);
  scan.num_ranges = 20'000;
  bus_.publish(channel::laser, scan);
  EXPECT_TRUE(status_.message(0, false).outputs.empty());
  EXPECT_EQ(rejected("too large to send"), 1);
}

TEST_F(BusTest, SendsARecordedMessageByteForByteWithItsStamp) {
  std::vector<std::uint8_t> seen;
  lcm_subscribe(
      lcm_.getUnderlyingLCM(), channel::odometry,
      [](const lcm_recv_buf_t* buffer, const char*, void* self) {
        const auto* data = static_cast<const std::uint8_t*>(buffer->data);
        static_cast<std::vector<std::uint8_t>*>(self)->assign(data, data + buffer->data_size);
      },
      &seen);
  const auto recorded = messages::encode(odometry(100, 5, 9));
  bus_.publish_recorded(channel::odometry, recorded);
  lcm_.handleTimeout(0);
  EXPECT_EQ(seen, recorded);
  EXPECT_EQ(status_.message(0, false).outputs[0].last_seq, 9);
}

TEST_F(BusTest, DoesNotSendARecordedMessageThatIsDamagedOrNotOurs) {
  auto damaged = messages::encode(odometry(100));
  damaged.pop_back();
  bus_.publish_recorded(channel::odometry, damaged);
  bus_.publish_recorded("ELSEWHERE", messages::encode(odometry(100)));
  EXPECT_TRUE(status_.message(0, false).outputs.empty());
  EXPECT_EQ(rejected("no channel of ours"), 1);
}

TEST_F(BusTest, TakesCommandsWhateverTheirStamp) {
  int commands = 0;
  bus_.subscribe_command<pico::velocity_t>(channel::velocity, 5,
                                           [&](const pico::velocity_t&) { ++commands; });
  pico::velocity_t command{};
  send(channel::velocity, messages::encode(command));
  send(channel::velocity, messages::encode(command));
  command.vx = std::numeric_limits<double>::infinity();
  send(channel::velocity, messages::encode(command));
  EXPECT_EQ(commands, 2);
}

TEST_F(BusTest, KnowsTheTypeOnEachOfItsChannels) {
  for (const char* name :
       {channel::laser, channel::odometry, channel::sonar, channel::velocity, channel::open_door,
        channel::speak, channel::truth, channel::world, channel::position, channel::proximity,
        channel::current_map, channel::local_map, channel::identified_map, channel::entrance,
        channel::global_map, channel::world_position, "STATUS_SCAN"})
    EXPECT_NE(channel::type_on(name), nullptr) << name;
  EXPECT_EQ(channel::type_on("LIDAR"), nullptr);
}

TEST(Status, SaysWhatItWaitsForThenOkThenStale) {
  Status status("scan", 7);
  EXPECT_EQ(status.channel(), "STATUS_SCAN");
  status.add_input("A");
  status.add_input("B");
  auto message = status.message(1, false);
  EXPECT_EQ(message.note, "waiting for A, B");
  EXPECT_EQ(message.inputs[0].state, pico::status_input_t::WAITING);
  status.received("A");
  message = status.message(2, false);
  EXPECT_EQ(message.note, "waiting for B");
  EXPECT_EQ(message.inputs[0].state, pico::status_input_t::OK);
  status.message(3, false);
  message = status.message(4, true);
  EXPECT_EQ(message.inputs[0].state, pico::status_input_t::STALE);
  EXPECT_EQ(message.seq, 3);
  EXPECT_EQ(message.boot, 7);
  EXPECT_TRUE(message.last);
  EXPECT_FALSE(message.degraded);
}

TEST(Status, KeepsTheFirstReasonForBeingDegraded) {
  Status status("scan", 7);
  status.degrade("a buffer overflowed");
  status.degrade("something else");
  status.set_note("and a note");
  const auto message = status.message(0, false);
  EXPECT_TRUE(message.degraded);
  EXPECT_EQ(message.note, "a buffer overflowed; and a note");
}

TEST(Status, GivesQuantilesOfTheProcessingTime) {
  Status status("scan", 7);
  for (int i = 1; i <= 2000; ++i) status.processing_time(i);
  const auto message = status.message(0, false);
  EXPECT_EQ(message.processed, 2000);
  EXPECT_NEAR(message.p50_us, 1500, 1);  // of the last 1000: 1001 to 2000
  EXPECT_NEAR(message.p99_us, 1990, 1);
  EXPECT_EQ(message.max_us, 2000);
  EXPECT_GT(message.rss_bytes, 100'000);
}

TEST(Status, ReportsRejectedMessagesOnceAsNews) {
  Status status("scan", 7);
  status.rejected("A", "too short");
  status.rejected("A", "too short");
  status.counted("A", "beam: no return", 500);
  EXPECT_EQ(status.take_news(), std::vector<std::string>{"A: rejected 2 (too short)"});
  EXPECT_TRUE(status.take_news().empty());
  EXPECT_EQ(status.message(0, false).num_rejects, 2);
}

}  // namespace
}  // namespace perceptor
