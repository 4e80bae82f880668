#include "components/localize/rays.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace perceptor::localize {
namespace {

double brute_force(const std::vector<Segment>& lines, const Vector2& origin,
                   const Vector2& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& line : lines) {
    const Vector2 along = line.b - line.a;
    const double across = cross(direction, along);
    const double distance = cross(line.a - origin, along) / across;
    const double place = cross(line.a - origin, direction) / across;
    if (distance > 0.0 && place >= 0.0 && place <= 1.0) nearest = std::min(nearest, distance);
  }
  return nearest;
}

double place(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(-20.0, 20.0)(random);
}

/// Spread over 40 m by 10 m; each third runs along x.
std::vector<Segment> random_lines(std::mt19937_64& random) {
  std::uniform_real_distribution<double> step(-3.0, 3.0);
  std::vector<Segment> lines;
  for (int i = 0; i < 120; ++i) {
    const Vector2 a(place(random), place(random) / 4.0);
    lines.push_back({a, a + Vector2(step(random), i % 3 == 0 ? 0.0 : step(random))});
  }
  return lines;
}

Rays sorted(const std::vector<Segment>& lines) {
  Rays rays;
  for (const Segment& line : lines) rays.add(line);
  rays.sort();
  return rays;
}

TEST(Rays, MeetWhatALookAtEachLineFinds) {
  std::mt19937_64 random(7);
  const std::vector<Segment> lines = random_lines(random);
  const Rays rays = sorted(lines);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector2 origin(1.5 * place(random), place(random) / 3.0);
    const double bearing = i % 5 == 0 ? (i % 4) * std::numbers::pi / 2.0 : place(random);
    const Vector2 direction(std::cos(bearing), std::sin(bearing));
    const RayHit hit = rays.first(origin, direction);
    const double expected = brute_force(lines, origin, direction);
    if (std::isinf(expected)) {
      EXPECT_TRUE(std::isinf(hit.distance));
    } else {
      EXPECT_NEAR(hit.distance, expected, 1e-9);
      EXPECT_NEAR(distance(lines[hit.line], origin + hit.distance * direction), 0.0, 1e-9);
      ++met;
    }
  }
  EXPECT_GT(met, 1000);
}

TEST(Rays, TellTheOpeningNearestToTheRangeOfThoseBeforeTheLine) {
  std::mt19937_64 random(13);
  const std::vector<Segment> lines = random_lines(random);
  const std::vector<Segment> openings = random_lines(random);
  Rays rays;
  for (const Segment& line : lines) rays.add(line);
  for (const Segment& opening : openings) rays.add_opening(opening);
  rays.sort();
  int passed = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector2 origin(1.5 * place(random), place(random) / 3.0);
    const double bearing = place(random);
    const Vector2 direction(std::cos(bearing), std::sin(bearing));
    const double range = std::abs(place(random)) / 4.0;
    const RayHit hit = rays.first(origin, direction, range);
    const double met = brute_force(lines, origin, direction);
    EXPECT_TRUE(hit.distance == met || std::abs(hit.distance - met) < 1e-9);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& opening : openings) {
      const double at = brute_force({opening}, origin, direction);
      if (at < met && std::abs(range - at) < std::abs(range - nearest)) nearest = at;
    }
    EXPECT_TRUE(hit.opening == nearest || std::abs(hit.opening - nearest) < 1e-9);
    if (std::isfinite(nearest)) ++passed;
  }
  EXPECT_GT(passed, 500);
}

TEST(Rays, LeapOverWhatIsEmptyAndMissNothingBehindIt) {
  Rays rays;
  std::vector<Segment> lines;
  for (int i = 0; i < 8; ++i) {  // small things, far apart
    const double angle = i * std::numbers::pi / 4.0;
    const Vector2 place = 30.0 * Vector2(std::cos(angle), std::sin(angle));
    lines.push_back({place, place + Vector2(0.1, 0.2)});
    rays.add(lines.back());
  }
  rays.sort();
  for (int i = 0; i < 8000; ++i) {
    const double bearing = i * std::numbers::pi / 4000.0;
    const Vector2 direction(std::cos(bearing), std::sin(bearing));
    EXPECT_EQ(rays.first({0.1, 0.3}, direction).distance,
              brute_force(lines, {0.1, 0.3}, direction));
  }
}

TEST(Rays, AllLinesNearAPlaceAreAmongThoseThatMayBe) {
  std::mt19937_64 random(11);
  const std::vector<Segment> lines = random_lines(random);
  const Rays rays = sorted(lines);
  std::size_t given = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector2 at(1.5 * place(random), place(random) / 3.0);
    std::set<std::size_t> near;
    rays.for_lines_near(at, 0.4, [&](std::size_t line) { near.insert(line); });
    for (std::size_t line = 0; line < lines.size(); ++line)
      EXPECT_TRUE(near.contains(line) || distance(lines[line], at) >= 0.4);
    given += near.size();
  }
  EXPECT_LT(given, 1000 * lines.size() / 10) << "they are sorted for this";
}

TEST(Rays, OneLineAlongAnAxis) {
  Rays rays;
  rays.add({{1.0, -1.0}, {1.0, 1.0}});
  rays.sort();
  EXPECT_DOUBLE_EQ(rays.first({0.0, 0.0}, {1.0, 0.0}).distance, 1.0);
  EXPECT_TRUE(std::isinf(rays.first({0.0, 0.0}, {-1.0, 0.0}).distance));
  EXPECT_TRUE(std::isinf(rays.first({0.0, 2.0}, {1.0, 0.0}).distance));
}

TEST(Rays, NothingToMeet) {
  Rays rays;
  rays.sort();
  EXPECT_TRUE(std::isinf(rays.first({0.0, 0.0}, {1.0, 0.0}).distance));
  rays.for_lines_near({0.0, 0.0}, 1.0, [](std::size_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace perceptor::localize
