/// @file Does a well-formed message make sense? What is wrong with it, as a fixed text that
/// is counted; empty: nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <pico/entrance_t.hpp>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/open_door_t.hpp>
#include <pico/position_t.hpp>
#include <pico/proximity_t.hpp>
#include <pico/sonar_t.hpp>
#include <pico/speak_t.hpp>
#include <pico/status_t.hpp>
#include <pico/truth_t.hpp>
#include <pico/velocity_t.hpp>
#include <pico/world_position_t.hpp>

namespace perceptor::messages {

inline constexpr std::int32_t kMaxBeams = 10'000;
inline constexpr std::int32_t kMaxIrregularBeams = 7'000;  ///< more would not fit one datagram
inline constexpr double kMaxSweepTime = 1.0;               ///< [s] from the first beam to the last
inline constexpr double kMinRangeSigma = 1e-9;             ///< [m] so that its square is a number
inline constexpr std::size_t kMaxSpeech = 1'000;           ///< [bytes]
inline constexpr std::int32_t kMaxMapPoints = 1'000;       ///< more than a datagram holds
inline constexpr std::int32_t kMaxMapObjects = 1'000;      ///< the same

std::string_view validate(const pico::laser_scan_t& scan);
std::string_view validate(const pico::odometry_t& odometry);
std::string_view validate(const pico::sonar_t& sonar);
std::string_view validate(const pico::velocity_t& velocity);
std::string_view validate(const pico::open_door_t& request);
std::string_view validate(const pico::speak_t& speech);
std::string_view validate(const pico::truth_t& truth);
std::string_view validate(const pico::position_t& position);
std::string_view validate(const pico::proximity_t& proximity);
std::string_view validate(const pico::map_t& map);
std::string_view validate(const pico::entrance_t& entrance);
std::string_view validate(const pico::world_position_t& position);
std::string_view validate(const pico::status_t& status);

}  // namespace perceptor::messages
