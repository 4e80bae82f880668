#include "tools/eval/scan_set_reader.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace perceptor {
namespace {

constexpr std::int64_t kMostBeams = 100000;  // a real laser has some thousand
constexpr std::int64_t kAnyId = std::numeric_limits<std::int64_t>::max();

std::int64_t read_id(LineReader& line) { return line.integer(0, kAnyId, "a scan's id"); }

Position read_pose(LineReader& line, std::string_view what) {
  Position pose;
  line.finite({&pose.x, &pose.y, &pose.a}, what);
  return pose;
}

Segment read_segment(LineReader& line) {
  Segment segment;
  line.finite({&segment.a.x(), &segment.a.y(), &segment.b.x(), &segment.b.y()}, "a coordinate");
  return segment;
}

/// What all scans of a file share, without ranges.
LaserScan read_header(LineReader& line) {
  const std::int64_t beams = line.integer(1, kMostBeams, "a number of beams, 1 to 100000");
  const double angle_min = line.finite("angle_min");
  const double increment = line.finite("a positive angle_increment");
  if (increment <= 0.0) line.fail("a positive angle_increment");
  LaserScan scan;
  scan.valid_min = line.finite("range_min");
  scan.valid_max = line.finite("range_max above range_min");
  if (scan.valid_max <= scan.valid_min) line.fail("range_max above range_min");
  scan.range_sigma = line.finite("a positive range_sigma");
  if (scan.range_sigma <= 0.0) line.fail("a positive range_sigma");
  line.end();
  for (std::int64_t i = 0; i < beams; ++i)
    scan.bearings.push_back(angle_min + static_cast<double>(i) * increment);
  return scan;
}

LabelledScan read_scan(LineReader& line, const LaserScan& header,
                       std::unordered_set<std::int64_t>& ids) {
  LabelledScan scan;
  scan.id = read_id(line);
  if (!ids.insert(scan.id).second) line.fail("an id that no scan before it has");
  scan.time = line.finite("a time");
  scan.odometry = read_pose(line, "the pose by odometry");
  scan.laser_in_world = read_pose(line, "the true pose");
  scan.scan = header;
  scan.scan.ranges.reserve(header.bearings.size());
  for (std::size_t i = 0; i < header.bearings.size(); ++i)
    scan.scan.ranges.push_back(line.number("a range for each beam"));
  line.end();
  return scan;
}

TruePiece read_piece(LineReader& line, std::size_t beams) {
  const auto beam = [&](std::size_t from) {
    return static_cast<std::size_t>(
        line.integer(static_cast<std::int64_t>(from), static_cast<std::int64_t>(beams) - 1,
                     "a beam, " + std::to_string(from) + " to " + std::to_string(beams - 1)));
  };
  TruePiece piece;
  piece.edge =
      static_cast<int>(line.integer(0, std::numeric_limits<int>::max(), "the number of an edge"));
  piece.first_beam = beam(0);
  piece.last_beam = beam(piece.first_beam);
  const auto between = static_cast<std::int64_t>(piece.last_beam - piece.first_beam + 1);
  piece.returns = static_cast<std::size_t>(
      line.integer(0, between, "the number of returns among the piece's beams"));
  piece.has_to_be_found = line.integer(0, 1, "must, 0 or 1") == 1;
  piece.segment = read_segment(line);
  return piece;
}

TrueCorner read_corner(LineReader& line) {
  TrueCorner corner;
  line.finite({&corner.location.x(), &corner.location.y()}, "a coordinate");
  const std::int64_t kind = line.integer(-1, 1, "a kind, 1 or -1");
  if (kind == 0) line.fail("a kind, 1 or -1");
  corner.is_convex = kind == 1;
  corner.has_to_be_found = line.integer(0, 1, "must, 0 or 1") == 1;
  return corner;
}

}  // namespace

ScanSet read_scans(const std::filesystem::path& scan_file) {
  ScanSet set;
  LineReader line(scan_file);
  std::optional<LaserScan> header;
  std::unordered_set<std::int64_t> ids;
  while (line.next()) {
    const std::string_view kind = line.word("H or S");
    if (kind == "H" && !header) {
      header = read_header(line);
    } else if (kind == "S" && header) {
      set.scans.push_back(read_scan(line, *header, ids));
    } else {
      line.fail(header ? "S" : "the header, H");
    }
  }
  if (set.scans.empty()) throw TextFileError(scan_file.string() + ": holds no scan");
  return set;
}

void read_truth(const std::filesystem::path& truth_file, ScanSet& set) {
  std::unordered_map<std::int64_t, LabelledScan*> scans;
  for (LabelledScan& scan : set.scans) scans[scan.id] = &scan;

  LineReader line(truth_file);
  while (line.next()) {
    const std::string_view kind = line.word("T, K or D");
    if (kind != "T" && kind != "K" && kind != "D") line.fail("T, K or D");
    const auto scan = scans.find(read_id(line));
    if (scan == scans.end()) line.fail("the id of a scan of the set");
    LabelledScan& labelled = *scan->second;
    if (kind == "T") {
      labelled.pieces.push_back(read_piece(line, labelled.scan.size()));
    } else if (kind == "K") {
      labelled.corners.push_back(read_corner(line));
    } else {
      labelled.doors.push_back(read_segment(line));
    }
    line.end();
  }
  set.has_truth = true;
}

std::optional<std::filesystem::path> default_truth_file(const std::filesystem::path& scan_file) {
  const bool is_gzipped = scan_file.extension() == ".gz";
  std::filesystem::path plain = is_gzipped ? scan_file.parent_path() / scan_file.stem() : scan_file;
  if (plain.extension() != ".scan") return {};
  plain.replace_extension(".truth");
  std::filesystem::path gzipped = plain;
  gzipped += ".gz";
  if (is_gzipped) std::swap(plain, gzipped);  // first the one that is packed like the scans
  std::error_code error;
  for (const auto& file : {plain, gzipped})
    if (std::filesystem::is_regular_file(file, error)) return file;
  return {};
}

}  // namespace perceptor
