/// @file record: every message on the bus, in one LCM event log.
///
/// in:  every channel
/// out: nothing but the file and STATUS_RECORD
///
/// lcm-logger writes the same format. It loses in silence what is beyond its queue, ends when the
/// disk is full, and one datagram of a stranger ends it as well.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "components/record/recording.hpp"

namespace perceptor {

struct RecordConfig {
  enum class Existing { refuse, append, replace };

  std::string file = "recording.lcmlog";
  Existing existing = Existing::refuse;  ///< what becomes of a file of that name
  double min_free = 200.0;               ///< [MB] on the disk, before a recording begins
  double flush_period = 0.1;             ///< [s] what a sudden death costs at most
};

void describe(config::Fields& fields, RecordConfig& config);

class RecordComponent {
 public:
  using Config = RecordConfig;
  static constexpr std::string_view kName = "record";
  static constexpr std::string_view kSummary = "records every message on the bus in an LCM log";
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kShortcuts = {
      {{"file", "the log: recording.lcmlog by default"},
       {"existing", "what becomes of a file of that name: refuse, append, or replace"}}};

  /// The bus must outlive the component. Throws config::Error where the file is there already,
  /// cannot be written, or too little of the disk is free to begin.
  RecordComponent(const RecordConfig& config, Bus& bus);

  /// Writes out what came, and looks whether that went well; gives when to be called next [us].
  std::int64_t step(std::int64_t now);
  static bool finished() { return false; }
  void finish();

 private:
  void tell();

  Bus& bus_;
  std::filesystem::path file_;
  double min_free_;      ///< [MB]
  std::int64_t period_;  ///< [us]
  std::int64_t next_ = 0;
  record::Recording recording_;
};

}  // namespace perceptor
