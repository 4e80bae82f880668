#include "common/log/event_log.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <lcm/lcm-cpp.hpp>

#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kHeaderSize = 28;
constexpr std::size_t kDataLengthOffset = 24;
const std::string kMagic = "\xED\xA1\xDA\x01";

class EventLog : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "a.lcmlog"; }

  void write(const std::string& bytes) const { std::ofstream(file()) << bytes; }

  std::string bytes() const {
    std::ifstream in(file());
    return {std::istreambuf_iterator<char>(in), {}};
  }

  TemporaryFolder folder_;
};

/// The bytes of one event.
std::string event(const std::string& channel, const std::string& data, std::int64_t timestamp = 0) {
  std::string bytes = kMagic;
  const auto put = [&bytes](std::uint64_t value, int size) {
    for (int i = size - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i));
  };
  put(0, 8);
  put(static_cast<std::uint64_t>(timestamp), 8);
  put(channel.size(), 4);
  put(data.size(), 4);
  return bytes + channel + data;
}

/// Claims another length of data for the event that begins `bytes`.
std::string with_length(std::string bytes, std::uint32_t length) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[kDataLengthOffset + i] = static_cast<char>(length >> (8 * (3 - i)));
  return bytes;
}

std::vector<std::string> payloads(LogReader& reader) {
  std::vector<std::string> all;
  for (LogEvent e; reader.next(e);) all.emplace_back(e.data.begin(), e.data.end());
  return all;
}

TEST_F(EventLog, ReadsBackWhatItWrote) {
  LogWriter writer(file());
  const std::string data = "some data";
  writer.write("FIRST", -5, data.data(), data.size());
  writer.write(std::string(kMaxChannelLength, 'C'), std::numeric_limits<std::int64_t>::max(),
               nullptr, 0);
  writer.close();

  LogReader reader(file());
  const auto first = reader.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->number, 0);
  EXPECT_EQ(first->timestamp, -5);
  EXPECT_EQ(first->channel, "FIRST");
  EXPECT_EQ(std::string(first->data.begin(), first->data.end()), data);
  const auto second = reader.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->number, 1);
  EXPECT_EQ(second->timestamp, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(second->channel, std::string(kMaxChannelLength, 'C'));
  EXPECT_TRUE(second->data.empty());
  EXPECT_FALSE(reader.next());
  EXPECT_THAT(reader.damage(), IsEmpty());
  EXPECT_EQ(reader.offset(), reader.size());
  EXPECT_EQ(static_cast<std::uintmax_t>(reader.size()), std::filesystem::file_size(file()));
}

