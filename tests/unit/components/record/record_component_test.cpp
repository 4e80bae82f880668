#include "components/record/record_component.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <pico/odometry_t.hpp>

#include "common/bus/channels.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::HasSubstr;

class RecordComponentTest : public testing::Test {
 protected:
  RecordComponentTest() { config_.file = folder_ / "a.lcmlog"; }

  void send(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
    lcm_.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void send(std::int64_t seq) {
    pico::odometry_t odometry{};
    odometry.utime = seq;
    odometry.seq = seq;
    send(channel::odometry, messages::encode(odometry));
  }

  /// One start of the process.
  struct Run {
    explicit Run(RecordComponentTest& test)
        : bus(test.lcm_, test.lcm_, test.status_), record(test.config_, bus) {}
    Bus bus;
    RecordComponent record;
  };

  std::string refusal() {
    try {
      const Run run(*this);
    } catch (const config::Error& error) {
      return error.what();
    }
    return {};
  }

  std::vector<std::string> recorded() const {
    std::vector<std::string> channels;
    LogReader reader(config_.file);
    for (LogEvent event; reader.next(event);) channels.push_back(event.channel);
    return channels;
  }

  TemporaryFolder folder_;
  RecordConfig config_;
  lcm::LCM lcm_{"memq://"};
  Status status_{"record", 1};
};

TEST_F(RecordComponentTest, RecordsEveryChannelAndTellsWhatIsMissingOfOurs) {
  {
    Run run(*this);
    send(1);
    send(4);
    send("SOMEBODY_ELSES", {1, 2, 3});
    send("STATUS_ANYTHING", {1});
    send(channel::odometry, {1, 2, 3});
    send("LCM_SELF_TEST", {});
    send("not\x7fprintable", {});
    run.record.finish();
  }
  EXPECT_EQ(recorded(),
            (std::vector<std::string>{"PICO_ODOMETRY", "PICO_ODOMETRY", "SOMEBODY_ELSES",
                                      "STATUS_ANYTHING", "PICO_ODOMETRY"}));
  const pico::status_t status = status_.message(0, true);
  ASSERT_EQ(status.inputs.size(), 3U);
  EXPECT_EQ(status.inputs[0].channel, "PICO_ODOMETRY");
  EXPECT_EQ(status.inputs[0].received, 3);
  EXPECT_EQ(status.inputs[0].missed, 2);
  EXPECT_EQ(status.inputs[1].channel, "STATUS_*");
  EXPECT_EQ(status.inputs[2].channel, "other channels");
  EXPECT_EQ(status.inputs[2].received, 2);
  EXPECT_EQ(status.inputs[2].rejected, 1);
  EXPECT_THAT(status.note, HasSubstr("a.lcmlog"));
}

TEST_F(RecordComponentTest, RefusesAFileThatIsThereAndAppendsOrReplacesWhenTold) {
  {
    const Run run(*this);
    send(1);
  }
  EXPECT_THAT(refusal(), HasSubstr("is there already"));
  config_.existing = RecordConfig::Existing::append;
  {
    const Run run(*this);
    send(2);
  }
  EXPECT_EQ(recorded().size(), 2U);
  config_.existing = RecordConfig::Existing::replace;
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(recorded().size(), 0U);
}

TEST_F(RecordComponentTest, DoesNotBeginWhereTooLittleIsFree) {
  config_.min_free = 1e9;
  EXPECT_THAT(refusal(), HasSubstr("min_free, 1000000000 MB"));
  EXPECT_FALSE(std::filesystem::exists(config_.file));
  std::ofstream(config_.file) << "x";
  config_.existing = RecordConfig::Existing::append;
  EXPECT_EQ(refusal(), "") << "a recording that goes on is not stopped by that";
}

TEST_F(RecordComponentTest, DoesNotBeginWhereItCannotWrite) {
  config_.file = folder_ / "absent" / "a.lcmlog";
  config_.min_free = 0.0;
  EXPECT_THAT(refusal(), HasSubstr("cannot write"));
}

TEST(RecordConfig, FileHoldsTheDefaults) {
  RecordConfig defaults;
  RecordConfig read;
  read.file = "another";
  config::load_file(std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config" / "record.json",
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](RecordConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

}  // namespace
}  // namespace perceptor
