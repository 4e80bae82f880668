/// @file Tells whoever started this process that it is ready, and that it does not hang.
///
/// By the protocol of systemd (man sd_notify), which tools/launch speaks too: so a component can as
/// well be a service of systemd with Type=notify and WatchdogSec=. Where nobody asks for it nothing
/// is sent. systemd's own library waits while nobody reads; perception must not.
#pragma once

#include <cstdint>
#include <string_view>

#include <sys/socket.h>
#include <sys/un.h>

namespace perceptor {

class Heartbeat {
 public:
  /// Asked for by NOTIFY_SOCKET and WATCHDOG_USEC in the environment.
  Heartbeat();
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

  /// The process does its work from now on.
  void ready() const;

  /// The process is alive at `now` [us, monotonic]; gives when to say so again.
  std::int64_t beat(std::int64_t now);

 private:
  void tell(std::string_view text) const;

  int descriptor_ = -1;
  sockaddr_un address_{};
  socklen_t address_size_ = 0;
  std::int64_t period_;  ///< [us]
  std::int64_t next_ = 0;
};

}  // namespace perceptor
