#include "tools/eval/scan_set_reader.hpp"

#include <gmock/gmock.h>

#include "tests/unit/tools/eval/text_file.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::Eq;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Optional;

const std::string kHeader = "H 3 -0.5 0.5 0.01 10 0.02\n";
const std::string kScans = "# lxscan 1\n" + kHeader +
                           "# map hall\nS 4 1.5 1 2 0.1 3 4 0.2 1.0 0 2.5\n" +
                           "S 7 2.5 0 0 0 0 0 0 0 0 0\n";
const std::string kTruth =
    "# the first scan\n"
    "T 4 11 0 2 2 1 1 -0.5 2 0.5\n"
    "T 4 12 1 1 0 0 1 0 1 0\n"
    "K 4 0.5 0.6 1 0\n"
    "K 4 -0.5 0.6 -1 1\n"
    "D 7 1 0 2 0\n";

class ScanSetReader : public ::testing::Test {
 protected:
  ScanSet scans(const std::string& text) const {
    testing::write_plain(folder_ / "a.scan", text);
    return read_scans(folder_ / "a.scan");
  }
  ScanSet labelled(const std::string& truth) const {
    ScanSet set = scans(kScans);
    testing::write_plain(folder_ / "a.truth", truth);
    read_truth(folder_ / "a.truth", set);
    return set;
  }
  std::string fault(const std::string& text) const {
    return error_of<TextFileError>([&] { scans(text); });
  }
  std::string truth_fault(const std::string& text) const {
    return error_of<TextFileError>([&] { labelled(text); });
  }

  TemporaryFolder folder_;
};

TEST_F(ScanSetReader, ReadsScans) {
  const ScanSet set = scans(kScans);
  EXPECT_FALSE(set.has_truth);
  ASSERT_EQ(set.scans.size(), 2U);
  const LabelledScan& first = set.scans[0];
  EXPECT_EQ(first.id, 4);
  EXPECT_EQ(first.time, 1.5);
  EXPECT_EQ(first.odometry, (Position{1.0, 2.0, 0.1}));
  EXPECT_EQ(first.laser_in_world, (Position{3.0, 4.0, 0.2}));
  EXPECT_EQ(first.scan.laser_in_robot, Position{});
  EXPECT_EQ(first.scan.valid_min, 0.01);
  EXPECT_EQ(first.scan.valid_max, 10.0);
  EXPECT_EQ(first.scan.range_sigma, 0.02);
  EXPECT_EQ(first.scan.time_increment, 0.0);
  EXPECT_THAT(first.scan.bearings, ElementsAre(-0.5, 0.0, 0.5));
  EXPECT_THAT(first.scan.ranges, ElementsAre(1.0, 0.0, 2.5));
  EXPECT_EQ(count_returns(first.scan), 2U);
  EXPECT_EQ(set.scans[1].id, 7);
}

TEST_F(ScanSetReader, ReadsGzippedScansAlike) {
  testing::write_gzipped(folder_ / "b.scan.gz", kScans);
  const ScanSet set = read_scans(folder_ / "b.scan.gz");
  ASSERT_EQ(set.scans.size(), 2U);
  EXPECT_EQ(set.scans[0].scan.ranges, scans(kScans).scans[0].scan.ranges);
}

TEST_F(ScanSetReader, ReadsTheTruth) {
  const ScanSet set = labelled(kTruth);
  EXPECT_TRUE(set.has_truth);
  const std::vector<TruePiece>& pieces = set.scans[0].pieces;
  const std::vector<TrueCorner>& corners = set.scans[0].corners;
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].edge, 11);
  EXPECT_EQ(pieces[0].first_beam, 0U);
  EXPECT_EQ(pieces[0].last_beam, 2U);
  EXPECT_EQ(pieces[0].returns, 2U);
  EXPECT_TRUE(pieces[0].has_to_be_found);
  EXPECT_EQ(pieces[0].segment.a, Vector2(1.0, -0.5));
  EXPECT_EQ(pieces[0].segment.b, Vector2(2.0, 0.5));
  EXPECT_FALSE(pieces[1].has_to_be_found);
  ASSERT_EQ(corners.size(), 2U);
  EXPECT_EQ(corners[0].location, Vector2(0.5, 0.6));
  EXPECT_TRUE(corners[0].is_convex);
  EXPECT_FALSE(corners[0].has_to_be_found);
  EXPECT_FALSE(corners[1].is_convex);
  EXPECT_TRUE(corners[1].has_to_be_found);
  EXPECT_TRUE(set.scans[0].doors.empty());
  ASSERT_EQ(set.scans[1].doors.size(), 1U);
  EXPECT_EQ(set.scans[1].doors[0].b, Vector2(2.0, 0.0));
}

