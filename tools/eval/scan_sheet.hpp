/// @file A contact sheet: many scans with what was found in them, beside each other, as SVG.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/eval/scan_panel.hpp"

namespace perceptor {

/// What stands above the panels.
struct SheetTitle {
  std::string file{};
  std::string method{};
  double smallest_sigma = 0.0;  ///< [m] of the ranges, among the scans drawn
  double largest_sigma = 0.0;   ///< [m]
};

/// Which of so many scans are drawn: each `every`-th from the first; without, some two dozen
/// spread evenly, the first and the last included.
std::vector<std::size_t> scans_of_sheet(std::size_t scans, std::optional<std::size_t> every);

/// Lays panels out in rows, in the order in which they are added.
class ScanSheet {
 public:
  /// `footprint` of the robot [m], robot frame; empty: none is drawn.
  explicit ScanSheet(std::vector<Vector2> footprint) : footprint_(std::move(footprint)) {}

  void add(const ScanFindings& scan);

  /// The SVG document.
  std::string document(const SheetTitle& title) const;

 private:
  std::vector<Vector2> footprint_;
  std::string panels_;
  std::size_t count_ = 0;
};

}  // namespace perceptor
