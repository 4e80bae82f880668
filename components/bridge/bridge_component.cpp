#include "components/bridge/bridge_component.hpp"

#include <chrono>
#include <string>

namespace perceptor {
namespace {

constexpr std::string_view kLogPrefix = "log:";

/// The one place where the bridge looks at the wall clock: two starts are two sessions.
std::int64_t session_of(const BridgeConfig& config) {
  if (config.session != 0) return config.session;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

}  // namespace

BridgeComponent::BridgeComponent(const BridgeConfig& config, Bus& bus) {
  if (config.source == "sim") {
    sim_ = std::make_unique<SimSource>(config, session_of(config), bus);
  } else if (config.source.starts_with(kLogPrefix)) {
    log_ = std::make_unique<LogSource>(config.source.substr(kLogPrefix.size()), config.speed,
                                       config.duration, bus);
  } else {
    throw config::Error("/source: \"" + config.source +
                        "\" is no source; sources are: sim, log:FILE");
  }
}

std::int64_t BridgeComponent::step(std::int64_t now) {
  return sim_ ? sim_->step(now) : log_->step(now);
}

bool BridgeComponent::finished() const { return sim_ ? sim_->finished() : log_->finished(); }

}  // namespace perceptor
