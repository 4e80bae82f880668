/// @file A parameter struct with a field of each kind, for the tests of configuration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/fields.hpp"
#include "common/config/robot.hpp"

namespace perceptor {

enum class Method { fast, thorough };

struct WayPoint {
  double x = 0.0;
  double y = 0.0;
  std::string word;
};

struct Example {
  double max_speed = 2.0;
  std::int64_t big = 7;
  int beams = 1000;
  bool enabled = true;
  std::string source = "sim";
  Method method = Method::fast;
  std::vector<WayPoint> tour;
  Robot robot;
};

inline void describe(config::Fields& fields, WayPoint& place) {
  fields.number("x", place.x, {}, "[m] forward");
  fields.number("y", place.y, {}, "[m] left");
  fields.text("word", place.word, "what to say there");
}

inline void describe(config::Fields& fields, Example& example) {
  fields.number("max_speed", example.max_speed, {0.0, 10.0}, "[m/s] faster is a jump");
  fields.integer("big", example.big, {}, "any whole number");
  fields.integer("beams", example.beams, {1, 10000}, "beams a scan");
  fields.boolean("enabled", example.enabled, "off: nothing is published");
  fields.text("source", example.source, "where the data comes from");
  fields.choice<Method>("method", example.method,
                        {{"fast", Method::fast}, {"thorough", Method::thorough}},
                        "how lines are found");
  fields.list("tour", example.tour, "way-points");
  fields.group("robot", example.robot, "the robot itself");
}

/// What `describe` functions are bound to.
template <class Struct>
config::Describe bind(Struct& value) {
  return [&value](config::Fields& fields) { describe(fields, value); };
}

/// The text of the Error that `action` throws; empty where it throws none.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const config::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace perceptor
