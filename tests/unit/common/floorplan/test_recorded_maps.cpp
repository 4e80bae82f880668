/// @file The maps of others, found in PERCEPTOR_DATA or beside the source tree.
#include <cstdlib>

#include <gmock/gmock.h>

#include "common/floorplan/floorplan.hpp"

namespace perceptor {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::filesystem::path data_folder() {
  const char* chosen = std::getenv("PERCEPTOR_DATA");  // NOLINT(concurrency-mt-unsafe)
  if (chosen != nullptr) return chosen;
  return std::filesystem::path(PERCEPTOR_SOURCE_DIR) / ".." / "shared" / "data";
}

class RecordedMaps : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data_folder() / "maps"))
      GTEST_SKIP() << "no recorded maps in " << data_folder() << "; set PERCEPTOR_DATA";
  }
  static Floorplan read(const std::string& name) {
    return read_floorplan(data_folder() / "maps" / name);
  }
};

TEST_F(RecordedMaps, ReadsTheHospitalOf2019) {
  const Floorplan plan = read("hospital_2019.json");
  EXPECT_EQ(plan.points.size(), 56U);
  EXPECT_EQ(plan.walls.size(), 40U);
  EXPECT_EQ(plan.cabinets.size(), 4U);
  EXPECT_THAT(plan.ignored, IsEmpty());
}

TEST_F(RecordedMaps, ReadsTheOfficialExample) {
  const Floorplan plan = read("emc_example.json");
  EXPECT_EQ(plan.points.size(), 20U);
  EXPECT_EQ(plan.walls.size(), 12U);
  EXPECT_EQ(plan.cabinets.size(), 2U);
}

TEST_F(RecordedMaps, IgnoresWhatStudentsAddedAndSaysSo) {
  const Floorplan plan = read("hospital_2019_with_nodes.json");
  EXPECT_EQ(plan.walls.size(), 40U);
  EXPECT_THAT(plan.ignored, UnorderedElementsAre("/start", "/nodes", "/nodelinks"));
}

TEST_F(RecordedMaps, ReadsChainsThatTouchCabinets) {
  const Floorplan plan = read("open_chains.json");
  EXPECT_EQ(plan.walls.size(), 12U);
  EXPECT_EQ(plan.cabinets.size(), 4U);
}

}  // namespace
}  // namespace perceptor
