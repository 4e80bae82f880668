/// @file The words of one line, read as numbers.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/convert/recording.hpp"

namespace perceptor {

/// Takes words off a line, one after the other. The first that is missing or is not what was
/// asked for is the fault; everything asked after it gives nothing.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  /// The next word; empty at the end of the line.
  std::string_view word();

  /// The next words as numbers; "nan" and "inf" are numbers too.
  void number(double& value);
  void number(float& value);
  void finite(std::initializer_list<double*> values);

  /// The next words as a pose, its heading brought into (-pi, pi].
  void pose(Position& position);

  /// The next word as seconds, rounded to microseconds.
  void time(std::int64_t& utime);

  /// The next word as a number of beams, 1 to `most`.
  std::size_t count(std::int32_t most);

  /// The next words as ranges, or as bearings and ranges in turn.
  std::vector<float> numbers(std::size_t count);

  /// Nothing is left on the line.
  void end();

  bool at_end();
  bool good() const { return !fault_; }
  const std::optional<Dropped>& fault() const { return fault_; }

 private:
  void fail(std::string_view reason, std::string_view detail);

  std::string_view rest_;
  std::optional<Dropped> fault_;
};

}  // namespace perceptor
