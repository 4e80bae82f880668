#include "tools/eval/pose_reference.hpp"

#include <gmock/gmock.h>

#include "tests/unit/tools/eval/text_file.hpp"
#include "tools/eval/line_reader.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class PoseReference : public ::testing::Test {
 protected:
  Trajectory poses(const std::string& text) {
    testing::write_plain(file_, text);
    return read_poses(file_);
  }
  std::vector<Relation> relations(const std::string& text) {
    testing::write_plain(file_, text);
    return read_relations(file_);
  }
  std::string poses_error(const std::string& text) {
    return testing::error_of<TextFileError>([&] { poses(text); });
  }
  std::string relations_error(const std::string& text) {
    return testing::error_of<TextFileError>([&] { relations(text); });
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "drive.ref";
};

TEST_F(PoseReference, PosesInOrderOfTimeWithOrWithoutScatter) {
  const Trajectory read = poses(
      "# frame robot\n"
      "REF 1134864630.105179 1.5 -2.5 4.0\n"
      "\n"
      "REF 1134864629.895182 1.0 -2.0 0.5 0.03\n");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].utime, 1'134'864'629'895'182);
  EXPECT_EQ(read[0].pose, (Position{1.0, -2.0, 0.5}));
  EXPECT_EQ(read[1].utime, 1'134'864'630'105'179);
  EXPECT_NEAR(read[1].pose.a, 4.0 - 2.0 * 3.14159265358979, 1e-12);
}

TEST_F(PoseReference, PosesThatAreNone) {
  EXPECT_THAT(poses_error("ODOM 1 2 3 4\n"), EndsWith("drive.ref:1: expected REF, found \"ODOM\""));
  EXPECT_THAT(poses_error("REF 1 2 3\n"), HasSubstr("the line ends"));
  EXPECT_THAT(poses_error("REF 1 2 nan 3\n"), HasSubstr("found \"nan\""));
  EXPECT_THAT(poses_error("REF 1e12 2 3 4\n"), HasSubstr("expected a time [s]"));
  EXPECT_THAT(poses_error("REF 1 2 3 4 5 6\n"), HasSubstr("expected the end of the line"));
  EXPECT_THAT(poses_error("# nothing\n"), EndsWith("holds no line REF t x y theta"));
  EXPECT_THAT(testing::error_of<TextFileError>([&] { read_poses(folder_ / "none"); }),
              HasSubstr("none"));
}

TEST_F(PoseReference, SaysWhatToDoAboutAFileOfXz) {
  EXPECT_THAT(poses_error("\xFD"
                          "7zXZ and so on"),
              EndsWith("is packed with xz: unpack it first (xz -dc)"));
  EXPECT_THAT(relations_error("\xFD"
                              "7zXZ and so on"),
              EndsWith("is packed with xz: unpack it first (xz -dc)"));
}

TEST_F(PoseReference, RelationsInThePlane) {
  const auto read = relations("976052905.167303 976052911.885496 -0.5 0.25 9 8 7 -1.5\n");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].from_utime, 976'052'905'167'303);
  EXPECT_EQ(read[0].to_utime, 976'052'911'885'496);
  EXPECT_EQ(read[0].to_in_from, (Position{-0.5, 0.25, -1.5}));
}

TEST_F(PoseReference, RelationsThatAreNone) {
  EXPECT_THAT(relations_error("REF 1 2 3 4\n"), HasSubstr("expected a time [s], found \"REF\""));
  EXPECT_THAT(relations_error("1 2 3 4 5\n"), HasSubstr("the line ends"));
  EXPECT_THAT(relations_error(""), EndsWith("holds no line t1 t2 x y z roll pitch yaw"));
}

}  // namespace
}  // namespace perceptor
