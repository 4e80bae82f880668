/// @file A scene as a picture with its legend, drawn by cairo: PNG or SVG.
#pragma once

#include <filesystem>

#include "tools/plot/shown.hpp"

namespace perceptor {

/// What the legend says is what the picture has: layers without marks are left out. Throws
/// std::runtime_error where the file cannot be written, or ends neither in .png nor in .svg.
void draw(const viewer::Scene& scene, const std::filesystem::path& file,
          const DrawingOptions& options = {});

}  // namespace perceptor
