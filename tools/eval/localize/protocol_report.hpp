/// @file All trials together: what the protocol asks for, as text and as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/eval/localize/outcome.hpp"
#include "tools/eval/localize/proportion.hpp"

namespace perceptor {

struct JudgedTrial {
  std::size_t number = 0;
  std::string site;
  Conditions conditions;
  Outcome outcome;
};

/// One line of the protocol that is a share of trials.
struct ProtocolLine {
  std::string name;
  double asked = 0.0;
  bool at_least = true;  ///< otherwise: at most
  std::function<bool(const JudgedTrial&)> is_case;
  std::function<bool(const JudgedTrial&)> is_hit;
};

const std::vector<ProtocolLine>& protocol_lines();

/// The lines with their confidence intervals, times, errors, and each failure with its number.
std::string report(const std::vector<JudgedTrial>& trials);

/// The same and each trial, for machines.
std::string report_json(const std::vector<JudgedTrial>& trials, std::uint64_t seed);

}  // namespace perceptor
