#include "tools/eval/run_sentence.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tools/eval/fixed.hpp"

namespace perceptor {
namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// A value, the bound it was held against, and the key of that.
std::string held_against(const std::string& value, const char* bound, double limit,
                         const char* unit, const char* key) {
  return value + unit + " of " + bound + " " + short_number(limit) + unit + " (" + key + ")";
}

std::string support(const scan::RunAccount& run, const scan::WallParameters& wall) {
  return held_against(std::to_string(run.support), "at least", wall.min_beams, "",
                      "wall.min_beams");
}

std::string share(const scan::RunAccount& run, const scan::WallParameters& wall) {
  return held_against(fixed(run.share, 2), "at least", wall.min_support_share, "",
                      "wall.min_support_share");
}

std::string length(const scan::RunAccount& run, const scan::WallParameters& wall) {
  return held_against(fixed(run.length, 2), "at least", wall.min_length, " m", "wall.min_length");
}

std::string certainty(const scan::RunAccount& run, const scan::WallParameters& wall) {
  return held_against(fixed(run.angle_sigma, 4), "at most", wall.max_angle_sigma, " rad",
                      "wall.max_angle_sigma");
}

bool ends_at(const scan::RunAccount& run, scan::Limit limit) {
  return run.before.limit == limit || run.after.limit == limit;
}

}  // namespace

std::string setting(const char* key, double value) {
  return std::string(key) + " " + short_number(value);
}

std::string in_words(const scan::RunEnd& end) {
  switch (end.limit) {
    case scan::Limit::scan_end:
      return "the scan's end";
    case scan::Limit::gap:
      return "a gap of " + fixed(end.step, 2) + " m";
    case scan::Limit::strays:
      return "beams in no run";
    case scan::Limit::corner:
      break;
  }
  return "a corner of " + fixed(std::abs(end.turn) * 180.0 / std::numbers::pi, 0) + " deg";
}

std::string verdict_in_words(const scan::RunAccount& run, const scan::ScanParameters& parameters) {
  const scan::WallParameters& wall = parameters.wall;
  switch (run.verdict) {
    case scan::Verdict::too_few_beams:
      return "too few beams support a line: " + support(run, wall);
    case scan::Verdict::too_scattered:
      return "too small a share of the beams supports a line: " + share(run, wall);
    case scan::Verdict::too_short:
      return "too short: " + length(run, wall);
    case scan::Verdict::too_uncertain:
      return "its direction is too uncertain: " + certainty(run, wall);
    case scan::Verdict::wall:
      break;
  }
  return "wall " + std::to_string(run.wall) + ": beams " + support(run, wall) + ", share " +
         share(run, wall) + ", length " + length(run, wall) + ", sigma of direction " +
         certainty(run, wall);
}

std::string verdict_in_short(const scan::RunAccount& run, const scan::ScanParameters& parameters) {
  if (run.verdict != scan::Verdict::wall) return verdict_in_words(run, parameters);
  return "wall " + std::to_string(run.wall) + " of " + std::to_string(run.support) + " beams, " +
         fixed(run.length, 2) + " m";
}

std::string keys_of_ends(const scan::RunAccount& run, const scan::ScanParameters& parameters) {
  std::string text;
  if (ends_at(run, scan::Limit::gap))
    text += "What a gap is: " + setting("gap.min_incidence", parameters.gap.min_incidence) +
            " rad, " + setting("gap.max_hole", parameters.gap.max_hole) + " m.\n";
  if (ends_at(run, scan::Limit::corner) || ends_at(run, scan::Limit::strays))
    text += "What one line explains: " + setting("wall.merge_chi2", parameters.wall.merge_chi2) +
            ", " + setting("wall.bend", parameters.wall.bend) + " m, " +
            setting("noise.surface_roughness", parameters.noise.surface_roughness) + " m.\n";
  return text;
}

}  // namespace perceptor
