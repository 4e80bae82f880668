#include <algorithm>

#include <gmock/gmock.h>

#include "common/config/robot.hpp"
#include "tests/unit/common/config/example.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor {
namespace {

using testing::HasSubstr;

const std::filesystem::path kRobotFile = std::filesystem::path(PERCEPTOR_CONFIG_DIR) / "robot.json";

std::string error_of_reading(const std::string& text) {
  const TemporaryFile file(text);
  Robot robot;
  return error_of([&] { config::load_file(file.path(), bind(robot)); });
}

TEST(Robot, FileHoldsEveryKeyWithTheDefaultsOfTheCode) {
  Robot from_file;
  from_file.footprint.clear();
  from_file.limits = {0.0, 0.0, 0.0, 0.0};
  from_file.laser = {{1.0, 1.0, 1.0}, 0.0, 0.0, 0.0};
  config::load_file(kRobotFile, bind(from_file));
  Robot from_code;
  EXPECT_EQ(config::print(bind(from_file)), config::print(bind(from_code)));
}

TEST(Robot, DefaultsFitPico) {
  const Robot robot;
  const auto by_x = [](const auto& p, const auto& q) { return p.x < q.x; };
  const auto by_y = [](const auto& p, const auto& q) { return p.y < q.y; };
  const auto [back, front] =
      std::minmax_element(robot.footprint.begin(), robot.footprint.end(), by_x);
  const auto [right, left] =
      std::minmax_element(robot.footprint.begin(), robot.footprint.end(), by_y);
  EXPECT_DOUBLE_EQ(front->x - back->x, 0.41);
  EXPECT_DOUBLE_EQ(left->y - right->y, 0.35);
}

TEST(Robot, RefusesAFootprintWithoutAreaOrClockwise) {
  const char* kAllowed = "at least three corners, counter-clockwise";
  EXPECT_THAT(error_of_reading(R"({"footprint": []})"), HasSubstr(kAllowed));
  EXPECT_THAT(error_of_reading(R"({"footprint": [{"x": 0, "y": 0}, {"x": 1, "y": 0}]})"),
              HasSubstr(kAllowed));
  EXPECT_THAT(
      error_of_reading(R"({"footprint": [{"x": 0, "y": 0}, {"x": 0, "y": 1}, {"x": 1, "y": 0}]})"),
      HasSubstr(kAllowed));
  EXPECT_EQ(
      error_of_reading(R"({"footprint": [{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]})"),
      "");
}

TEST(Robot, RefusesLimitsOfZero) {
  EXPECT_THAT(error_of_reading(R"({"limits": {"speed": 0}})"), HasSubstr("/limits/speed is 0"));
}

}  // namespace
}  // namespace perceptor
