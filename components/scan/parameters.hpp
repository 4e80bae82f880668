/// @file What can be turned in the scan component, and what moves when it is.
#pragma once

#include <cstdint>

namespace perceptor::scan {

/// How a stretch of beams is cut at its corners; every other step is shared.
enum class ScanMethod {
  split_and_merge,         ///< by likelihood ratios
  angle_clustering,        ///< mean angle of the cluster against the next angle
  endpoint_fit,            ///< at the beam farthest from the chord
  incremental_regression,  ///< beam by beam, as long as the regression takes them
  ransac,                  ///< lines through random pairs of beams, the longest run first
};

/// How far a beam may lie from where the wall is.
struct NoiseParameters {
  double sigma_growth = 0.0005;      ///< [m/m] added to the sensor's sigma for each metre of range
  double surface_roughness = 0.003;  ///< [m] rms from beam to beam of a real wall; added to the
                                     ///< noise across it, and all there is on a grazed wall
};

/// Where the wall cannot go on from one beam to the next.
struct GapParameters {
  double min_incidence =
      0.087;              ///< [rad] between beam and wall; less bridges larger jumps in range
  double max_hole = 0.3;  ///< [m] of wall that no beam returned from; more bridges doorways
};

/// Where the mean angle of a cluster and the next angle differ.
struct ClusterParameters {
  double min_spacing = 0.05;    ///< [m] between resampled points; more misses short walls
  double spacing_sigmas = 6.0;  ///< [-] the same in sigmas of the range: the larger of the two
  double min_turn = 0.2;        ///< [rad] that is a corner; less sees flatter corners
  double turn_sigmas = 4.0;     ///< [-] the same in sigmas of the angle: the larger of the two
};

/// How far from its chord a run bends.
struct EndpointFitParameters {
  double split_sigmas = 3.0;  ///< [-] of the noise across the chord; less cuts more, for the merge
                              ///< step to undo
};

/// How a run grows beam by beam.
struct IncrementalParameters {
  double grow_sigmas = 3.0;  ///< [-] that a beam may add to the regression's error; less cuts more,
                             ///< more grows further round a corner
  int seed_beams = 5;        ///< that begin a run; more looks past noise, but round more corners
};

/// How models are drawn, and which are good enough.
struct RansacParameters {
  double inlier_sigmas = 2.5;  ///< [-] of the noise across the line
  int max_trials = 100;        ///< pairs drawn for one wall; more finds shorter walls among others
  double confidence = 0.99;    ///< [-] that a wall as long as the best one so far is not missed:
                               ///< ends the trials earlier
  int min_separation = 5;      ///< beams from one of a pair to the other; fewer draws lines whose
                               ///< direction is noise
  int min_inliers = 6;         ///< beams of a wall
  std::int64_t seed = 1;       ///< of the random numbers; they begin anew with each scan
};

/// What makes a wall.
struct WallParameters {
  double merge_chi2 = 12.0;  ///< [-] rise of chi-square at which two lines are better than one
  double bend = 0.008;  ///< [m] rms by which a long wall and the laser may be crooked; more keeps
                        ///< such walls whole, less sees flatter corners
  double bend_growth = 0.008;   ///< [m/m] the same for each metre of a shorter wall
  double max_excess = 4.0;      ///< [-] variance of a bumpy wall's beams over what the noise says;
                                ///< more takes curved things for walls
  double support_sigmas = 3.5;  ///< [-] a beam further from the line does not support it; at an
                                ///< end, further from the line of the others
  double min_support_share = 0.7;  ///< [-] of the beams between its ends; less takes curved things
  int min_beams = 6;               ///< beams that support it
  double min_length = 0.25;        ///< [m]
  double max_angle_sigma = 0.08;   ///< [rad] a wall whose direction is less certain is left out
};

/// What makes a corner.
struct CornerParameters {
  double min_angle = 0.2;          ///< [rad] between two walls that meet
  double reach = 0.1;              ///< [m] from a wall's last beam to where it meets its neighbour
  double spike_jump = 0.15;        ///< [m] in range; less takes more outer corners
  double vector_angle = 0.5;       ///< [rad] between neighbours, for a corner without walls
  int min_beams = 6;               ///< on the near side of a corner without a wall
  double connection_radius = 0.3;  ///< [m] within which an end may be connected to another's
};

struct ScanParameters {
  ScanMethod method = ScanMethod::split_and_merge;
  NoiseParameters noise;
  GapParameters gap;
  ClusterParameters angle_clustering;
  EndpointFitParameters endpoint_fit;
  IncrementalParameters incremental_regression;
  RansacParameters ransac;
  WallParameters wall;
  CornerParameters corner;
};

}  // namespace perceptor::scan
