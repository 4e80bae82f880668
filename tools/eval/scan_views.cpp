#include "tools/eval/scan_views.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "common/config/fields.hpp"
#include "components/scan/explain.hpp"
#include "tools/eval/scan_explanation.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

const LabelledScan& scan_of(const ScanSet& set, std::int64_t id) {
  const auto scan = std::ranges::find(set.scans, id, &LabelledScan::id);
  if (scan != set.scans.end()) return *scan;
  const auto [first, last] = std::ranges::minmax(set.scans, {}, &LabelledScan::id);
  throw config::Error("--explain " + std::to_string(id) + ": no scan has this id; there are " +
                      std::to_string(set.scans.size()) + ", from " + std::to_string(first.id) +
                      " to " + std::to_string(last.id));
}

/// None: all beams.
std::optional<std::size_t> beam_of(const LaserScan& scan, const Question& question) {
  if (question.bearing && !std::isfinite(*question.bearing))
    throw config::Error("--bearing " + std::to_string(*question.bearing) + ": must be a number");
  if (question.bearing) return nearest_beam(scan, *question.bearing);
  if (question.beam && *question.beam >= scan.size())
    throw config::Error("--beam " + std::to_string(*question.beam) +
                        ": the scan has the beams 0 to " + std::to_string(scan.size() - 1));
  return question.beam;
}

}  // namespace

void draw_scans(const ScanSet& set, const scan::ScanParameters& parameters, SheetTitle title,
                std::optional<std::size_t> every, const std::filesystem::path& out) {
  scan::WallExtractor extractor(parameters, set.footprint);
  ScanSheet sheet(set.footprint);
  title.smallest_sigma = std::numeric_limits<double>::max();
  const std::vector<std::size_t> chosen = scans_of_sheet(set.scans.size(), every);
  {
    Progress progress("drawing", static_cast<std::int64_t>(chosen.size()));
    std::int64_t done = 0;
    for (const std::size_t i : chosen) {
      const LabelledScan& labelled = set.scans[i];
      const scan::Extraction& found = extractor.extract(labelled.scan);
      const scan::Account account = scan::explain(extractor, labelled.scan);
      sheet.add({labelled, found, account});
      title.smallest_sigma = std::min(title.smallest_sigma, labelled.scan.range_sigma);
      title.largest_sigma = std::max(title.largest_sigma, labelled.scan.range_sigma);
      progress.at(++done);
    }
  }
  std::ofstream file(out);
  file << sheet.document(title);
  if (!file.flush()) throw std::runtime_error("cannot write " + out.string());
}

std::string explain(const ScanSet& set, const scan::ScanParameters& parameters,
                    const Question& question) {
  const LabelledScan& labelled = scan_of(set, question.scan);
  const auto beam = beam_of(labelled.scan, question);
  scan::WallExtractor extractor(parameters, set.footprint);
  const scan::Extraction& found = extractor.extract(labelled.scan);
  const scan::Account account = scan::explain(extractor, labelled.scan);
  const ScanFindings findings = {labelled, found, account};
  return beam ? explain_beam(findings, *beam, parameters) : explain_scan(findings, parameters);
}

}  // namespace perceptor
