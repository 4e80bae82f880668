#include "tools/eval/scan_explanation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/geometry/angle.hpp"
#include "tools/eval/fixed.hpp"
#include "tools/eval/run_sentence.hpp"

namespace perceptor {
namespace {

using scan::Fate;

std::string count(std::size_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

std::string beams_of(std::size_t first, std::size_t last) {
  return std::to_string(first) + " to " + std::to_string(last);
}

std::string fate_in_words(const scan::BeamGroup& group, const scan::Account& account) {
  const auto of_run = [&] { return "run " + std::to_string(group.run); };
  const auto wall = [&] { return "wall " + std::to_string(account.runs[group.run].wall); };
  switch (group.fate) {
    case Fate::no_return:
      return "no return";
    case Fate::on_robot:
      return "on the robot itself";
    case Fate::stray:
      return "jumps away from both neighbours";
    case Fate::in_no_run:
      return "in no run that one line explains";
    case Fate::without_wall:
      return of_run() + ", no wall";
    case Fate::off_line:
      return of_run() + ", off the line of " + wall();
    case Fate::supports:
      break;
  }
  return of_run() + ", part of " + wall();
}

std::string group_line(const scan::BeamGroup& group, const ScanFindings& findings) {
  const LaserScan& scan = findings.labelled.scan;
  char line[160];
  std::snprintf(line, sizeof line, "%6zu %6zu  %7.3f  %7.3f  ", group.first_beam, group.last_beam,
                scan.bearings[group.first_beam], scan.bearings[group.last_beam]);
  return line + fate_in_words(group, findings.account) + "\n";
}

std::string limits_of(const scan::RunAccount& run) {
  return "from " + in_words(run.before) + " to " + in_words(run.after);
}

/// "run 7, 5 beams (75 to 79), from a gap of 0.41 m to the scan's end: "
std::string run_head(std::size_t number, const scan::RunAccount& run) {
  return "run " + std::to_string(number) + ", " + count(run.beams, "beam") + " (" +
         beams_of(run.first_beam, run.last_beam) + "), " + limits_of(run) + ": ";
}

std::string place(const Vector2& at) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", at.x(), at.y());
  return text;
}

std::string on_wall(const ScanFindings& findings, std::size_t beam, std::size_t number) {
  const scan::Wall& wall = findings.found.walls[number];
  const Segment segment = {wall.first.location, wall.last.location};
  const std::vector<BeamEnd> ends = beam_ends(findings.labelled.scan);
  const auto end = std::ranges::find(ends, beam, &BeamEnd::beam);
  const double off = end == ends.end() ? 0.0 : std::abs(signed_distance(segment, end->location));
  return "wall " + std::to_string(number) + ", from " + place(segment.a) + " to " +
         place(segment.b) + ", " + fixed(1e3 * off, 0) + " mm off its line";
}

std::string why_no_return(const LaserScan& scan, double range) {
  if (!std::isfinite(range)) return "no return: " + fixed(range, 3) + " is no range.\n";
  if (range <= 0.0) return "no return: " + fixed(range, 3) + " m is not positive.\n";
  char limits[80];
  std::snprintf(limits, sizeof limits, "[%g, %g]", scan.valid_min, scan.valid_max);
  return "no return: " + fixed(range, 3) + " m is not within " + limits +
         ", what the scan says of its laser.\n";
}

std::string sentence(const scan::BeamGroup& group, std::size_t beam, const ScanFindings& findings,
                     const scan::ScanParameters& parameters) {
  const LaserScan& scan = findings.labelled.scan;
  const auto wall = [&] { return on_wall(findings, beam, findings.account.runs[group.run].wall); };
  switch (group.fate) {
    case Fate::no_return:
      return why_no_return(scan, scan.ranges[beam]);
    case Fate::on_robot:
      return "it ends inside the robot's footprint (robot.footprint).\n";
    case Fate::stray:
      return "it jumps away from both its neighbours, which belong together (" +
             setting("gap.min_incidence", parameters.gap.min_incidence) + " rad, " +
             setting("gap.max_hole", parameters.gap.max_hole) + " m).\n";
    case Fate::in_no_run:
      return "in no run: too few neighbours lie on one line with it, at least " +
             std::to_string(scan::kFewestBeams) + " would have to (" +
             setting("wall.merge_chi2", parameters.wall.merge_chi2) + ").\n";
    case Fate::without_wall:
      return "in a run that is no wall.\n";
    case Fate::off_line:
      return "in a run that is " + wall() + ": too far to be part of it (" +
             setting("wall.support_sigmas", parameters.wall.support_sigmas) + ").\n";
    case Fate::supports:
      break;
  }
  return "part of " + wall() + ".\n";
}

const scan::BeamGroup& group_of(const scan::Account& account, std::size_t beam) {
  return *std::ranges::find_if(
      account.groups, [beam](const scan::BeamGroup& group) { return beam <= group.last_beam; });
}

}  // namespace

std::string explain_scan(const ScanFindings& findings, const scan::ScanParameters& parameters) {
  const auto& [labelled, found, account] = findings;
  std::string text = "scan " + std::to_string(labelled.id) + " at " + fixed(labelled.time, 3) +
                     " s: " + count(labelled.scan.size(), "beam") + ", " +
                     count(count_returns(labelled.scan), "return") + ", " +
                     count(account.runs.size(), "run") + ", " + count(found.walls.size(), "wall") +
                     ", " + count(found.corners.size(), "corner") + "\n\n";
  text += "         beams    bearings [rad]  what became of them\n";
  for (const scan::BeamGroup& group : account.groups) text += group_line(group, findings);
  text += "\n";
  for (std::size_t i = 0; i < account.runs.size(); ++i)
    text += run_head(i, account.runs[i]) + verdict_in_short(account.runs[i], parameters) + "\n";
  return text;
}

std::string explain_beam(const ScanFindings& findings, std::size_t beam,
                         const scan::ScanParameters& parameters) {
  const LaserScan& scan = findings.labelled.scan;
  const scan::BeamGroup& group = group_of(findings.account, beam);
  std::string text = "beam " + std::to_string(beam) + " at " + fixed(scan.bearings[beam], 3) +
                     " rad, " + fixed(scan.ranges[beam], 3) +
                     " m: " + sentence(group, beam, findings, parameters);
  if (group.run == scan::kNoRun) return text;
  const scan::RunAccount& run = findings.account.runs[group.run];
  return text + "Its " + run_head(group.run, run) + verdict_in_words(run, parameters) + ".\n" +
         keys_of_ends(run, parameters);
}

std::size_t nearest_beam(const LaserScan& scan, double bearing) {
  const auto away = [bearing](double beam) { return std::abs(angle_difference(bearing, beam)); };
  return static_cast<std::size_t>(std::ranges::min_element(scan.bearings, {}, away) -
                                  scan.bearings.begin());
}

}  // namespace perceptor
