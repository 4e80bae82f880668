/// @file Which parts of the world's sides have been seen so far, and from where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/map.hpp"
#include "tools/eval/true_world.hpp"
#include "tools/eval/world_view.hpp"

namespace perceptor {

struct SeenParameters {
  std::size_t min_beams = 10;  ///< on a side, in one scan: fewer show nothing of it
  double min_length = 0.3;     ///< [m] of the side, in one scan
  double step = 0.05;          ///< [m] of the side, each seen or not
};

/// What was seen of one side from one side of it.
struct SeenSide {
  std::int64_t since = 0;   ///< [us] the first scan that showed enough; 0: none yet
  std::vector<bool> steps;  ///< along the side: seen in a scan that showed enough
};

class SeenSides {
 public:
  explicit SeenSides(const SeenParameters& parameters) : parameters_(parameters) {}

  /// One scan. The world keeps its sides but for the leaves at their end.
  void take(std::int64_t utime, const TrueWorld& world, const std::vector<SideView>& views,
            const Vector2& laser_in_world);

  /// By the index of the world's side and the side that it was seen from.
  const SeenSide& seen(std::size_t side, FreeSide from) const;

  /// From where a side was seen; unknown where from both sides, or never.
  FreeSide seen_from(std::size_t side) const;

  std::size_t size() const { return sides_.size(); }
  void clear() { sides_.clear(); }

  /// The middle of one of the steps [m] world frame.
  static Vector2 step_at(const TrueSide& side, const SeenSide& seen, std::size_t step);

 private:
  struct Both {
    SeenSide left;
    SeenSide right;
  };
  SeenParameters parameters_;
  std::vector<Both> sides_;
};

}  // namespace perceptor
