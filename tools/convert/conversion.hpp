/// @file From a recording to an LCM event log, and what is to be said of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "tools/convert/bag_reader.hpp"
#include "tools/convert/event_writer.hpp"
#include "tools/convert/recording_reader.hpp"

namespace perceptor {

struct ConversionOptions {
  RecordingFormat format = RecordingFormat::automatic;
  EventWriterOptions events = {};
  BagTopics topics = {};  ///< of a ROS bag
};

/// Lines, or messages, that gave nothing, for one reason.
struct DroppedLines {
  std::int64_t count = 0;
  std::vector<std::string> first;  ///< "12: abc", of the first few
};

struct ConversionSummary {
  std::string_view unit = "line";  ///< what is counted: lines of a text, messages of a bag
  std::int64_t lines = 0;
  std::int64_t scans = 0;
  std::int64_t odometry = 0;
  std::int64_t session = 0;
  double duration = 0.0;  ///< [s] from the earliest utime to the latest
  std::map<std::string_view, DroppedLines> dropped;
  std::vector<std::string> notes;

  bool is_useful() const { return scans + odometry > 0; }
};

/// Converts all of `in`. `name` is what the input is called in messages; `progress` is told the
/// bytes read so far, after each line. Throws NotARecording and LogError.
ConversionSummary convert(std::istream& in, const std::string& name,
                          const std::filesystem::path& out, const ConversionOptions& options,
                          const std::function<void(std::int64_t bytes)>& progress = {});

/// The same of a ROS bag, of which nothing but the file will do.
ConversionSummary convert_bag(const std::filesystem::path& bag, const std::filesystem::path& out,
                              const ConversionOptions& options,
                              const std::function<void(std::int64_t bytes)>& progress = {});

/// For people.
void print(std::ostream& out, const ConversionSummary& summary);

}  // namespace perceptor
