#include "tools/eval/scan_panel.hpp"

#include <algorithm>
#include <cmath>

#include "tools/eval/fixed.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor {

const char* const kPanelStyle =
    "text{font:13px sans-serif;fill:#222}"
    ".frame{fill:none;stroke:#888}"
    ".used,.unused,.own{fill:none;stroke-width:2.4;stroke-linecap:round}"
    ".used{stroke:#8a8a8a}.unused{stroke:#d81b1b}.own{stroke:#ddd}"
    ".wall,.end{stroke:#0057d9;stroke-width:1.2}"
    ".number{font-size:10px;fill:#0057d9;text-anchor:middle}"
    ".convex,.concave,.floating{stroke-width:1.4;fill:none}"
    ".convex{stroke:#e69f00}.concave{stroke:#111}.floating{stroke:#999}"
    ".convex.filled{fill:#e69f00}.concave.filled{fill:#111}.floating.filled{fill:#999}"
    ".robot{fill:#f0e442;stroke:#222}"
    ".scale{stroke:#222;stroke-width:2}";

namespace {

constexpr double kShownShare = 0.95;   // [-] of the returns, from the nearest, that fit in for sure
constexpr double kShownBeyond = 1.1;   // [-] what is not much farther than those is shown as well
constexpr double kMargin = 1.06;       // [-] about all that is shown
constexpr double kSmallestHalf = 0.5;  // [m]
constexpr double kMarkSize = 4.0;      // [px] half of a corner's mark, of a tick at a wall's end
constexpr double kRobotSize = 7.0;     // [px] from the middle of the robot's mark to its tip
constexpr double kNumberAside = 9.0;   // [px] from a wall to its number
constexpr double kShortestBar = 12.0;  // [px] below which the scale bar is ten times as long
constexpr double kInset = 10.0;        // [px] of texts from the frame

std::string px(double value) { return fixed(value, 1); }

/// name="value", with a blank before it.
std::string attribute(const char* name, const std::string& value) {
  std::string text = " ";
  return text.append(name).append("=\"").append(value).append("\"");
}

std::string place(const char* x, const char* y, const Vector2& at) {
  return attribute(x, px(at.x())) + attribute(y, px(at.y()));
}

/// An element without content.
std::string element(const char* name, const std::string& kind, const std::string& attributes) {
  std::string text = "<";
  return text.append(name).append(attribute("class", kind)).append(attributes).append("/>\n");
}

std::string line(const char* kind, const Vector2& a, const Vector2& b) {
  return element("line", kind, place("x1", "y1", a) + place("x2", "y2", b));
}

std::string text(const char* kind, const Vector2& at, const std::string& content) {
  return "<text" + attribute("class", kind) + place("x", "y", at) + ">" + content + "</text>\n";
}

std::string polygon(const char* kind, const std::vector<Vector2>& corners) {
  std::string points;
  for (const Vector2& corner : corners)
    points.append(px(corner.x())).append(",").append(px(corner.y())).append(" ");
  return corners.empty() ? "" : element("polygon", kind, attribute("points", points));
}

std::string square(const std::string& kind, const Vector2& upper_left, double side) {
  return element("rect", kind,
                 place("x", "y", upper_left) + place("width", "height", {side, side}));
}

std::string draw_robot(const PanelView& view, const std::vector<Vector2>& footprint) {
  std::vector<Vector2> corners;
  corners.reserve(footprint.size());
  for (const Vector2& corner : footprint) corners.push_back(view.to_panel(corner));
  const Vector2 robot = view.to_panel({0.0, 0.0});
  const std::vector<Vector2> arrow = {robot + Vector2(0.0, -kRobotSize),
                                      robot + Vector2(-0.6 * kRobotSize, 0.8 * kRobotSize),
                                      robot + Vector2(0.6 * kRobotSize, 0.8 * kRobotSize)};
  return polygon("frame", corners) + polygon("robot", arrow);
}

const char* class_of(scan::Fate fate) {
  if (fate == scan::Fate::supports) return "used";
  return fate == scan::Fate::on_robot ? "own" : "unused";
}

/// The ends of all beams of a class: a path of points, much shorter than as many circles.
std::string draw_beams(const PanelView& view, const ScanFindings& scan, const std::string& kind) {
  std::vector<bool> is_drawn(scan.labelled.scan.size());
  for (const scan::BeamGroup& group : scan.account.groups)
    if (class_of(group.fate) == kind)
      for (std::size_t i = group.first_beam; i <= group.last_beam; ++i) is_drawn[i] = true;
  std::string points;
  for (const BeamEnd& end : beam_ends(scan.labelled.scan)) {
    if (!is_drawn[end.beam]) continue;
    const Vector2 at = view.to_panel(end.location);
    points.append("M").append(px(at.x())).append(" ").append(px(at.y())).append("h0");
  }
  return points.empty() ? "" : element("path", kind, attribute("d", points));
}

std::string draw_wall(const PanelView& view, const scan::Wall& wall, std::size_t number) {
  const Vector2 first = view.to_panel(wall.first.location);
  const Vector2 last = view.to_panel(wall.last.location);
  const Vector2 across = perpendicular(unit(last - first));
  const Vector2 tick = kMarkSize * across;
  // The robot's side is the wall's left: there its number hides no beams of what is behind.
  const Vector2 middle = 0.5 * (first + last) - kNumberAside * across + Vector2(0.0, 3.5);
  return line("wall", first, last) + line("end", first - tick, first + tick) +
         line("end", last - tick, last + tick) + text("number", middle, std::to_string(number));
}

std::string draw_corner(const PanelView& view, const scan::Corner& corner) {
  std::string kind = "floating";
  if (corner.property == PointProperty::convex) kind = "convex";
  if (corner.property == PointProperty::concave) kind = "concave";
  const Vector2 at = view.to_panel(corner.place.location);
  if (corner.method == CornerMethod::vector)
    return square(kind, at - Vector2(kMarkSize, kMarkSize), 2.0 * kMarkSize);
  if (corner.method == CornerMethod::intersection) kind += " filled";
  return element("circle", kind, place("cx", "cy", at) + attribute("r", px(kMarkSize)));
}

std::string draw_scale(const PanelView& view) {
  const double metres = view.scale() < kShortestBar ? 10.0 : 1.0;
  const Vector2 begin(kInset, kPanelSize - kInset);
  const Vector2 end = begin + Vector2(metres * view.scale(), 0.0);
  return line("scale", begin, end) +
         text("metres", begin + Vector2(0.0, -5.0), fixed(metres, 0) + " m");
}

}  // namespace

