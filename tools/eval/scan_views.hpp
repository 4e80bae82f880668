/// @file Extracts single scans again, to show people what was found and why.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "components/scan/parameters.hpp"
#include "tools/eval/scan_set.hpp"
#include "tools/eval/scan_sheet.hpp"

namespace perceptor {

/// Draws every `every`-th scan, or some spread evenly, into an SVG file. `title` lacks the sigmas
/// only. Throws std::runtime_error where the file cannot be written.
void draw_scans(const ScanSet& set, const scan::ScanParameters& parameters, SheetTitle title,
                std::optional<std::size_t> every, const std::filesystem::path& out);

/// Which scan is explained, and which of its beams; without a beam, all of them.
struct Question {
  std::int64_t scan = 0;  ///< its id
  std::optional<std::size_t> beam;
  std::optional<double> bearing;  ///< [rad] laser frame; the nearest beam answers
};

/// The text. Throws config::Error for a scan or a beam that is not there.
std::string explain(const ScanSet& set, const scan::ScanParameters& parameters,
                    const Question& question);

}  // namespace perceptor
