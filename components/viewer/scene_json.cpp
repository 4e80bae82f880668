#include "components/viewer/scene_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "common/bus/losses.hpp"
#include "common/text/format.hpp"

namespace perceptor::viewer {
namespace {

using Json = nlohmann::ordered_json;

/// Names come from other processes: what is no UTF-8 is replaced, not thrown at.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json pose(const Position& p) {
  const auto rounded = [](double value) { return std::round(value * 1e5) / 1e5; };
  return {rounded(p.x), rounded(p.y), rounded(p.a)};
}

Json millimetres(const std::vector<Vector2>& points) {
  Json numbers = Json::array();
  for (const Vector2& point : points)
    for (const double metres : {point.x(), point.y()})
      numbers.push_back(std::llround(metres * 1000.0));
  return numbers;
}

Json items(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items)
    list.push_back({static_cast<int>(item.mark), millimetres(item.points), item.text, item.label});
  return list;
}

std::string_view name(Shape shape) {
  static constexpr std::array<std::string_view, 8> kNames = {
      "line", "polygon", "dot", "ring", "square", "triangle", "cross", "arrow"};
  return kNames[static_cast<std::size_t>(shape)];
}

}  // namespace

JsonParts to_json(const Scene& scene) {
  JsonParts parts;
  Json poses = Json::object();
  for (std::size_t i = 0; i < kLayers; ++i) {
    const std::string id(kLayerLooks[i].id);
    poses[id] = pose(scene.layers[i].frame_in_scene);
    parts["layer." + id] = text_of(items(scene.layers[i].items));
  }
  parts["scene"] = text_of({{"frame", name(scene.frame)},
                            {"utime", scene.utime},
                            {"robot", pose(scene.robot_in_scene)},
                            {"poses", poses},
                            {"notes", scene.notes}});
  return parts;
}

std::string legend_json() {
  Json legend;
  for (const LayerLook& layer : kLayerLooks)
    legend["layers"].push_back(
        {{"id", layer.id}, {"title", layer.title}, {"key", std::string(1, layer.key)}});
  for (const MarkLook& mark : kMarkLooks)
    legend["marks"].push_back({{"layer", look_of(mark.layer).id},
                               {"label", mark.label},
                               {"shape", name(mark.shape)},
                               {"colour", format("#%06x", mark.colour)},
                               {"width", mark.width},
                               {"dash", mark.dash},
                               {"fill", mark.fill}});
  return text_of(legend);
}

std::string to_json(const std::map<std::string, pico::status_t>& statuses) {
  Json list = Json::array();
  for (const auto& [component, status] : statuses) {
    const Losses losses = losses_of(status);
    Json published = Json::object();
    for (const auto& output : status.outputs) published[output.channel] = output.published;
    list.push_back({{"component", component},
                    {"boot", status.boot},
                    {"utime", status.utime},
                    {"published", published},
                    {"rejected", losses.rejected},
                    {"missed", losses.missed},
                    {"p50", status.p50_us},
                    {"p99", status.p99_us},
                    {"cpu", status.cpu_s},
                    {"rss", status.rss_bytes},
                    {"degraded", status.degraded != 0},
                    {"note", status.note}});
  }
  return text_of(list);
}

}  // namespace perceptor::viewer
