/// @file A private bus, and everything that a component published on it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/bus.hpp"

namespace perceptor {

struct Recorder {
  struct Event {
    std::string channel;
    std::vector<std::uint8_t> payload;
  };

  Recorder() {
    lcm_subscribe(
        lcm.getUnderlyingLCM(), "(PICO|SIM)_.*",
        [](const lcm_recv_buf_t* buffer, const char* channel, void* self) {
          const auto* bytes = static_cast<const std::uint8_t*>(buffer->data);
          static_cast<Recorder*>(self)->events.push_back(
              {channel, {bytes, bytes + buffer->data_size}});
        },
        this);
  }

  void drain() {
    while (lcm.handleTimeout(0) > 0) {
    }
  }

  int count(const std::string& channel) const {
    int times = 0;
    for (const Event& event : events) times += event.channel == channel ? 1 : 0;
    return times;
  }

  template <class Message>
  std::vector<Message> messages(const std::string& channel) const {
    std::vector<Message> result;
    for (const Event& event : events) {
      if (event.channel != channel) continue;
      Message message;
      message.decode(event.payload.data(), 0, static_cast<int>(event.payload.size()));
      result.push_back(message);
    }
    return result;
  }

  /// How often the status counts this reason.
  std::int64_t rejected(const std::string& channel) {
    std::int64_t times = 0;
    const pico::status_t message = status.message(0, false);
    for (const auto& reject : message.rejects)
      times += reject.channel == channel ? reject.count : 0;
    return times;
  }
  std::string note() { return status.message(0, false).note; }

  lcm::LCM lcm{"memq://"};
  Status status{"bridge", 1};
  Bus bus{lcm, lcm, status};
  std::vector<Event> events;
};

}  // namespace perceptor
