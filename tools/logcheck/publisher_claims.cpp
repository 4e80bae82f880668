#include "tools/logcheck/publisher_claims.hpp"

#include <algorithm>

namespace perceptor {
namespace {

std::string name_of(const Claim& claim) {
  return claim.component + " (boot " + std::to_string(claim.boot) + ")";
}

std::string messages(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " message" : " messages");
}

}  // namespace

void PublisherClaims::add(const Claim& claim, bool is_first_status,
                          std::int64_t in_log_at_first_status) {
  const auto known = std::ranges::find_if(claims_, [&claim](const Claim& other) {
    return other.component == claim.component && other.boot == claim.boot;
  });
  if (known == claims_.end()) {
    claims_.push_back(claim);
    if (is_first_status) return;
    // A channel is listed from its first message on: nothing was published before.
    claims_.back().published_first = 0;
    claims_.back().in_log_first = in_log_at_first_status;
    if (const std::int64_t lost = claims_.back().lost(); lost > 0)
      claims_.back().losses.push_back({lost, claim.stamp, claim.stamp});
    return;
  }
  if (std::next(known) != claims_.end()) concurrent_ = true;
  const std::int64_t lost_before = known->lost();
  const std::int64_t stamp_before = known->stamp;
  known->published_last = claim.published_last;
  known->in_log_last = claim.in_log_last;
  known->session = claim.session;
  known->last_seq = claim.last_seq;
  known->stamp = claim.stamp;
  known->stopped = claim.stopped;
  if (const std::int64_t lost = known->lost() - lost_before; lost > 0)
    known->losses.push_back({lost, stamp_before, claim.stamp});
}

ClaimedCompleteness PublisherClaims::check(std::int64_t in_log) const {
  ClaimedCompleteness result;
  if (claims_.empty()) {
    result.unproven.emplace_back("no STATUS of its publisher in the log");
    return result;
  }
  if (concurrent_) {
    result.unproven.emplace_back("two publishers at once");
    return result;
  }
  std::int64_t accounted = 0;  // messages of the log that belong to the claims so far
  bool has_open_end = false;   // the publisher before may own what follows
  for (const Claim& claim : claims_) {
    const bool is_first = &claim == &claims_.front();
    const std::int64_t before = claim.in_log_first - accounted;
    const std::int64_t own = has_open_end ? std::min(before, claim.published_first) : before;
    const std::int64_t short_of = claim.published_first - own;
    if (short_of > 0 && is_first) {
      result.unproven.push_back("the log began after " + name_of(claim) + ", which had published " +
                                messages(short_of) + " by then");
    } else if (short_of > 0) {
      result.missing += short_of;
      result.missing_reasons.push_back(messages(short_of) + " missing before the first STATUS of " +
                                       name_of(claim));
    } else if (short_of < 0) {
      result.unproven.push_back(messages(-short_of) + " before the first STATUS of " +
                                name_of(claim) + " are nobody's");
    }
    if (claim.lost() > 0) {
      result.missing += claim.lost();
      result.missing_reasons.push_back(name_of(claim) + " published " +
                                       std::to_string(claim.published_last) + ", " +
                                       std::to_string(claim.lost()) + " are missing");
      result.losses.insert(result.losses.end(), claim.losses.begin(), claim.losses.end());
    } else if (claim.lost() < 0) {
      result.unproven.push_back(std::to_string(-claim.lost()) + " more in the log than " +
                                name_of(claim) + " published");
    }
    accounted = claim.in_log_last;
    has_open_end = !claim.stopped;
    if (has_open_end)
      result.unproven.push_back(name_of(claim) +
                                " sent no last STATUS (killed, or the log ended before it): what "
                                "it published after the one before is not known");
  }
  if (!has_open_end && in_log > accounted)
    result.unproven.push_back(messages(in_log - accounted) +
                              " after the last STATUS of the publisher");
  return result;
}

}  // namespace perceptor
