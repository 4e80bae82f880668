/// @file One scan and what was found in it, drawn to scale for people: a panel of a contact sheet.
#pragma once

#include <string>
#include <vector>

#include "common/model/laser_scan.hpp"
#include "tools/eval/scan_findings.hpp"

namespace perceptor {

inline constexpr double kPanelSize = 400.0;  ///< [px] of a panel's side

/// The square of the robot's frame that a panel shows.
struct PanelView {
  Vector2 centre{0.0, 0.0};  ///< [m] robot frame
  double half = 1.0;         ///< [m] from there to each side

  double scale() const { return 0.5 * kPanelSize / half; }  ///< [px/m]
  /// [px] from the panel's upper left corner, right and down: x of the robot points up.
  Vector2 to_panel(const Vector2& location) const;
};

/// Shows the robot and all beams but the farthest: few far returns would make the rest too small
/// to see.
PanelView view_of(const LaserScan& scan);

/// An SVG element of kPanelSize by kPanelSize at the place `left`, `top` [px]. What it shows: the
/// robot's footprint, or a triangle where there is none; the ends of all beams; walls with their
/// numbers and a tick across each end; corners; the scan's id; a scale bar. Its classes are those
/// of kPanelStyle.
std::string scan_panel(const ScanFindings& scan, const std::vector<Vector2>& footprint, double left,
                       double top);

/// The style sheet of panels. Blue against red and grey is told apart by the colour-blind too.
extern const char* const kPanelStyle;

}  // namespace perceptor
