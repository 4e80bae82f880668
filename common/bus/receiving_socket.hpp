/// @file The socket that LCM receives from, made fit for a bus that nobody guards.
///
/// liblcm 1.3.1 listens on every network, and one fragment whose offset wraps crashes it. All our
/// messages fit one datagram, so a filter in the kernel lets only whole messages through; and a
/// larger buffer holds what comes in a burst.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace perceptor {

/// The port of a UDP bus, as LCM reads its URL: "udpm://239.255.76.67:7667?ttl=1"; empty means
/// LCM_DEFAULT_URL, else LCM's own default. None where the URL names no UDP bus.
std::optional<std::uint16_t> bus_port(const std::string& lcm_url);

class ReceivingSocket {
 public:
  /// Finds the socket of this process that is bound to the bus's port; LCM opens it at the first
  /// subscribe, and does not hand it out. None: there is no such socket.
  static std::optional<ReceivingSocket> find(std::uint16_t port);

  /// Only datagrams with a whole LCM message ("LC02") come through from now on. Throws
  /// std::system_error.
  void let_only_whole_messages_through() const;

  /// Asks for so much room [bytes]; gives what the kernel grants.
  int grow_buffer(int bytes) const;

  /// Datagrams that the kernel dropped since the socket was opened: kept out by the filter, or no
  /// room in the buffer.
  std::int64_t drops() const;

 private:
  explicit ReceivingSocket(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;  ///< LCM's own: never closed here
};

}  // namespace perceptor
