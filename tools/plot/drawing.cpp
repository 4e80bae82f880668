#include "tools/plot/drawing.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <cairo-svg.h>
#include <cairo.h>

#include "common/text/format.hpp"
#include "tools/plot/legend.hpp"
#include "tools/plot/marks.hpp"
#include "tools/plot/view.hpp"

namespace perceptor {
namespace {

using viewer::Scene;

constexpr double kLine = 19.0;         // [px] from note to note
constexpr double kInset = 14.0;        // [px] from the picture's edges
constexpr double kLabelAbove = 8.0;    // [px] what it names
constexpr double kShortestBar = 60.0;  // [px]

void draw_items(cairo_t* cairo, const Scene& scene, const View& view,
                const DrawingOptions& options) {
  struct Label {
    const viewer::Item& item;
    Vector2 place;
  };
  std::vector<Label> labels;
  for_items(scene, options, [&](const viewer::Item& item, const std::vector<Vector2>& points) {
    std::vector<Vector2> places;
    places.reserve(points.size());
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
