#include "common/runner/heartbeat.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include <unistd.h>

namespace perceptor {
namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kBeats = 20;  // within the time after which a process counts as hung

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

/// [us]
std::int64_t period() {
  const std::string_view patience = environment("WATCHDOG_USEC");
  std::int64_t microseconds = 0;
  std::from_chars(patience.data(), patience.data() + patience.size(), microseconds);
  return microseconds > 0 ? std::max<std::int64_t>(microseconds / kBeats, 1) : kNever;
}

}  // namespace

Heartbeat::Heartbeat() : period_(period()) {
  const std::string_view name = environment("NOTIFY_SOCKET");
  if (name.empty() || name.size() > sizeof(address_.sun_path)) return;
  address_.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address_.sun_path);
  if (name.front() == '@') address_.sun_path[0] = '\0';  // a name without a file
  address_size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  descriptor_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
}

Heartbeat::~Heartbeat() {
  if (descriptor_ >= 0) close(descriptor_);
}

void Heartbeat::ready() const { tell("READY=1"); }

std::int64_t Heartbeat::beat(std::int64_t now) {
  if (descriptor_ < 0 || period_ == kNever) return kNever;
  if (now >= next_) {
    tell("WATCHDOG=1");
    next_ = now + period_;
  }
  return next_;
}

void Heartbeat::tell(std::string_view text) const {
  if (descriptor_ < 0) return;
  sendto(descriptor_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
         reinterpret_cast<const sockaddr*>(&address_), address_size_);
}

}  // namespace perceptor
