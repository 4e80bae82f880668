/// @file The simulated world as the score of maps needs it: what the laser can hit, its corners,
/// and its openings with the walls beside them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/model/map.hpp"

namespace perceptor {

enum class Surface {
  wall,
  furniture,  ///< a side of a cabinet or a box
  leaf        ///< of a shut door
};

struct TrueSide {
  Segment segment;  ///< [m] world frame
  Surface surface = Surface::wall;

  friend bool operator==(const TrueSide& s, const TrueSide& t) {
    return s.segment.a == t.segment.a && s.segment.b == t.segment.b && s.surface == t.surface;
  }
};

inline constexpr std::size_t kNoSide = static_cast<std::size_t>(-1);

/// An opening as it is seen from one side of a thick wall.
struct OpeningFace {
  Segment segment;                                         ///< [m] world frame, jamb to jamb
  std::array<std::size_t, 2> adjoining{kNoSide, kNoSide};  ///< sides that end at its a and its b
};

struct TrueOpening {
  std::int32_t id = 0;             ///< stays the same while the world does
  std::vector<OpeningFace> faces;  ///< one, or two of a wall with jambs
  bool is_open = false;
  double from_furniture = 0.0;  ///< [m] from a jamb to the nearest cabinet or box
};

/// Where two sides end together.
struct TrueCorner {
  Vector2 location = Vector2::Zero();  ///< [m] world frame
  std::array<std::size_t, 2> sides{};
};

struct TrueWorld {
  std::vector<TrueSide> sides;  ///< leaves last: the index of the others stays
  std::vector<TrueCorner> corners;
  std::vector<TrueOpening> openings;
};

struct TrueWorldParameters {
  double join = 0.005;         ///< [m] ends so near to each other are one corner
  double min_turn = 0.2;       ///< [rad] from one side to the next: less is no corner
  double max_thickness = 0.4;  ///< [m] of a wall: a longer side in an opening is no jamb
};

/// Of all objects of SIM_WORLD, its parts put together.
TrueWorld true_world(const Map& map, const TrueWorldParameters& parameters);

}  // namespace perceptor
