/// @file What travels on the bus, channel by channel, as rows of a table.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/time/continuity.hpp"
#include "tools/top/row.hpp"

namespace perceptor {

class ChannelTable {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// One message, and when it arrived [us, monotonic].
  void take(const std::string& name, Bytes payload, std::int64_t now);

  /// A title and a row for each channel in the order of their names, as of `now` [us, monotonic].
  /// Rates are those of the last two seconds.
  std::vector<Row> rows(std::int64_t now) const;

 private:
  struct Arrival {
    std::int64_t when;  ///< [us]
    std::size_t size;   ///< [bytes]
  };
  struct Channel {
    std::int64_t bad = 0;  ///< not the bytes of the channel's type
    std::deque<Arrival> recent;
    ContinuityWatch watch;  ///< where the messages have stamps
  };
  std::map<std::string, Channel> channels_;
};

}  // namespace perceptor
