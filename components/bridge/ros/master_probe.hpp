/// @file Is there a ROS master that answers? Asked without waiting.
///
/// roscpp's own calls wait: for ever for a master that is not there, and for as long as the kernel
/// tries for one whose machine is off or whose radio link is down, minutes during which the bridge
/// would answer to nothing. So nothing is asked of roscpp until the master has answered here.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace perceptor {

struct MasterAddress {
  std::string host;
  std::string port;
};

/// Of "http://HOST:PORT", with or without a slash behind it; none where it is not of that form.
std::optional<MasterAddress> parse_master_uri(std::string_view uri);

class MasterProbe {
 public:
  enum class Answer { not_yet, yes, no };

  /// A master that takes longer counts for none [us].
  static constexpr std::int64_t kPatience = 1'000'000;

  /// `node` is the name under which it asks.
  MasterProbe(MasterAddress address, std::string node);
  ~MasterProbe();
  MasterProbe(const MasterProbe&) = delete;
  MasterProbe& operator=(const MasterProbe&) = delete;

  /// Goes on asking at `now` [us, monotonic], and never waits. After a yes or a no, the next call
  /// asks anew.
  Answer ask(std::int64_t now);

 private:
  class Question;

  MasterAddress address_;
  std::string node_;
  std::unique_ptr<Question> question_;  ///< under way
  std::int64_t give_up_ = 0;            ///< [us]
};

}  // namespace perceptor
