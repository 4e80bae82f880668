/// @file What the local map of a log explains of the scans, and where it holds walls twice.
///
/// Each laser scan is brought together with its own current map and its own local map, which
/// have its session and seq and its robot frame. Beams end where the laser was when it measured
/// them, if positions tell how the robot moved (as pico-scan corrects them), and else as if the
/// robot had stood still.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "common/log/event_log.hpp"
#include "common/model/laser_scan.hpp"
#include "common/time/continuity.hpp"
#include "common/time/position_history.hpp"
#include "tools/eval/double_walls.hpp"
#include "tools/eval/explained_beams.hpp"

namespace perceptor {

struct LogExplanationParameters {
  ExplainedParameters explained;
  DoubleWallParameters doubles;
  /// [s] between the two positions that tell how the robot moved. A scan whose bracket is wider
  /// has maps only where pico-scan was told to accept it, so that this is no limit in practice.
  double max_bracket = 10.0;
};

/// Of one scan.
struct MapExplanation {
  Stamp stamp;            ///< that of the scan
  bool is_moved = false;  ///< the robot's motion during the sweep is known
  Share by_current;       ///< valid beams in range that the scan's own walls explain
  Share by_local;         ///< the same beams: by the local map
  std::size_t doubles = 0;
};

/// Of a log.
struct LogExplanation {
  std::int64_t scans = 0;  ///< laser scans
  std::int64_t current_maps = 0;
  std::int64_t local_maps = 0;
  std::int64_t undecodable = 0;  ///< messages of these that are no good
  std::int64_t compared = 0;     ///< scans with both maps: what the rest is about
  std::int64_t moved = 0;        ///< of those, scans with the robot's motion known
  Share by_current;
  Share by_local;
  std::int64_t doubles = 0;      ///< in all maps together
  std::size_t most_doubles = 0;  ///< in one map
  std::int64_t maps_with_doubles = 0;
};

class LogExplainer {
 public:
  using Sink = std::function<void(const MapExplanation&)>;

  /// `sink` sees each scan that was compared, in the order of their local maps; may be empty.
  explicit LogExplainer(const LogExplanationParameters& parameters = {}, Sink sink = {});

  /// Events in log order. Of a scan's three messages any may come first.
  void take(const LogEvent& event);

  const LogExplanation& result() const { return result_; }

 private:
  /// What has come of one scan.
  struct Trio {
    Stamp stamp;
    std::optional<LaserScan> scan;
    std::optional<Map> current;
    std::optional<Map> local;
  };

  Trio& trio_of(const Stamp& stamp);
  template <class Message, class Add>
  void take_part(const LogEvent& event, std::int64_t& count, Add&& add);
  void take_position(const LogEvent& event);
  void compare(const Trio& trio);

  LogExplanationParameters parameters_;
  Sink sink_;
  LogExplanation result_;
  std::deque<Trio> waiting_;  ///< for the rest of their messages
  PositionHistory positions_;
  ContinuityWatch position_watch_;
  ContinuityWatch map_watch_;
};

}  // namespace perceptor
