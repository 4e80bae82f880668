#include "tools/eval/scan_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>

#include "tools/eval/fixed.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor {
namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kBetween = 2;  // blanks from column to column

using Head = std::array<Cells, 3>;

const Head kTimeHead = {{{"method", "median", "p99", "x"}, {"", "us", "us", "floor"}, Cells(4)}};
const Head kCountHead = {{{"walls", "corners"}, Cells(2), Cells(2)}};
const Head kScoreHead = {
    {{"TP", "FP", "frag", "angle", "perp.", "corner", "corner", "corner", "corner", "end"},
     {"%", "%", "%", "rms", "rms", "TP", "FP", "kind", "median", "point"},
     {"", "", "", "deg", "mm", "%", "%", "%", "mm", "mm"}}};

/// "-" where there is nothing to have a share of.
std::string percent(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) : "-";
}

std::string degrees(double radians) { return fixed(radians * 180.0 / std::numbers::pi, 3); }

void append(Cells& row, const Cells& cells) { row.insert(row.end(), cells.begin(), cells.end()); }

Cells time_cells(const std::vector<double>& times_us, double floor_us) {
  const double median = quantile(times_us, 0.5);
  return {fixed(median, 1), fixed(quantile(times_us, 0.99), 1),
          floor_us > 0.0 ? fixed(median / floor_us, 1) : "-"};
}

Cells score_cells(const ScanScore& score) {
  const auto if_any = [](std::int64_t count, const std::string& text) {
    return count > 0 ? text : "-";
  };
  return {percent(score.pieces_found, score.pieces),
          percent(score.false_walls, score.walls),
          percent(score.fragments, score.walls),
          if_any(score.pieces_found, degrees(score.angle_rms)),
          if_any(score.pieces_found, fixed(1e3 * score.offset_rms, 2)),
          percent(score.corners_found, score.corners),
          percent(score.false_corners, score.corner_claims),
          percent(score.corner_mix_ups, score.corner_matches),
          if_any(score.corners_found, fixed(1e3 * score.corner_median, 2)),
          if_any(score.pieces_found, fixed(1e3 * score.end_median, 1))};
}

Cells count_cells(const std::vector<FoundWalls>& found) {
  std::size_t walls = 0;
  std::size_t corners = 0;
  for (const FoundWalls& scan : found) {
    walls += scan.walls.size();
    corners += scan.corners.size();
  }
  return {std::to_string(walls), std::to_string(corners)};
}

std::vector<Cells> head(bool has_truth) {
  std::vector<Cells> rows(kTimeHead.begin(), kTimeHead.end());
  const Head& more = has_truth ? kScoreHead : kCountHead;
  for (std::size_t i = 0; i < rows.size(); ++i) append(rows[i], more[i]);
  return rows;
}

/// The first column to the left, the others to the right.
std::string aligned(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths;
  for (const Cells& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t padding = widths[i] - row[i].size();
      line.append(i > 0 ? kBetween + padding : 0, ' ');
      line.append(row[i]);
      line.append(i == 0 ? padding : 0, ' ');
    }
    const std::size_t end = line.find_last_not_of(' ');
    if (end != std::string::npos) text.append(line, 0, end + 1).append("\n");
  }
  return text;
}

void append_dump(std::string& text, std::int64_t id, const FoundWalls& found) {
  char line[160];
  const auto scan = static_cast<long long>(id);
  for (const auto& [a, b] : found.walls) {
    std::snprintf(line, sizeof line, "E %lld %.5f %.5f %.5f %.5f\n", scan, a.x(), a.y(), b.x(),
                  b.y());
    text += line;
  }
  for (const auto& [location, is_convex] : found.corners) {
    std::snprintf(line, sizeof line, "C %lld %.5f %.5f %d\n", scan, location.x(), location.y(),
                  is_convex ? 1 : -1);
    text += line;
  }
}

}  // namespace

const std::string_view kScanColumns =
    "Columns:\n"
    "  median, p99  time from ranges to walls and corners, over the scans; of each scan the\n"
    "               shortest of --repeat runs\n"
    "  x floor      that median over the floor's: points and prefix sums, nothing else\n"
    "  TP           walls that have to be found and were: within 5 degrees and 0.1 m of a found\n"
    "               one that covers half of them, and is covered by half itself\n"
    "  FP           found walls that are none, or the second on one wall\n"
    "  frag         the latter alone: pieces of a wall that was found broken\n"
    "  angle, perp. error of the walls found: of direction, and across at the middle, rms\n"
    "  corner TP    corners that have to be found and were, within 0.15 m\n"
    "  corner FP    found corners that are none\n"
    "  corner kind  convex taken for concave or the reverse\n"
    "  corner median, end point  how far corners and ends of walls are off, median\n"
    "Rows: bound, the most likely walls for who knows which beam ends where; floor; the methods.\n"
    "Without truth: how many walls and corners were found, and times.\n";

std::string scan_table(const ScanEvaluation& evaluation) {
  std::vector<Cells> rows = head(evaluation.bound.has_value());
  if (evaluation.bound) {
    rows.push_back({"bound", "-", "-", "-"});
    append(rows.back(), score_cells(*evaluation.bound));
  }
  const double floor_us = quantile(evaluation.floor_us, 0.5);
  rows.push_back({"floor"});
  append(rows.back(), time_cells(evaluation.floor_us, floor_us));
  append(rows.back(), Cells(rows.front().size() - rows.back().size(), "-"));
  for (const MethodResult& method : evaluation.methods) {
    rows.push_back({method.name});
    append(rows.back(), time_cells(method.times_us, floor_us));
    append(rows.back(), method.score ? score_cells(*method.score) : count_cells(method.found));
  }
  return aligned(rows);
}

std::string scan_dump(const ScanSet& set, const ScanEvaluation& evaluation) {
  std::string text;
  for (const MethodResult& method : evaluation.methods) {
    if (evaluation.methods.size() > 1) text += "# method " + method.name + "\n";
    for (std::size_t i = 0; i < set.scans.size(); ++i)
      append_dump(text, set.scans[i].id, method.found[i]);
  }
  return text;
}

}  // namespace perceptor
