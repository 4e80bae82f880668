/// @file Which part of a scene goes where in the picture.
#pragma once

#include "tools/plot/shown.hpp"

namespace perceptor {

inline constexpr double kLegendWidth = 240.0;  ///< [px] at the picture's right

struct View {
  Vector2 centre = Vector2::Zero();  ///< [m]
  Vector2 middle = Vector2::Zero();  ///< [px]
  double scale = 1.0;                ///< [px/m]

  Vector2 place(const Vector2& in_scene) const {
    const Vector2 away = scale * (in_scene - centre);
    return middle + Vector2(away.x(), -away.y());
  }
};

/// Everything that is shown, or what is around the robot, as large as fits beside the legend.
View view_of(const viewer::Scene& scene, const DrawingOptions& options);

}  // namespace perceptor
