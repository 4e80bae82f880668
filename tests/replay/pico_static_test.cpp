/// What the real PICO saw, standing at the mouth of a passage of about 0.8 m: a room in front of
/// it, a corridor wall behind the passage. Drawn as a person sees it in a plot of one scan:
///
///        D           A left wall  A-D... the room ends left, out of sight
///       / .          D-C far wall, C-B right wall: concave corners at D and C
///      A   .         B-E right jamb, F-G left jamb: the passage between them
///           C        H-K the corridor wall, seen through the passage
///     robot/
///     F   B          B, E and G are convex; behind F the robot is in its own way
///      .   .
///       G   E
///          H---K
#include <cmath>
#include <fstream>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/geometry/angle.hpp"
#include "common/geometry/segment.hpp"
#include "tests/process/harness.hpp"
#include "tests/support/recorded_data.hpp"

namespace perceptor::test {
namespace {

constexpr const char* kFile = "logs/pico_static.log.xz";
/// The same, as the robot recorded it.
constexpr const char* kBag = "originals/pico_2019-05-07.bag.xz";

/// By eye, to 5 cm, in the order in which a laser turning left meets their ends.
const Segment kLeftJamb{{-0.35, -0.40}, {0.55, -1.40}};
const Segment kCorridorWall{{0.95, -2.40}, {2.00, -1.45}};
const Segment kRightJamb{{1.05, -0.75}, {0.35, 0.00}};
const Segment kRightWall{{0.35, -0.05}, {1.40, 0.90}};
const Segment kFarWall{{1.40, 0.90}, {-0.30, 2.65}};
const Segment kLeftWall{{-0.30, 2.65}, {-1.55, 1.55}};
const std::array kDrawn{kLeftJamb, kCorridorWall, kRightJamb, kRightWall, kFarWall, kLeftWall};

/// [m] A drawn line may be this far off.
constexpr double kDrawnWithin = 0.06;
/// [m] Near its ends a drawn line may catch the neighbour's points.
constexpr double kDrawnEnds = 0.1;

/// Lines through points with 5 mm noise: two ways of picking the points differ by less [rad].
constexpr double kAngleTolerance = 0.015;
/// The same, across the line at its middle [m].
constexpr double kOffsetTolerance = 0.01;
/// Beams meet the ends of the jambs and of the corridor wall up to 3 cm apart; and a round
/// edge ends where one likes [m].
constexpr double kEndTolerance = 0.05;
/// Asked of a corner between two long walls, from scan to scan: standard deviation [m].
constexpr double kCornerScatter = 0.004;
/// Asked of a door's width [m].
constexpr double kWidthTolerance = 0.03;
/// Scans in which all must be right.
constexpr double kShare = 0.99;

struct Scan {
  std::vector<Vector2> points;  ///< returns, in order
  pico::laser_scan_t message;
};

struct Recorded {
  std::vector<Scan> scans;
  std::vector<pico::map_t> current;
  std::vector<pico::map_t> local;
  std::vector<pico::map_t> identified;
};

template <class Message>
Message decoded(const LogEvent& event) {
  Message message;
  EXPECT_EQ(detail::decode(event.data, message), "") << event.channel;
  return message;
}

Scan points_of(const pico::laser_scan_t& message) {
  Scan scan{{}, message};
  for (std::size_t i = 0; i < message.ranges.size(); ++i) {
    const double range = message.ranges[i];
    if (!(range >= message.valid_min && range <= message.valid_max)) continue;
    const double bearing = message.angle_min + static_cast<double>(i) * message.angle_increment;
    scan.points.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  return scan;
}

Recorded replayed(const char* file) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "recording") << testing::unpacked(*testing::recorded(file));
  for (const auto& command :
       {std::vector<std::string>{program("pico-convert"), "--still", scratch / "recording",
                                 scratch / "in.lcmlog"},
        std::vector<std::string>{program("pico-replay"), scratch / "in.lcmlog",
                                 scratch / "out.lcmlog"}}) {
    const Finished finished = run(command);
    EXPECT_EQ(finished.exit_code, 0) << finished.output;
  }
  Recorded all;
  LogReader reader(scratch / "out.lcmlog");
  while (const auto event = reader.next()) {
    if (event->channel == channel::laser)
      all.scans.push_back(points_of(decoded<pico::laser_scan_t>(*event)));
    if (event->channel == channel::current_map) all.current.push_back(decoded<pico::map_t>(*event));
    if (event->channel == channel::local_map) all.local.push_back(decoded<pico::map_t>(*event));
    if (event->channel == channel::identified_map)
      all.identified.push_back(decoded<pico::map_t>(*event));
  }
  return all;
}

class PicoInTheDoorway : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (testing::recorded(kFile)) recorded_ = replayed(kFile);
  }
  static void TearDownTestSuite() { recorded_ = {}; }
  void SetUp() override {
    PERCEPTOR_REQUIRE_RECORDED(kFile);
    ASSERT_EQ(recorded_.scans.size(), 243U);
    ASSERT_EQ(recorded_.current.size(), recorded_.scans.size());
    ASSERT_EQ(recorded_.local.size(), recorded_.scans.size());
    ASSERT_EQ(recorded_.identified.size(), recorded_.scans.size());
  }

  static Recorded recorded_;
};

