#include "tools/plot/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <cairo-svg.h>
#include <cairo.h>

#include "common/text/format.hpp"
#include "tools/plot/marks.hpp"

namespace perceptor {
namespace {

using viewer::Layer;
using viewer::Mark;
using viewer::Scene;

constexpr double kLegendWidth = 240.0;  // [px]
constexpr double kMargin = 1.1;         // about all that is shown
constexpr double kSmallestHalf = 0.5;   // [m]
constexpr double kLine = 19.0;          // [px] of the legend
constexpr double kAboveTitle = 6.0;     // [px] more
constexpr double kInset = 14.0;         // [px] from the picture's edges
constexpr double kTextSize = 13.0;      // [px]
constexpr double kLabelAbove = 8.0;     // [px] what it names
constexpr double kShortestBar = 60.0;   // [px]
constexpr std::int32_t kInk = 0x111111;
const Vector2 kSample(30.0, 14.0);  // [px]

/// Which part of the scene goes where.
struct View {
  Vector2 centre = Vector2::Zero();  ///< [m]
  Vector2 middle = Vector2::Zero();  ///< [px]
  double scale = 1.0;                ///< [px/m]

  Vector2 place(const Vector2& in_scene) const {
    const Vector2 away = scale * (in_scene - centre);
    return middle + Vector2(away.x(), -away.y());
  }
};

/// Calls `use(item, points)` for each item that is shown, the lowest first, with its points in the
/// scene's frame [m].
template <class Use>
void for_items(const Scene& scene, const DrawingOptions& options, const Use& use) {
  for (std::size_t i = 0; i < viewer::kLayers; ++i) {
    const auto layer = static_cast<Layer>(i);
    if (options.hidden.contains(layer)) continue;
    for (const viewer::Item& item : scene[layer].items) {
      std::vector<Vector2> points;
      for (const Vector2& point : item.points)
        points.push_back(transform(scene[layer].frame_in_scene, point));
      use(item, points);
    }
  }
}

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
  const Box box = box_of(
      scene, options, [](Layer layer) { return layer != Layer::beams && layer != Layer::robot; });
  if (!box.is_empty()) return box;
  const Box of_all = box_of(scene, options, [](Layer) { return true; });
  return of_all.is_empty() ? Box{Vector2::Zero(), Vector2::Zero()} : of_all;
}

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

void draw_items(cairo_t* cairo, const Scene& scene, const View& view,
                const DrawingOptions& options) {
  struct Label {
    const viewer::Item& item;
    Vector2 place;
  };
  std::vector<Label> labels;
  for_items(scene, options, [&](const viewer::Item& item, const std::vector<Vector2>& points) {
    std::vector<Vector2> places;
    for (const Vector2& point : points) places.push_back(view.place(point));
    draw_mark(cairo, look_of(item.mark), places);
    if (!item.label.empty()) labels.push_back({item, (places.front() + places.back()) / 2.0});
  });
  for (const auto& [item, place] : labels)
    draw_text(cairo, item.label, place - Vector2(0.0, kLabelAbove), kTextSize,
              look_of(item.mark).colour, Anchor::middle, true);
}

/// A bar of 1, 2 or 5 times a power of ten metres, in the lower right corner.
void draw_scale_bar(cairo_t* cairo, const View& view) {
  const double power = std::pow(10.0, std::floor(std::log10(kShortestBar / view.scale)));
  double metres = 10.0 * power;
  for (const double times : {5.0, 2.0, 1.0})
    if (times * power * view.scale >= kShortestBar) metres = times * power;
  const Vector2 right = 2.0 * view.middle - Vector2(kInset, kInset);
  const Vector2 left = right - Vector2(metres * view.scale, 0.0);
  set_colour(cairo, kInk);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
  cairo_set_line_width(cairo, 2.0);
  cairo_move_to(cairo, left.x(), left.y());
  cairo_line_to(cairo, right.x(), right.y());
  cairo_stroke(cairo);
  draw_text(cairo, format("%g m", metres), (left + right) / 2.0 - Vector2(0.0, kLabelAbove),
            kTextSize, kInk, Anchor::middle);
}

/// A line of the legend: the title of a layer, or one of its marks.
struct LegendLine {
  Layer layer;
  std::optional<Mark> mark;
};

/// The marks that the picture has, by layer, what is drawn last first.
std::vector<LegendLine> legend_of(const Scene& scene, const DrawingOptions& options) {
  std::array<bool, viewer::kMarks> is_there{};
  for_items(scene, options, [&](const viewer::Item& item, const std::vector<Vector2>&) {
    is_there[static_cast<std::size_t>(item.mark)] = true;
  });
  std::vector<LegendLine> lines;
  for (std::size_t i = viewer::kLayers; i-- > 0;) {
    const auto layer = static_cast<Layer>(i);
    const std::size_t title = lines.size();
    for (std::size_t m = 0; m < viewer::kMarks; ++m)
      if (is_there[m] && viewer::kMarkLooks[m].layer == layer)
        lines.push_back({layer, static_cast<Mark>(m)});
    if (lines.size() > title)
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(title), {layer, std::nullopt});
  }
  return lines;
}

