/// @file All perceiving components in one process, on a private in-process bus: what goes in
/// decides what comes out, byte for byte, and nothing else does.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/bus.hpp"
#include "components/identify/identify_component.hpp"
#include "components/localize/localize_component.hpp"
#include "components/locate/locate_component.hpp"
#include "components/merge/merge_component.hpp"
#include "components/proximity/proximity_component.hpp"
#include "components/scan/scan_component.hpp"

namespace perceptor {

struct PipelineConfig {
  LocateComponent::Config locate;
  ProximityComponent::Config proximity;
  ScanComponent::Config scan;
  MergeComponent::Config merge;
  IdentifyComponent::Config identify;
  std::optional<LocalizeComponent::Config> localize;  ///< where the building is known
};

/// Reads locate.json, scan.json, ... and robot.json of one folder. An override names its
/// component: "scan.aligner.max_gap=3". `map`: of the building, as pico-localize has it; without
/// one nobody localizes. Throws config::Error.
PipelineConfig load_pipeline_config(const std::filesystem::path& config_dir,
                                    const std::vector<std::string>& overrides,
                                    const std::string& map = {});

class Pipeline {
 public:
  using Bytes = std::span<const std::uint8_t>;
  /// Sees every message on the bus, those fed included, in order.
  using Sink = std::function<void(const std::string& channel, Bytes payload)>;

  /// `boot` goes into every STATUS.
  Pipeline(const PipelineConfig& config, std::int64_t boot, Sink sink);
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// Puts one message on the bus and waits until nobody has anything more to say.
  void feed(const std::string& channel, Bytes payload);

  /// Every component's STATUS, as of `utime`.
  void publish_status(std::int64_t utime);

  /// Nothing more will be fed: every component's last STATUS.
  void finish(std::int64_t utime);

 private:
  struct Node;
  template <class Component>
  void add(const typename Component::Config& config, std::int64_t boot);
  void settle();

  lcm::LCM lcm_;
  Sink sink_;
  std::vector<std::unique_ptr<Node>> nodes_;
};

}  // namespace perceptor