Recorded PicoInTheDoorway::recorded_;

bool lies_on(const Segment& drawn, const Vector2& point, double beyond_ends) {
  const double along = direction(drawn).dot(point - drawn.a);
  return along > -beyond_ends && along < length(drawn) + beyond_ends &&
         std::abs(signed_distance(drawn, point)) < kDrawnWithin;
}

/// The line of least squares through the points near a drawn one, from its first point to
/// its last. Apart from scan's own fit: unweighted.
Segment measured(const Scan& scan, const Segment& drawn) {
  std::vector<Vector2> points;
  for (const Vector2& point : scan.points)
    if (lies_on(drawn, point, -kDrawnEnds)) points.push_back(point);
  Vector2 mean = Vector2::Zero();
  for (const Vector2& point : points) mean += point / static_cast<double>(points.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Vector2& point : points) {
    const Vector2 off = point - mean;
    xx += off.x() * off.x();
    xy += off.x() * off.y();
    yy += off.y() * off.y();
  }
  const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
  Vector2 along(std::cos(turn), std::sin(turn));
  if (along.dot(direction(drawn)) < 0.0) along = -along;

  double first = 0.0;
  double last = 0.0;
  for (const Vector2& point : scan.points)
    if (lies_on(drawn, point, kDrawnEnds)) {
      first = std::min(first, along.dot(point - mean));
      last = std::max(last, along.dot(point - mean));
    }
  return {mean + first * along, mean + last * along};
}

std::vector<Segment> objects(const pico::map_t& map, int type) {
  std::vector<Segment> found;
  for (const pico::map_object_t& object : map.objects) {
    if (object.type != type) continue;
    const auto& a = map.points.at(static_cast<std::size_t>(object.points.at(0)));
    const auto& b = map.points.at(static_cast<std::size_t>(object.points.at(1)));
    found.push_back({{a.x, a.y}, {b.x, b.y}});
  }
  return found;
}

bool is_same_wall(const Segment& wall, const Segment& as_measured) {
  const bool parallel = smallest_relative_angle(wall, as_measured) < kAngleTolerance;
  const bool on_line = std::abs(signed_distance(wall, middle(as_measured))) < kOffsetTolerance;
  const bool same_ends = (wall.a - as_measured.a).norm() < kEndTolerance &&
                         (wall.b - as_measured.b).norm() < kEndTolerance;
  return parallel && on_line && same_ends;
}

/// Each wall a person sees is there once, and no other.
bool are_the_walls(const std::vector<Segment>& walls, const Scan& scan) {
  if (walls.size() != kDrawn.size()) return false;
  return std::ranges::all_of(kDrawn, [&](const Segment& drawn) {
    const Segment as_measured = measured(scan, drawn);
    return std::ranges::count_if(
               walls, [&](const Segment& wall) { return is_same_wall(wall, as_measured); }) == 1;
  });
}

double share_of(std::size_t good, std::size_t all) {
  return static_cast<double>(good) / static_cast<double>(all);
}

/// Where the lines through two segments meet.
Vector2 crossing(const Segment& s, const Segment& t) {
  const Vector2 along = direction(s);
  return s.a + cross(t.a - s.a, direction(t)) / cross(along, direction(t)) * along;
}

