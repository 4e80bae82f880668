/// @file Makes floorplans, and writes them in the public JSON format.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/floorplan/floorplan.hpp"

namespace perceptor {

/// As map files hold them: rounded, and never minus zero.
double to_millimetres(double metres);

/// Collects lines; points to the millimetre, each once: lines that meet share theirs.
class FloorplanBuilder {
 public:
  void add_wall(const Segment& wall) { plan_.walls.push_back(edge(wall)); }
  void add_cabinet(const std::vector<Segment>& sides) { plan_.cabinets.push_back(edges(sides)); }
  void add_door(const Segment& door) { plan_.doors.push_back(edges({door})); }
  void add_start_area(const std::vector<Segment>& sides) {
    plan_.start_area.push_back(edges(sides));
  }

  const Floorplan& plan() const { return plan_; }

 private:
  Floorplan::Edge edge(const Segment& segment) { return {point(segment.a), point(segment.b)}; }
  std::vector<Floorplan::Edge> edges(const std::vector<Segment>& segments);
  int point(const Vector2& location);

  Floorplan plan_;
  std::map<std::pair<double, double>, int> indices_;
};

/// What was made to the millimetre is written so. Throws std::runtime_error where the file cannot
/// be written; makes its folder.
void write_floorplan(const Floorplan& plan, const std::string& comment,
                     const std::filesystem::path& file);

}  // namespace perceptor
