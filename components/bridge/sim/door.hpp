/// @file A sliding door between two jambs.
#pragma once

#include <optional>

#include "common/geometry/segment.hpp"

namespace perceptor::sim {

enum class DoorMode {
  open,        ///< there is no leaf
  shut,        ///< the leaf is flush with the jambs
  recessed,    ///< shut, the leaf set back from the jambs
  on_request,  ///< shut; opens when asked, and shuts again
  timed        ///< opens and shuts by the clock
};

struct DoorParameters {
  Segment opening;  ///< between the jambs [m] world frame
  DoorMode mode = DoorMode::open;
  double recess = 0.1;       ///< [m] of a recessed leaf, positive to the left of the opening
  double travel_time = 2.0;  ///< [s] from shut to open
  double open_for = 10.0;    ///< [s] from the request (or the period's start) until it shuts
  double period = 30.0;      ///< [s] of a timed door
};

class Door {
 public:
  explicit Door(const DoorParameters& parameters);

  /// Somebody asks for it at `time` [s since the simulation began]. False: it does not open on
  /// request.
  bool request(double time);

  /// Moves the leaf by what it does in `seconds`. `occupied`: it does not shut upon what stands
  /// in the opening.
  void advance(double time, double seconds, bool occupied);

  /// 0 shut to 1 open.
  double open_ratio() const { return open_ratio_; }

  /// Where the leaf is; none when the door is open all the way. It slides into the wall behind
  /// the opening's second end.
  std::optional<Segment> leaf() const;

  const DoorParameters& parameters() const { return parameters_; }

 private:
  bool wants_open(double time) const;

  DoorParameters parameters_;
  double open_ratio_ = 0.0;
  std::optional<double> requested_at_;
};

}  // namespace perceptor::sim
