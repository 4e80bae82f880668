/// Ten thousand random steps, good and bad: what holds of every item whatever came.
#include <cmath>
#include <deque>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "common/time/aligner.hpp"
#include "common/time/continuity.hpp"

namespace perceptor {
namespace {

constexpr int kSteps = 10'000;
constexpr double kSpeed = 2.0;  // [m/s] of every robot here

/// A robot drives straight on from where its session began, so that its position at any time is
/// known. Its sensors' stamps go forward, stand still, step back or leap; its session changes, its
/// zero frame too. As in a component, the bus's watch turns down what does not go forward.
class AlignerRules : public testing::Test {
 protected:
  struct Sent {
    Stamp stamp;
    std::int64_t zero_utime;
  };

  double x_at(std::int64_t utime, std::int64_t zero_utime) const {
    return kSpeed * seconds_between(zero_utime, utime);
  }

  void step() {
    switch (random_() % 40) {
      case 0:
        ++session_;
        time_ = static_cast<std::int64_t>(random_() % 100'000'000);
        zero_utime_ = time_;
        return;
      case 1:
        zero_utime_ = time_;  // switched on anew
        return;
      case 2:
        time_ -= static_cast<std::int64_t>(random_() % 5'000'000);
        return;
      case 3:
        time_ += static_cast<std::int64_t>(random_() % 1'000'000);
        return;
      default:
        time_ += static_cast<std::int64_t>(random_() % 20'000);
    }
    if (random_() % 2 == 0)
      send_position();
    else
      send_item();
    while (const auto outcome = aligner_.next()) take(*outcome);
  }

  void send_position() {
    const Stamp stamp{time_, session_, ++seq_};
    const Continuity continuity = positions_.check(stamp);
    if (!goes_on(continuity)) return;
    aligner_.add_position(stamp, continuity == Continuity::began_anew, zero_utime_,
                          {x_at(time_, zero_utime_), 0.0, 0.0});
    sent_.push_back({stamp, zero_utime_});
  }

  void send_item() {
    const Stamp stamp{time_, session_, ++seq_};
    const Continuity continuity = items_.check(stamp);
    if (!goes_on(continuity)) return;
    aligner_.add_item(stamp, continuity == Continuity::began_anew, stamp.seq);
    waiting_.push_back(stamp);
  }

  static bool goes_on(Continuity continuity) {
    return continuity == Continuity::continues || continuity == Continuity::began_anew;
  }

  void take(const Aligner<std::int64_t>::Outcome& outcome) {
    const auto* paired = std::get_if<Aligner<std::int64_t>::Paired>(&outcome);
    const Stamp& stamp =
        paired ? paired->stamp : std::get<Aligner<std::int64_t>::Dropped>(outcome).stamp;
    ASSERT_FALSE(waiting_.empty());
    EXPECT_EQ(stamp.seq, waiting_.front().seq) << "each item once, in their order";
    waiting_.pop_front();
    if (!paired) {
      ++dropped_;
      return;
    }
    ++paired_;
    EXPECT_EQ(paired->item, stamp.seq);
    EXPECT_NEAR(paired->position.robot_in_zero.x, x_at(stamp.utime, paired->position.zero_utime),
                kSpeed * 1.1e-3)
        << "in its own frame, at its own time";
    EXPECT_TRUE(has_bracket(stamp, paired->position.zero_utime));
  }

  /// Positions of that session and frame on both sides, close enough, or one at the same time.
  bool has_bracket(const Stamp& item, std::int64_t zero_utime) const {
    const double max_gap = AlignerParameters{}.max_gap;
    bool is_before = false;
    bool is_behind = false;
    for (const Sent& sent : sent_) {
      if (sent.stamp.session != item.session || sent.zero_utime != zero_utime) continue;
      const double seconds = seconds_between(item.utime, sent.stamp.utime);
      if (std::abs(seconds) <= 1e-3) return true;
      is_before = is_before || (seconds < 0.0 && seconds > -max_gap);
      is_behind = is_behind || (seconds > 0.0 && seconds < max_gap);
    }
    return is_before && is_behind;
  }

  std::mt19937_64 random_{20261126};
  std::int64_t time_ = 50'000'000;
  std::int64_t session_ = 1;
  std::int64_t zero_utime_ = 50'000'000;
  std::int64_t seq_ = 0;
  ContinuityWatch positions_;
  ContinuityWatch items_;
  Aligner<std::int64_t> aligner_{AlignerParameters{}};
  std::vector<Sent> sent_;
  std::deque<Stamp> waiting_;
  int paired_ = 0;
  int dropped_ = 0;
};

TEST_F(AlignerRules, HoldWhateverComes) {
  for (int i = 0; i < kSteps; ++i) {
    step();
    ASSERT_LE(waiting_.size(), static_cast<std::size_t>(AlignerParameters{}.max_items));
    ASSERT_FALSE(HasFailure()) << "step " << i;
  }
  while (const auto dropped = aligner_.abandon()) take(*dropped);
  EXPECT_TRUE(waiting_.empty());
  EXPECT_GT(paired_, 1'000);
  EXPECT_GT(dropped_, 100);
}

}  // namespace
}  // namespace perceptor
