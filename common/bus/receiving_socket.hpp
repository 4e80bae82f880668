/// @file The socket that LCM receives from, made fit for a bus that nobody guards.
///
/// liblcm 1.3.1 listens on every network. One fragment whose offset wraps crashes it, and a message
/// whose channel's name has no end it takes for one of 4 GB. All our messages fit one datagram, so
/// a filter in the kernel (S. McCanne and V. Jacobson, "The BSD packet filter", USENIX 1993) lets
/// only whole messages through; and a larger buffer holds what comes in a burst.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace perceptor {

/// The port of a UDP bus, as LCM reads its URL: "udpm://239.255.76.67:7667?ttl=1"; empty means
/// LCM_DEFAULT_URL, else LCM's own default. None where the URL names no UDP bus.
std::optional<std::uint16_t> bus_port(const std::string& lcm_url);

/// The sockets of this process that are bound to a bus's port. LCM opens one at the first
/// subscribe, and does not hand it out; those of an LCM program that started this one were
/// inherited, and are as dangerous.
class ReceivingSockets {
 public:
  explicit ReceivingSockets(std::uint16_t port);

  /// Finds them, filters them, and gives them room for seconds of all channels. Call it after the
  /// first subscribe; where the URL names no UDP bus there are none. Throws std::system_error.
  static ReceivingSockets guard(const std::string& lcm_url);

  std::size_t size() const { return descriptors_.size(); }

  /// Only datagrams with a whole LCM message ("LC02", and a channel of at most 63 characters) come
  /// through from now on. Throws std::system_error.
  void let_only_whole_messages_through() const;

  /// Asks for so much room [bytes] in each; to who is not root the kernel may grant less
  /// (net.core.rmem_max).
  void grow_buffers(int bytes) const;

  /// Datagrams that the kernel dropped since the sockets were opened: kept out by the filter, or no
  /// room in the buffer.
  std::int64_t drops() const;

 private:
  ReceivingSockets() = default;

  std::vector<int> descriptors_;  ///< LCM's own: never closed here
};

}  // namespace perceptor
