/// @file One mark of a scene, drawn by cairo as the page of the viewer draws it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cairo.h>

#include "components/viewer/scene.hpp"

namespace perceptor {

/// `places`: [px] right and down.
void draw_mark(cairo_t* cairo, const viewer::MarkLook& look, const std::vector<Vector2>& places);

/// As the legend shows it, in a box.
void draw_sample(cairo_t* cairo, const viewer::MarkLook& look, const Vector2& corner,
                 const Vector2& size);

inline constexpr double kTextSize = 13.0;       ///< [px]
inline constexpr std::int32_t kInk = 0x111111;  ///< of text

enum class Anchor { left, middle };
void draw_text(cairo_t* cairo, const std::string& text, const Vector2& place, double size,
               std::int32_t colour, Anchor anchor = Anchor::left, bool is_bold = false);

void set_colour(cairo_t* cairo, std::int32_t colour, double opacity = 1.0);

}  // namespace perceptor
