#include "tools/eval/scan_set_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

namespace perceptor {
namespace {

constexpr int kPlaceDigits = 5;

/// One line of words, whatever the locale.
class Line {
 public:
  explicit Line(char kind) : text_(1, kind) {}

  Line& number(double value, int digits) {
    std::array<char, 340> buffer;  // the largest double has 309 digits before the point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, digits);
    text_.append(1, ' ').append(buffer.data(), end.ptr);
    return *this;
  }
  Line& place(const Vector2& p) { return number(p.x(), kPlaceDigits).number(p.y(), kPlaceDigits); }
  Line& pose(const Position& p) { return place(p.location()).number(p.a, 6); }
  template <class Integer>
  Line& integer(Integer value) {
    text_.append(1, ' ').append(std::to_string(value));
    return *this;
  }
  void to(std::ostream& out) { out << text_ << '\n'; }

 private:
  std::string text_;
};

double increment(const LaserScan& scan) {
  return (scan.bearings.back() - scan.bearings.front()) /
         static_cast<double>(scan.bearings.size() - 1);
}

bool has_even_beams(const LaserScan& scan) {
  constexpr double kRounding = 1e-9;  // [rad] of the header line
  if (scan.size() < 2 || scan.bearings.size() != scan.size()) return false;
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    const double even = scan.bearings.front() + static_cast<double>(beam) * increment(scan);
    if (std::abs(scan.bearings[beam] - even) > kRounding) return false;
  }
  return true;
}

bool is_of_same_laser(const LaserScan& a, const LaserScan& b) {
  return a.size() == b.size() && a.bearings == b.bearings && a.valid_min == b.valid_min &&
         a.valid_max == b.valid_max && a.range_sigma == b.range_sigma;
}

const LaserScan& common_laser(const ScanSet& set) {
  if (set.scans.empty()) throw std::invalid_argument("a set without scans has no header line");
  const LaserScan& first = set.scans.front().scan;
  const bool share_one = std::ranges::all_of(set.scans, [&](const LabelledScan& labelled) {
    return is_of_same_laser(labelled.scan, first);
  });
  if (!share_one || !has_even_beams(first))
    throw std::invalid_argument("one header line describes only scans of one laser, evenly spaced");
  return first;
}

void write_header(std::ostream& out, const LaserScan& scan) {
  out << "# lxscan 1  (see FORMAT.md)\n";
  Line line('H');
  line.integer(scan.size()).number(scan.bearings.front(), 9).number(increment(scan), 9);
  line.number(scan.valid_min, 3).number(scan.valid_max, 3).number(scan.range_sigma, 4).to(out);
}

template <class Write>
void write_file(const std::filesystem::path& path, const Write& write) {
  std::ofstream out(path, std::ios::binary);
  if (out) write(out);
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_scans(std::ostream& out, const ScanSet& set) {
  write_header(out, common_laser(set));
  for (const LabelledScan& labelled : set.scans) {
    Line line('S');
    line.integer(labelled.id).number(labelled.time, 4);
    line.pose(labelled.odometry).pose(labelled.laser_in_world);
    for (const double range : labelled.scan.ranges)
      is_return(labelled.scan, range) ? line.number(range, 4) : line.integer(0);
    line.to(out);
  }
}

void write_truth(std::ostream& out, const ScanSet& set) {
  for (const LabelledScan& scan : set.scans) {
    for (const TruePiece& piece : scan.pieces) {
      Line line('T');
      line.integer(scan.id).integer(piece.edge).integer(piece.first_beam).integer(piece.last_beam);
      line.integer(piece.returns).integer(piece.has_to_be_found ? 1 : 0);
      line.place(piece.segment.a).place(piece.segment.b).to(out);
    }
    for (const TrueCorner& corner : scan.corners)
      Line('K')
          .integer(scan.id)
          .place(corner.location)
          .integer(corner.is_convex ? 1 : -1)
          .integer(corner.has_to_be_found ? 1 : 0)
          .to(out);
    for (const Segment& door : scan.doors)
      Line('D').integer(scan.id).place(door.a).place(door.b).to(out);
  }
}

std::filesystem::path truth_path(const std::filesystem::path& scan_path) {
  if (scan_path.extension() != ".scan")
    throw std::invalid_argument(scan_path.string() + ": the name of a file of scans ends in .scan");
  std::filesystem::path path = scan_path;
  return path.replace_extension(".truth");
}

void write_scan_set(const ScanSet& set, const std::filesystem::path& scan_path) {
  const std::filesystem::path of_truth = truth_path(scan_path);
  write_file(scan_path, [&](std::ostream& out) { write_scans(out, set); });
  if (set.has_truth) write_file(of_truth, [&](std::ostream& out) { write_truth(out, set); });
}

}  // namespace perceptor
