#include "common/bus/bus.hpp"

#include <algorithm>
#include <chrono>

#include "common/bus/channels.hpp"

namespace perceptor {

namespace {

/// Messages that LCM holds until they are checked, of up to 64 kB each: of one channel, and of all
/// where they come through one subscription. It keeps the room that they took. More it drops in
/// silence; their numbers are missed.
constexpr int kUnchecked = 500;
constexpr int kUncheckedOfAll = 3000;

constexpr int kAtOnce = 1000;  // messages that are checked before one is handled

constexpr std::string_view kFailed = "failed while it was processed";

/// All but what LCM sends to itself at the start, which, left over, would be handed on in the place
/// of a later message: LCM counts what waits for a subscription, and does not note which it was.
constexpr const char* kAll = "(?!LCM_SELF_TEST$).*";
constexpr const char* kOtherChannels = "other channels";

/// As STATUS lists a channel of which everything is recorded. Anybody may make up names: these are
/// few whatever comes.
std::string listed_as(const std::string& channel) {
  if (channel.starts_with(channel::status_prefix)) return std::string(channel::status_prefix) + "*";
  return channel::type_on(channel) == nullptr ? kOtherChannels : channel;
}

}  // namespace

struct Bus::Subscription {
  std::function<void(const lcm_recv_buf_t& buffer, const char* channel)> take;
  lcm_subscription_t* handle = nullptr;
};

Bus::Bus(lcm::LCM& input, lcm::LCM& output, Status& status)
    : input_(input), output_(output), status_(status) {}

Bus::~Bus() {
  for (const auto& subscription : subscriptions_)
    lcm_unsubscribe(input_.getUnderlyingLCM(), subscription->handle);
}

void Bus::subscribe_buffers(const std::string& channel, int capacity, TakeBuffer take) {
  auto& subscription =
      *subscriptions_.emplace_back(std::make_unique<Subscription>(std::move(take)));
  subscription.handle = lcm_subscribe(
      input_.getUnderlyingLCM(), channel.c_str(),
      [](const lcm_recv_buf_t* buffer, const char* name, void* self) {
        static_cast<Subscription*>(self)->take(*buffer, name);
      },
      &subscription);
  lcm_subscription_set_queue_capacity(subscription.handle, capacity);
}

void Bus::subscribe_bytes(const std::string& channel, std::function<std::string_view(Bytes)> take,
                          bool waits) {
  status_.add_input(channel, waits);
  subscribe_buffers(
      channel, kUnchecked,
      [this, channel, take = std::move(take)](const lcm_recv_buf_t& buffer, const char*) {
        receive(channel, buffer, take);
      });
}

void Bus::receive(const std::string& channel, const lcm_recv_buf_t& buffer,
                  const std::function<std::string_view(Bytes)>& take) {
  status_.received(channel);
  if (buffer.data_size > kMaxReceived) return reject(channel, "too large");
  // An exception that leaves a handler makes the next lcm_handle abort the process.
  try {
    const Bytes bytes(static_cast<const std::uint8_t*>(buffer.data), buffer.data_size);
    if (const auto reason = take(bytes); !reason.empty()) reject(channel, reason);
  } catch (...) {
    reject(channel, kFailed);
  }
}

void Bus::hand_on(Waiting message, int capacity) {
  if (!lets_wait_) return handle(message);
  if (waiting_of_[message.channel] >= capacity) make_room(message);
  ++waiting_of_[message.channel];
  waiting_.push_back(std::move(message));
}

/// By the oldest of the channel. That the channel began anew with it is left to the next.
void Bus::make_room(Waiting& message) {
  const auto is_of_channel = [&](const Waiting& other) { return other.channel == message.channel; };
  const auto oldest = std::ranges::find_if(waiting_, is_of_channel);
  const auto next = std::find_if(oldest + 1, waiting_.end(), is_of_channel);
  bool& began_anew = next == waiting_.end() ? message.began_anew : next->began_anew;
  began_anew = began_anew || oldest->began_anew;
  waiting_.erase(oldest);
  --waiting_of_[message.channel];
  reject(message.channel, "too slow for all that comes");
}

void Bus::check_what_came() {
  if (!lets_wait_) return;
  for (int i = 0; i < kAtOnce && input_.handleTimeout(0) > 0;) ++i;
}

bool Bus::handle_next() {
  if (waiting_.empty()) return false;
  const Waiting message = std::move(waiting_.front());
  waiting_.pop_front();
  --waiting_of_[message.channel];
  handle(message);
  return true;
}

void Bus::handle(const Waiting& message) {
  const auto started = std::chrono::steady_clock::now();
  const std::int64_t sent_before = sent_;
  try {
    message.handle(message.began_anew);
  } catch (...) {
    reject(message.channel, kFailed);
  }
  if (sent_ == sent_before) return;  // it only waits, or was turned down
  const std::chrono::duration<double, std::micro> spent =
      std::chrono::steady_clock::now() - started;
  status_.processing_time(spent.count());
}

void Bus::subscribe_all(TakeAnything take) {
  takes_all_ = true;
  subscribe_buffers(
      kAll, kUncheckedOfAll,
      [this, take = std::move(take), watches = std::map<std::string, ContinuityWatch>()](
          const lcm_recv_buf_t& buffer, const char* name) mutable {
        const std::string channel = name;
        const std::string listed = listed_as(channel);
        receive(listed, buffer, [&](Bytes bytes) {
          if (listed == channel && messages::find_fault(channel::type_on(channel), bytes).empty()) {
            const Stamp stamp = messages::stamp_in(bytes).value_or(Stamp{});
            watches[channel].check(stamp);
            status_.watched(channel, watches[channel]);
            status_.accepted(channel, stamp);
          }
          return take({channel, buffer.recv_utime, bytes});
        });
      });
}

void Bus::send(const std::string& channel, Bytes payload, const Stamp& stamp) {
  if (payload.size() > kMaxPayload) return count(channel, "too large to send", 1);
  if (output_.publish(channel, payload.data(), static_cast<unsigned>(payload.size())) != 0)
    return count(channel, "the bus did not take it", 1);
  status_.published(channel, stamp);
  ++sent_;
}

void Bus::publish_recorded(const std::string& channel, Bytes payload) {
  const lcm_type_info_t* type = channel::type_on(channel);
  if (type == nullptr) return count("log", "no channel of ours", 1);
  if (const auto fault = messages::find_fault(type, payload); !fault.empty())
    return reject(channel, fault);
  send(channel, payload, messages::stamp_in(payload).value_or(Stamp{}));
}

void Bus::publish_status(std::int64_t utime, bool last) {
  const auto payload = messages::encode(status_.message(utime, last));
  output_.publish(status_.channel(), payload.data(), static_cast<unsigned>(payload.size()));
}

void Bus::reject(const std::string& channel, std::string_view reason) {
  status_.rejected(channel, reason);
}

void Bus::count(std::string_view channel, std::string_view reason, std::int64_t times) {
  status_.counted(channel, reason, times);
}

}  // namespace perceptor
