#include "common/bus/channels.hpp"

#include <array>
#include <utility>

#include <pico/all_types.h>

namespace perceptor::channel {

const lcm_type_info_t* type_on(std::string_view channel) {
  using Entry = std::pair<std::string_view, const lcm_type_info_t* (*)()>;
  static constexpr std::array kTypes = {
      Entry{laser, pico_laser_scan_t_get_type_info},
      Entry{odometry, pico_odometry_t_get_type_info},
      Entry{sonar, pico_sonar_t_get_type_info},
      Entry{velocity, pico_velocity_t_get_type_info},
      Entry{open_door, pico_open_door_t_get_type_info},
      Entry{speak, pico_speak_t_get_type_info},
      Entry{truth, pico_truth_t_get_type_info},
      Entry{world, pico_map_t_get_type_info},
      Entry{position, pico_position_t_get_type_info},
      Entry{proximity, pico_proximity_t_get_type_info},
      Entry{current_map, pico_map_t_get_type_info},
      Entry{local_map, pico_map_t_get_type_info},
      Entry{identified_map, pico_map_t_get_type_info},
      Entry{entrance, pico_entrance_t_get_type_info},
      Entry{global_map, pico_map_t_get_type_info},
      Entry{world_position, pico_world_position_t_get_type_info},
      Entry{combined_map, pico_map_t_get_type_info},
  };
  for (const auto& [name, type] : kTypes)
    if (channel == name) return type();
  if (channel.starts_with(status_prefix)) return pico_status_t_get_type_info();
  return nullptr;
}

}  // namespace perceptor::channel
