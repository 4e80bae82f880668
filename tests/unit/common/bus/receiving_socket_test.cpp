#include "common/bus/receiving_socket.hpp"

#include <string>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace perceptor {
namespace {

TEST(BusPort, IsReadAsLcmReadsIt) {
  EXPECT_EQ(bus_port("udpm://"), 7667);
  EXPECT_EQ(bus_port("udpm://239.255.76.67"), 7667);
  EXPECT_EQ(bus_port("udpm://239.255.76.67?ttl=1"), 7667);
  EXPECT_EQ(bus_port("udpm://239.255.76.67:7700"), 7700);
  EXPECT_EQ(bus_port("udpm://239.255.76.67:7700?ttl=0&recv_buf_size=1"), 7700);
  EXPECT_EQ(bus_port("udpm://:7700"), 7700);
}

TEST(BusPort, OfWhatIsNoUdpBusIsNone) {
  EXPECT_FALSE(bus_port("memq://"));
  EXPECT_FALSE(bus_port("file:///log.lcmlog"));
  EXPECT_FALSE(bus_port("udpm://239.255.76.67:nonsense"));
  EXPECT_FALSE(bus_port("udpm://239.255.76.67:99999"));
}

const std::string kNumber(4, '\1');

/// A datagram with a message that has no content.
std::string message(const std::string& channel) { return "LC02" + kNumber + channel + '\0'; }

/// A socket as LCM's, on a port of its own, and what is sent to it within this machine.
class ReceivingSocketTest : public testing::Test {
 protected:
  ReceivingSocketTest() : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* address = reinterpret_cast<sockaddr*>(&address_);
    socklen_t size = sizeof(address_);
    EXPECT_EQ(bind(descriptor_, address, size), 0);
    EXPECT_EQ(getsockname(descriptor_, address, &size), 0);
  }
  ~ReceivingSocketTest() override { close(descriptor_); }

  std::uint16_t port() const { return ntohs(address_.sin_port); }

  void send(const std::string& datagram) const {
    const int sender = socket(AF_INET, SOCK_DGRAM, 0);
    sendto(sender, datagram.data(), datagram.size(), 0,
           reinterpret_cast<const sockaddr*>(&address_), sizeof(address_));
    close(sender);
  }

  /// What waits; empty: nothing.
  std::string receive() const {
    std::string datagram(100, '\0');
    const ssize_t size = recv(descriptor_, datagram.data(), datagram.size(), MSG_DONTWAIT);
    datagram.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return datagram;
  }

  int descriptor_;
  sockaddr_in address_{};
};

TEST_F(ReceivingSocketTest, IsFoundByItsPort) {
  EXPECT_EQ(ReceivingSockets(port()).size(), 1U);
  EXPECT_EQ(ReceivingSockets(1).size(), 0U);
  const int inherited = dup(descriptor_);
  EXPECT_EQ(ReceivingSockets(port()).size(), 2U);
  close(inherited);
}

TEST_F(ReceivingSocketTest, OnlyWholeMessagesComeThroughAndTheRestIsCounted) {
  const ReceivingSockets sockets(port());
  sockets.let_only_whole_messages_through();
  EXPECT_EQ(sockets.drops(), 0);
  for (const char* kept_out : {"LC03 a fragment", "", "LC0", "something else", "xLC02"})
    send(kept_out);
  EXPECT_EQ(receive(), "");
  EXPECT_EQ(sockets.drops(), 5);
  send(message("A_CHANNEL") + "and its content");
  EXPECT_EQ(receive(), message("A_CHANNEL") + "and its content");
}

TEST_F(ReceivingSocketTest, AChannelWhoseNameHasNoEndIsKeptOut) {
  const ReceivingSockets sockets(port());
  sockets.let_only_whole_messages_through();
  const std::string longest(63, 'x');
  send(message(longest));
  EXPECT_EQ(receive(), message(longest));
  for (const std::string& name : {std::string(), std::string("PICO_LASER"), longest})
    send("LC02" + kNumber + name);
  send(message(longest + "x"));
  EXPECT_EQ(receive(), "");
  EXPECT_EQ(sockets.drops(), 4);
}

TEST_F(ReceivingSocketTest, ALargerBufferHoldsMore) {
  const ReceivingSockets sockets(port());
  const auto held = [&] {
    int count = 0;
    for (int i = 0; i < 100; ++i) send(message("A_CHANNEL") + std::string(1000, 'x'));
    while (!receive().empty()) ++count;
    return count;
  };
  sockets.grow_buffers(5'000);
  const int few = held();
  EXPECT_LT(few, 20);
  sockets.grow_buffers(100'000);
  EXPECT_GT(held(), few);
  EXPECT_GT(sockets.drops(), 0);
}

}  // namespace
}  // namespace perceptor
