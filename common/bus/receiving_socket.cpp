#include "common/bus/receiving_socket.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <linux/filter.h>
#include <linux/sock_diag.h>
#include <sys/socket.h>

#include "common/bus/own_sockets.hpp"

namespace perceptor {
namespace {

constexpr std::string_view kScheme = "udpm://";
constexpr std::uint16_t kDefaultPort = 7667;
constexpr int kBuffer = 4 * 1024 * 1024;             // [bytes] seconds of all channels
constexpr std::uint32_t kWholeMessage = 0x4C433032;  // "LC02", network order
constexpr std::uint32_t kMagicAt = 8;                // [bytes] behind the UDP header
constexpr std::uint32_t kChannelAt = 16;             // [bytes] behind magic and number
constexpr std::uint32_t kLongestChannel = 63;        // [bytes] without its end

std::string default_url() {
  const char* url = std::getenv("LCM_DEFAULT_URL");
  return url == nullptr ? std::string(kScheme) : std::string(url);
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "LC02", and the channel's name has an end within the datagram: what is read beyond the datagram
/// drops it.
std::vector<sock_filter> whole_messages_only() {
  constexpr std::uint32_t kAll = 0xFFFFFFFF;
  const sock_filter keep_out = BPF_STMT(BPF_RET | BPF_K, 0);
  const sock_filter let_through = BPF_STMT(BPF_RET | BPF_K, kAll);
  std::vector<sock_filter> program = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kMagicAt),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kWholeMessage, 1, 0),
      keep_out,
  };
  for (std::uint32_t i = 0; i <= kLongestChannel; ++i) {
    program.push_back(BPF_STMT(BPF_LD | BPF_B | BPF_ABS, kChannelAt + i));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 0, 1));
    program.push_back(let_through);
  }
  program.push_back(keep_out);
  return program;
}

}  // namespace

std::optional<std::uint16_t> bus_port(const std::string& lcm_url) {
  const std::string url = lcm_url.empty() ? default_url() : lcm_url;
  if (!url.starts_with(kScheme)) return std::nullopt;
  const std::string place = url.substr(kScheme.size(), url.find('?') - kScheme.size());
  const std::size_t colon = place.find(':');
  if (colon == std::string::npos) return kDefaultPort;
  return number_in<std::uint16_t>(std::string_view(place).substr(colon + 1));
}

ReceivingSockets::ReceivingSockets(std::uint16_t port)
    : descriptors_(own_sockets(SOCK_DGRAM, port)) {}

ReceivingSockets ReceivingSockets::guard(const std::string& lcm_url) {
  const auto port = bus_port(lcm_url);
  ReceivingSockets sockets = port ? ReceivingSockets(*port) : ReceivingSockets();
  sockets.let_only_whole_messages_through();
  sockets.grow_buffers(kBuffer);
  return sockets;
}

void ReceivingSockets::let_only_whole_messages_through() const {
  std::vector<sock_filter> program = whole_messages_only();
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  for (const int descriptor : descriptors_)
    if (setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof(filter)) != 0)
      throw std::system_error(errno, std::generic_category(),
                              "cannot filter what the bus receives");
}

void ReceivingSockets::grow_buffers(int bytes) const {
  for (const int descriptor : descriptors_)
    if (setsockopt(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, &bytes, sizeof(bytes)) != 0)
      setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof(bytes));
}

std::int64_t ReceivingSockets::drops() const {
  std::int64_t sum = 0;
  for (const int descriptor : descriptors_) {
    std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
    socklen_t size = sizeof(memory);
    if (getsockopt(descriptor, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) == 0)
      sum += memory[SK_MEMINFO_DROPS];
  }
  return sum;
}

}  // namespace perceptor
