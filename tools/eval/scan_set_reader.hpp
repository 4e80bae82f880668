/// @file Reads single scans and the truth about them: lxscan text files, plain or gzipped.
///
/// *.scan, one header and one line a scan; a range that is no return (0) stays as written:
///   # comment
///   H n angle_min angle_increment range_min range_max range_sigma        [rad], [m]
///   S id time, odometry x y a, laser in world x y a, n ranges             [s], [m], [rad]
/// *.truth, in the frame of the laser at scan `id`:
///   T id edge first_beam last_beam returns must x1 y1 x2 y2               a piece of a wall
///   K id x y kind must                                                    a corner
///   D id x1 y1 x2 y2                                                      a door opening
/// `must` is 1 for what has to be found, else 0; `kind` 1 for convex corners, -1 for concave.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/eval/line_reader.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

/// The scans alone. Throws TextFileError where the file cannot be read or is no lxscan file,
/// also where two scans have one id.
ScanSet read_scans(const std::filesystem::path& scan_file);

/// Adds the truth. Throws TextFileError as above, also for the id of no scan of the set and for
/// a beam that the scan does not have.
void read_truth(const std::filesystem::path& truth_file, ScanSet& set);

/// The file beside it that has ".truth" for ".scan" in its name, gzipped or not; none where
/// neither is there.
std::optional<std::filesystem::path> default_truth_file(const std::filesystem::path& scan_file);

}  // namespace perceptor
