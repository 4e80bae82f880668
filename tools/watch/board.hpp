/// @file What is known of a running Perceptor, as lines for people.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pico/entrance_t.hpp>
#include <pico/map_t.hpp>
#include <pico/proximity_t.hpp>
#include <pico/status_t.hpp>
#include <pico/world_position_t.hpp>

namespace perceptor {

class Board {
 public:
  void take(const pico::status_t& status);
  void take(const pico::map_t& identified_map) { map_ = identified_map; }
  void take(const pico::world_position_t& position) { position_ = position; }
  void take(const pico::entrance_t& entrance) { entrance_ = entrance; }
  void take(const pico::proximity_t& proximity) { proximity_ = proximity; }

  /// One line for each component in the order of the data flow, and some for the map and the
  /// place. Rates are those between a component's last two STATUS messages.
  std::vector<std::string> lines() const;

  bool has_heard(const std::string& component) const { return seen_.contains(component); }

 private:
  struct Seen {
    pico::status_t now;
    std::optional<pico::status_t> before;
  };
  std::map<std::string, Seen> seen_;
  std::optional<pico::map_t> map_;
  std::optional<pico::world_position_t> position_;
  std::optional<pico::entrance_t> entrance_;
  std::optional<pico::proximity_t> proximity_;
};

}  // namespace perceptor
