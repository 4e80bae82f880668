/// @file Pairs what was measured at T with the robot's position at T: the only place that
/// pairs, waits or drops.
///
/// Items wait, first in first out, until the positions on both sides of them are there. An
/// item's fate follows from the sequence of items and the sequence of positions alone, however
/// the two are interleaved, as long as no buffer overflows and nothing is extrapolated.
#pragma once

#include <deque>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "common/time/position_history.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {

template <class Item>
class Aligner {
 public:
  struct Paired {
    Stamp stamp;
    Item item;
    AlignedPosition position;
  };
  struct Dropped {
    Stamp stamp;
    std::string_view reason;
  };
  using Outcome = std::variant<Paired, Dropped>;

  explicit Aligner(const AlignerParameters& parameters)
      : parameters_(parameters), history_(parameters) {}

  /// `began_anew`: as the bus says, for each of the two channels.
  void add_position(const Stamp& stamp, bool began_anew, std::int64_t zero_utime,
                    const Position& robot_in_zero) {
    history_.add(stamp, began_anew, zero_utime, robot_in_zero);
  }

  void add_item(const Stamp& stamp, bool began_anew, Item item) {
    waiting_.push_back({stamp, began_anew, std::move(item)});
  }

  /// The next outcome, in the order of the items; none while the oldest item waits.
  std::optional<Outcome> next() {
    if (waiting_.empty()) return std::nullopt;
    Waiting& oldest = waiting_.front();
    PositionHistory::Fate fate = history_.decide(oldest.stamp, oldest.began_anew);
    if (const auto* paired = std::get_if<AlignedPosition>(&fate)) {
      Outcome outcome = Paired{oldest.stamp, std::move(oldest.item), *paired};
      waiting_.pop_front();
      return outcome;
    }
    if (const auto* dropped = std::get_if<DropReason>(&fate)) return drop_oldest(dropped->text);
    if (!history_.knows_session(oldest.stamp.session) && a_later_session_has_positions())
      return drop_oldest(drop_reason::no_session);
    if (static_cast<int>(waiting_.size()) > parameters_.max_items) {
      overflowed_ = true;
      history_.allow_all_segments();
      return drop_oldest(drop_reason::overflow);
    }
    return std::nullopt;
  }

  /// Gives up on what still waits, oldest first: no more positions will come.
  std::optional<Dropped> abandon() {
    if (waiting_.empty()) return std::nullopt;
    return drop_oldest(drop_reason::after_last);
  }

  /// Whether arrival order has had a say: a buffer overflowed, or a position was extrapolated.
  bool depends_on_arrival() const { return overflowed_ || history_.depends_on_arrival(); }

 private:
  struct Waiting {
    Stamp stamp;
    bool began_anew;
    Item item;
  };

  /// A channel's sessions come one after the other: once a later one has positions, none will
  /// come for this one.
  bool a_later_session_has_positions() const {
    for (const Waiting& item : waiting_)
      if (item.stamp.session != waiting_.front().stamp.session &&
          history_.knows_session(item.stamp.session))
        return true;
    return false;
  }

  Dropped drop_oldest(std::string_view reason) {
    const Dropped dropped{waiting_.front().stamp, reason};
    waiting_.pop_front();
    return dropped;
  }

  AlignerParameters parameters_;
  PositionHistory history_;
  std::deque<Waiting> waiting_;
  bool overflowed_ = false;
};

}  // namespace perceptor
