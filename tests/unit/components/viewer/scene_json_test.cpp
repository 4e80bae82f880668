#include "components/viewer/scene_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace perceptor::viewer {
namespace {

using Json = nlohmann::json;

TEST(SceneJson, ItemsAreWholeMillimetres) {
  Scene scene;
  scene[Layer::local_map].items = {
      {Mark::local_wall, {{1.0004, -2.0}, {0.0, 0.5}}, "a wall", "label"}};
  const JsonParts parts = to_json(scene);
  EXPECT_EQ(Json::parse(parts.at("layer.local")),
            Json({{static_cast<int>(Mark::local_wall), {1000, -2000, 0, 500}, "a wall", "label"}}));
  EXPECT_EQ(Json::parse(parts.at("layer.beams")), Json::array());
}

TEST(SceneJson, TheSceneNamesItsFrameAndWhereEachLayerLies) {
  Scene scene;
  scene.frame = SceneFrame::world;
  scene.utime = 123;
  scene[Layer::beams].frame_in_scene = {1.0, 2.0, 0.5};
  scene.notes = {"a \"note\""};
  const Json json = Json::parse(to_json(scene).at("scene"));
  EXPECT_EQ(json["frame"], "world");
  EXPECT_EQ(json["utime"], 123);
  EXPECT_EQ(json["poses"]["beams"], Json({1.0, 2.0, 0.5}));
  EXPECT_EQ(json["notes"][0], "a \"note\"");
}

TEST(SceneJson, NamesThatAreNoUtf8AreReplaced) {
  Scene scene;
  scene[Layer::local_map].items = {{Mark::local_wall, {{0.0, 0.0}}, "\xff\xfe"}};
  EXPECT_TRUE(Json::accept(to_json(scene).at("layer.local")));
}

TEST(SceneJson, TheLegendListsAllLayersAndMarks) {
  const Json legend = Json::parse(legend_json());
  EXPECT_EQ(legend["layers"].size(), kLayers);
  EXPECT_EQ(legend["marks"].size(), kMarks);
  EXPECT_EQ(legend["marks"][static_cast<std::size_t>(Mark::door)]["label"], "door");
  EXPECT_EQ(legend["marks"][static_cast<std::size_t>(Mark::door)]["colour"], "#009e73");
}

TEST(SceneJson, AStatusHasItsSums) {
  pico::status_t status{};
  status.component = "scan";
  status.inputs.resize(2);
  status.inputs[0].rejected = 2;
  status.inputs[1].rejected = 3;
  status.inputs[1].missed = 4;
  status.outputs.resize(1);
  status.outputs[0].channel = "CURRENT_MAP";
  status.outputs[0].published = 9;
  const Json json = Json::parse(to_json({{"scan", status}}));
  EXPECT_EQ(json[0]["component"], "scan");
  EXPECT_EQ(json[0]["rejected"], 5);
  EXPECT_EQ(json[0]["missed"], 4);
  EXPECT_EQ(json[0]["published"]["CURRENT_MAP"], 9);
}

}  // namespace
}  // namespace perceptor::viewer
