/// @file What a component counts of itself, and the STATUS message it makes of it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
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

  /// `waits`: without it the component has nothing to do, and the note says that it waits.
  void add_input(const std::string& channel, bool waits = true);

  /// A message came in, good or bad.
  void received(const std::string& channel);

  /// What `watch` has seen of the channel, the last message included.
  void watched(const std::string& channel, const ContinuityWatch& watch);

  /// The message is good, and goes on to the component.
  void accepted(const std::string& channel, const Stamp& stamp);

  /// A message came in and was turned down.
  void rejected(const std::string& channel, std::string_view reason);

  /// Something worth counting that turned no message down: beams without a return.
  void counted(std::string_view channel, std::string_view reason, std::int64_t count);

  /// Messages that were lost before anybody saw them: counted like those turned down, and told of.
  void lost(std::string_view channel, std::string_view reason, std::int64_t count);

  void published(const std::string& channel, const Stamp& stamp);

  /// Of one message that led to output [us].
  void processing_time(double microseconds);

  /// A promise is suspended; every STATUS says so from now on, with the first reason.
  void degrade(std::string_view why);

  /// For people, in every STATUS until replaced.
  void set_note(std::string_view note);

  /// The message as of `utime`. An input is stale when nothing came since the last but one.
  pico::status_t message(std::int64_t utime, bool last);

  /// Messages turned down or lost since this was last asked, a line for each reason.
  std::vector<std::string> take_news();

 private:
  struct Input {
    bool waits = false;
    bool is_contested = false;
    std::int64_t received = 0;
    std::int64_t rejected = 0;
    std::int64_t missed = 0;
    std::int64_t restarts = 0;
    std::int64_t last_utime = 0;
    std::int64_t received_at_last_status = 0;
    int silent_statuses = 0;
  };
  struct Output {
    std::int64_t published = 0;
    Stamp last{0, 0, -1};
  };
  using Reason = std::pair<std::string, std::string>;  ///< channel, text

  std::string note() const;
  double quantile_us(double share) const;

  std::string component_;
  std::int64_t boot_;
  std::int64_t seq_ = 0;
  std::map<std::string, Input> inputs_;
  std::map<std::string, Output> outputs_;
  std::map<Reason, std::int64_t> reasons_;
  std::map<Reason, std::int64_t> news_;
  std::vector<double> recent_us_;  ///< a ring of the last processing times
  std::int64_t processed_ = 0;
  double max_us_ = 0.0;
  std::string degraded_;
  std::string note_;
};

}  // namespace perceptor
