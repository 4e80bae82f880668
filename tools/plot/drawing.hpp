/// @file A scene as a picture with its legend, drawn by cairo: PNG or SVG.
#pragma once

#include <filesystem>
#include <optional>
#include <set>

#include "components/viewer/scene.hpp"

namespace perceptor {

struct DrawingOptions {
  int width = 1400;                ///< [px] of the picture, legend included
  int height = 900;                ///< [px]
  std::optional<double> around{};  ///< [m] shown on each side of the robot; without, everything
  std::set<viewer::Layer> hidden{};
};

/// What the legend says is what the picture has: layers without marks are left out. Throws
/// std::runtime_error where the file cannot be written, or ends neither in .png nor in .svg.
void draw(const viewer::Scene& scene, const std::filesystem::path& file,
          const DrawingOptions& options = {});

}  // namespace perceptor
