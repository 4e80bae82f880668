#include "tools/plot/legend.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "tools/plot/marks.hpp"
#include "tools/plot/view.hpp"

namespace perceptor {
namespace {

using viewer::Layer;
using viewer::Mark;
using viewer::Scene;

constexpr double kLine = 19.0;       // [px] from line to line
constexpr double kAboveTitle = 6.0;  // [px] more
constexpr double kInset = 14.0;      // [px] from the picture's edges, and from a sample to its text
const Vector2 kSample(30.0, 14.0);   // [px]

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

}  // namespace

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

}  // namespace perceptor
