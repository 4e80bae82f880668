#include "components/scan/explain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace perceptor::scan {
namespace {

/// A beam's fate, and the run that it is one of.
struct BeamRecord {
  Fate fate = Fate::no_return;
  std::size_t run = kNoRun;

  friend bool operator==(const BeamRecord&, const BeamRecord&) = default;
};

std::vector<BeamRecord> records_of(const WallExtractor& extractor, const LaserScan& scan) {
  const Beams& beams = extractor.sweep().beams;
  std::vector<BeamRecord> records(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (is_return(scan, scan.ranges[i])) records[i].fate = Fate::on_robot;
  for (const std::size_t beam : extractor.strays()) records[beam].fate = Fate::stray;
  for (std::size_t i = 0; i < beams.count; ++i) records[beams.beam[i]].fate = Fate::in_no_run;

  const std::vector<RunResult>& runs = extractor.runs();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const bool is_wall = runs[r].verdict == Verdict::wall;
    for (std::size_t i = runs[r].run.begin; i < runs[r].run.end; ++i) {
      BeamRecord& record = records[beams.beam[i]];
      record = {Fate::without_wall, r};
      if (!is_wall) continue;
      const Wall& wall = extractor.found().walls[runs[r].wall];
      record.fate =
          supports(beams, i, wall, extractor.parameters()) ? Fate::supports : Fate::off_line;
    }
  }
  return records;
}

std::vector<BeamGroup> group(const std::vector<BeamRecord>& records) {
  std::vector<BeamGroup> groups;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i == 0 || records[i] != records[i - 1])
      groups.push_back({.first_beam = i, .fate = records[i].fate, .run = records[i].run});
    groups.back().last_beam = i;
  }
  return groups;
}

/// Of the turn from one run's line to that of the next.
double turn_between(const Run& run, const Run& next, const Beams& beams) {
  const Line line = make_line(polar_line(run.moments), beams.laser);
  const Line next_line = make_line(polar_line(next.moments), beams.laser);
  return std::atan2(cross(line.direction, next_line.direction),
                    line.direction.dot(next_line.direction));
}

/// Between the beams i and i + 1, one of which is the end of a run; the turn where both are.
RunEnd end_between(const Beams& beams, std::size_t i, std::optional<double> turn) {
  RunEnd end{.limit = Limit::strays, .step = distance(beams.end(i), beams.end(i + 1))};
  if (is_gap(beams, i, i + 1)) {
    end.limit = Limit::gap;
  } else if (turn) {
    end.limit = Limit::corner;
    end.turn = *turn;
  }
  return end;
}

RunAccount account_of(const RunResult& result, const WallExtractor& extractor) {
  const Beams& beams = extractor.sweep().beams;
  Wall wall{};
  const Verdict verdict = fit_wall(result.run, extractor.sweep(), extractor.parameters(), wall);
  RunAccount account{.first_beam = beams.beam[result.run.begin],
                     .last_beam = beams.beam[result.run.end - 1],
                     .beams = result.run.size(),
                     .verdict = verdict,
                     .wall = result.wall,
                     .support = wall.support};
  if (verdict == Verdict::too_few_beams) return account;
  account.share = support_share(wall);
  if (verdict == Verdict::too_scattered) return account;
  account.length = length(wall);
  account.angle_sigma = angle_sigma(wall);
  return account;
}

}  // namespace

Account explain(const WallExtractor& extractor, const LaserScan& scan) {
  Account account{.groups = group(records_of(extractor, scan))};
  const Beams& beams = extractor.sweep().beams;
  const std::vector<RunResult>& results = extractor.runs();
  for (const RunResult& result : results) account.runs.push_back(account_of(result, extractor));

  for (std::size_t r = 0; r < results.size(); ++r) {
    const bool is_last = r + 1 == results.size();
    const std::size_t next = is_last ? 0 : r + 1;
    const Run& run = results[r].run;
    const Run next_run =
        is_last && beams.is_circle ? past_seam(results[0].run, beams) : results[next].run;
    std::optional<double> turn;
    if (next_run.begin == run.end) turn = turn_between(run, next_run, beams);
    if (beams.is_circle || run.end < beams.count)
      account.runs[r].after = end_between(beams, run.end - 1, turn);
    if (beams.is_circle || results[next].run.begin > 0)
      account.runs[next].before = end_between(beams, next_run.begin - 1, turn);
  }
  return account;
}

}  // namespace perceptor::scan
