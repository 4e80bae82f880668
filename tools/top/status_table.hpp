/// @file How the components are, from their STATUS, as rows of a table.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pico/status_t.hpp>

#include "tools/top/row.hpp"

namespace perceptor {

class StatusTable {
 public:
  void take(const pico::status_t& status);

  /// A title and a row for each component in the order of their names. Rates are those between a
  /// component's last two STATUS messages.
  std::vector<Row> rows() const;

 private:
  struct Component {
    pico::status_t now;
    std::optional<pico::status_t> before;
  };
  std::map<std::string, Component> components_;
};

}  // namespace perceptor
