/// @file Truth drawn by hand.
#pragma once

#include "tools/eval/scan_set.hpp"

namespace perceptor::testing {

inline TruePiece piece(int edge, const Segment& segment, bool has_to_be_found = true) {
  TruePiece piece;
  piece.edge = edge;
  piece.segment = segment;
  piece.has_to_be_found = has_to_be_found;
  return piece;
}

/// From (x1, y) to (x2, y).
inline Segment along_x(double x1, double x2, double y = 0.0) { return {{x1, y}, {x2, y}}; }

}  // namespace perceptor::testing
