#include "common/bus/bus.hpp"

#include <chrono>

#include "common/bus/channels.hpp"

namespace perceptor {

struct Bus::Subscription {
  Bus& bus;
  std::string channel;
  std::function<std::string_view(Bytes)> take;
  lcm_subscription_t* handle = nullptr;

  void receive(Bytes bytes) {
    const auto started = std::chrono::steady_clock::now();
    const std::int64_t sent_before = bus.sent_;
    bus.status_.received(channel);
    if (bytes.size() > kMaxPayload) return bus.reject(channel, "too large");
    // An exception that leaves a handler makes the next lcm_handle abort the process.
    try {
      if (const auto reason = take(bytes); !reason.empty()) bus.reject(channel, reason);
    } catch (...) {
      bus.reject(channel, "failed while it was processed");
    }
    if (bus.sent_ == sent_before) return;  // it only waits, or was turned down
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - started;
    bus.status_.processing_time(spent.count());
  }
};

Bus::Bus(lcm::LCM& input, lcm::LCM& output, Status& status)
    : input_(input), output_(output), status_(status) {}

Bus::~Bus() {
  for (const auto& subscription : subscriptions_)
    lcm_unsubscribe(input_.getUnderlyingLCM(), subscription->handle);
}

void Bus::subscribe_bytes(const std::string& channel, int capacity,
                          std::function<std::string_view(Bytes)> take, bool waits) {
  status_.add_input(channel, waits);
  auto& subscription =
      *subscriptions_.emplace_back(std::make_unique<Subscription>(*this, channel, std::move(take)));
  subscription.handle = lcm_subscribe(
      input_.getUnderlyingLCM(), channel.c_str(),
      [](const lcm_recv_buf_t* buffer, const char*, void* self) {
        static_cast<Subscription*>(self)->receive(
            {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
      },
      &subscription);
  lcm_subscription_set_queue_capacity(subscription.handle, capacity);
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

std::string_view detail::order_fault(Continuity continuity) {
  switch (continuity) {
    case Continuity::stepped_back:
      return "time stepped back";
    case Continuity::repeated:
      return "time stood still";
    case Continuity::continues:
    case Continuity::began_anew:
      break;
  }
  return {};
}

}  // namespace perceptor
