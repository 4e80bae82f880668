/// @file A publisher whose log is written down by hand.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <pico/laser_scan_t.hpp>
#include <pico/position_t.hpp>
#include <pico/status_t.hpp>

#include "common/bus/status.hpp"
#include "common/log/event_log.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {

template <class Message>
LogEvent event(const std::string& channel, const Message& message) {
  LogEvent e;
  e.channel = channel;
  e.timestamp = message.utime;
  e.data.resize(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(e.data.data(), 0, static_cast<int>(e.data.size()));
  return e;
}

/// One start of a component that counts what it publishes, as the real ones do; `log` is what
/// the logger caught.
class Publisher {
 public:
  Publisher(std::vector<LogEvent>& log, const std::string& component, std::int64_t boot)
      : log_(log), status_(component, boot) {}

  void scan(std::int64_t session, std::int64_t seq, bool caught = true) {
    pico::laser_scan_t message{};
    message.num_ranges = 1;
    message.ranges = {1.0F};
    send("PICO_LASER", message, session, seq, caught);
  }

  void position(std::int64_t session, std::int64_t seq, bool caught = true) {
    send("POSITION", pico::position_t{}, session, seq, caught);
  }

  void status(bool last = false, bool caught = true) {
    const auto message = status_.message(static_cast<std::int64_t>(log_.size()) * 1000, last);
    if (caught) log_.push_back(event(status_.channel(), message));
  }

 private:
  template <class Message>
  void send(const std::string& channel, Message message, std::int64_t session, std::int64_t seq,
            bool caught) {
    set_stamp(message, {static_cast<std::int64_t>(log_.size()) * 1000, session, seq});
    status_.published(channel, stamp_of(message));
    if (caught) log_.push_back(event(channel, message));
  }

  std::vector<LogEvent>& log_;
  Status status_;
};

}  // namespace perceptor
