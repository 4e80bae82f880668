#include "tools/eval/log_tracks.hpp"

#include <algorithm>

#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"

namespace perceptor {

double duration(const Track& track) {
  if (track.merge.empty()) return 0.0;
  return seconds_between(track.merge.front().utime, track.merge.back().utime);
}

Track& TrackReader::track_of(std::int64_t session, std::int64_t zero_utime) {
  const auto found = std::ranges::find_if(tracks_, [&](const Track& track) {
    return track.session == session && track.zero_utime == zero_utime;
  });
  if (found != tracks_.end()) return *found;
  tracks_.push_back({session, zero_utime, {}, {}});
  return tracks_.back();
}

void TrackReader::take(const LogEvent& event) {
  if (event.channel != channel::local_map) return;
  pico::map_t map;
  if (!detail::decode(event.data, map).empty()) {
    ++undecodable_;
    return;
  }
  Track& track = track_of(map.session, map.zero_utime);
  track.merge.push_back({map.utime, to_model(map.robot_in_local)});
  track.odometry.push_back({map.utime, to_model(map.robot_in_zero)});
}

std::vector<Track> TrackReader::tracks() const {
  std::vector<Track> tracks = tracks_;
  for (Track& track : tracks) {
    put_in_order(track.merge);
    put_in_order(track.odometry);
  }
  return tracks;
}

const Track& longest(const std::vector<Track>& tracks) {
  return *std::ranges::max_element(tracks, {}, duration);
}

}  // namespace perceptor
