/// A map file that makes no sense is told with its file and place, and the process does not start.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

constexpr const char* kPoints =
    R"("points": [{"x": 0, "y": 0}, {"x": 2, "y": 0}, {"x": 2, "y": 2}, {"x": 0, "y": 0}])";

std::string with_walls(const std::string& walls) {
  return "{" + std::string(kPoints) + ", " + walls + "}";
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

struct BadMap {
  const char* name;
  std::string text;
  const char* said;
};

void PrintTo(const BadMap& map, std::ostream* out) { *out << map.name; }

class BadMapTest : public testing::TestWithParam<BadMap> {};

TEST_P(BadMapTest, IsToldAndExitsWithTwo) {
  const ScratchFolder scratch;
  const auto file = scratch / "map.json";
  std::ofstream(file) << GetParam().text;
  for (const char* component : {"pico-globalmap", "pico-localize"}) {
    const Finished refused = run({program(component), "--map", file}, Seconds(20));
    EXPECT_EQ(refused.exit_code, 2) << refused.output;
    for (const std::string& word : {file.string(), std::string(GetParam().said)})
      EXPECT_NE(refused.output.find(word), std::string::npos)
          << word << " not in " << refused.output;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadMapTest,
    testing::Values(
        BadMap{"WallWithoutLength", with_walls(R"("walls": [[0, 3]])"), "/walls/0"},
        BadMap{"IndexOutOfRange", with_walls(R"("walls": [[0, 9]])"), "/walls/0/1"},
        BadMap{"KeyTwice", with_walls(R"("walls": [[0, 1]], "walls": [[1, 2]])"), "/walls"},
        BadMap{"NumberAsText", R"({"points": [{"x": "0", "y": 0}], "walls": []})", "/points/0/x"},
        BadMap{"NotANumber", R"({"points": [{"x": NaN, "y": 0}], "walls": []})", "line 1"},
        BadMap{"NestedTooDeep", repeated("[", 100'000) + repeated("]", 100'000), "too deep"},
        BadMap{"TooLarge", with_walls("\"walls\": [" + repeated("[0, 1], ", 6'400'000) + "[0, 1]]"),
               "too large"},
        BadMap{"Empty", "", "line 1"}),
    [](const auto& map) { return std::string(map.param.name); });

TEST(Vectorize, WhatIsAskedOfAPlainImageIsNotTakenForAYamlFile) {
  const ScratchFolder scratch;
  const auto file = scratch / "map.yaml";
  std::ofstream(file) << "image: map.pgm\n";
  const Finished refused =
      run({program("pico-vectorize"), file, scratch / "map.json", "--free", "0.5"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.output.find("YAML"), std::string::npos) << refused.output;
}

}  // namespace
}  // namespace perceptor::test
