#include "components/record/recording.hpp"

#include <csignal>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "tools/temporary_folder.hpp"

namespace perceptor::record {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// No file of this process may grow beyond so many bytes while this lives: a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

class RecordingTest : public testing::Test {
 protected:
  void add(int messages) {
    const std::vector<std::uint8_t> payload(100);
    for (int i = 0; i < messages; ++i) recording_.add("A", i, payload);
  }

  int events_in_file() const {
    LogReader reader(file_);
    int events = 0;
    for (LogEvent event; reader.next(event);) ++events;
    EXPECT_THAT(reader.damage(), IsEmpty());
    return events;
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.lcmlog";
  Recording recording_{file_, LogWriter::Mode::replace};
};

TEST_F(RecordingTest, HoldsWhatWasAdded) {
  add(100);
  recording_.flush();
  EXPECT_EQ(events_in_file(), 100);
  EXPECT_EQ(recording_.size(), static_cast<std::int64_t>(std::filesystem::file_size(file_)));
  EXPECT_EQ(recording_.take_lost(), 0);
}

TEST_F(RecordingTest, AFullDiskCostsWhatDoesNotFitAndIsTold) {
  add(10);
  recording_.flush();
  {
    const FullDisk full(2'000);
    add(20);
    recording_.flush();
    EXPECT_THAT(recording_.trouble(), HasSubstr("cannot write"));
    EXPECT_EQ(recording_.take_lost(), 20) << "all since the last whole event that is safe";
    add(5);
    EXPECT_EQ(recording_.take_lost(), 5);
  }
  EXPECT_EQ(events_in_file(), 10);
  recording_.flush();
  add(7);
  recording_.flush();
  EXPECT_THAT(recording_.trouble(), IsEmpty());
  EXPECT_EQ(events_in_file(), 17);
  EXPECT_EQ(recording_.take_lost(), 0);
}

TEST_F(RecordingTest, MoreThanTheBufferOnAFullDiskIsCountedToo) {
  const FullDisk full(2'000);
  add(10'000);
  recording_.flush();
  EXPECT_EQ(recording_.take_lost(), 10'000);
  EXPECT_EQ(events_in_file(), 0);
}

}  // namespace
}  // namespace perceptor::record
