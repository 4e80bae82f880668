/// @file The keys of scan.json.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/config/fields.hpp"
#include "common/config/robot.hpp"
#include "common/time/position_history.hpp"
#include "components/scan/parameters.hpp"

namespace perceptor {

struct ScanConfig {
  scan::ScanParameters scan;
  AlignerParameters aligner;
  Robot robot;
};

namespace scan {
/// Every method, and how configuration and command lines call it.
const std::vector<std::pair<std::string, ScanMethod>>& method_names();

void describe(config::Fields& fields, NoiseParameters& p);
void describe(config::Fields& fields, GapParameters& p);
void describe(config::Fields& fields, ClusterParameters& p);
void describe(config::Fields& fields, EndpointFitParameters& p);
void describe(config::Fields& fields, IncrementalParameters& p);
void describe(config::Fields& fields, RansacParameters& p);
void describe(config::Fields& fields, WallParameters& p);
void describe(config::Fields& fields, CornerParameters& p);
void describe(config::Fields& fields, ScanParameters& p);
}  // namespace scan

void describe(config::Fields& fields, AlignerParameters& p);
void describe(config::Fields& fields, ScanConfig& config);

}  // namespace perceptor
