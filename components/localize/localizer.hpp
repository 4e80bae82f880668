/// @file Finds the robot in the known building, follows it, and notices when it is wrong.
///
/// While it searches, the last scans from different poses are kept, and all places of the building
/// compete for them; a place is claimed when it leads the runner-up by a margin on several scans,
/// explains enough, and has few beams that go through walls. While it follows, each scan's walls
/// are laid on the building's, or its beams where no wall of the building is that exact, and now
/// and then the claimed place has to win the competition again.
///
/// The competition takes longer than the time from scan to scan. It runs beside, and its outcome
/// counts from the first scan after a fixed time, measured in the scans' own: results do not depend
/// on how fast the computer is.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <utility>
#include <vector>

#include "components/localize/alignment.hpp"
#include "components/localize/search.hpp"
#include "components/localize/start_hint.hpp"

namespace perceptor::localize {

enum class State : std::int8_t {
  searching,  ///< nothing was claimed yet
  tracking,   ///< the pose is claimed
  lost        ///< it was, and turned out wrong: searching again
};

struct KeyframeParameters {
  double distance = 0.15;  ///< [m] from the last one; closer ones say the same again
  double angle = 0.15;     ///< [rad] the same
  int count = 12;          ///< are kept, spread over the way; more decide safer and cost more
  double reach = 15.0;     ///< [m] and [rad] of way, before which they are forgotten
};

struct ClaimParameters {
  int min_keyframes = 3;        ///< that were seen from the place
  int min_leads = 3;            ///< of those, on which it beats the runner-up
  double margin = 55.0;         ///< of the log likelihood over the runner-up's
  double lost_margin = 15.0;    ///< another pose this much better ends a claim, or mends it
  double min_explained = 0.4;   ///< share of the beams that end where the map says
  int ambiguous_keyframes = 8;  ///< after so many a place without a margin is called ambiguous
};

struct WatchParameters {
  double min_explained = 0.2;   ///< a scan that fits less speaks against the pose
  double max_through = 0.15;    ///< or one with more beams through walls
  double poor_explained = 0.5;  ///< or one that is poor in both: fits less than this
  double poor_through = 0.04;   ///< and has more than this through walls
  double time = 0.4;            ///< [s] of such scans: lost
  double period = 2.0;          ///< [s] until the claimed place has to win again
};

/// By what the robot is followed.
enum class TrackBy {
  walls,  ///< those of each scan: where the map is exact
  beams   ///< of each scan: where it is made of scans, off by decimetres
};

struct LocalizerParameters {
  SearchParameters search;
  KeyframeParameters keyframes;
  ClaimParameters claim;
  TrackBy track_by = TrackBy::walls;
  AlignmentParameters tracking{.max_offset = 0.15, .max_angle = 0.15, .max_shift = 0.15};
  MotionNoise motion{.translation = 0.02,
                     .heading = 0.02,
                     .heading_by_translation = 0.01,
                     .still = 0.001};  ///< of the local map's own pose
  WatchParameters watch;
  double map_time = 5.0;         ///< [s] in which is learnt how far the walls stand off the map
  double min_map_sigma = 0.001;  ///< [m] they do at least
  double walls_together = 2.0;   ///< so many neighbours stand off it in the same way: their error
                                 ///< counts as one
  double search_time = 0.3;      ///< [s] from the scan that asks where the robot is to the first
                                 ///< that may know; less than it takes, and scans have to wait
  double found_sigma = 0.1;      ///< [m] of the pose when it is claimed
  double found_heading_sigma = 0.05;  ///< [rad] the same
};

/// One scan as localize gets it.
struct Sight {
  std::int64_t utime = 0;   ///< [us]
  Position robot_in_local;  ///< odometry's drift taken out by merge
  Map walls;                ///< of the local map, robot frame
  Map scan_walls;           ///< of this scan alone, robot frame
  std::vector<BeamEnd> ends;
};

struct WorldPosition {
  State state = State::searching;
  std::optional<PoseEstimate> robot_in_world;  ///< claimed, or the best guess
  bool ambiguous = false;                      ///< other places explain all that was seen as well
  int places = 0;                              ///< that were in the running at the last search
  double explained = 0.0;  ///< share of this scan's beams that end where the map says
  double through = 0.0;    ///< share that go through walls
};

class Localizer {
 public:
  /// `meanwhile` is called when a scan needs what a search has found, and every 2 ms until it has.
  Localizer(
      World world, const LocalizerParameters& parameters,
      std::optional<StartHint> hint = std::nullopt, std::function<void()> meanwhile = [] {})
      : world_(std::move(world)),
        parameters_(parameters),
        hint_(std::move(hint)),
        meanwhile_(std::move(meanwhile)) {}

  // A search that runs beside looks at this object.
  Localizer(const Localizer&) = delete;
  Localizer& operator=(const Localizer&) = delete;

  /// Scans in order of utime, of one local frame.
  WorldPosition update(const Sight& sight);

  /// Another local frame, or another time: nothing that was known holds but the hint.
  void clear();

 private:
  struct Answer {
    std::vector<Hypothesis> places;  ///< best first
    std::optional<Hypothesis> own;   ///< the claimed pose, as it was when asked
  };
  struct Tracked {
    PoseEstimate robot_in_world;
    Position robot_in_local;
    std::int64_t utime = 0;
    double map_variance = 0.0;  ///< [m^2] how far the walls stand off the map
  };

  bool keep_keyframe(const Sight& sight, const std::vector<Beam>& beams);
  void forget_one_of_many();
  bool is_time_to_ask(std::int64_t utime) const;
  void ask(const Sight& sight);
  void take_answer(const Sight& sight);
  void wait_for_answer() const;
  std::function<bool(const Position& local_in_world)> is_possible() const;
  bool fits_together() const;
  void forget_older_half();
  bool is_claimed() const;
  bool is_ambiguous() const;
  void check_claim(const Hypothesis& own, const Sight& sight);
  void lay_walls(const Sight& sight, double seconds, Tracked& tracked,
                 PoseEstimate& published) const;
  void lay_beams(const std::vector<Beam>& beams, Tracked& tracked, PoseEstimate& published) const;
  void track(const Sight& sight, const std::vector<Beam>& beams, WorldPosition& position);
  void guess(const Sight& sight, WorldPosition& position) const;
  void take_claim_back();
  void lose(std::int64_t utime);

  World world_;
  LocalizerParameters parameters_;
  std::optional<StartHint> hint_;
  std::function<void()> meanwhile_;
  bool has_begun_ = false;                  ///< a scan has come
  std::optional<Position> start_in_local_;  ///< of the first scan, while the hint holds
  State state_ = State::searching;
  std::vector<Keyframe> keyframes_;
  std::optional<Tracked> tracked_;
  std::future<Answer> answer_;
  std::int64_t asked_ = 0;                 ///< [us] utime of the scan that asked
  std::optional<std::int64_t> checked_;    ///< [us] when it asked whether the claim is right: at
                                           ///< once, and now and then
  std::vector<Hypothesis> places_;         ///< the last answer, best first
  std::int64_t since_ = 0;                 ///< [us] walls seen before tell nothing
  std::optional<std::int64_t> bad_since_;  ///< [us] scans speak against the pose
};

}  // namespace perceptor::localize
