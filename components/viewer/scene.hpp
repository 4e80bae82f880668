/// @file What a picture of the robot and its surroundings is made of: marks on layers, the same for
/// the browser, for PNG and for SVG. It knows nothing of where the marks come from, nor of who
/// draws them.
///
/// The colours are those of M. Okabe and K. Ito, "Color Universal Design" (2008), which the
/// colour-blind tell apart; no two marks differ by colour alone.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor::viewer {

/// In the order in which they are drawn, the lowest first.
enum class Layer : std::uint8_t {
  truth,
  global_map,
  combined_map,
  obstacles,
  proximity,
  beams,
  local_map,
  current_map,
  identified,
  way_out,
  trail,
  robot,
};
inline constexpr std::size_t kLayers = 12;

/// How a layer is switched, and what the legend calls it.
struct LayerLook {
  std::string_view id;     ///< one word
  std::string_view title;  ///< for people
  char key;                ///< shows and hides it
};

/// Of each Layer, in order.
extern const std::array<LayerLook, kLayers> kLayerLooks;

enum class Mark : std::uint8_t {
  map_wall,
  map_cabinet,
  map_door,
  start_area,
  confirmed_wall,
  unseen_wall,
  contradicted_wall,
  open_door,
  shut_door,
  unseen_door,
  static_obstacle,
  dynamic_obstacle,
  too_close,
  contact,
  clear_sector,
  blind_sector,
  beam_fan,
  beam_end,
  true_wall,
  true_robot,
  true_mover,
  local_wall,
  origin,
  current_wall,
  convex_corner,
  concave_corner,
  corner,
  loose_end,
  door,
  possible_door,
  entrance,
  hallway,
  trail,
  safe_distance,
  pose_ellipse,
  robot,
  heading,
};
inline constexpr std::size_t kMarks = 37;

/// Symbols stand at each point and have the size of the screen; the others join the points.
enum class Shape : std::uint8_t { line, polygon, dot, ring, square, triangle, cross, arrow };

struct MarkLook {
  Layer layer;
  std::string_view label;  ///< in the legend
  Shape shape;
  std::int32_t colour;  ///< 0xRRGGBB of line and symbol
  double width;         ///< [px] of a line, of a symbol from its middle to its edge
  double dash;          ///< [px] of a dash and of the gap after it; 0: a whole line
  double fill;          ///< [-] opacity of a polygon's inside
};

/// Of each Mark, in order.
extern const std::array<MarkLook, kMarks> kMarkLooks;

inline const MarkLook& look_of(Mark mark) { return kMarkLooks[static_cast<std::size_t>(mark)]; }
inline const LayerLook& look_of(Layer layer) {
  return kLayerLooks[static_cast<std::size_t>(layer)];
}

/// One thing in the picture.
struct Item {
  Mark mark;
  std::vector<Vector2> points;  ///< [m] in the layer's frame
  std::string text{};           ///< what it is, for whoever points at it
  std::string label{};          ///< written beside it
};

struct LayerScene {
  Position frame_in_scene;  ///< of `items`
  std::vector<Item> items;
};

enum class SceneFrame : std::uint8_t { robot, local, world };
std::string_view name(SceneFrame frame);

struct Scene {
  SceneFrame frame = SceneFrame::robot;  ///< what the picture stands still in
  std::int64_t utime = 0;                ///< [us] of the newest measurement; 0: none yet
  Position robot_in_scene;
  std::array<LayerScene, kLayers> layers;
  std::vector<std::string> notes;  ///< what is missing, old or not known, for people

  LayerScene& operator[](Layer layer) { return layers[static_cast<std::size_t>(layer)]; }
  const LayerScene& operator[](Layer layer) const {
    return layers[static_cast<std::size_t>(layer)];
  }
};

}  // namespace perceptor::viewer
