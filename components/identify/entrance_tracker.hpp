/// @file The best way out over the last scans. A false exit is worse than a late one.
///
/// 1. The ways out of the last scans are kept in the local frame, where what stands still
///    stays in place while the robot moves.
/// 2. Those of different scans that lie close together are sightings of one opening. Its
///    place, direction, width and confidence are the medians of the sightings.
/// 3. An opening counts when enough of the last scans agree with these medians. One that is
///    seen now and then, or each time elsewhere, does not.
/// 4. Of several that count, the best is the one with the highest confidence over nearness:
///    confidence / (1 + distance / half_distance). The one named before keeps its place unless
///    another is clearly better, so that whoever drives to it is not called back.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "common/geometry/position.hpp"
#include "components/identify/entrance.hpp"

namespace perceptor::identify {

class EntranceTracker {
 public:
  explicit EntranceTracker(const EntranceParameters& parameters = {}) : parameters_(parameters) {}

  /// Forgets all: another local frame begins.
  void clear();

  /// Takes what one scan's map shows, in the robot frame, and gives the best way out in the
  /// same frame; nothing where none is sure, or the robot has gone through it. `utime` [us]
  /// grows from call to call.
  std::optional<Exit> update(std::int64_t utime, const Position& robot_in_local,
                             const std::vector<Exit>& exits);

 private:
  struct Scan {
    std::int64_t utime = 0;
    std::vector<Exit> exits;  ///< local frame
  };

  std::size_t needed() const;
  void remember(Scan scan);
  std::vector<std::vector<Exit>> openings() const;
  std::optional<Exit> agreed(const std::vector<Exit>& sightings) const;
  double worth(const Exit& in_local, const Exit& in_robot) const;

  EntranceParameters parameters_;
  std::deque<Scan> scans_;     ///< the oldest first
  std::optional<Exit> named_;  ///< by the last update, local frame
};

}  // namespace perceptor::identify
