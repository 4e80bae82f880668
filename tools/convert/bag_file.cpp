#include "tools/convert/bag_file.hpp"

#include <memory>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "tools/convert/recording.hpp"

namespace perceptor {
namespace {

struct OpenBag {
  rosbag::Bag bag;
  rosbag::View view;
  rosbag::View::iterator at;

  explicit OpenBag(const std::string& file) : bag(file), view(bag), at(view.begin()) {}
};

std::vector<std::uint8_t> bytes_of(const rosbag::MessageInstance& message) {
  std::vector<std::uint8_t> bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  return bytes;
}

}  // namespace

BagFile open_bag(const std::filesystem::path& file,
                 std::function<bool(std::string_view topic)> is_wanted) {
  std::shared_ptr<OpenBag> open;
  try {
    open = std::make_shared<OpenBag>(file.string());
  } catch (const rosbag::BagUnindexedException&) {
    throw NotARecording(file.string() + " has no index (it was not closed): rosbag reindex " +
                        file.string());
  } catch (const std::exception& error) {
    throw NotARecording(file.string() + " is no bag that can be read: " + error.what());
  }
  BagFile bag;
  bag.messages = open->view.size();
  bag.next = [open, is_wanted = std::move(is_wanted)]() -> std::optional<BagMessage> {
    if (open->at == open->view.end()) return std::nullopt;
    const rosbag::MessageInstance& instance = *open->at;
    BagMessage message{instance.getTopic(), instance.getDataType(), {}, {}};
    try {
      if (is_wanted(message.topic)) message.bytes = bytes_of(instance);
    } catch (const std::exception& error) {
      message.fault = error.what();
    }
    ++open->at;
    return message;
  };
  return bag;
}

}  // namespace perceptor
