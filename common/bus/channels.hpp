/// @file The names of the channels, and what travels on each.
#pragma once

#include <string_view>

#include <lcm/lcm_coretypes.h>

namespace perceptor::channel {

inline constexpr const char* laser = "PICO_LASER";
inline constexpr const char* odometry = "PICO_ODOMETRY";
inline constexpr const char* sonar = "PICO_SONAR";
inline constexpr const char* velocity = "CMD_VELOCITY";
inline constexpr const char* open_door = "CMD_OPEN_DOOR";
inline constexpr const char* speak = "CMD_SPEAK";
inline constexpr const char* truth = "SIM_TRUTH";
inline constexpr const char* world = "SIM_WORLD";
inline constexpr const char* position = "POSITION";
inline constexpr const char* proximity = "PROXIMITY";
inline constexpr const char* current_map = "CURRENT_MAP";
inline constexpr const char* local_map = "LOCAL_MAP";
inline constexpr const char* identified_map = "IDENTIFIED_MAP";
inline constexpr const char* entrance = "ENTRANCE";
inline constexpr const char* global_map = "GLOBAL_MAP";
inline constexpr const char* world_position = "WORLD_POSITION";
inline constexpr const char* combined_map = "COMBINED_MAP";
inline constexpr std::string_view status_prefix = "STATUS_";
inline constexpr std::string_view command_prefix = "CMD_";

/// The type of the messages on a channel of ours; null for any other channel.
const lcm_type_info_t* type_on(std::string_view channel);

}  // namespace perceptor::channel
