/// @file What makes a wall of the map certain, and what takes it out again.
#pragma once

#include <cstdint>
#include <vector>

#include "components/merge/rivals.hpp"
#include "components/merge/sees_through.hpp"
#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct ConfirmationParameters {
  int sightings = 3;            ///< scans that must see a wall before it is published
  double min_time = 0.5;        ///< [s] from the first to the last of them; larger is safer
                                ///< against what moves, and slower to show a new wall
  double min_share = 0.5;       ///< of the scans since the first that must see it; larger keeps out
                                ///< what noise shows now and then
  double tentative_time = 0.5;  ///< [s] a wall not confirmed that is unseen for so long is
                                ///< removed; more than the time between scans; larger confirms
                                ///< errors that happen now and then in one place
};

struct ForgettingParameters {
  SeesThroughParameters sees_through;
  RivalParameters rivals;
  double factor = 0.5;      ///< of a wall's weight kept by each scan that sees through it
  double min_weight = 1.0;  ///< below it the piece that is seen through goes
  double min_piece = 0.2;   ///< [m] what is left of a wall beside the opening stays if longer
};

/// Halves the weight of each wall that the scan sees through, and cuts the piece that it sees
/// through out of the tentative ones and of those whose weight is used up: a shorter wall, two,
/// or none remain. `sighted`
/// and `laser` in the local frame. A new piece takes its id from `next_id`, which counts on.
void forget_seen_through(std::vector<Wall>& walls, const std::vector<Wall>& sighted,
                         const Vector2& laser, std::int32_t& next_id,
                         const ForgettingParameters& parameters);

/// The same for the piece of a wall in whose place the scan saw another one, if that is confirmed
/// or was seen steadily; one that is not confirmed has to wait. `seen` are the observations of this
/// scan.
void forget_contradicted(std::vector<Wall>& walls, const std::vector<Observation>& seen,
                         const Vector2& laser, std::int32_t& next_id,
                         const ForgettingParameters& parameters,
                         const ConfirmationParameters& confirmation);

/// What is about to be confirmed ends where another confirmed wall stands in its place.
void make_room(std::vector<Wall>& walls, const ForgettingParameters& parameters,
               const ConfirmationParameters& confirmation);

/// Confirms the walls that were seen often enough over a long enough time. One that is connected
/// to a confirmed wall, however many walls lie between, needs the time and the share but not the
/// number of sightings: what walks past a wall's end is connected to it as well.
void confirm(std::vector<Wall>& walls, const ConfirmationParameters& parameters);

/// Removes the walls that were not confirmed and are not seen any more.
void forget_tentative(std::vector<Wall>& walls, std::int64_t utime,
                      const ConfirmationParameters& parameters);

/// Removes what is left of walls that later scans found to end sooner, where it is shorter than
/// any wall that is taken in [m].
void forget_short(std::vector<Wall>& walls, double min_length);

/// Removes the longest unseen until `max_walls` are left; of those seen last together the
/// tentative go first, then the lightest.
void forget_longest_unseen(std::vector<Wall>& walls, std::size_t max_walls);

}  // namespace perceptor::merge
