#include "tools/replay/pipeline.hpp"

#include <string_view>

#include "common/config/fields.hpp"

namespace perceptor {
namespace {

/// The overrides that begin with "<component>.", without that.
std::vector<std::string> overrides_of(std::string_view component,
                                      const std::vector<std::string>& overrides) {
  const std::string prefix = std::string(component) + ".";
  std::vector<std::string> own;
  for (const std::string& line : overrides)
    if (line.starts_with(prefix)) own.push_back(line.substr(prefix.size()));
  return own;
}

template <class Component>
void load_one(const std::filesystem::path& dir, const std::vector<std::string>& overrides,
              typename Component::Config& config) {
  const std::string file = std::string(Component::kName) + ".json";
  config::load({dir / file, dir / "robot.json", overrides_of(Component::kName, overrides)},
               [&config](config::Fields& fields) { describe(fields, config); });
}

void check_components_are_known(const std::vector<std::string>& overrides) {
  for (const std::string& line : overrides) {
    const std::string name = line.substr(0, line.find('.'));
    bool known = false;
    for (const std::string_view component :
         {LocateComponent::kName, ProximityComponent::kName, ScanComponent::kName,
          MergeComponent::kName, IdentifyComponent::kName, LocalizeComponent::kName})
      known |= name == component;
    if (!known)
      throw config::Error("--set " + line +
                          ": begin with a component: locate, proximity, scan, merge, "
                          "identify or localize, as in scan.aligner.max_gap=3");
  }
}

}  // namespace

PipelineConfig load_pipeline_config(const std::filesystem::path& config_dir,
                                    const std::vector<std::string>& overrides,
                                    const std::string& map) {
  check_components_are_known(overrides);
  PipelineConfig config;
  load_one<LocateComponent>(config_dir, overrides, config.locate);
  load_one<ProximityComponent>(config_dir, overrides, config.proximity);
  load_one<ScanComponent>(config_dir, overrides, config.scan);
  load_one<MergeComponent>(config_dir, overrides, config.merge);
  load_one<IdentifyComponent>(config_dir, overrides, config.identify);
  if (!map.empty()) {
    load_one<LocalizeComponent>(config_dir, overrides, config.localize.emplace());
    config.localize->map = map;
    config.localize->config_dir = config_dir;
  }
  return config;
}

/// One component with what it stands on; `component` goes first when it is taken down.
struct Pipeline::Node {
  Node(lcm::LCM& lcm, std::string_view name, std::int64_t boot)
      : status(std::string(name), boot), bus(lcm, lcm, status) {}

  Status status;
  Bus bus;
  std::shared_ptr<void> component;
  std::function<void()> finish = [] {};
};

Pipeline::Pipeline(const PipelineConfig& config, std::int64_t boot, Sink sink)
    : lcm_("memq://"), sink_(std::move(sink)) {
  lcm_subscribe(
      lcm_.getUnderlyingLCM(), ".*",
      [](const lcm_recv_buf_t* buffer, const char* channel, void* self) {
        static_cast<Pipeline*>(self)->sink_(
            channel, {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
      },
      this);
  add<LocateComponent>(config.locate, boot);
  add<ProximityComponent>(config.proximity, boot);
  add<ScanComponent>(config.scan, boot);
  add<MergeComponent>(config.merge, boot);
  add<IdentifyComponent>(config.identify, boot);
  if (config.localize) add<LocalizeComponent>(*config.localize, boot);
}

Pipeline::~Pipeline() = default;

template <class Component>
void Pipeline::add(const typename Component::Config& config, std::int64_t boot) {
  Node& node = *nodes_.emplace_back(std::make_unique<Node>(lcm_, Component::kName, boot));
  const auto component = std::make_shared<Component>(config, node.bus);
  node.component = component;
  if constexpr (requires { component->finish(); })
    node.finish = [component] { component->finish(); };
}

void Pipeline::feed(const std::string& channel, Bytes payload) {
  lcm_.publish(channel, payload.data(), static_cast<unsigned>(payload.size()));
  settle();
}

void Pipeline::publish_status(std::int64_t utime) {
  for (const auto& node : nodes_) node->bus.publish_status(utime, false);
  settle();
}

void Pipeline::finish(std::int64_t utime) {
  for (const auto& node : nodes_) {
    node->finish();
    node->bus.publish_status(utime, true);
  }
  settle();
}

void Pipeline::settle() {
  while (lcm_.handleTimeout(0) > 0) {
  }
}

}  // namespace perceptor
