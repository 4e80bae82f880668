#include "tools/eval/line_reader.hpp"

#include <gmock/gmock.h>

#include "tests/unit/tools/eval/text_file.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::EndsWith;
using testing::error_of;
using ::testing::HasSubstr;

class LineReaderTest : public ::testing::Test {
 protected:
  LineReader reader(const std::string& text) const {
    testing::write_plain(folder_ / "file", text);
    return LineReader(folder_ / "file");
  }

  TemporaryFolder folder_;
};

TEST_F(LineReaderTest, PassesOverCommentsAndEmptyLines) {
  LineReader line = reader("# remark\n\n  # another\nA 1 -2.5\r\n\t B\n");
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.word("a word"), "A");
  EXPECT_EQ(line.integer(0, 5, "an integer"), 1);
  EXPECT_EQ(line.number("a number"), -2.5);
  line.end();
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.word("a word"), "B");
  line.end();
  EXPECT_FALSE(line.next());
}

TEST_F(LineReaderTest, TheLastLineNeedsNoNewline) {
  LineReader line = reader("A\nB");
  EXPECT_TRUE(line.next());
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.word("a word"), "B");
  EXPECT_FALSE(line.next());
}

TEST_F(LineReaderTest, ReadsALineOfManyBlocks) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "1.25 ";
  for (const bool is_gzipped : {false, true}) {
    const auto file = folder_ / "long";
    if (is_gzipped) {
      testing::write_gzipped(file, text + "\nlast");
    } else {
      testing::write_plain(file, text + "\nlast");
    }
    LineReader line(file);
    ASSERT_TRUE(line.next());
    double sum = 0.0;
    for (int i = 0; i < 100000; ++i) sum += line.number("a number");
    EXPECT_EQ(sum, 125000.0);
    ASSERT_TRUE(line.next());
    EXPECT_EQ(line.word("a word"), "last");
  }
}

TEST_F(LineReaderTest, SaysWhereWhatWasExpectedAndWhatIsThere) {
  LineReader line = reader("1\n\n2 x 7 inf\n");
  line.next();
  line.next();
  EXPECT_EQ(line.integer(2, 2, "two"), 2);
  EXPECT_THAT(error_of<TextFileError>([&] { line.number("a number"); }),
              EndsWith("file:3: expected a number, found \"x\""));
  EXPECT_THAT(error_of<TextFileError>([&] { line.integer(1, 6, "a die"); }),
              HasSubstr(":3: expected a die, found \"7\""));
  EXPECT_THAT(error_of<TextFileError>([&] { line.finite("a length"); }),
              HasSubstr(":3: expected a length, found \"inf\""));
  EXPECT_THAT(error_of<TextFileError>([&] { line.word("more"); }),
              HasSubstr(":3: expected more, the line ends"));
}

TEST_F(LineReaderTest, RefusesWhatIsLeftOnALine) {
  LineReader line = reader("1 2");
  line.next();
  line.number("a number");
  EXPECT_THAT(error_of<TextFileError>([&] { line.end(); }),
              HasSubstr(":1: expected the end of the line, found \"2\""));
}

TEST_F(LineReaderTest, SaysThatAFileIsNotThereOrAFolder) {
  EXPECT_THAT(error_of<TextFileError>([&] { LineReader(folder_ / "none"); }),
              HasSubstr("cannot open"));
  EXPECT_THAT(error_of<TextFileError>([&] { LineReader(folder_.path()).next(); }),
              HasSubstr("cannot read"));
}

TEST_F(LineReaderTest, SaysThatAGzippedFileIsCutOff) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i * 7919 % 10007) + "\n";
  const auto file = folder_ / "cut.gz";
  testing::write_gzipped(file, text);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto read_all = [&] {
    LineReader line(file);
    while (line.next()) {
    }
  };
  EXPECT_THAT(error_of<TextFileError>(read_all), HasSubstr("cut off"));
}

TEST_F(LineReaderTest, RefusesAnEndlessLine) {
  LineReader line = reader(std::string(5'000'000, 'x'));
  EXPECT_THAT(error_of<TextFileError>([&] { line.next(); }), HasSubstr("endless"));
}

}  // namespace
}  // namespace perceptor
