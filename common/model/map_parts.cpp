#include "common/model/map_parts.hpp"

namespace perceptor {
namespace {

/// The objects from `begin` to before `end`, and their points.
Map part_of(const Map& map, std::size_t begin, std::size_t end) {
  Map part = map;
  for (std::size_t i = 0; i < part.objects.size(); ++i)
    part.objects[i].remove = i < begin || i >= end;
  remove_objects(part);
  return part;
}

}  // namespace

std::vector<Map> parts_of(const Map& map, std::size_t objects, std::size_t points) {
  std::vector<Map> parts;
  std::size_t begin = 0;
  do {
    std::size_t end = begin;
    std::size_t points_in_part = 0;
    while (end < map.objects.size() && end - begin < objects) {
      points_in_part += map.objects[end].points.size();
      if (end > begin && points_in_part > points) break;
      ++end;
    }
    parts.push_back(part_of(map, begin, end));
    begin = end;
  } while (begin < map.objects.size());
  return parts;
}

}  // namespace perceptor