TEST_F(ScanSetReader, SaysWhatIsWrongWithScans) {
  EXPECT_THAT(fault("# nothing\n"), EndsWith("a.scan: holds no scan"));
  EXPECT_THAT(fault("S 1 0 0 0 0 0 0 0 1\n"), EndsWith(":1: expected the header, H, found \"S\""));
  EXPECT_THAT(fault(kHeader + kHeader), HasSubstr(":2: expected S, found \"H\""));
  EXPECT_THAT(fault(kHeader + "T 1\n"), HasSubstr(":2: expected S, found \"T\""));
  EXPECT_THAT(fault("H 0 0 0.1 0 10 0.01\n"), HasSubstr(":1: expected a number of beams"));
  EXPECT_THAT(fault("H 999999999 0 0.1 0 10 0.01\n"), HasSubstr("a number of beams"));
  EXPECT_THAT(fault("H 3 0 -0.1 0 10 0.01\n"), HasSubstr("a positive angle_increment"));
  EXPECT_THAT(fault("H 3 0 0.1 10 10 0.01\n"), HasSubstr("range_max above range_min"));
  EXPECT_THAT(fault("H 3 0 0.1 0 10 0\n"), HasSubstr("a positive range_sigma, found \"0\""));
  EXPECT_THAT(fault("H 3 0 0.1 0 10\n"), HasSubstr("a positive range_sigma, the line ends"));
  EXPECT_THAT(fault(kHeader + "S 1 0 0 0 0 0 0 0 1 2\n"),
              HasSubstr(":2: expected a range for each beam, the line ends"));
  EXPECT_THAT(fault(kHeader + "S 1 0 0 0 0 0 0 0 1 2 3 4\n"),
              HasSubstr(":2: expected the end of the line, found \"4\""));
  EXPECT_THAT(fault(kScans + "S 4 0 0 0 0 0 0 0 1 2 3\n"),
              HasSubstr(":6: expected an id that no scan before it has, found \"4\""));
}

TEST_F(ScanSetReader, SaysWhatIsWrongWithTheTruth) {
  EXPECT_THAT(truth_fault("W 4 0 0 1 1\n"), HasSubstr(":1: expected T, K or D, found \"W\""));
  EXPECT_THAT(truth_fault("# \nK 5 0 0 1 1\n"),
              EndsWith("a.truth:2: expected the id of a scan of the set, found \"5\""));
  EXPECT_THAT(truth_fault("T 4 1 0 3 3 1 0 0 1 1\n"),
              HasSubstr(":1: expected a beam, 0 to 2, found \"3\""));
  EXPECT_THAT(truth_fault("T 4 1 2 1 1 1 0 0 1 1\n"), HasSubstr("a beam, 2 to 2, found \"1\""));
  EXPECT_THAT(truth_fault("T 4 1 0 2 4 1 0 0 1 1\n"), HasSubstr("number of returns"));
  EXPECT_THAT(truth_fault("T 4 1 0 2 3 2 0 0 1 1\n"), HasSubstr("must, 0 or 1"));
  EXPECT_THAT(truth_fault("K 4 0 0 0 1\n"), HasSubstr("a kind, 1 or -1, found \"0\""));
  EXPECT_THAT(truth_fault("D 4 0 0 1\n"), HasSubstr("a coordinate, the line ends"));
  EXPECT_THAT(truth_fault("D 4 0 0 1 nan\n"), HasSubstr("a coordinate, found \"nan\""));
}

TEST_F(ScanSetReader, FindsTheTruthBesideTheScans) {
  EXPECT_FALSE(default_truth_file(folder_ / "c.scan"));
  testing::write_plain(folder_ / "c.truth.gz", "");
  EXPECT_THAT(default_truth_file(folder_ / "c.scan"), Optional(Eq(folder_ / "c.truth.gz")));
  EXPECT_THAT(default_truth_file(folder_ / "c.scan.gz"), Optional(Eq(folder_ / "c.truth.gz")));
  testing::write_plain(folder_ / "c.truth", "");
  EXPECT_THAT(default_truth_file(folder_ / "c.scan"), Optional(Eq(folder_ / "c.truth")));
  EXPECT_THAT(default_truth_file(folder_ / "c.scan.gz"), Optional(Eq(folder_ / "c.truth.gz")));
  EXPECT_FALSE(default_truth_file(folder_ / "c.txt"));
}

}  // namespace
}  // namespace perceptor
