/// @file What each scan shows: walls and corners in the robot frame, one CURRENT_MAP for each
/// scan that is paired with a position.
///
/// in:  PICO_LASER, POSITION
/// out: CURRENT_MAP
#pragma once

#include <string_view>

#include <pico/laser_scan_t.hpp>

#include "common/bus/bus.hpp"
#include "common/time/aligner.hpp"
#include "components/scan/extractor.hpp"
#include "components/scan/scan_config.hpp"

namespace perceptor {

class ScanComponent {
 public:
  static constexpr std::string_view kName = "scan";
  static constexpr std::string_view kSummary =
      "turns each laser scan into the walls and corners that it shows";
  using Config = ScanConfig;

  /// The bus must outlive the component.
  ScanComponent(const ScanConfig& config, Bus& bus);

  /// Counts the scans that still wait for a position.
  void finish();

 private:
  using LaserAligner = Aligner<pico::laser_scan_t>;

  /// Publishes the map of each scan whose position is known by now.
  void drain();
  void publish_map(const LaserAligner::Paired& paired);

  Bus& bus_;
  scan::WallExtractor extractor_;
  LaserAligner aligner_;
};

}  // namespace perceptor