Vector2 PanelView::to_panel(const Vector2& location) const {
  const Vector2 from_centre = scale() * (location - centre);
  return {0.5 * kPanelSize - from_centre.y(), 0.5 * kPanelSize - from_centre.x()};
}

PanelView view_of(const LaserScan& scan) {
  const std::vector<BeamEnd> ends = beam_ends(scan);
  std::vector<double> ranges;
  ranges.reserve(ends.size());
  for (const BeamEnd& end : ends) ranges.push_back(end.range);
  const double shown = kShownBeyond * quantile(std::move(ranges), kShownShare);
  Vector2 low(0.0, 0.0);
  Vector2 high(0.0, 0.0);
  for (const BeamEnd& end : ends) {
    if (end.range > shown) continue;
    low = low.cwiseMin(end.location);
    high = high.cwiseMax(end.location);
  }
  return {.centre = 0.5 * (low + high),
          .half = std::max(kSmallestHalf, 0.5 * kMargin * (high - low).maxCoeff())};
}

std::string scan_panel(const ScanFindings& scan, const std::vector<Vector2>& footprint, double left,
                       double top) {
  const PanelView view = view_of(scan.labelled.scan);
  std::string svg = "<svg" + place("x", "y", {left, top}) +
                    place("width", "height", {kPanelSize, kPanelSize}) + ">\n";
  for (const char* kind : {"own", "used", "unused"}) svg += draw_beams(view, scan, kind);
  svg += draw_robot(view, footprint);
  for (std::size_t i = 0; i < scan.found.walls.size(); ++i)
    svg += draw_wall(view, scan.found.walls[i], i);
  for (const scan::Corner& corner : scan.found.corners) svg += draw_corner(view, corner);
  svg += text("id", {kInset, 1.8 * kInset}, std::to_string(scan.labelled.id));
  svg += draw_scale(view);
  svg += square("frame", {0.0, 0.0}, kPanelSize);
  return svg + "</svg>\n";
}

}  // namespace perceptor
