/// Bytes from the bus: the first says of which type they claim to be, the rest is the message. What
/// the check lets through is decoded to the last byte; what is valid becomes a sound model.
#include <array>

#include "common/bus/bus.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/validate.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/message_samples.hpp"

namespace perceptor::fuzz {
namespace {

using Input = std::span<const std::uint8_t>;

void use(const pico::laser_scan_t& scan) {
  const LaserScan model = to_model(scan);
  require(model.bearings.size() == model.ranges.size(), "a bearing for each range");
  require(beam_ends(model).size() == count_returns(model), "an end for each return");
}

void use(const pico::map_t& message) {
  const Map map = to_model(message);
  require(find_broken_reference(map).empty(), "a valid map has no broken reference");
  pico::map_t again = message;
  set_map(again, map);
  require(messages::validate(again).empty(), "a valid map stays valid");
}

template <class Message>
void use(const Message&) {}

template <class Message>
void take(Input bytes) {
  if (!messages::find_fault<Message>(bytes).empty()) return;
  Message message;
  const auto size = static_cast<int>(bytes.size());
  require(message.decode(bytes.data(), 0, size) == size, "what is checked is decoded");
  if (messages::validate(message).empty()) use(message);
}

struct Type {
  void (*take)(Input);
  Bytes (*sample)();
};

template <class Message>
constexpr Type kType = {take<Message>,
                        [] { return messages::encode(messages::sample<Message>()); }};

constexpr std::array kTypes = {
    kType<pico::laser_scan_t>, kType<pico::odometry_t>,  kType<pico::sonar_t>,
    kType<pico::velocity_t>,   kType<pico::open_door_t>, kType<pico::speak_t>,
    kType<pico::truth_t>,      kType<pico::position_t>,  kType<pico::proximity_t>,
    kType<pico::map_t>,        kType<pico::entrance_t>,  kType<pico::world_position_t>,
    kType<pico::status_t>};

}  // namespace

std::vector<Bytes> seeds() {
  std::vector<Bytes> all;
  for (std::size_t i = 0; i < kTypes.size(); ++i) {
    Bytes seed = kTypes[i].sample();
    seed.insert(seed.begin(), static_cast<std::uint8_t>(i));
    all.push_back(std::move(seed));
  }
  return all;
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using perceptor::fuzz::kTypes;
  if (size > 0) kTypes[data[0] % kTypes.size()].take({data + 1, size - 1});
  return 0;
}
