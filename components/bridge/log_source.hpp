/// @file A recorded log as a source: its PICO_* messages are published again, byte for byte, at
/// the log's own pace.
#pragma once

#include <cstdint>
#include <filesystem>

#include "common/bus/bus.hpp"
#include "common/log/event_log.hpp"
#include "components/bridge/pace.hpp"
#include "components/bridge/source.hpp"

namespace perceptor {

class LogSource : public Source {
 public:
  /// `speed` and `duration` [s] as in BridgeConfig. Throws config::Error where the log cannot be
  /// read.
  LogSource(const std::filesystem::path& file, double speed, double duration, Bus& bus);

  std::int64_t step(std::int64_t now) override;

  bool finished() const override { return at_end_; }

 private:
  void read_next();
  void advance_due(bool is_first);
  void say_how_it_goes();

  Bus& bus_;
  LogReader reader_;
  std::int64_t duration_;  ///< [us]; 0: to the end
  LogEvent next_;          ///< not published yet
  bool at_end_ = false;
  std::int64_t last_stamp_ = 0;  ///< [us] the log's own, the largest since it last jumped
  std::int64_t first_ = 0;       ///< [us] when the first event is due
  std::int64_t due_ = 0;         ///< [us] when `next_` is due, from the steps of the stamps
  Pace pace_;
  std::int64_t published_ = 0;
  std::size_t damage_told_ = 0;  ///< damaged stretches counted so far
  std::int64_t next_note_ = 0;   ///< [us] log time
};

}  // namespace perceptor
