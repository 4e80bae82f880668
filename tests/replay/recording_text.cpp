#include "tests/replay/recording_text.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace perceptor::test {
namespace {

/// Streams do not read "nan" and "inf".
double number(std::istringstream& words) {
  std::string word;
  words >> word;
  return std::strtod(word.c_str(), nullptr);
}

}  // namespace

TextRecording read_text(const std::string& text) {
  TextRecording recording;
  double valid_min = 0.0;
  double valid_max = 0.0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "#") {
      std::string key;
      words >> key;
      if (key == "valid_min") valid_min = number(words);
      if (key == "valid_max") valid_max = number(words);
    } else if (keyword == "ODOM") {
      recording.last_odometry = number(words);
      if (recording.first_odometry == 0.0) recording.first_odometry = recording.last_odometry;
    } else if (keyword == "LASER" || keyword == "LASERA") {
      TextScan scan;
      scan.time = number(words);
      const bool has_bearings = keyword == "LASERA";
      const int before_count = has_bearings ? 1 : 3;
      for (int i = 0; i < before_count; ++i) number(words);
      const auto beams = static_cast<std::int64_t>(number(words));
      for (std::int64_t i = 0; i < beams; ++i) {
        if (has_bearings) number(words);
        const auto range = static_cast<double>(static_cast<float>(number(words)));
        const bool returned = std::isfinite(range) && range >= valid_min && range <= valid_max;
        if (!returned) ++scan.beams_without_return;
      }
      recording.scans.push_back(scan);
    }
  }
  return recording;
}

}  // namespace perceptor::test