/// Smaller where it would not fit.
void draw_legend(cairo_t* cairo, const Scene& scene, const DrawingOptions& options) {
  const std::vector<LegendLine> lines = legend_of(scene, options);
  const auto titles = std::ranges::count_if(lines, [](const auto& line) { return !line.mark; });
  const double height = kLine * static_cast<double>(lines.size()) +
                        kAboveTitle * static_cast<double>(titles) + 2.0 * kInset;
  const double scale = std::min(1.0, options.height / height);
  cairo_translate(cairo, options.width - kLegendWidth + kInset, 0.0);
  cairo_scale(cairo, scale, scale);
  double y = kInset;
  for (const auto& [layer, mark] : lines) {
    y += kLine;
    if (mark) {
      draw_sample(cairo, look_of(*mark), {0.0, y - kSample.y()}, kSample);
      draw_text(cairo, std::string(look_of(*mark).label), {kSample.x() + kInset, y - 2.0},
                kTextSize, kInk);
    } else {
      y += kAboveTitle;
      draw_text(cairo, std::string(look_of(layer).title), {0.0, y}, kTextSize, kInk, Anchor::left,
                true);
    }
  }
}

void draw_notes(cairo_t* cairo, const Scene& scene, const DrawingOptions& options) {
  double y = options.height - kInset;
  for (const std::string& note : scene.notes) {
    draw_text(cairo, note, {kInset, y}, kTextSize, kInk);
    y -= kLine;
  }
}

void draw_all(cairo_t* cairo, const Scene& scene, const DrawingOptions& options) {
  const View view = view_of(scene, options);
  set_colour(cairo, 0xFFFFFF);
  cairo_paint(cairo);
  cairo_save(cairo);
  cairo_rectangle(cairo, 0.0, 0.0, options.width - kLegendWidth, options.height);
  cairo_clip(cairo);
  draw_items(cairo, scene, view, options);
  draw_scale_bar(cairo, view);
  draw_notes(cairo, scene, options);
  cairo_restore(cairo);
  draw_legend(cairo, scene, options);
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Cairo = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void check(cairo_status_t status, const std::filesystem::path& file) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(file.string() + ": " + cairo_status_to_string(status));
}

}  // namespace

void draw(const Scene& scene, const std::filesystem::path& file, const DrawingOptions& options) {
  const bool is_svg = file.extension() == ".svg";
  if (!is_svg && file.extension() != ".png")
    throw std::runtime_error(file.string() + ": ends neither in .png nor in .svg");
  const Surface surface(
      is_svg ? cairo_svg_surface_create(file.c_str(), options.width, options.height)
             : cairo_image_surface_create(CAIRO_FORMAT_RGB24, options.width, options.height),
      cairo_surface_destroy);
  check(cairo_surface_status(surface.get()), file);
  const Cairo cairo(cairo_create(surface.get()), cairo_destroy);
  draw_all(cairo.get(), scene, options);
  check(cairo_status(cairo.get()), file);
  if (is_svg) {
    cairo_surface_finish(surface.get());
    return check(cairo_surface_status(surface.get()), file);
  }
  check(cairo_surface_write_to_png(surface.get(), file.c_str()), file);
}

}  // namespace perceptor
