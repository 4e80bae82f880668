#include "tools/plot/marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace perceptor {
namespace {

using viewer::MarkLook;
using viewer::Shape;

constexpr double kArrowHead = 0.45;   // [rad] of each barb from the shaft
constexpr double kSymbolLine = 2.0;   // [px] of rings, crosses and arrows
constexpr double kHalo = 4.0;         // [px] white around bold text
constexpr double kSampleInset = 3.0;  // [px]

void path(cairo_t* cairo, const std::vector<Vector2>& places) {
  cairo_new_path(cairo);
  for (const Vector2& place : places) cairo_line_to(cairo, place.x(), place.y());
}

void draw_polygon(cairo_t* cairo, const MarkLook& look, const std::vector<Vector2>& places) {
  path(cairo, places);
  cairo_close_path(cairo);
  set_colour(cairo, look.colour, look.fill);
  cairo_fill_preserve(cairo);
  set_colour(cairo, look.colour);
  if (look.width > 0.0)
    cairo_stroke(cairo);
  else
    cairo_new_path(cairo);
}

void draw_arrow(cairo_t* cairo, const Vector2& from, const Vector2& to, double size) {
  path(cairo, {from, to});
  const double angle = std::atan2(to.y() - from.y(), to.x() - from.x());
  for (const double barb : {-kArrowHead, kArrowHead}) {
    cairo_move_to(cairo, to.x(), to.y());
    cairo_line_to(cairo, to.x() - size * std::cos(angle + barb),
                  to.y() - size * std::sin(angle + barb));
  }
  cairo_stroke(cairo);
}

void draw_symbol(cairo_t* cairo, Shape shape, const Vector2& place, double size) {
  const double x = place.x();
  const double y = place.y();
  cairo_new_path(cairo);
  if (shape == Shape::dot || shape == Shape::ring)
    cairo_arc(cairo, x, y, size, 0.0, 2.0 * std::numbers::pi);
  if (shape == Shape::square) cairo_rectangle(cairo, x - size, y - size, 2.0 * size, 2.0 * size);
  if (shape == Shape::triangle)
    path(cairo, {{x, y - size}, {x + size, y + size}, {x - size, y + size}});
  if (shape == Shape::cross) {
    path(cairo, {{x - size, y - size}, {x + size, y + size}});
    cairo_move_to(cairo, x - size, y + size);
    cairo_line_to(cairo, x + size, y - size);
  }
  if (shape == Shape::ring || shape == Shape::cross)
    cairo_stroke(cairo);
  else
    cairo_fill(cairo);
}

}  // namespace

void set_colour(cairo_t* cairo, std::int32_t colour, double opacity) {
  const auto part = [colour](int shift) { return ((colour >> shift) & 0xFF) / 255.0; };
  cairo_set_source_rgba(cairo, part(16), part(8), part(0), opacity);
}

void draw_mark(cairo_t* cairo, const MarkLook& look, const std::vector<Vector2>& places) {
  const bool is_line = look.shape == Shape::line || look.shape == Shape::polygon;
  set_colour(cairo, look.colour);
  cairo_set_line_width(cairo, is_line ? look.width : kSymbolLine);
  cairo_set_dash(cairo, &look.dash, look.dash > 0.0 ? 1 : 0, 0.0);
  if (look.shape == Shape::polygon) return draw_polygon(cairo, look, places);
  if (look.shape == Shape::arrow) return draw_arrow(cairo, places[0], places[1], look.width);
  if (look.shape == Shape::line) {
    path(cairo, places);
    return cairo_stroke(cairo);
  }
  for (const Vector2& place : places) draw_symbol(cairo, look.shape, place, look.width);
}

void draw_sample(cairo_t* cairo, const MarkLook& look, const Vector2& corner, const Vector2& size) {
  const Vector2 middle = corner + size / 2.0;
  const Vector2 half = size / 2.0 - Vector2(kSampleInset, kSampleInset);
  const Vector2 across(half.x(), 0.0);
  if (look.shape == Shape::polygon)
    return draw_mark(cairo, look,
                     {middle - half, middle + Vector2(half.x(), -half.y()), middle + half,
                      middle + Vector2(-half.x(), half.y())});
  if (look.shape == Shape::line || look.shape == Shape::arrow) {
    MarkLook thin = look;
    thin.width = std::min(look.width, half.y() * 2.0);
    return draw_mark(cairo, thin, {middle - across, middle + across});
  }
  draw_mark(cairo, look, {middle});
}

void draw_text(cairo_t* cairo, const std::string& text, const Vector2& place, double size,
               std::int32_t colour, Anchor anchor, bool is_bold) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo, text.c_str(), &extents);
  const double left = anchor == Anchor::middle ? place.x() - extents.width / 2.0 : place.x();
  cairo_set_dash(cairo, nullptr, 0, 0.0);
  cairo_move_to(cairo, left, place.y());
  cairo_text_path(cairo, text.c_str());
  set_colour(cairo, 0xFFFFFF);
  cairo_set_line_width(cairo, kHalo);
  if (anchor == Anchor::middle) cairo_stroke_preserve(cairo);
  set_colour(cairo, colour);
  cairo_fill(cairo);
}

}  // namespace perceptor
