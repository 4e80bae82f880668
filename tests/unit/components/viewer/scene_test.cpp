#include "components/viewer/scene.hpp"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace perceptor::viewer {
namespace {

TEST(SceneLooks, EachLayerHasItsOwnNameAndKey) {
  std::set<std::string_view> ids;
  std::set<char> keys;
  for (const LayerLook& layer : kLayerLooks) {
    EXPECT_TRUE(ids.insert(layer.id).second) << layer.id;
    EXPECT_TRUE(keys.insert(layer.key).second) << layer.key;
    EXPECT_EQ(std::string_view("fsd0 ").find(layer.key), std::string_view::npos)
        << "taken by a button";
  }
}

TEST(SceneLooks, NoTwoMarksDifferByColourAlone) {
  std::set<std::tuple<Shape, double, double, double>> looks;
  for (const MarkLook& mark : kMarkLooks)
    EXPECT_TRUE(looks.insert({mark.shape, mark.width, mark.dash, mark.fill}).second) << mark.label;
}

TEST(SceneLooks, EveryMarkIsNamed) {
  for (const MarkLook& mark : kMarkLooks) EXPECT_FALSE(mark.label.empty());
}

}  // namespace
}  // namespace perceptor::viewer
