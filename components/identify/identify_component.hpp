/// @file Names what the local map shows: convex and concave corners, doors and possible doors;
/// one IDENTIFIED_MAP for each LOCAL_MAP.
///
/// in:  LOCAL_MAP
/// out: IDENTIFIED_MAP
#pragma once

#include <string_view>

#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "components/identify/identify.hpp"

namespace perceptor {

namespace identify {
void describe(config::Fields& fields, ConfidenceParameters& parameters);
}  // namespace identify

struct IdentifyConfig {
  identify::IdentifyParameters identify;
};

void describe(config::Fields& fields, IdentifyConfig& config);

class IdentifyComponent {
 public:
  static constexpr std::string_view kName = "identify";
  static constexpr std::string_view kSummary =
      "names the local map's corners, convex or concave, and its doors and possible doors";
  using Config = IdentifyConfig;

  /// The bus must outlive the component.
  IdentifyComponent(const IdentifyConfig& config, Bus& bus);

 private:
  void take(const pico::map_t& local_map);

  Bus& bus_;
  identify::IdentifyParameters parameters_;
};

}  // namespace perceptor
