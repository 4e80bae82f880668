#include "common/floorplan/floorplan.hpp"

#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "common/config/json_file.hpp"
#include "common/config/place.hpp"
#include "common/config/reader.hpp"
#include "common/floorplan/outline.hpp"

namespace perceptor {
namespace {

using config::Place;
using nlohmann::json;

constexpr std::string_view kComment = "_comment";
constexpr config::Range kCoordinate = {-1e4, 1e4};  // [m] no building is larger
constexpr std::size_t kMostEdges = 20'000;          // of all kinds together: nor has more

void ignore(const Place& place, Floorplan& plan) { plan.ignored.push_back(place.pointer); }

const json& require_list(const json& value, const Place& place, std::string_view of_what) {
  if (!value.is_array() || value.empty())
    config::fail(place, value, "a list of at least one " + std::string(of_what));
  return value;
}

double read_coordinate(const json& point, const Place& place, const std::string& name) {
  const auto found = point.find(name);
  if (found == point.end()) config::fail(place, point, "a point with x and y; no " + name);
  return config::read_number(*found, place.key(name), kCoordinate);
}

Vector2 read_point(const json& value, const Place& place, Floorplan& plan) {
  if (!value.is_object()) config::fail(place, value, R"(a point {"x": 0.0, "y": 0.0})");
  for (const auto& [key, unused] : value.items())
    if (key != "x" && key != "y" && key != kComment) ignore(place.key(key), plan);
  return {read_coordinate(value, place, "x"), read_coordinate(value, place, "y")};
}

int read_index(const json& value, const Place& place, const Floorplan& plan) {
  const auto last = static_cast<std::int64_t>(plan.points.size()) - 1;
  return static_cast<int>(config::read_integer(value, place, {0, last}));
}

Floorplan::Edge read_edge(const json& value, const Place& place, const Floorplan& plan) {
  if (!value.is_array() || value.size() != 2)
    config::fail(place, value, "the indices of two points [0, 1]");
  const Floorplan::Edge edge = {read_index(value[0], place.item(0), plan),
                                read_index(value[1], place.item(1), plan)};
  const Segment segment = plan.segment(edge);
  if (segment.a == segment.b) config::fail(place, value, "two points that lie apart");
  return edge;
}

std::vector<Floorplan::Edge> read_edges(const json& value, const Place& place,
                                        std::string_view of_what, const Floorplan& plan) {
  std::vector<Floorplan::Edge> edges;
  for (const json& edge : require_list(value, place, of_what))
    edges.push_back(read_edge(edge, place.item(edges.size()), plan));
  return edges;
}

/// Cabinets, doors and start areas: lists of lists of edges. The whole may be missing or
/// empty, each in it may not.
std::vector<std::vector<Floorplan::Edge>> read_outlines(const json& document, const Place& whole,
                                                        const std::string& key,
                                                        const Floorplan& plan) {
  std::vector<std::vector<Floorplan::Edge>> outlines;
  const auto found = document.find(key);
  if (found == document.end()) return outlines;
  const Place place = whole.key(key);
  if (!found->is_array()) config::fail(place, *found, "a list");
  for (const json& outline : *found)
    outlines.push_back(read_edges(outline, place.item(outlines.size()), "edge", plan));
  return outlines;
}

void check_size(const Place& whole, const Floorplan& plan) {
  std::size_t edges = plan.walls.size();
  for (const auto* outlines : {&plan.cabinets, &plan.doors, &plan.start_area})
    for (const auto& outline : *outlines) edges += outline.size();
  if (edges > kMostEdges)
    config::fail(whole, "has " + std::to_string(edges) + " walls and edges; allowed: at most " +
                            std::to_string(kMostEdges));
}

void check_cabinets(const json& document, const Place& whole, const Floorplan& plan) {
  for (std::size_t i = 0; i < plan.cabinets.size(); ++i)
    if (!find_corners(plan, plan.cabinets[i]))
      config::fail(whole.key("cabinets").item(i), document.at("cabinets")[i],
                   "sides that follow each other around one cabinet, in any order");
}

const json& require_key(const json& document, const Place& whole, const std::string& key) {
  const auto found = document.find(key);
  if (found == document.end()) config::fail(whole.key(key), "is missing; allowed: a list");
  return *found;
}

bool is_known(const std::string& key) {
  return key == "points" || key == "walls" || key == "cabinets" || key == "doors" ||
         key == "start_area" || key == kComment;
}

}  // namespace

Floorplan read_floorplan(const std::filesystem::path& file) {
  const json document = config::read_json(file);
  const Place whole = {file.string(), ""};
  if (!document.is_object()) config::fail(whole, document, "a map {\"points\": ...}");

  Floorplan plan;
  for (const auto& [key, unused] : document.items())
    if (!is_known(key)) ignore(whole.key(key), plan);

  const Place points = whole.key("points");
  for (const json& point : require_list(require_key(document, whole, "points"), points, "point"))
    plan.points.push_back(read_point(point, points.item(plan.points.size()), plan));

  plan.walls = read_edges(require_key(document, whole, "walls"), whole.key("walls"), "wall", plan);
  plan.cabinets = read_outlines(document, whole, "cabinets", plan);
  plan.doors = read_outlines(document, whole, "doors", plan);
  plan.start_area = read_outlines(document, whole, "start_area", plan);
  check_size(whole, plan);
  check_cabinets(document, whole, plan);
  return plan;
}

}  // namespace perceptor
