/// @file What was measured, and where the robot is, as marks in a picture.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/geometry/segment.hpp"
#include "common/model/laser_scan.hpp"
#include "components/viewer/scene.hpp"

namespace perceptor::viewer {

/// The ends of all beams that returned, and the space between neighbours of them; the robot moved
/// at `twist` during the sweep. Robot frame at the first beam.
std::vector<Item> beam_items(const LaserScan& scan, const Twist& twist = {});

/// One of the equal sectors around the robot.
struct SectorView {
  bool too_close = false;
  bool blind = false;
  bool contact = false;
  double distance = 0.0;  ///< [m] of the nearest in it; infinite: nothing seen
};

/// Each sector up to `radius` [m], the first from bearing -pi on. Robot frame.
std::vector<Item> proximity_items(const std::vector<SectorView>& sectors, double radius);

struct WayOut {
  bool found = false;
  Vector2 middle = Vector2::Zero();  ///< [m] of the opening
  double direction = 0.0;            ///< [rad] outward
  double width = 0.0;                ///< [m]
  double confidence = 0.0;           ///< 0 to 1
  std::optional<Segment> hallway;    ///< [m] its centre line
  double hallway_width = 0.0;        ///< [m]
};

/// In the frame of `way_out`.
std::vector<Item> way_out_items(const WayOut& way_out);

/// Where the robot may be: the ellipse of three sigmas of the covariance of x, y [m^2], around the
/// robot at `robot`, in its frame. One that has no area is none.
std::optional<Item> ellipse_item(const Position& robot, const Eigen::Matrix2d& covariance);

/// An arrow from the robot's centre.
Item heading_item(Mark mark, const Position& robot, std::string text);

/// A round body.
Item disc_item(Mark mark, const Vector2& centre, double radius, std::string text);

}  // namespace perceptor::viewer
