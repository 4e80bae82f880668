#include "common/floorplan/floorplan_writer.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace perceptor {

double to_millimetres(double metres) {
  const double millimetres = std::round(metres * 1000.0);
  return millimetres == 0.0 ? 0.0 : millimetres / 1000.0;
}

std::vector<Floorplan::Edge> FloorplanBuilder::edges(const std::vector<Segment>& segments) {
  std::vector<Floorplan::Edge> edges;
  edges.reserve(segments.size());
  for (const Segment& segment : segments) edges.push_back(edge(segment));
  return edges;
}

int FloorplanBuilder::point(const Vector2& location) {
  const Vector2 rounded(to_millimetres(location.x()), to_millimetres(location.y()));
  const auto [entry, is_new] =
      indices_.try_emplace({rounded.x(), rounded.y()}, static_cast<int>(plan_.points.size()));
  if (is_new) plan_.points.push_back(rounded);
  return entry->second;
}

void write_floorplan(const Floorplan& plan, const std::string& comment,
                     const std::filesystem::path& file) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  using Json = nlohmann::ordered_json;
  std::ofstream out(file);
  const auto write_list = [&](const char* key, const auto& items, const char* end) {
    out << "  \"" << key << "\": [";
    const char* before = "\n    ";
    for (const auto& item : items) {
      out << before << Json(item).dump();
      before = ",\n    ";
    }
    out << (items.empty() ? "]" : "\n  ]") << end;
  };
  Json points = Json::array();
  for (const Vector2& point : plan.points) points.push_back({{"x", point.x()}, {"y", point.y()}});
  out << "{\n  \"_comment\": " << Json(comment).dump() << ",\n";
  write_list("points", points, ",\n");
  write_list("walls", plan.walls, ",\n");
  write_list("cabinets", plan.cabinets, ",\n");
  if (!plan.start_area.empty()) write_list("start_area", plan.start_area, ",\n");
  write_list("doors", plan.doors, "\n");
  out << "}\n";
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace perceptor
