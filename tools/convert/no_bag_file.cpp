/// @file In the place of bag_file.cpp in a build without rosbag_storage.
#include "tools/convert/bag_file.hpp"
#include "tools/convert/recording.hpp"

namespace perceptor {

BagFile open_bag(const std::filesystem::path& file, const std::function<bool(std::string_view)>&) {
  throw NotARecording(file.string() +
                      " is a ROS bag, and this pico-convert was built without rosbag_storage. As "
                      "root, or with sudo:\n  apt install librosbag-storage-dev\nthen configure "
                      "and build again (tools/setup does all of that)");
}

}  // namespace perceptor
