/// @file Messages <-> model. The only place that sets the counts of a message.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/pose_t.hpp>

#include "common/geometry/position.hpp"
#include "common/model/laser_scan.hpp"
#include "common/model/map.hpp"

namespace perceptor {

Position to_model(const pico::pose_t& pose);
pico::pose_t to_message(const Position& position);

/// Of a validated scan: bearings are computed for a regular one.
LaserScan to_model(const pico::laser_scan_t& scan);

/// The points and objects of a validated map.
Map to_model(const pico::map_t& message);

/// Fills points, objects and their counts; everything else of the message stays.
void set_map(pico::map_t& message, const Map& map);

/// A message of one part in a named frame; everything unknown says so.
pico::map_t make_map_message(const std::string& frame, const Map& map);

/// A map of any size in as many parts as each is well within one message.
std::vector<pico::map_t> make_map_messages(const std::string& frame, const Map& map,
                                           std::int64_t map_id);

}  // namespace perceptor
