#include "components/bridge/ros/master_probe.hpp"

#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace perceptor {
namespace {

using Answer = MasterProbe::Answer;

/// A port of this machine that takes connections, and says what it is told to.
class Port {
 public:
  Port() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* any = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof(address);
    if (bind(socket_, any, size) != 0 || listen(socket_, 4) != 0 ||
        getsockname(socket_, any, &size) != 0)
      throw std::runtime_error("no port");
    number_ = std::to_string(ntohs(address.sin_port));
  }
  ~Port() { close(); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  void close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  const std::string& number() const { return number_; }

  /// Takes the next connection, gives what it asks, and replies.
  std::string reply(const std::string& text) const {
    const int connection = accept(socket_, nullptr, nullptr);
    std::string asked;
    std::array<char, 4096> block{};
    while (asked.find("</methodCall>") == std::string::npos) {
      const ssize_t got = recv(connection, block.data(), block.size(), 0);
      if (got <= 0) break;
      asked.append(block.data(), static_cast<std::size_t>(got));
    }
    send(connection, text.data(), text.size(), MSG_NOSIGNAL);
    ::close(connection);
    return asked;
  }

 private:
  int socket_;
  std::string number_;
};

/// The answer, asked for as the bridge does; `now` goes on with each call.
Answer answer_of(MasterProbe& probe, std::int64_t& now) {
  Answer answer = Answer::not_yet;
  while (answer == Answer::not_yet) {
    answer = probe.ask(now);
    now += 2'000;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return answer;
}

TEST(MasterProbe, AMasterThatRepliesIsThere) {
  const Port port;
  MasterProbe probe({"127.0.0.1", port.number()}, "pico_bridge");
  std::string asked;
  std::thread master([&] { asked = port.reply("HTTP/1.0 200 OK\r\n\r\n<methodResponse/>"); });
  std::int64_t now = 0;
  EXPECT_EQ(answer_of(probe, now), Answer::yes);
  master.join();
  EXPECT_TRUE(asked.starts_with("POST /RPC2 ")) << asked;
  EXPECT_NE(asked.find("<methodName>getPid</methodName>"), std::string::npos);
  EXPECT_NE(asked.find("/pico_bridge"), std::string::npos);
}

TEST(MasterProbe, APortThatNobodyListensToIsNone) {
  Port port;
  port.close();
  MasterProbe probe({"127.0.0.1", port.number()}, "pico_bridge");
  std::int64_t now = 0;
  EXPECT_EQ(answer_of(probe, now), Answer::no);
  EXPECT_LT(now, MasterProbe::kPatience) << "said at once";
}

/// A master that hangs, or a machine that swallows what it is sent.
TEST(MasterProbe, SilenceIsNoneWhenPatienceEnds) {
  const Port port;  // the kernel takes the connection, nobody replies
  MasterProbe probe({"127.0.0.1", port.number()}, "pico_bridge");
  std::int64_t now = 0;
  EXPECT_EQ(answer_of(probe, now), Answer::no);
  EXPECT_GE(now, MasterProbe::kPatience);
}

TEST(MasterProbe, AnotherKindOfServerIsNone) {
  const Port port;
  MasterProbe probe({"127.0.0.1", port.number()}, "pico_bridge");
  for (const std::string reply :
       {"HTTP/1.0 404 Not Found\r\n\r\n", "SSH-2.0-OpenSSH_9.2\r\n", ""}) {
    std::thread server([&] { port.reply(reply); });
    std::int64_t now = 0;
    EXPECT_EQ(answer_of(probe, now), Answer::no) << reply;
    server.join();
  }
}

TEST(MasterProbe, AHostThatIsNotKnownIsNone) {
  MasterProbe probe({"no-such-robot.invalid", "11311"}, "pico_bridge");
  std::int64_t now = 0;
  EXPECT_EQ(answer_of(probe, now), Answer::no);
}

TEST(MasterUri, OfAHostAndAPort) {
  const auto address = parse_master_uri("http://pico:11311/");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "pico");
  EXPECT_EQ(address->port, "11311");
  for (const char* wrong : {"", "pico:11311", "http://", "http://pico", "http://:11311",
                            "http://pico:", "http://pico:0", "http://pico:99999",
                            "http://pico:11311/x", "https://pico:11311"})
    EXPECT_FALSE(parse_master_uri(wrong)) << wrong;
}

}  // namespace
}  // namespace perceptor
