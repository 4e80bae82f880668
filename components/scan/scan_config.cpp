#include "components/scan/scan_config.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor {

namespace scan {
const std::vector<std::pair<std::string, ScanMethod>>& method_names() {
  static const auto names = [] {
    std::vector<std::pair<std::string, ScanMethod>> all;
    all.reserve(kMethods.size());
    for (const NamedMethod& named : kMethods) all.emplace_back(named.name, named.method);
    return all;
  }();
  return names;
}

void describe(config::Fields& fields, NoiseParameters& p) {
  fields.number("sigma_growth", p.sigma_growth, {0.0, 0.1},
                "[m/m] added to the sensor's sigma for each metre of range");
  fields.number("surface_roughness", p.surface_roughness, {0.0, 0.1},
                "[m] rms from beam to beam of a real wall; added to the noise across it");
}

void describe(config::Fields& fields, GapParameters& p) {
  fields.number("min_incidence", p.min_incidence, {0.01, 1.0},
                "[rad] between beam and wall; less bridges larger jumps in range");
  fields.number("max_hole", p.max_hole, {0.0, 10.0},
                "[m] of wall that no beam returned from; more bridges doorways");
}

void describe(config::Fields& fields, ClusterParameters& p) {
  fields.number("min_spacing", p.min_spacing, {0.001, 1.0},
                "[m] between resampled points; more misses short walls");
  fields.number("spacing_sigmas", p.spacing_sigmas, {0.0, 100.0},
                "[-] the same in sigmas of the range: the larger of the two");
  fields.number("min_turn", p.min_turn, {0.01, 1.5},
                "[rad] that is a corner; less sees flatter corners");
  fields.number("turn_sigmas", p.turn_sigmas, {0.0, 100.0},
                "[-] the same in sigmas of the angle: the larger of the two");
}

void describe(config::Fields& fields, EndpointFitParameters& p) {
  fields.number("split_sigmas", p.split_sigmas, {1.0, 100.0},
                "[-] of the noise across the chord; less cuts more, for the merge step to undo");
}

void describe(config::Fields& fields, IncrementalParameters& p) {
  fields.number("grow_sigmas", p.grow_sigmas, {1.0, 100.0},
                "[-] that a beam may add to the regression's error; less cuts more, more grows "
                "further round a corner");
  fields.integer("seed_beams", p.seed_beams, {2, 1000},
                 "that begin a run; more looks past noise, but round more corners");
}

void describe(config::Fields& fields, RansacParameters& p) {
  fields.number("inlier_sigmas", p.inlier_sigmas, {1.0, 100.0}, "[-] of the noise across the line");
  fields.integer("max_trials", p.max_trials, {1, 100000},
                 "pairs drawn for one wall; more finds shorter walls among others");
  fields.number("confidence", p.confidence, {0.0, 1.0},
                "[-] that a wall as long as the best one so far is not missed: ends the trials "
                "earlier; 1: never");
  fields.integer("min_separation", p.min_separation, {1, 1000},
                 "beams from one of a pair to the other; fewer draws lines whose direction is "
                 "noise");
  fields.integer("min_inliers", p.min_inliers, {3, 10000}, "beams of a wall");
  fields.integer("seed", p.seed, {0, std::numeric_limits<std::int64_t>::max()},
                 "of the random numbers; they begin anew with each scan");
}

void describe(config::Fields& fields, WallParameters& p) {
  fields.number("merge_chi2", p.merge_chi2, {1.0, 1000.0},
                "[-] rise of chi-square at which two lines are better than one; more merges more");
  fields.number("bend", p.bend, {0.0, 0.1},
                "[m] rms by which a long wall and the laser may be crooked; more keeps such walls "
                "whole, less sees flatter corners");
  fields.number("bend_growth", p.bend_growth, {0.0, 0.1},
                "[m/m] the same for each metre of a shorter wall; the smaller of the two");
  fields.number("max_excess", p.max_excess, {1.0, 100.0},
                "[-] variance of a bumpy wall's beams over what the noise says; more takes curved "
                "things for walls");
  fields.number("support_sigmas", p.support_sigmas, {1.0, 10.0},
                "[-] a beam further from the line does not support it");
  fields.number("min_support_share", p.min_support_share, {0.0, 1.0},
                "[-] of the beams between its ends; less takes curved things for walls");
  fields.integer("min_beams", p.min_beams, {3, 10000}, "that support a wall");
  fields.number("min_length", p.min_length, {0.01, 10.0}, "[m] of a wall");
  fields.number("max_angle_sigma", p.max_angle_sigma, {0.001, 1.0},
                "[rad] a wall whose direction is less certain is left out");
}

void describe(config::Fields& fields, CornerParameters& p) {
  fields.number("min_angle", p.min_angle, {0.01, 1.5}, "[rad] between two walls that meet");
  fields.number("reach", p.reach, {0.0, 1.0},
                "[m] from a wall's last beam to where it meets its neighbour");
  fields.number("spike_jump", p.spike_jump, {0.01, 10.0},
                "[m] in range; less takes more outer corners");
  fields.number("vector_angle", p.vector_angle, {0.01, 1.5},
                "[rad] between neighbours one of which is no wall");
  fields.integer("min_beams", p.min_beams, {2, 10000},
                 "on the near side of a corner that no wall ends in");
  fields.number("connection_radius", p.connection_radius, {0.0, 2.0},
                "[m] within which an end may be connected to another wall's");
}

void describe(config::Fields& fields, ScanParameters& p) {
  fields.choice("method", p.method, method_names(), "how beams are cut at corners");
  fields.group("noise", p.noise, "how far a beam may lie from where the wall is");
  fields.group("gap", p.gap, "where the wall cannot go on from one beam to the next");
  fields.group("angle_clustering", p.angle_clustering,
               "where the mean angle of a cluster and the next angle differ");
  fields.group("endpoint_fit", p.endpoint_fit, "how far from its chord a run bends");
  fields.group("incremental_regression", p.incremental_regression, "how a run grows beam by beam");
  fields.group("ransac", p.ransac, "how models are drawn, and which are good enough");
  fields.group("wall", p.wall, "what makes a wall");
  fields.group("corner", p.corner, "what makes a corner");
}

}  // namespace scan

void describe(config::Fields& fields, AlignerParameters& p) {
  fields.number("max_gap", p.max_gap, {0.001, 60.0},
                "[s] between the positions around a scan; a scan in a wider gap is dropped");
  fields.number("max_extrapolation", p.max_extrapolation, {0.0, 1.0},
                "[s] ahead of the last position, without waiting; above 0 the results depend on "
                "arrival, and STATUS says degraded");
  fields.integer("max_items", p.max_items, {1, 10000},
                 "scans that wait for a position; beyond it the oldest is dropped");
  fields.integer("max_positions", p.max_positions, {2, 1000000},
                 "positions kept for scans that come late");
}

void describe(config::Fields& fields, ScanConfig& config) {
  describe(fields, config.scan);
  fields.group("aligner", config.aligner, "how a scan is paired with the robot's position");
  fields.group("robot", config.robot, "the robot itself");
}

}  // namespace perceptor
