#include "components/viewer/scene.hpp"

namespace perceptor::viewer {
namespace {

constexpr std::int32_t kBlack = 0x000000;
constexpr std::int32_t kOrange = 0xE69F00;
constexpr std::int32_t kSkyBlue = 0x56B4E9;
constexpr std::int32_t kGreen = 0x009E73;
constexpr std::int32_t kYellow = 0xF0E442;
constexpr std::int32_t kBlue = 0x0072B2;
constexpr std::int32_t kVermilion = 0xD55E00;
constexpr std::int32_t kPurple = 0xCC79A7;
constexpr std::int32_t kGrey = 0x8A8A8A;
constexpr std::int32_t kDarkGrey = 0x505050;

}  // namespace

const std::array<LayerLook, kLayers> kLayerLooks = {{
    {"truth", "Truth (simulator)", 'u'},
    {"global", "Map of the building", 'g'},
    {"combined", "Found of that map", 'm'},
    {"obstacles", "Not on the map", 'o'},
    {"proximity", "Too close", 'p'},
    {"beams", "Laser", 'b'},
    {"local", "Walls remembered", 'l'},
    {"current", "Walls seen now", 'c'},
    {"identified", "Corners and doors", 'i'},
    {"way_out", "Way out", 'w'},
    {"trail", "Way so far", 't'},
    {"robot", "Robot", 'r'},
}};

const std::array<MarkLook, kMarks> kMarkLooks = {{
    {Layer::global_map, "wall", Shape::line, kGrey, 1.5, 0.0, 0.0},
    {Layer::global_map, "cabinet", Shape::polygon, kGrey, 1.5, 0.0, 0.25},
    {Layer::global_map, "door", Shape::line, kGrey, 3.0, 3.0, 0.0},
    {Layer::global_map, "start area", Shape::polygon, kGrey, 1.0, 2.0, 0.06},
    {Layer::combined_map, "wall or cabinet, seen", Shape::line, kBlue, 4.0, 0.0, 0.0},
    {Layer::combined_map, "not seen yet", Shape::line, kSkyBlue, 2.0, 6.0, 0.0},
    {Layer::combined_map, "is not there", Shape::line, kVermilion, 4.0, 3.0, 0.0},
    {Layer::combined_map, "door, open", Shape::line, kGreen, 3.0, 2.0, 0.0},
    {Layer::combined_map, "door, shut", Shape::line, kPurple, 10.0, 0.0, 0.0},
    {Layer::combined_map, "door, not seen yet", Shape::line, kPurple, 3.0, 4.0, 0.0},
    {Layer::obstacles, "stands still", Shape::polygon, kOrange, 2.0, 0.0, 0.4},
    {Layer::obstacles, "moves", Shape::polygon, kPurple, 2.0, 4.0, 0.35},
    {Layer::proximity, "too close", Shape::polygon, kVermilion, 1.0, 0.0, 0.45},
    {Layer::proximity, "touches the robot", Shape::polygon, kBlack, 1.0, 0.0, 0.6},
    {Layer::proximity, "nothing there", Shape::polygon, kGreen, 0.0, 0.0, 0.06},
    {Layer::proximity, "no beam goes there", Shape::polygon, kGrey, 0.0, 0.0, 0.25},
    {Layer::beams, "seen as free", Shape::polygon, kSkyBlue, 0.0, 0.0, 0.12},
    {Layer::beams, "end of a beam", Shape::dot, kSkyBlue, 1.5, 0.0, 0.0},
    {Layer::truth, "wall, shut door, box", Shape::line, kYellow, 5.0, 0.0, 0.0},
    {Layer::truth, "robot", Shape::arrow, kDarkGrey, 15.0, 0.0, 0.0},
    {Layer::truth, "person", Shape::polygon, kDarkGrey, 2.0, 2.0, 0.1},
    {Layer::local_map, "wall", Shape::line, kBlack, 2.0, 0.0, 0.0},
    {Layer::local_map, "where it began", Shape::cross, kBlack, 6.0, 0.0, 0.0},
    {Layer::current_map, "wall", Shape::line, kOrange, 3.0, 0.0, 0.0},
    {Layer::identified, "convex corner", Shape::triangle, kVermilion, 6.0, 0.0, 0.0},
    {Layer::identified, "concave corner", Shape::square, kBlue, 4.0, 0.0, 0.0},
    {Layer::identified, "corner, kind not known", Shape::dot, kBlack, 4.0, 0.0, 0.0},
    {Layer::identified, "loose end of a wall", Shape::ring, kDarkGrey, 4.0, 0.0, 0.0},
    {Layer::identified, "door", Shape::line, kGreen, 7.0, 0.0, 0.0},
    {Layer::identified, "possible door", Shape::line, kGreen, 4.0, 7.0, 0.0},
    {Layer::way_out, "best way out", Shape::arrow, kGreen, 12.0, 0.0, 0.0},
    {Layer::way_out, "middle of the hallway", Shape::line, kGreen, 1.5, 9.0, 0.0},
    {Layer::trail, "trail", Shape::line, kDarkGrey, 2.0, 5.0, 0.0},
    {Layer::robot, "safe distance", Shape::polygon, kOrange, 1.5, 5.0, 0.0},
    {Layer::robot, "may be here (3 sigma)", Shape::polygon, kBlack, 1.0, 2.0, 0.15},
    {Layer::robot, "robot", Shape::polygon, kBlack, 2.0, 0.0, 0.3},
    {Layer::robot, "where it heads", Shape::arrow, kBlack, 9.0, 0.0, 0.0},
}};

std::string_view name(SceneFrame frame) {
  switch (frame) {
    case SceneFrame::robot:
      return "robot";
    case SceneFrame::local:
      return "local";
    case SceneFrame::world:
      break;
  }
  return "world";
}

}  // namespace perceptor::viewer
