#include "tools/eval/pose_reference.hpp"

#include <cmath>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"
#include "tools/eval/line_reader.hpp"

namespace perceptor {
namespace {

constexpr double kLatest = 1e11;  // [s] a time that is surely none, and whose utime still fits

std::int64_t read_time(LineReader& lines) {
  constexpr std::string_view kTime = "a time [s]";
  const double seconds = lines.finite(kTime);
  if (std::abs(seconds) > kLatest) lines.fail(kTime);
  return std::llround(seconds * static_cast<double>(kMicrosecondsPerSecond));
}

/// Such a file is a common mistake, and what its bytes would be told as helps nobody.
void refuse_xz(const LineReader& lines, const std::filesystem::path& file) {
  if (lines.line().starts_with("\xFD"
                               "7zXZ"))
    throw TextFileError(file.string() + " is packed with xz: unpack it first (xz -dc)");
}

}  // namespace

Trajectory read_poses(const std::filesystem::path& file) {
  LineReader lines(file);
  Trajectory poses;
  while (lines.next()) {
    refuse_xz(lines, file);
    if (lines.word("REF") != "REF") lines.fail("REF");
    TimedPose& timed = poses.emplace_back();
    timed.utime = read_time(lines);
    lines.finite({&timed.pose.x, &timed.pose.y, &timed.pose.a}, "x y theta [m, m, rad]");
    timed.pose.a = wrap_angle(timed.pose.a);
    if (!lines.at_end()) lines.finite("a scatter [m]");
    lines.end();
  }
  if (poses.empty()) throw TextFileError(file.string() + " holds no line REF t x y theta");
  put_in_order(poses);
  return poses;
}

std::vector<Relation> read_relations(const std::filesystem::path& file) {
  LineReader lines(file);
  std::vector<Relation> relations;
  while (lines.next()) {
    refuse_xz(lines, file);
    Relation& relation = relations.emplace_back();
    relation.from_utime = read_time(lines);
    relation.to_utime = read_time(lines);
    Position& pose = relation.to_in_from;
    double out_of_plane = 0.0;
    lines.finite({&pose.x, &pose.y, &out_of_plane, &out_of_plane, &out_of_plane, &pose.a},
                 "x y z roll pitch yaw [m, rad]");
    pose.a = wrap_angle(pose.a);
    lines.end();
  }
  if (relations.empty())
    throw TextFileError(file.string() + " holds no line t1 t2 x y z roll pitch yaw");
  return relations;
}

}  // namespace perceptor
