/// What somebody else sends to the bus's port cannot bring a process down, and is counted.
#include <random>
#include <thread>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <sys/socket.h>
#include <unistd.h>

#include "common/bus/receiving_socket.hpp"
#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

constexpr std::uint16_t kPort = 7667;
constexpr const char* kGroup = "239.255.76.67";
constexpr const char* kKeptOut = "no whole message, or no room for it";

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t number, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// As liblcm 1.3.1 reads it: magic, number, size of the message, offset, which of how many.
Bytes fragment(std::uint32_t message_size, std::uint32_t offset, std::uint32_t which,
               const Bytes& content) {
  Bytes bytes;
  append(bytes, 0x4C433033, 4);  // "LC03"
  append(bytes, 1, 4);
  append(bytes, message_size, 4);
  append(bytes, offset, 4);
  append(bytes, which, 2);
  append(bytes, 2, 2);
  bytes.insert(bytes.end(), content.begin(), content.end());
  return bytes;
}

/// Sends to everybody on the bus.
class Stranger {
 public:
  Stranger() : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_port = htons(kPort);
    inet_pton(AF_INET, kGroup, &address_.sin_addr);
  }
  ~Stranger() { close(descriptor_); }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  void send(const Bytes& datagram) const {
    sendto(descriptor_, datagram.data(), datagram.size(), 0,
           reinterpret_cast<const sockaddr*>(&address_), sizeof(address_));
  }

 private:
  int descriptor_;
  sockaddr_in address_{};
};

class HostileSenderTest : public testing::Test {
 protected:
  HostileSenderTest() {
    // This process listens to the same bus, and has to survive as well.
    ReceivingSockets::guard("");
  }

  std::int64_t kept_out() {
    for (const auto& reject : status_.last("proximity").rejects)
      if (reject.reason == kKeptOut) return reject.count;
    return 0;
  }

  std::int64_t arrived() { return published(status_.last("proximity"), "PROXIMITY"); }
  std::int64_t missed() { return status_.last("proximity").inputs.at(0).missed; }
  /// Came, but proximity was not on turn for so long that newer ones took their place.
  std::int64_t came_too_late() {
    return rejected(status_.last("proximity"), "PICO_LASER", "too slow for all that comes");
  }

  StatusListener status_;
  Process proximity_{{program("pico-proximity")}};
  Stranger stranger_;
};

TEST_F(HostileSenderTest, AFragmentWhoseOffsetWrapsIsKeptOut) {
  ASSERT_TRUE(status_.wait_for({"proximity"}));
  const std::string channel = "PICO_LASER";
  Bytes first(channel.begin(), channel.end());
  first.resize(60);
  for (int i = 0; i < 10; ++i) {
    stranger_.send(fragment(100, 0, 0, first));
    stranger_.send(fragment(100, 0xFFFFFF00U, 1, Bytes(0x140)));  // ends at 64
  }
  EXPECT_TRUE(status_.wait_until([&] { return kept_out() == 20; })) << kept_out();
  EXPECT_EQ(proximity_.stop(), 0);
}

TEST_F(HostileSenderTest, AFloodHidesNoGoodMessage) {
  ASSERT_TRUE(status_.wait_for({"proximity"}));
  constexpr int kScans = 100;
  constexpr int kStrange = 20'000;
  std::thread flood([&] {
    std::mt19937 random(1);
    for (int i = 0; i < kStrange; ++i) {
      Bytes datagram(random() % 200);
      for (auto& byte : datagram) byte = static_cast<std::uint8_t>(random());
      stranger_.send(i % 2 == 0 ? datagram
                                : fragment(static_cast<std::uint32_t>(random()),
                                           static_cast<std::uint32_t>(random()),
                                           i % 4 == 1 ? 0U : 1U, datagram));
    }
  });
  pico::laser_scan_t scan{};
  scan.valid_min = 0.01;
  scan.valid_max = 10.0;
  scan.range_sigma = 0.01;
  scan.num_ranges = 1;
  scan.ranges = {2.0F};
  for (int i = 0; i < kScans; ++i) {
    scan.utime = 5'000'000 + i;
    scan.seq = i;
    status_.lcm().publish("PICO_LASER", &scan);
    status_.lcm().handleTimeout(10);
  }
  flood.join();
  EXPECT_TRUE(status_.wait_until([&] { return arrived() + missed() + came_too_late() == kScans; }))
      << arrived() << " arrived, " << missed() << " were missed, " << came_too_late()
      << " came too late";
  EXPECT_GE(arrived(), kScans * 9 / 10) << "a busy machine may be late for some";
  EXPECT_TRUE(status_.wait_until([&] { return kept_out() == kStrange; })) << kept_out();
  EXPECT_EQ(proximity_.stop(), 0);
}

}  // namespace
}  // namespace perceptor::test
