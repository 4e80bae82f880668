#include "tools/convert/bag_file.hpp"

#include <cstring>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <rosbag/bag.h>

#include "tests/support/ros1_bytes.hpp"
#include "tools/convert/conversion.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor::testing {

/// A scan or an odometry as rosbag wants it to write.
struct BagRecord {
  std::string type;
  std::string md5;
  std::vector<std::uint8_t> bytes;
};

}  // namespace perceptor::testing

namespace ros {
using perceptor::testing::BagRecord;
namespace message_traits {
template <>
struct MD5Sum<BagRecord> {
  static const char* value() { return "*"; }
  static const char* value(const BagRecord& record) { return record.md5.c_str(); }
};
template <>
struct DataType<BagRecord> {
  static const char* value() { return "*"; }
  static const char* value(const BagRecord& record) { return record.type.c_str(); }
};
template <>
struct Definition<BagRecord> {
  static const char* value() { return ""; }
  static const char* value(const BagRecord&) { return ""; }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<BagRecord> {
  template <class Stream>
  static void write(Stream& stream, const BagRecord& record) {
    std::memcpy(stream.advance(static_cast<std::uint32_t>(record.bytes.size())),
                record.bytes.data(), record.bytes.size());
  }
  // NOLINTNEXTLINE(readability-identifier-naming): roscpp asks for this name
  static std::uint32_t serializedLength(const BagRecord& record) {
    return static_cast<std::uint32_t>(record.bytes.size());
  }
};
}  // namespace serialization
}  // namespace ros

namespace perceptor {
namespace {

using testing::BagRecord;

constexpr int kScans = 50;

/// A standing robot's scans and odometry, ten a second, and what nobody asked for.
void write_bag(const std::filesystem::path& file, rosbag::CompressionType compression) {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.setCompression(compression);
  bag.setChunkThreshold(10'000);
  for (std::uint32_t i = 0; i < kScans; ++i) {
    const ros::Time time(100 + i / 10, (i % 10) * 100'000'000);
    testing::Ros1Scan scan;
    scan.seconds = time.sec;
    scan.nanoseconds = time.nsec;
    scan.angle_max = 359.0F * 0.01F - 1.0F;
    scan.angle_increment = 0.01F;
    scan.ranges.assign(360, 2.0F);
    testing::Ros1Odometry odometry;
    odometry.seconds = time.sec;
    odometry.nanoseconds = time.nsec;
    bag.write(
        "/pico/odom", time,
        BagRecord{"nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7", bytes_of(odometry)});
    bag.write(
        "/pico/laser", time,
        BagRecord{"sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369", bytes_of(scan)});
    bag.write("/chatter", time,
              BagRecord{"std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", {0, 0, 0, 0}});
  }
  bag.close();
}

class EachCompression : public ::testing::TestWithParam<rosbag::CompressionType> {};

TEST_P(EachCompression, ConvertsToScansAndOdometry) {
  const TemporaryFolder folder;
  write_bag(folder / "in.bag", GetParam());
  EXPECT_TRUE(is_bag(folder / "in.bag"));
  const ConversionSummary summary =
      convert_bag(folder / "in.bag", folder / "out.lcmlog", ConversionOptions{});
  EXPECT_EQ(summary.lines, 3 * kScans);
  EXPECT_EQ(summary.scans, kScans);
  EXPECT_EQ(summary.odometry, kScans);
  EXPECT_TRUE(summary.dropped.empty());
  EXPECT_NEAR(summary.duration, 4.9, 1e-9);
  std::ostringstream text;
  print(text, summary);
  EXPECT_THAT(text.str(), ::testing::HasSubstr("150 messages read: 50 scans, 50 odometry"));
  EXPECT_THAT(text.str(), ::testing::HasSubstr("skipped /chatter: 50 of std_msgs/String"));
}

INSTANTIATE_TEST_SUITE_P(All, EachCompression,
                         ::testing::Values(rosbag::compression::Uncompressed,
                                           rosbag::compression::BZ2, rosbag::compression::LZ4));

TEST(BagFile, ThatWasCutOffIsNotRead) {
  const TemporaryFolder folder;
  write_bag(folder / "in.bag", rosbag::compression::Uncompressed);
  const auto whole = std::filesystem::file_size(folder / "in.bag");
  for (const std::uintmax_t size : {whole / 2, whole - 10, std::uintmax_t{20}}) {
    std::filesystem::resize_file(folder / "in.bag", size);
    EXPECT_THROW(convert_bag(folder / "in.bag", folder / "out.lcmlog", {}), NotARecording);
  }
}

/// rosbag_storage crashes on some of these.
TEST(BagFile, ThatIsDamagedEndsNothing) {
  const TemporaryFolder folder;
  write_bag(folder / "in.bag", rosbag::compression::Uncompressed);
  std::ostringstream whole;
  whole << std::ifstream(folder / "in.bag", std::ios::binary).rdbuf();
  std::mt19937 random(5);
  int converted = 0;
  int cut_short = 0;
  for (int i = 0; i < 60; ++i) {
    std::string bytes = whole.str();
    for (int j = 0; j < 20; ++j)
      bytes[4200 + random() % (bytes.size() - 4200)] = static_cast<char>(random());
    std::ofstream(folder / "damaged.bag", std::ios::binary) << bytes;
    try {
      const auto summary = convert_bag(folder / "damaged.bag", folder / "out.lcmlog", {});
      ++converted;
      cut_short += static_cast<int>(summary.dropped.contains(drop_reason::damaged));
    } catch (const NotARecording& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("damaged.bag"));
    }
  }
  EXPECT_GT(converted, 0);
  std::cout << converted << " converted, " << cut_short << " of them in part\n";
}

TEST(BagFile, IsKnownByItsFirstWords) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.bag") << "ODOM 1 0 0 0\n";
  EXPECT_FALSE(is_bag(folder / "text.bag"));
  EXPECT_FALSE(is_bag(folder / "nowhere.bag"));
}

}  // namespace
}  // namespace perceptor
