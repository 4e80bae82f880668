/// @file What a component sees of the outside: checked messages come in, counted messages go
/// out. No message can bring the process down.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/status.hpp"
#include "common/messages/encode.hpp"
#include "common/messages/schema.hpp"
#include "common/messages/validate.hpp"
#include "common/time/continuity.hpp"

namespace perceptor {

/// A payload of this size still fits one datagram, so that LCM never needs fragments [bytes].
inline constexpr std::size_t kMaxPayload = 60'000;

/// Nothing larger is looked at, whoever sent it, over whatever bus [bytes]. Of a message whose
/// channel's name has no end liblcm 1.3.1 says that it has 4 GB.
inline constexpr std::size_t kMaxReceived = std::size_t{16} * 1024 * 1024;

class Bus {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// Input and output may be one object. Both, and the status, must outlive the bus.
  Bus(lcm::LCM& input, lcm::LCM& output, Status& status);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Calls `handler(message, began_anew)` for every good message, in order of arrival. Before
  /// that: size, fingerprint and counts are checked on the raw bytes, then `validate`, then
  /// that time goes forward. `began_anew`: the channel's first message, a new session, or time
  /// that stepped back by more than 2 s. `capacity`: good messages that may wait for the handler;
  /// of more the oldest is turned down, so choose it for what the channel is.
  template <class Message>
  void subscribe(const std::string& channel, int capacity,
                 std::function<void(const Message&, bool began_anew)> handler);

  /// Calls `handler(message)` for every valid message, whatever its stamp: for commands.
  template <class Message>
  void subscribe_command(const std::string& channel, int capacity,
                         std::function<void(const Message&)> handler);

  /// From now on good messages wait for handle_next. What is taken from LCM is checked at once, so
  /// that bad ones, however many, take no good one's place.
  void let_messages_wait() { lets_wait_ = true; }

  /// Checks what has come meanwhile, though not more than a little at a time. Does nothing where
  /// messages do not wait; else a handler that takes its time may call it.
  void check_what_came();

  /// Calls the handler of the message that waits longest; false: none waits.
  bool handle_next();

  bool has_waiting() const { return !waiting_.empty(); }

  /// A message as it came, whoever sent it and whatever it is.
  struct Anything {
    const std::string& channel;
    std::int64_t received_at;  ///< [us] the wall clock's
    Bytes payload;
  };
  /// Gives the reason why it turns it down; empty: it took it.
  using TakeAnything = std::function<std::string_view(const Anything&)>;

  /// Every message on every channel, for a recorder; STATUS tells what is missing on the channels
  /// that are ours. None waits: `take` is to be quick.
  void subscribe_all(TakeAnything take);

  bool takes_all() const { return takes_all_; }

  /// Encodes and sends.
  template <class Message>
  void publish(const std::string& channel, const Message& message);

  /// Sends a recorded message as it is. One that fails the check of raw bytes, or whose
  /// channel is none of ours, is rejected.
  void publish_recorded(const std::string& channel, Bytes payload);

  /// Sends a STATUS; it is not counted among the outputs, which it describes.
  void publish_status(std::int64_t utime, bool last);

  /// Counts a message that the component turns down.
  void reject(const std::string& channel, std::string_view reason);

  /// Counts what turned no message down: beams that are not used, a jump that was bridged.
  void count(std::string_view channel, std::string_view reason, std::int64_t times);

  Status& status() { return status_; }

 private:
  struct Subscription;
  using TakeBuffer = std::function<void(const lcm_recv_buf_t& buffer, const char* channel)>;

  /// A good message, and what becomes of it.
  struct Waiting {
    std::string channel;
    std::function<void(bool began_anew)> handle;
    bool began_anew;
  };

  /// `capacity`: messages that LCM holds for it.
  void subscribe_buffers(const std::string& channel, int capacity, TakeBuffer take);

  /// Counts the message, and what `take` says of it, among those of `channel`.
  void receive(const std::string& channel, const lcm_recv_buf_t& buffer,
               const std::function<std::string_view(Bytes)>& take);

  /// `take` gives the reason why it turns the bytes down; empty: it took them. `waits`: STATUS
  /// says so while nothing has come.
  void subscribe_bytes(const std::string& channel, std::function<std::string_view(Bytes)> take,
                       bool waits);

  /// Handles it now, or when its turn comes.
  void hand_on(Waiting message, int capacity);
  void make_room(Waiting& message);
  void handle(const Waiting& message);
  void send(const std::string& channel, Bytes payload, const Stamp& stamp);

  lcm::LCM& input_;
  lcm::LCM& output_;
  Status& status_;
  std::int64_t sent_ = 0;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  bool takes_all_ = false;
  bool lets_wait_ = false;
  std::deque<Waiting> waiting_;            ///< in order of arrival
  std::map<std::string, int> waiting_of_;  ///< how many, by channel
};

namespace detail {

/// Why a message is no good; empty: nothing, and `message` holds it.
template <class Message>
std::string_view decode(Bus::Bytes bytes, Message& message) {
  if (const auto fault = messages::find_fault<Message>(bytes); !fault.empty()) return fault;
  const auto size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) return "decoded size differs";
  return messages::validate(message);
}

}  // namespace detail

template <class Message>
void Bus::subscribe(const std::string& channel, int capacity,
                    std::function<void(const Message&, bool began_anew)> handler) {
  subscribe_bytes(
      channel,
      [this, channel, capacity, handler = std::make_shared<decltype(handler)>(std::move(handler)),
       watch = ContinuityWatch()](Bytes bytes) mutable -> std::string_view {
        Message message;
        if (const auto fault = detail::decode(bytes, message); !fault.empty()) return fault;
        const Continuity continuity = watch.check(stamp_of(message));
        status_.watched(channel, watch);
        if (const auto fault = order_fault(continuity); !fault.empty()) return fault;
        status_.accepted(channel, stamp_of(message));
        hand_on({channel,
                 [handler, message = std::move(message)](bool began_anew) {
                   (*handler)(message, began_anew);
                 },
                 continuity == Continuity::began_anew},
                capacity);
        return {};
      },
      true);
}

template <class Message>
void Bus::subscribe_command(const std::string& channel, int capacity,
                            std::function<void(const Message&)> handler) {
  subscribe_bytes(
      channel,
      [this, channel, capacity, handler = std::make_shared<decltype(handler)>(std::move(handler))](
          Bytes bytes) -> std::string_view {
        Message message;
        if (const auto fault = detail::decode(bytes, message); !fault.empty()) return fault;
        hand_on({channel, [handler, message = std::move(message)](bool) { (*handler)(message); },
                 false},
                capacity);
        return {};
      },
      false);
}

template <class Message>
void Bus::publish(const std::string& channel, const Message& message) {
  send(channel, messages::encode(message), stamp_of(message));
}

}  // namespace perceptor