TEST_F(EventLog, IsReadByLcmsOwnReader) {
  LogWriter writer(file());
  for (int i = 0; i < 100; ++i) {
    const std::string data(static_cast<std::size_t>(i * 37), static_cast<char>(i));
    writer.write("CHANNEL_" + std::to_string(i % 3), 1'700'000'000'000'000 + i, data.data(),
                 data.size());
  }
  writer.close();

  lcm::LogFile log(file().string(), "r");
  ASSERT_TRUE(log.good());
  for (int i = 0; i < 100; ++i) {
    const lcm::LogEvent* e = log.readNextEvent();
    ASSERT_NE(e, nullptr);
    EXPECT_EQ(e->eventnum, i);
    EXPECT_EQ(e->timestamp, 1'700'000'000'000'000 + i);
    EXPECT_EQ(e->channel, "CHANNEL_" + std::to_string(i % 3));
    ASSERT_EQ(e->datalen, i * 37);
    EXPECT_EQ(std::string(static_cast<const char*>(e->data), static_cast<std::size_t>(e->datalen)),
              std::string(static_cast<std::size_t>(i * 37), static_cast<char>(i)));
  }
  EXPECT_EQ(log.readNextEvent(), nullptr);
}

TEST_F(EventLog, ReadsWhatLcmsOwnWriterWrote) {
  {
    lcm::LogFile log(file().string(), "w");
    for (int i = 0; i < 100; ++i) {
      std::string data(static_cast<std::size_t>(i * 41), static_cast<char>(i));
      lcm::LogEvent e;
      e.eventnum = 0;
      e.timestamp = 1000 - i;
      e.channel = "C";
      e.datalen = static_cast<std::int32_t>(data.size());
      e.data = data.data();
      ASSERT_EQ(log.writeEvent(&e), 0);
    }
  }
  LogReader reader(file());
  for (int i = 0; i < 100; ++i) {
    const auto e = reader.next();
    ASSERT_TRUE(e);
    EXPECT_EQ(e->number, i);
    EXPECT_EQ(e->timestamp, 1000 - i);
    EXPECT_EQ(e->channel, "C");
    EXPECT_EQ(e->data, std::vector<std::uint8_t>(static_cast<std::size_t>(i * 41),
                                                 static_cast<std::uint8_t>(i)));
  }
  EXPECT_FALSE(reader.next());
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST_F(EventLog, TakesNoNoticeOfMagicInsideAHealthyPayload) {
  // A log within a log: each inner event is as good as any.
  const std::string inner = event("INNER", "aaaa") + event("INNER", "bbbb");
  write(event("A", kMagic + kMagic) + event("B", inner) + event("C", inner));
  LogReader reader(file());
  EXPECT_THAT(payloads(reader), ElementsAre(kMagic + kMagic, inner, inner));
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST_F(EventLog, ReadsEventsLargerThanItsWindow) {
  const std::string large(1'000'000, 'x');
  const std::string huge(9'000'000, 'y');
  write(event("A", "small") + event("B", large) + event("C", huge) + event("D", "last"));
  LogReader reader(file());
  EXPECT_THAT(payloads(reader), ElementsAre("small", large, huge, "last"));
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST_F(EventLog, GivesTheWholeEventsOfATruncatedLog) {
  const std::string whole = event("A", "first") + event("B", "second");
  const std::string last = event("C", "third");
  for (std::size_t kept = 1; kept < last.size(); ++kept) {
    write(whole + last.substr(0, kept));
    LogReader reader(file());
    EXPECT_THAT(payloads(reader), ElementsAre("first", "second")) << kept;
    EXPECT_THAT(reader.damage(), ElementsAre(LogDamage{static_cast<std::int64_t>(whole.size()),
                                                       static_cast<std::int64_t>(kept)}));
  }
}

TEST_F(EventLog, GoesOnAfterGarbageBetweenEvents) {
  const std::string first = event("A", "first");
  const std::string garbage = "garbage" + kMagic + "more";
  write(first + garbage + event("B", "second") + event("C", "third"));
  LogReader reader(file());
  EXPECT_THAT(payloads(reader), ElementsAre("first", "second", "third"));
  EXPECT_THAT(reader.damage(), ElementsAre(LogDamage{static_cast<std::int64_t>(first.size()),
                                                     static_cast<std::int64_t>(garbage.size())}));
}

TEST_F(EventLog, LosesOneEventToADamagedLengthThatReachesIntoLaterEvents) {
  const std::string first = event("A", "first");
  const std::string bad = with_length(event("B", "bad"), 60);
  write(first + bad + event("C", "third") + event("D", "fourth") + event("E", "fifth"));
  LogReader reader(file());
  EXPECT_THAT(payloads(reader), ElementsAre("first", "third", "fourth", "fifth"));
  EXPECT_THAT(reader.damage(), ElementsAre(LogDamage{static_cast<std::int64_t>(first.size()),
                                                     static_cast<std::int64_t>(bad.size())}));
}

TEST_F(EventLog, LosesOneEventToAnImpossibleLength) {
  for (const std::uint32_t length : {0x7FFFFFFFU, 0xFFFFFFFFU, 0x80000000U, 70'000'000U, 1000U}) {
    write(event("A", "first") + with_length(event("B", "bad"), length) + event("C", "third"));
    LogReader reader(file());
    EXPECT_THAT(payloads(reader), ElementsAre("first", "third")) << length;
    EXPECT_EQ(reader.damage().size(), 1U);
  }
}

TEST_F(EventLog, LosesOneEventToABadChannel) {
  std::string no_channel = event("X", "bad");
  no_channel[23] = 0;
  for (const std::string& bad : {no_channel, event("tab\there", "bad"),
                                 event(std::string(kMaxChannelLength + 1, 'C'), "bad")}) {
    write(event("A", "first") + bad + event("C", "third"));
    LogReader reader(file());
    EXPECT_THAT(payloads(reader), ElementsAre("first", "third"));
    EXPECT_EQ(reader.damage().size(), 1U);
  }
}

TEST_F(EventLog, KeepsTheEventBeforeADamagedMagic) {
  std::string bad = event("B", "bad");
  bad[0] = 'x';
  write(event("A", "first") + bad + event("C", "third"));
  LogReader reader(file());
  EXPECT_THAT(payloads(reader), ElementsAre("first", "third"));
  EXPECT_EQ(reader.damage().size(), 1U);
}

TEST_F(EventLog, AFileThatIsNoLogIsAllDamage) {
  write("# just text\n");
  LogReader reader(file());
  EXPECT_FALSE(reader.next());
  EXPECT_THAT(reader.damage(), ElementsAre(LogDamage{0, 12}));
}

TEST_F(EventLog, AnEmptyFileHoldsNothing) {
  write("");
  LogReader reader(file());
  EXPECT_FALSE(reader.next());
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST_F(EventLog, FalseMagicsByTheThousandCostOnePass) {
  // Each claims more data than anything that follows it could confirm.
  const std::string claim = with_length(event("A", ""), 300'000);
  std::string bytes;
  while (bytes.size() < 1'000'000) bytes += claim;
  write(bytes);
  LogReader reader(file());
  payloads(reader);
  EXPECT_EQ(reader.offset(), reader.size());
}

TEST_F(EventLog, EveryByteIsEitherInAnEventOrCountedAsDamage) {
  std::mt19937_64 random(7);
  std::string healthy;
  for (int i = 0; i < 40; ++i)
    healthy += event("CHANNEL", std::string(static_cast<std::size_t>(random() % 200), 'd'));
  for (int round = 0; round < 2000; ++round) {
    std::string bytes = healthy;
    const std::size_t edits = 1 + random() % 8;
    for (std::size_t i = 0; i < edits; ++i)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    write(bytes);
    LogReader reader(file());
    std::size_t accounted = 0;
    std::size_t events = 0;
    for (LogEvent e; reader.next(e); ++events)
      accounted += kHeaderSize + e.channel.size() + e.data.size();
    for (const LogDamage& damage : reader.damage())
      accounted += static_cast<std::size_t>(damage.size);
    ASSERT_EQ(accounted, bytes.size());
    // One edit costs two events at most: a length that swallows the start of the next.
    if (bytes.size() == healthy.size()) {
      EXPECT_GE(events + 2 * edits, 40U);
    }
  }
}

TEST_F(EventLog, SaysWhichFileCannotBeOpened) {
  try {
    LogReader reader(folder_ / "absent.lcmlog");
    FAIL();
  } catch (const LogError& error) {
    EXPECT_THAT(error.what(), HasSubstr("absent.lcmlog"));
    EXPECT_THAT(error.what(), HasSubstr("No such file"));
  }
  EXPECT_THROW(LogReader{folder_.path()}, LogError);
  EXPECT_THROW(LogWriter{folder_ / "absent/a.lcmlog"}, LogError);
}

TEST_F(EventLog, RefusesToWriteWhatNoReaderWouldTake) {
  LogWriter writer(file());
  EXPECT_THROW(writer.write("", 0, "x", 1), LogError);
  EXPECT_THROW(writer.write(std::string(kMaxChannelLength + 1, 'C'), 0, "x", 1), LogError);
  EXPECT_THROW(writer.write("new\nline", 0, "x", 1), LogError);
  EXPECT_THROW(writer.write("C", 0, "x", kMaxEventData + 1), LogError);
  writer.close();
  writer.close();
  EXPECT_THROW(writer.write("C", 0, "x", 1), LogError);
  EXPECT_EQ(bytes(), "");
}

TEST_F(EventLog, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  LogWriter writer("/dev/full");
  writer.write("C", 0, "x", 1);  // fits the buffer
  EXPECT_THROW(writer.close(), LogError);
  LogWriter unbuffered("/dev/full");
  const std::string large(1'000'000, 'x');
  EXPECT_THROW(unbuffered.write("C", 0, large.data(), large.size()), LogError);
}

TEST_F(EventLog, GoesOnBehindTheLastWholeEvent) {
  const std::string whole = event("A", "first") + event("A", "second");
  const std::string cut_short = event("A", "a writer that was killed");
  for (const std::string& rest : {std::string(), cut_short.substr(0, 2), cut_short.substr(0, 40)}) {
    write(whole + rest);
    LogWriter writer(file(), LogWriter::Mode::append);
    writer.write("A", 0, "third", 5);
    writer.close();
    EXPECT_EQ(bytes(), whole + event("A", "third"));
  }
}

TEST_F(EventLog, GoesOnInALargeFileAndInOneThatIsNotThere) {
  {
    LogWriter writer(file(), LogWriter::Mode::append);
    const std::string data(50'000, 'x');
    for (int i = 0; i < 100; ++i) writer.write("A", i, data.data(), data.size());
  }
  std::filesystem::resize_file(file(), std::filesystem::file_size(file()) - 1);
  LogWriter(file(), LogWriter::Mode::append).write("A", 0, "the last", 8);
  LogReader reader(file());
  const std::vector<std::string> read = payloads(reader);
  EXPECT_EQ(read.size(), 100U);
  EXPECT_EQ(read.back(), "the last");
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST_F(EventLog, GivesUpWhatDidNotGoOutWhole) {
  LogWriter writer(file());
  writer.write("A", 0, "kept", 4);
  writer.flush();
  writer.write("A", 0, "lost", 4);
  writer.write("A", 0, "lost", 4);
  EXPECT_EQ(writer.give_up(), 2);
  EXPECT_EQ(bytes(), event("A", "kept"));
}

TEST_F(EventLog, IsKnownByItsFirstBytes) {
  write(event("A", "data"));
  EXPECT_TRUE(is_event_log(file()));
  write("# lxscan 1\n");
  EXPECT_FALSE(is_event_log(file()));
  write(kMagic.substr(0, 3));
  EXPECT_FALSE(is_event_log(file()));
  EXPECT_FALSE(is_event_log(folder_ / "none"));
  EXPECT_FALSE(is_event_log(folder_.path()));
}

}  // namespace
}  // namespace perceptor