/// The different places of points with this property.
std::vector<Vector2> places(const pico::map_t& map, int property) {
  std::vector<Vector2> found;
  for (const pico::map_point_t& point : map.points) {
    const Vector2 place(point.x, point.y);
    const bool is_known = std::ranges::any_of(
        found, [&](const Vector2& other) { return (other - place).norm() < kEndTolerance; });
    if (point.property == property && !is_known) found.push_back(place);
  }
  return found;
}

bool is_among(const std::vector<Vector2>& found, const Vector2& place) {
  return std::ranges::any_of(
      found, [&](const Vector2& other) { return (other - place).norm() < kEndTolerance; });
}

bool begins_a_second_after(const pico::map_t& map, const pico::map_t& first) {
  return map.utime - first.utime > 1'000'000;
}

/// One door, between the far ends of the jambs, as wide as the points say.
bool has_the_door(const pico::map_t& map, const Scan& scan) {
  const auto doors = objects(map, pico::map_object_t::DOOR);
  if (doors.size() != 1) return false;
  const Vector2 left_post = measured(scan, kLeftJamb).b;
  const Vector2 right_post = measured(scan, kRightJamb).a;
  const std::vector<Vector2> ends{doors[0].a, doors[0].b};
  const double width = (left_post - right_post).norm();
  return std::abs(length(doors[0]) - width) < kWidthTolerance && is_among(ends, left_post) &&
         is_among(ends, right_post);
}

/// The room's two concave corners and no other; the convex ones at both sides of the doorway.
bool has_the_corners(const pico::map_t& map, const Scan& scan) {
  const auto concave = places(map, pico::map_point_t::CONCAVE);
  const auto convex = places(map, pico::map_point_t::CONVEX);
  const Segment right_wall = measured(scan, kRightWall);
  const Segment far_wall = measured(scan, kFarWall);
  const Segment left_wall = measured(scan, kLeftWall);
  return concave.size() == 2 && is_among(concave, crossing(right_wall, far_wall)) &&
         is_among(concave, crossing(far_wall, left_wall)) &&
         is_among(convex, measured(scan, kLeftJamb).b) &&
         is_among(convex, measured(scan, kRightJamb).a) &&
         is_among(convex, crossing(right_wall, measured(scan, kRightJamb)));
}

/// No door or possible door ends at the corridor wall.
bool leaves_the_corridor_alone(const pico::map_t& map) {
  for (const int type : {pico::map_object_t::DOOR, pico::map_object_t::POSSIBLE_DOOR})
    for (const Segment& door : objects(map, type))
      if (distance(kCorridorWall, door.a) < 0.3 || distance(kCorridorWall, door.b) < 0.3)
        return false;
  return true;
}

TEST_F(PicoInTheDoorway, TheWallsAPersonSeesAreTheWallsOfEachScan) {
  std::size_t good = 0;
  for (std::size_t i = 0; i < recorded_.scans.size(); ++i)
    if (are_the_walls(objects(recorded_.current[i], pico::map_object_t::WALL), recorded_.scans[i]))
      ++good;
  EXPECT_GE(share_of(good, recorded_.scans.size()), kShare);
}

