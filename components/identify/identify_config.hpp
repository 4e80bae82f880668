/// @file What of identify can be configured.
#pragma once

#include "common/config/fields.hpp"
#include "components/identify/entrance_tracker.hpp"
#include "components/identify/hallway.hpp"
#include "components/identify/identify.hpp"

namespace perceptor {

namespace identify {
void describe(config::Fields& fields, ConfidenceParameters& parameters);
void describe(config::Fields& fields, EntranceParameters& parameters);
void describe(config::Fields& fields, HallwayParameters& parameters);
}  // namespace identify

struct IdentifyConfig {
  identify::IdentifyParameters identify;
  identify::EntranceParameters entrance;
  identify::HallwayParameters hallway;
};

void describe(config::Fields& fields, IdentifyConfig& config);

}  // namespace perceptor
