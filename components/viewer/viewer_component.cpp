#include "components/viewer/viewer_component.hpp"

#include <iostream>
#include <vector>

#include "common/bus/channels.hpp"
#include "common/time/stamp.hpp"
#include "components/viewer/listen.hpp"
#include "components/viewer/page.hpp"
#include "components/viewer/scene_json.hpp"

namespace perceptor {
namespace {

constexpr int kStatusQueue = 200;  // a second of all components, and more

std::vector<viewer::PageFile> files() {
  std::vector<viewer::PageFile> files = viewer::page_files();
  files.push_back({"/legend.json", viewer::legend_json()});
  return files;
}

}  // namespace

void describe(config::Fields& fields, ViewerConfig& config) {
  fields.text("address", config.server.address,
              "to listen on; 0.0.0.0: on every network, where anybody may look");
  fields.integer("port", config.server.port, {1, 65535}, "of the page: http://ADDRESS:PORT");
  fields.integer("clients", config.server.clients, {1, 100}, "that may look at a time");
  fields.number("rate", config.rate, {0.1, 50.0}, "[Hz] pictures to each of them");
  fields.number("trail_step", config.newest.trail_step, {0.001, 10.0},
                "[m] between two points of the trail");
  fields.integer("trail_points", config.newest.trail_points, {2, 100'000},
                 "kept; the oldest go first");
  fields.number("stale", config.newest.stale, {0.1, 3600.0},
                "[s] the page tells of a channel that is older than the newest by more");
}

ViewerComponent::ViewerComponent(const ViewerConfig& config, Bus& bus)
    : period_(static_cast<std::int64_t>(kMicrosecondsPerSecond / config.rate)),
      newest_(config.newest),
      server_(config.server, files()) {
  viewer::listen(bus, newest_);
  bus.subscribe_command<pico::status_t>(
      std::string(channel::status_prefix) + ".*", kStatusQueue,
      [this](const pico::status_t& status) { statuses_[status.component] = status; });
  std::cout << "http://" << config.server.address << ':' << config.server.port << std::endl;
}

std::int64_t ViewerComponent::step(std::int64_t now) {
  if (now < next_) return next_;
  next_ = now + period_;
  if (server_.clients() == 0) {
    server_.forget();
    return next_;
  }
  viewer::JsonParts parts = viewer::to_json(newest_.scene());
  parts["status"] = viewer::to_json(statuses_);
  server_.publish(parts);
  return next_;
}

}  // namespace perceptor
