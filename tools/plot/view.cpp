#include "tools/plot/view.hpp"

#include <algorithm>
#include <limits>

namespace perceptor {
namespace {

using viewer::Layer;
using viewer::Scene;

constexpr double kMargin = 1.1;        // about all that is shown
constexpr double kSmallestHalf = 0.5;  // [m]

struct Box {
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());    ///< [m]
  Vector2 high = Vector2::Constant(-std::numeric_limits<double>::infinity());  ///< [m]

  bool is_empty() const { return low.x() > high.x(); }
};

/// Around the points of all items of layers that `counts` names.
template <class Counts>
Box box_of(const Scene& scene, const DrawingOptions& options, const Counts& counts) {
  Box box;
  for_items(scene, options, [&](const viewer::Item& item, const std::vector<Vector2>& points) {
    if (!counts(look_of(item.mark).layer)) return;
    for (const Vector2& point : points) {
      box.low = box.low.cwiseMin(point);
      box.high = box.high.cwiseMax(point);
    }
  });
  return box;
}

/// Single beams that went astray count only where there is nothing else.
Box box_of(const Scene& scene, const DrawingOptions& options) {
  Box box = box_of(scene, options,
                   [](Layer layer) { return layer != Layer::beams && layer != Layer::robot; });
  if (!box.is_empty()) return box;
  const Box of_all = box_of(scene, options, [](Layer) { return true; });
  return of_all.is_empty() ? Box{Vector2::Zero(), Vector2::Zero()} : of_all;
}

}  // namespace

View view_of(const Scene& scene, const DrawingOptions& options) {
  const Vector2 size(options.width - kLegendWidth, options.height);
  View view;
  view.middle = size / 2.0;
  Vector2 half;
  if (options.around) {
    view.centre = scene.robot_in_scene.location();
    half = Vector2::Constant(*options.around);
  } else {
    const Box box = box_of(scene, options);
    view.centre = (box.low + box.high) / 2.0;
    half = ((box.high - box.low) / 2.0).cwiseMax(Vector2::Constant(kSmallestHalf)) * kMargin;
  }
  view.scale = std::min(size.x() / half.x(), size.y() / half.y()) / 2.0;
  return view;
}

}  // namespace perceptor
