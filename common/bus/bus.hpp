/// @file What a component sees of the outside: checked messages come in, counted messages go
/// out. No message can bring the process down.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/status.hpp"
#include "common/messages/schema.hpp"
#include "common/messages/validate.hpp"
#include "common/time/continuity.hpp"

namespace perceptor {

/// One datagram; LCM-level fragments are never needed below it.
inline constexpr std::size_t kMaxPayload = 60'000;

class Bus {
 public:
  /// Input and output may be one object. Both must outlive the bus.
  Bus(lcm::LCM& input, lcm::LCM& output, Status& status);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Calls `handler(message, began_anew)` for every good message, in order of arrival. Checked
  /// before: fingerprint, counts and size on the raw bytes, then `validate`, then that time
  /// goes forward. `began_anew`: the channel's first message, a new session, or time that
  /// stepped back by more than 2 s. `capacity`: messages that may wait for the handler; a full
  /// queue loses the newest, so choose it for what the channel is.
  template <class Message>
  void subscribe(const std::string& channel, int capacity,
                 std::function<void(const Message&, bool began_anew)> handler);

  /// Calls `handler(message)` for every well-formed message, its stamp unchecked: for
  /// commands.
  template <class Message>
  void subscribe_unordered(const std::string& channel, int capacity,
                           std::function<void(const Message&)> handler);

  /// Encodes and sends. A payload above kMaxPayload is not sent, and counted as rejected on
  /// its own channel.
  template <class Message>
  void publish(const std::string& channel, const Message& message);

  /// Sends bytes as they are (a recorded message), checked like input.
  void publish_raw(const std::string& channel, const void* data, std::size_t size);

  /// Counts a message or part of one that the component itself turns down.
  void reject(std::string_view channel, std::string_view reason, std::int64_t count = 1);

  Status& status() { return status_; }

 private:
  struct Subscription;
  void subscribe_raw(const std::string& channel, int capacity,
                     std::function<void(const lcm::ReceiveBuffer&)> handler);
  void send(const std::string& channel, const std::vector<std::uint8_t>& payload,
            const Stamp& stamp);

  lcm::LCM& input_;
  lcm::LCM& output_;
  Status& status_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
};

}  // namespace perceptor
