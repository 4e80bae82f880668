/// @file The legend beside a picture: what is in the picture, and nothing else.
#pragma once

#include <cairo.h>

#include "tools/plot/shown.hpp"

namespace perceptor {

/// Layers and their marks, what is drawn last first; smaller where it would not fit. Moves and
/// scales `cairo`.
void draw_legend(cairo_t* cairo, const viewer::Scene& scene, const DrawingOptions& options);

}  // namespace perceptor
