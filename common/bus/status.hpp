/// @file What a component counts of itself, and the STATUS message it makes of it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <pico/status_t.hpp>

#include "common/time/continuity.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {

class Status {
 public:
  /// `boot`: one number for each start of the process.
  Status(std::string component, std::int64_t boot);

  const std::string& component() const { return component_; }
  /// STATUS_<NAME>
  std::string channel() const;

  void add_input(const std::string& channel);
  void add_output(const std::string& channel);

  void received(const std::string& channel);
  void accepted(const std::string& channel, const Stamp& stamp, const ContinuityWatch& watch);
  void published(const std::string& channel, const Stamp& stamp);
  void rejected(std::string_view channel, std::string_view reason, std::int64_t count = 1);
  void processing_time(double microseconds);

  /// A promise is suspended (a buffer overflowed, extrapolation is on); it says so once more
  /// in each STATUS from now on.
  void degrade(std::string_view why);

  /// For people; replaced by the next one.
  void set_note(std::string_view note);

  /// The message, as of now. `stale_after` [us]: an input that has not come for longer since
  /// the last STATUS is stale.
  pico::status_t message(std::int64_t utime, bool last);

  std::int64_t rejected_in_all() const;

 private:
  struct Input {
    std::int64_t received = 0;
    std::int64_t rejected = 0;
    std::int64_t missed = 0;
    std::int64_t restarts = 0;
    std::int64_t last_utime = 0;
    std::int64_t received_at_last_status = 0;
  };
  struct Output {
    std::int64_t published = 0;
    Stamp last{0, 0, -1};
  };

  std::string component_;
  std::int64_t boot_;
  std::int64_t seq_ = 0;
  std::map<std::string, Input, std::less<>> inputs_;
  std::map<std::string, Output, std::less<>> outputs_;
  std::map<std::pair<std::string, std::string>, std::int64_t> rejects_;
  std::deque<double> recent_us_;
  std::int64_t processed_ = 0;
  double max_us_ = 0.0;
  std::string degraded_;
  std::string note_;
};

}  // namespace perceptor
