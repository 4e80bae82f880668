#include "components/viewer/sensor_items.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "common/text/format.hpp"

namespace perceptor::viewer {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kSigmas = 3.0;
constexpr double kHeadingLength = 0.45;  // [m] of the arrow from the robot's centre
constexpr double kWayOutFrom = 0.15;     // [m] outside of the opening, whose name stands in it
constexpr double kWayOutTo = 0.7;        // [m]
constexpr int kCirclePoints = 24;
constexpr double kArcStep = 0.1;  // [rad] between the points of an arc

Vector2 at(double bearing, double distance) {
  return distance * Vector2(std::cos(bearing), std::sin(bearing));
}

Mark mark_of(const SectorView& sector) {
  if (sector.contact) return Mark::contact;
  if (sector.blind) return Mark::blind_sector;
  return sector.too_close ? Mark::too_close : Mark::clear_sector;
}

std::string text_of(const SectorView& sector, double from, double to) {
  std::string text = std::string(look_of(mark_of(sector)).label) +
                     format(", %.0f to %.0f deg", kDegrees * from, kDegrees * to);
  if (std::isfinite(sector.distance)) text += format(", nearest %.2f m", sector.distance);
  return text;
}

}  // namespace

std::vector<Item> beam_items(const LaserScan& scan, const Twist& twist) {
  std::vector<Item> items;
  Item ends{Mark::beam_end, {}};
  const BeamEnd* before = nullptr;
  const std::vector<BeamEnd> all = beam_ends(scan, twist);
  for (const BeamEnd& end : all) {
    const bool is_neighbour =
        before != nullptr && (end.beam == before->beam + 1 || before->beam == end.beam + 1);
    if (!is_neighbour) items.push_back({Mark::beam_fan, {end.origin}});
    items.back().points.push_back(end.location);
    ends.points.push_back(end.location);
    before = &end;
  }
  if (!ends.points.empty()) items.push_back(std::move(ends));
  return items;
}

std::vector<Item> proximity_items(const std::vector<SectorView>& sectors, double radius) {
  std::vector<Item> items;
  const double width = kTwoPi / static_cast<double>(std::max<std::size_t>(1, sectors.size()));
  const int steps = std::max(1, static_cast<int>(std::ceil(width / kArcStep)));
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    const double from = -std::numbers::pi + width * static_cast<double>(i);
    Item wedge{mark_of(sectors[i]), {Vector2::Zero()}, text_of(sectors[i], from, from + width)};
    for (int step = 0; step <= steps; ++step)
      wedge.points.push_back(at(from + width * step / steps, radius));
    items.push_back(std::move(wedge));
  }
  return items;
}

std::vector<Item> way_out_items(const WayOut& way_out) {
  std::vector<Item> items;
  if (way_out.found) {
    const Vector2 outward = at(way_out.direction, 1.0);
    items.push_back(
        {Mark::entrance,
         {way_out.middle + kWayOutFrom * outward, way_out.middle + kWayOutTo * outward},
         format("best way out, %.2f m wide, confidence %.2f", way_out.width, way_out.confidence)});
  }
  if (way_out.hallway)
    items.push_back({Mark::hallway,
                     {way_out.hallway->a, way_out.hallway->b},
                     format("middle of a hallway %.2f m wide", way_out.hallway_width)});
  return items;
}

std::optional<Item> ellipse_item(const Position& robot, const Eigen::Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  const Eigen::Vector2d& variances = axes.eigenvalues();
  if (axes.info() != Eigen::Success || !(variances.minCoeff() > 0.0)) return std::nullopt;
  const Eigen::Vector2d radii = kSigmas * variances.cwiseSqrt();
  Item ellipse{Mark::pose_ellipse,
               {},
               format("the robot is at (%.3f, %.3f) m, heading %.1f deg; three sigmas: %.1f mm by "
                      "%.1f mm",
                      robot.x, robot.y, kDegrees * robot.a, 1000.0 * radii.maxCoeff(),
                      1000.0 * radii.minCoeff())};
  for (int i = 0; i < kCirclePoints; ++i) {
    const Vector2 on_circle = at(kTwoPi * i / kCirclePoints, 1.0);
    ellipse.points.emplace_back(robot.location() +
                                axes.eigenvectors() * radii.cwiseProduct(on_circle));
  }
  return ellipse;
}

Item heading_item(Mark mark, const Position& robot, std::string text) {
  return {
      mark, {robot.location(), robot.location() + at(robot.a, kHeadingLength)}, std::move(text)};
}

Item disc_item(Mark mark, const Vector2& centre, double radius, std::string text) {
  Item disc{mark, {}, std::move(text)};
  for (int i = 0; i < kCirclePoints; ++i)
    disc.points.emplace_back(centre + at(kTwoPi * i / kCirclePoints, radius));
  return disc;
}

}  // namespace perceptor::viewer
