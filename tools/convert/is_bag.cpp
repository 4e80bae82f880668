#include <array>
#include <fstream>

#include "tools/convert/bag_file.hpp"

namespace perceptor {

bool is_bag(const std::filesystem::path& file) {
  constexpr std::string_view signature = "#ROSBAG";
  std::array<char, signature.size()> begin{};
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), begin.size());
  return in.good() && std::string_view(begin.data(), begin.size()) == signature;
}

}  // namespace perceptor
