/// @file The best line through a run of beams, in constant time from prefix sums.
///
/// A line that does not pass through the laser is a x + b y = 1, seen from there. A beam whose
/// range errs by e ends off it by r (a x + b y - 1) = e, to first order, whatever the direction:
/// minimising the sum of (r / sigma)^2 (a x + b y - 1)^2 is maximum likelihood for noise of the
/// range, in closed form, and the weight does not depend on the line: sums of moments serve for
/// every run of beams.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "components/scan/beams.hpp"

namespace perceptor::scan {

/// Weighted sums over some beams, seen from the laser. Those of two runs add up.
struct Moments {
  double beams = 0.0;
  double w = 0.0;  ///< [-] sum of (range / sigma)^2
  double x = 0.0;  ///< [m] of w x, and so on
  double y = 0.0;
  double xx = 0.0;  ///< [m^2]
  double xy = 0.0;
  double yy = 0.0;
};

inline Moments operator+(const Moments& a, const Moments& b) {
  return {.beams = a.beams + b.beams,
          .w = a.w + b.w,
          .x = a.x + b.x,
          .y = a.y + b.y,
          .xx = a.xx + b.xx,
          .xy = a.xy + b.xy,
          .yy = a.yy + b.yy};
}

inline Moments operator-(const Moments& a, const Moments& b) {
  return {.beams = a.beams - b.beams,
          .w = a.w - b.w,
          .x = a.x - b.x,
          .y = a.y - b.y,
          .xx = a.xx - b.xx,
          .xy = a.xy - b.xy,
          .yy = a.yy - b.yy};
}

/// Of a single beam.
inline Moments moments_of(const Beams& beams, std::size_t i) {
  const double w = beams.weight[i];
  const double x = beams.x[i];
  const double y = beams.y[i];
  return {.beams = 1.0,
          .w = w,
          .x = w * x,
          .y = w * y,
          .xx = w * x * x,
          .xy = w * x * y,
          .yy = w * y * y};
}

/// Sums up to each beam, of which those of any run are the difference.
class PrefixMoments {
 public:
  /// Takes the memory that so many beams need at most.
  void reserve(std::size_t beams) { sums_.reserve(beams + 1); }

  /// Sums the beams, in a circle all of them twice.
  void sum(const Beams& beams);

  /// Of the beams begin to end - 1.
  Moments of(std::size_t begin, std::size_t end) const {
    const Sums& from = sums_[begin];
    const Sums& to = sums_[end];
    return {.beams = static_cast<double>(end - begin),
            .w = to.w - from.w,
            .x = to.x - from.x,
            .y = to.y - from.y,
            .xx = to.xx - from.xx,
            .xy = to.xy - from.xy,
            .yy = to.yy - from.yy};
  }

 private:
  struct Sums {
    double w, x, y, xx, xy, yy;  // of Moments
  };
  std::vector<Sums> sums_;
};

/// A line seen from the laser: a x + b y = 1.
struct PolarLine {
  double a = 0.0;  ///< [1/m]
  double b = 0.0;  ///< [1/m]

  /// [m] from the laser.
  double distance() const { return 1.0 / std::sqrt(a * a + b * b); }
};

/// The best line through the beams. Beams that all lie in one direction have none: then both
/// coefficients are zero, as of a line infinitely far away.
inline PolarLine polar_line(const Moments& m) {
  // Of beams in one direction, rounding leaves this of a determinant that ought to be zero.
  constexpr double kRounding = 1e-12;
  const double determinant = m.xx * m.yy - m.xy * m.xy;
  const double trace = m.xx + m.yy;
  if (!(determinant > kRounding * trace * trace)) return {};
  const double inverse = 1.0 / determinant;
  return {.a = (m.x * m.yy - m.y * m.xy) * inverse, .b = (m.y * m.xx - m.x * m.xy) * inverse};
}

/// How well the best line explains its beams.
struct Misfit {
  double chi_square = 0.0;  ///< squared distances from it, each in its standard deviation; about
                            ///< the number of beams less two where the wall is straight
  double variance = 0.0;    ///< [m^2] mean expected squared distance
};

/// Of the best line through the beams. `roughness`: rms [m] by which a real surface departs
/// from a line, whatever the angle under which it is seen.
inline Misfit misfit(const Moments& m, double roughness) {
  const PolarLine line = polar_line(m);
  const double inverse_squared_distance = line.a * line.a + line.b * line.b;
  if (inverse_squared_distance == 0.0) return {};
  // Two beams are on their line; what is left of them is rounding.
  const double left = m.beams > 2.0 ? m.w - line.a * m.x - line.b * m.y : 0.0;
  const double of_range = std::max(0.0, left);
  // Both variances across the line, that of the range and the surface's, times w / distance^2.
  const double both = m.beams + roughness * roughness * inverse_squared_distance * m.w;
  return {.chi_square = of_range * m.beams / both,
          .variance = both / (m.w * inverse_squared_distance)};
}

/// Directed counter-clockwise as seen from the laser.
struct Line {
  Vector2 point{0.0, 0.0};      ///< [m] on it, robot frame
  Vector2 direction{1.0, 0.0};  ///< unit vector
  Vector2 normal{0.0, 1.0};     ///< unit vector to the left: towards the laser
};

/// With its point nearest to the laser.
Line make_line(const PolarLine& line, const Vector2& laser);

/// Signed distance of a point from a line, positive on its left [m].
double offset(const Line& line, const Vector2& point);

/// Where two lines meet; they must not be parallel.
Vector2 intersection(const Line& first, const Line& second);

}  // namespace perceptor::scan
