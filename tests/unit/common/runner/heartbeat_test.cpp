#include "common/runner/heartbeat.hpp"

#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace perceptor {
namespace {

constexpr std::int64_t kPatience = 2'000'000;  // [us]

/// Listens as systemd does, on a socket without a file.
class HeartbeatTest : public testing::Test {
 protected:
  HeartbeatTest() : descriptor_(socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    auto* any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(descriptor_, any, sizeof(address.sun_family)), 0);
    socklen_t size = sizeof(address);
    EXPECT_EQ(getsockname(descriptor_, any, &size), 0);
    const std::string name(address.sun_path + 1, size - sizeof(address.sun_family) - 1);
    setenv("NOTIFY_SOCKET", ("@" + name).c_str(), 1);
    setenv("WATCHDOG_USEC", std::to_string(kPatience).c_str(), 1);
  }
  ~HeartbeatTest() override {
    close(descriptor_);
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
  }

  std::vector<std::string> told() const {
    std::vector<std::string> messages;
    std::array<char, 100> text{};
    for (;;) {
      const ssize_t size = recv(descriptor_, text.data(), text.size(), MSG_DONTWAIT);
      if (size < 0) return messages;
      messages.emplace_back(text.data(), static_cast<std::size_t>(size));
    }
  }

  int descriptor_;
};

TEST_F(HeartbeatTest, TellsThatItIsReadyAndThatItLives) {
  Heartbeat heartbeat;
  heartbeat.ready();
  EXPECT_EQ(told(), std::vector<std::string>{"READY=1"});
  const std::int64_t next = heartbeat.beat(1000);
  EXPECT_EQ(told(), std::vector<std::string>{"WATCHDOG=1"});
  EXPECT_GT(next, 1000);
  EXPECT_LE(next, 1000 + kPatience / 10);
  EXPECT_EQ(heartbeat.beat(next - 1), next);
  EXPECT_TRUE(told().empty());
  heartbeat.beat(next);
  EXPECT_EQ(told().size(), 1U);
}

TEST_F(HeartbeatTest, GoesOnWhereNobodyReads) {
  Heartbeat heartbeat;
  for (int i = 0; i < 10'000; ++i) heartbeat.beat(i * kPatience);
  EXPECT_FALSE(told().empty());
}

TEST_F(HeartbeatTest, SaysNothingWhereNobodyAsked) {
  unsetenv("NOTIFY_SOCKET");
  Heartbeat heartbeat;
  heartbeat.ready();
  EXPECT_EQ(heartbeat.beat(0), std::numeric_limits<std::int64_t>::max());
  EXPECT_TRUE(told().empty());
}

TEST_F(HeartbeatTest, IsReadyAlsoWhereNobodyWatches) {
  for (const char* patience : {"0", "-1", "soon", ""}) {
    setenv("WATCHDOG_USEC", patience, 1);
    Heartbeat heartbeat;
    heartbeat.ready();
    EXPECT_EQ(heartbeat.beat(0), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(told(), std::vector<std::string>{"READY=1"});
  }
}

}  // namespace
}  // namespace perceptor
