/// @file How the components are, from their STATUS, as rows of a table.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pico/status_t.hpp>

#include "tools/top/row.hpp"

namespace perceptor {

class StatusTable {
 public:
  /// A STATUS, and when it arrived [us, monotonic].
  void take(const pico::status_t& status, std::int64_t now);

  /// A title and a row for each component in the order of their names, as of `now` [us, monotonic].
  /// Rates are those between a component's last two STATUS messages; one that says nothing more is
  /// silent.
  std::vector<Row> rows(std::int64_t now) const;

 private:
  struct Component {
    pico::status_t now;
    std::optional<pico::status_t> before;
    std::int64_t heard = 0;  ///< [us, monotonic]
  };
  std::map<std::string, Component> components_;
};

}  // namespace perceptor
