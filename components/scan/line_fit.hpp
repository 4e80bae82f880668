/// @file The best line through a run of beams, in constant time from prefix sums.
///
/// The range noise of a beam, projected on the normal of a wall at distance d from the laser,
/// is sigma d / range. Total least squares with the weight (range / sigma)^2 therefore
/// minimises what the maximum likelihood does, whatever the direction of the line, and the
/// weight does not depend on the line: sums of moments serve for every run of beams.
#pragma once

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

Moments operator+(const Moments& a, const Moments& b);
Moments operator-(const Moments& a, const Moments& b);

/// Sums up to each beam, of which those of any run are the difference.
class PrefixMoments {
 public:
  explicit PrefixMoments(const Beams& beams);

  /// Of the beams begin to end - 1.
  Moments of(std::size_t begin, std::size_t end) const { return sums_[end] - sums_[begin]; }

 private:
  std::vector<Moments> sums_;
};

/// Directed counter-clockwise as seen from the laser.
struct Line {
  Vector2 point{0.0, 0.0};      ///< [m] weighted mean of its beams, robot frame
  Vector2 direction{1.0, 0.0};  ///< unit vector
  Vector2 normal{0.0, 1.0};     ///< unit vector to the left: towards the laser
};

/// Of the best line through the beams, as long as there are two different ends among them.
Line fit_line(const Moments& moments, const Vector2& laser);

/// How well the best line explains its beams.
struct Misfit {
  double chi_square = 0.0;  ///< squared distances from it, each in its standard deviation; about
                            ///< the number of beams less two where the wall is straight
  double variance = 0.0;    ///< [m^2] mean expected squared distance
};

/// Of the best line through the beams; cheaper than the line itself.
Misfit misfit(const Moments& moments, const NoiseParameters& noise);

/// Signed distance of a point from a line, positive on its left [m].
double offset(const Line& line, const Vector2& point);

/// Where two lines meet; they must not be parallel.
Vector2 intersection(const Line& first, const Line& second);

/// A line as directed counter-clockwise around the laser.
Line make_line(const Vector2& point, const Vector2& direction, const Vector2& laser);

}  // namespace perceptor::scan
