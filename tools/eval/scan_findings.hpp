/// @file One scan, what the extractor found in it, and how it came to that.
#pragma once

#include "components/scan/explain.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

/// Refers to what it is made of.
struct ScanFindings {
  const LabelledScan& labelled;
  const scan::Extraction& found;
  const scan::Account& account;
};

}  // namespace perceptor
