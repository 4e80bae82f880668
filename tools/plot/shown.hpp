/// @file What of a scene is shown.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "components/viewer/scene.hpp"

namespace perceptor {

struct DrawingOptions {
  int width = 1400;                ///< [px] of the picture, legend included
  int height = 900;                ///< [px]
  std::optional<double> around{};  ///< [m] shown on each side of the robot; without, everything
  std::set<viewer::Layer> hidden{};
};

/// Calls `use(item, points)` for each item that is shown, the lowest first, with its points in the
/// scene's frame [m].
template <class Use>
void for_items(const viewer::Scene& scene, const DrawingOptions& options, const Use& use) {
  for (std::size_t i = 0; i < viewer::kLayers; ++i) {
    const auto layer = static_cast<viewer::Layer>(i);
    if (options.hidden.contains(layer)) continue;
    for (const viewer::Item& item : scene[layer].items) {
      std::vector<Vector2> points;
      points.reserve(item.points.size());
      for (const Vector2& point : item.points)
        points.push_back(transform(scene[layer].frame_in_scene, point));
      use(item, points);
    }
  }
}

}  // namespace perceptor
