#include "tools/eval/extract.hpp"

namespace perceptor {

void WallFinder::run(const LaserScan& scan) { extractor_.extract(scan); }

FoundWalls WallFinder::found() const {
  FoundWalls found;
  for (const scan::Wall& wall : extractor_.found().walls)
    found.walls.push_back({wall.first.location, wall.last.location});
  for (const scan::Corner& corner : extractor_.found().corners)
    if (corner.method == CornerMethod::intersection)
      found.corners.push_back({corner.place.location, corner.property == PointProperty::convex});
  return found;
}

}  // namespace perceptor
