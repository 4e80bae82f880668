#include "tools/eval/scan_set_writer.hpp"

#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

LabelledScan three_beams() {
  LabelledScan labelled;
  labelled.id = 7;
  labelled.time = 0.35;
  labelled.odometry = {1.0, 2.0, -0.5};
  labelled.laser_in_world = {1.25, 2.123456, -0.51234567};
  labelled.scan.valid_min = 0.01;
  labelled.scan.valid_max = 10.0;
  labelled.scan.range_sigma = 0.01;
  labelled.scan.bearings = {-2.0, 0.0, 2.0};
  labelled.scan.ranges = {1.23456, 0.0, std::numeric_limits<double>::infinity()};
  labelled.pieces.push_back({.edge = 3,
                             .first_beam = 0,
                             .last_beam = 2,
                             .returns = 1,
                             .has_to_be_found = false,
                             .segment = {{1.0, -2.0}, {3.000004, 4.0}}});
  labelled.corners.push_back({{0.5, -0.25}, true, true});
  labelled.corners.push_back({{1.5, -0.25}, false, false});
  labelled.doors.push_back({{0.0, 1.0}, {0.0, 2.0}});
  return labelled;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ScanSetWriter, WritesScansInTheFormatOfTheGivenSets) {
  std::ostringstream out;
  write_scans(out, {.scans = {three_beams()}, .footprint = {}, .has_truth = true});
  EXPECT_EQ(out.str(),
            "# lxscan 1  (see FORMAT.md)\n"
            "H 3 -2.000000000 2.000000000 0.010 10.000 0.0100\n"
            "S 7 0.3500 1.00000 2.00000 -0.500000 1.25000 2.12346 -0.512346 1.2346 0 0\n");
}

TEST(ScanSetWriter, WritesTheTruth) {
  std::ostringstream out;
  write_truth(out, {.scans = {three_beams()}, .footprint = {}, .has_truth = true});
  EXPECT_EQ(out.str(),
            "T 7 3 0 2 1 0 1.00000 -2.00000 3.00000 4.00000\n"
            "K 7 0.50000 -0.25000 1 1\n"
            "K 7 1.50000 -0.25000 -1 0\n"
            "D 7 0.00000 1.00000 0.00000 2.00000\n");
}

TEST(ScanSetWriter, WritesTheTruthBesideTheScans) {
  const TemporaryFolder folder;
  const ScanSet set{.scans = {three_beams()}, .footprint = {}, .has_truth = true};
  write_scan_set(set, folder / "some.set.scan");
  EXPECT_THAT(contents(folder / "some.set.scan"), ::testing::StartsWith("# lxscan 1"));
  EXPECT_THAT(contents(folder / "some.set.truth"), ::testing::StartsWith("T 7"));
}

TEST(ScanSetWriter, ASetWithoutTruthHasNoFileOfIt) {
  const TemporaryFolder folder;
  write_scan_set({.scans = {three_beams()}, .footprint = {}, .has_truth = false},
                 folder / "a.scan");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.truth"));
}

TEST(ScanSetWriter, RefusesWhatOneHeaderLineCannotDescribe) {
  std::ostringstream out;
  EXPECT_THROW(write_scans(out, {}), std::invalid_argument);
  LabelledScan uneven = three_beams();
  uneven.scan.bearings[1] = 0.1;
  EXPECT_THROW(write_scans(out, {.scans = {uneven}, .footprint = {}, .has_truth = true}),
               std::invalid_argument);
  EXPECT_THROW(
      write_scans(out, {.scans = {three_beams(), uneven}, .footprint = {}, .has_truth = true}),
      std::invalid_argument);
}

TEST(ScanSetWriter, RefusesNamesAndPlacesThatCannotBe) {
  EXPECT_THROW(truth_path("a.txt"), std::invalid_argument);
  EXPECT_THROW(write_scan_set({.scans = {three_beams()}, .footprint = {}, .has_truth = true},
                              "no/such/folder/a.scan"),
               std::runtime_error);
}

}  // namespace
}  // namespace perceptor