/// Standard deviation of points along the axis along which they scatter most [m].
double largest_deviation(const std::vector<Vector2>& points) {
  Vector2 mean = Vector2::Zero();
  for (const Vector2& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2& point : points)
    scatter += (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
  const double half_trace = 0.5 * scatter.trace();
  return std::sqrt(half_trace +
                   std::sqrt(std::max(0.0, half_trace * half_trace - scatter.determinant())));
}

TEST_F(PicoInTheDoorway, CornersOfLongWallsStayWhereTheyAre) {
  const std::array corners{crossing(kRightJamb, kRightWall), crossing(kRightWall, kFarWall),
                           crossing(kFarWall, kLeftWall)};
  for (const Vector2& drawn : corners) {
    std::vector<Vector2> seen;
    for (const pico::map_t& map : recorded_.current) {
      const auto corner = std::ranges::find_if(map.points, [&](const pico::map_point_t& point) {
        return point.method == pico::map_point_t::METHOD_INTERSECTION &&
               distance(drawn, {point.x, point.y}) < 2.0 * kDrawnWithin;
      });
      if (corner != map.points.end()) seen.emplace_back(corner->x, corner->y);
    }
    EXPECT_GE(share_of(seen.size(), recorded_.current.size()), kShare) << drawn.transpose();
    EXPECT_LE(largest_deviation(seen), kCornerScatter) << drawn.transpose();
  }
}

TEST_F(PicoInTheDoorway, NoWallIsMadeOfTheBeamsThatHitTheRobot) {
  for (std::size_t i = 0; i < recorded_.scans.size(); ++i) {
    const auto& points = recorded_.scans[i].points;
    for (const Segment& wall : objects(recorded_.current[i], pico::map_object_t::WALL))
      for (const Vector2& last : {points.back(), points.at(points.size() - 2)}) {
        ASSERT_LT(last.norm(), 0.2) << "the last beams of scan " << i << " hit something else";
        EXPECT_GT(distance(wall, last), 0.1) << "scan " << i;
      }
  }
}

TEST_F(PicoInTheDoorway, AfterASecondTheLocalMapHasTheSameWalls) {
  std::size_t good = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < recorded_.scans.size(); ++i) {
    const pico::map_t& map = recorded_.local[i];
    if (!begins_a_second_after(map, recorded_.local[0])) continue;
    ++all;
    if (are_the_walls(objects(map, pico::map_object_t::WALL), recorded_.scans[i])) ++good;
  }
  EXPECT_GE(share_of(good, all), kShare);
}

TEST_F(PicoInTheDoorway, AfterASecondThereIsOneDoorBetweenTheJambs) {
  for (std::size_t i = 0; i < recorded_.scans.size(); ++i) {
    const pico::map_t& map = recorded_.identified[i];
    if (!begins_a_second_after(map, recorded_.identified[0])) continue;
    EXPECT_TRUE(has_the_door(map, recorded_.scans[i])) << "scan " << i;
    EXPECT_TRUE(has_the_corners(map, recorded_.scans[i])) << "scan " << i;
    EXPECT_TRUE(leaves_the_corridor_alone(map)) << "scan " << i;
  }
}

/// Whether pico-convert reads bags in this build: it says so before it looks at the rest.
bool reads_bags() {
  const ScratchFolder scratch;
  std::ofstream(scratch / "empty.bag") << "#ROSBAG V2.0\n";
  const Finished finished = run({program("pico-convert"), scratch / "empty.bag", "/dev/null"});
  return finished.output.find("without rosbag_storage") == std::string::npos;
}

TEST_F(PicoInTheDoorway, TheRobotsOwnBagHasTheSameScansAndTheDoor) {
  PERCEPTOR_REQUIRE_RECORDED(kBag);
  if (!reads_bags()) GTEST_SKIP() << "pico-convert was built without rosbag_storage";
  const Recorded bag = replayed(kBag);
  ASSERT_EQ(bag.scans.size(), recorded_.scans.size());
  ASSERT_EQ(bag.identified.size(), recorded_.scans.size());
  for (std::size_t i = 0; i < bag.scans.size(); ++i) {
    const pico::laser_scan_t& scan = bag.scans[i].message;
    const pico::laser_scan_t& expected = recorded_.scans[i].message;
    // The text has seconds that went through a double: on the edge they round the other way.
    EXPECT_LE(std::abs(scan.utime - expected.utime), 1) << "scan " << i;
    EXPECT_EQ(scan.ranges, expected.ranges) << "scan " << i;
    // And the bag's floats in ten digits.
    EXPECT_EQ(static_cast<float>(scan.angle_min), static_cast<float>(expected.angle_min));
    EXPECT_EQ(static_cast<float>(scan.angle_increment),
              static_cast<float>(expected.angle_increment));
    if (!begins_a_second_after(bag.identified[i], bag.identified[0])) continue;
    EXPECT_TRUE(has_the_door(bag.identified[i], bag.scans[i])) << "scan " << i;
    EXPECT_TRUE(has_the_corners(bag.identified[i], bag.scans[i])) << "scan " << i;
  }
}

}  // namespace
}  // namespace perceptor::test
