#include "components/bridge/bridge_component.hpp"

#include <chrono>
#include <string>
#include <type_traits>

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
    source_.emplace<SimSource>(config, session_of(config), bus);
  } else if (config.source.starts_with(kLogPrefix)) {
    source_.emplace<LogSource>(config.source.substr(kLogPrefix.size()), config.speed,
                               config.duration, bus);
  } else {
    throw config::Error("/source: \"" + config.source +
                        "\" is no source; sources are: sim, log:FILE");
  }
}

std::int64_t BridgeComponent::step(std::int64_t now) {
  return std::visit(
      [now](auto& source) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(source)>, std::monostate>)
          return now;
        else
          return source.step(now);
      },
      source_);
}

bool BridgeComponent::finished() const {
  return std::visit(
      [](const auto& source) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(source)>, std::monostate>)
          return true;
        else
          return source.finished();
      },
      source_);
}

}  // namespace perceptor
