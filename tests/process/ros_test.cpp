/// The bridge, a master and a robot that speaks ROS 1: real processes, apart from the world.
///
/// PERCEPTOR_ROS_SECONDS: how long the test lasts that no scan is lost (10; 60 shows it for good).
#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/open_door_t.hpp>
#include <pico/speak_t.hpp>
#include <pico/velocity_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/process/fake_pico/measurements.hpp"
#include "tests/process/ros_fixture.hpp"
#include "tests/support/sanitized.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::int64_t monotonic() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

double seconds_since(std::int64_t then) { return seconds_between(then, monotonic()); }

/// What the fake PICO wrote down.
class Journal {
 public:
  struct Velocity {
    std::int64_t time = 0;  ///< [us, monotonic]
    Twist twist;

    bool is_zero() const { return twist.vx == 0.0 && twist.vy == 0.0 && twist.va == 0.0; }
  };

  explicit Journal(const fs::path& file) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string word;
      Velocity velocity;
      words >> word;
      if (word == "base") words >> base;
      if (word == "open_door") ++open_doors;
      if (word == "speak") words >> velocity.time, spoken.push_back(rest_of(words));
      if (word != "velocity") continue;
      words >> velocity.time >> velocity.twist.vx >> velocity.twist.vy >> velocity.twist.va;
      velocities.push_back(velocity);
    }
  }

  /// The first zero that was heard after a time; none: none was.
  std::optional<std::int64_t> zero_after(std::int64_t time) const {
    for (const Velocity& velocity : velocities)
      if (velocity.time > time && velocity.is_zero()) return velocity.time;
    return std::nullopt;
  }

  std::int64_t base = 0;  ///< [ns]
  std::vector<Velocity> velocities;
  int open_doors = 0;
  std::vector<std::string> spoken;

 private:
  static std::string rest_of(std::istringstream& words) {
    std::string rest;
    std::getline(words >> std::ws, rest);
    return rest;
  }
};

/// The bridge as well, and what it publishes.
class RosTest : public RosFixture {
 protected:
  void SetUp() override {
    RosFixture::SetUp();
    listen<pico::laser_scan_t>(channel::laser, scans_);
    listen<pico::odometry_t>(channel::odometry, odometries_);
  }

  void start_bridge() {
    bridge_ = std::make_unique<Process>(
        std::vector<std::string>{program("pico-bridge"), "--source", "ros"},
        scratch_ / "bridge.log");
  }
  /// Throws, which ends the test, where they do not hear each other.
  void start_all(const std::vector<std::string>& robot = {}) {
    start_master();
    start_robot(robot);
    start_bridge();
    if (!robot_hears(Seconds(10))) throw std::runtime_error("not heard: " + said_by_bridge());
    if (!data_comes(Seconds(10))) throw std::runtime_error("no data: " + said_by_bridge());
  }

  /// Takes what comes for so long.
  void listen_for(double seconds) {
    status_.wait_until([] { return false; }, Seconds(seconds));
  }
  /// A new scan and a new odometry came.
  bool data_comes(Seconds at_most) {
    scans_.clear();
    odometries_.clear();
    return status_.wait_until([&] { return !scans_.empty() && !odometries_.empty(); }, at_most);
  }
  /// Whoever begins to listen is told to stand still: what is said before that reaches nobody.
  bool robot_hears(Seconds at_most) {
    return status_.wait_until([&] { return !journal().velocities.empty(); }, at_most);
  }
  const pico::status_t& bridge_status() { return status_.last("bridge"); }
  bool status_says(const std::string& text, Seconds at_most = Seconds(5)) {
    return status_.wait_until([&] { return bridge_status().note.find(text) != std::string::npos; },
                              at_most);
  }
  int state_of(const std::string& input) {
    for (const auto& entry : bridge_status().inputs)
      if (entry.channel == input) return entry.state;
    return -1;
  }
  std::string said_by_bridge() const {
    std::ostringstream text;
    text << std::ifstream(scratch_ / "bridge.log").rdbuf();
    return text.str();
  }
  Journal journal() const { return Journal(scratch_ / "journal"); }

  /// Commands at 20 Hz for so long, and until then whatever comes is taken.
  void drive(const Twist& twist, double seconds) {
    constexpr double period = 0.05;
    for (int i = 0; i < static_cast<int>(seconds / period); ++i) {
      pico::velocity_t command{};
      command.vx = twist.vx;
      command.vy = twist.vy;
      command.va = twist.va;
      status_.lcm().publish(channel::velocity, &command);
      listen_for(period);
    }
  }

  StatusListener status_;
  std::unique_ptr<Process> bridge_;
  std::vector<pico::laser_scan_t> scans_;
  std::vector<pico::odometry_t> odometries_;

 private:
  template <class Message>
  void listen(const char* channel, std::vector<Message>& messages) {
    auto* subscription = lcm_subscribe(
        status_.lcm().getUnderlyingLCM(), channel,
        [](const lcm_recv_buf_t* buffer, const char*, void* all) {
          Message message;
          const Bus::Bytes bytes{static_cast<const std::uint8_t*>(buffer->data), buffer->data_size};
          if (detail::decode(bytes, message).empty())
            static_cast<std::vector<Message>*>(all)->push_back(message);
        },
        &messages);
    lcm_subscription_set_queue_capacity(subscription, 0);
  }
};

/// [us] As ROS's stamps are rounded.
std::int64_t utime_of(std::int64_t stamp) { return (stamp + 500) / 1000; }

/// The robot's own measurements, made once more, in the order of their kind.
struct Sent {
  std::vector<RosFace::Scan> scans;
  std::vector<RosFace::Odometry> odometries;

  Sent(const FakeOptions& options, std::int64_t base, std::int64_t last_utime) {
    Measurements measurements(options, base);
    std::int64_t newest = 0;
    while (newest <= last_utime + 100'000) {
      Measurements::Due due = measurements.next();
      if (due.odometry) newest = utime_of(due.odometry->stamp);
      if (due.odometry) odometries.push_back(*due.odometry);
      if (due.scan) scans.push_back(std::move(*due.scan));
    }
  }
};

/// Where in what was sent the first that was received is.
template <class SentMessage, class Received>
std::size_t place_of_first(const std::vector<SentMessage>& sent, const Received& first) {
  const auto found =
      std::ranges::find(sent, first.utime, [](const SentMessage& s) { return utime_of(s.stamp); });
  EXPECT_NE(found, sent.end()) << "a message that was never sent";
  return static_cast<std::size_t>(found - sent.begin());
}

struct Kind {
  std::string model;
  std::string miss;
  FakeOptions options;
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.model << '_' << kind.miss; }

class EachRobot : public RosTest, public testing::WithParamInterface<Kind> {};

TEST_P(EachRobot, EveryValueAndStampComesAsItWasSent) {
  const Kind& kind = GetParam();
  start_all({"--model", kind.model, "--miss", kind.miss});
  listen_for(3.0);
  ASSERT_GT(scans_.size(), 60U);

  FakeOptions options = kind.options;
  options.world = source("config/worlds/hospital.json");
  const Sent sent(options, journal().base, scans_.back().utime);
  options.miss = Miss::infinity;
  const Sent missed(options, journal().base, scans_.back().utime);

  const std::size_t first = place_of_first(sent.scans, scans_.front());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const pico::laser_scan_t& scan = scans_[i];
    const RosFace::Scan& expected = sent.scans.at(first + i);
    ASSERT_EQ(scan.utime, utime_of(expected.stamp)) << "scan " << i << ": one is missing";
    ASSERT_EQ(scan.ranges.size(), expected.ranges.size());
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      ASSERT_EQ(scan.ranges[beam], expected.ranges[beam]) << "scan " << i << ", beam " << beam;
      const bool is_miss = std::isinf(missed.scans.at(first + i).ranges[beam]);
      ASSERT_NE(is_return(to_model(scan), scan.ranges[beam]), is_miss)
          << scan.ranges[beam] << " of beam " << beam;
    }
    ASSERT_EQ(static_cast<float>(scan.angle_min), static_cast<float>(expected.angle_min));
    ASSERT_EQ(static_cast<float>(scan.angle_increment),
              static_cast<float>(expected.angle_increment));
    ASSERT_EQ(static_cast<float>(scan.time_increment), static_cast<float>(expected.time_increment));
  }

  const std::size_t first_odometry = place_of_first(sent.odometries, odometries_.front());
  for (std::size_t i = 0; i < odometries_.size(); ++i) {
    const RosFace::Odometry& expected = sent.odometries.at(first_odometry + i);
    const pico::pose_t& pose = odometries_[i].robot_in_odometry;
    ASSERT_EQ(odometries_[i].utime, utime_of(expected.stamp)) << "odometry " << i;
    ASSERT_EQ(pose.x, expected.x);
    ASSERT_EQ(pose.y, expected.y);
    ASSERT_NEAR(pose.a, expected.a, 1e-15) << "half angles, there and back";
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, EachRobot,
    testing::Values(Kind{"pico", "zero", {{}, Model::pico, Miss::zero}},
                    Kind{"pico", "infinity", {{}, Model::pico, Miss::infinity}},
                    Kind{"pico", "range_max", {{}, Model::pico, Miss::range_max}},
                    Kind{"simulator", "zero", {{}, Model::simulator, Miss::zero}},
                    Kind{"simulator", "infinity", {{}, Model::simulator, Miss::infinity}},
                    Kind{"simulator", "range_max", {{}, Model::simulator, Miss::range_max}}),
    [](const auto& which) { return which.param.model + "_" + which.param.miss; });

TEST_F(RosTest, NothingIsLostAtFortyHertzOf1081Beams) {
  const char* asked = std::getenv("PERCEPTOR_ROS_SECONDS");
  const double seconds = asked == nullptr ? 10.0 : std::atof(asked);
  start_all({"--rate", "40"});
  listen_for(seconds);
  FakeOptions options{source("config/worlds/hospital.json"), Model::pico};
  options.rate = 40.0;
  const Sent sent(options, journal().base, scans_.back().utime);
  const double too_many = static_cast<double>(scans_.size()) - 40.0 * seconds;
  EXPECT_TRUE(kSanitized || std::abs(too_many) <= 4.0) << too_many;
  const std::size_t first = place_of_first(sent.scans, scans_.front());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    ASSERT_EQ(scans_[i].utime, utime_of(sent.scans.at(first + i).stamp)) << "scan " << i;
    ASSERT_EQ(scans_[i].ranges, sent.scans.at(first + i).ranges) << "scan " << i;
    ASSERT_EQ(scans_[i].num_ranges, 1081);
    ASSERT_EQ(scans_[i].seq, scans_.front().seq + static_cast<std::int64_t>(i));
  }
  const std::size_t first_odometry = place_of_first(sent.odometries, odometries_.front());
  for (std::size_t i = 0; i < odometries_.size(); ++i)
    ASSERT_EQ(odometries_[i].utime, utime_of(sent.odometries.at(first_odometry + i).stamp));
  std::cout << scans_.size() << " scans and " << odometries_.size() << " odometries in " << seconds
            << " s, none lost\n";
}

TEST_F(RosTest, CommandsReachTheRobotWithinItsLimits) {
  start_all();
  drive({0.2, -0.1, 0.3}, 0.5);
  drive({3.0, 4.0, -9.0}, 0.5);
  pico::open_door_t door{};
  door.door = -1;
  status_.lcm().publish(channel::open_door, &door);
  pico::speak_t speech{};
  speech.text = "I am here";
  status_.lcm().publish(channel::speak, &speech);
  listen_for(0.5);

  const Journal heard = journal();
  int slow = 0;
  int fast = 0;
  for (const auto& velocity : heard.velocities) {
    if (velocity.twist.vx == 0.2 && velocity.twist.vy == -0.1 && velocity.twist.va == 0.3) ++slow;
    if (std::abs(velocity.twist.vx - 0.3) < 1e-6 && std::abs(velocity.twist.vy - 0.4) < 1e-6 &&
        velocity.twist.va == -1.2)
      ++fast;
    EXPECT_LE(std::hypot(velocity.twist.vx, velocity.twist.vy), 0.5 + 1e-6);
  }
  EXPECT_EQ(slow, 10);
  EXPECT_EQ(fast, 10);
  EXPECT_EQ(heard.open_doors, 1);
  EXPECT_THAT(heard.spoken, testing::ElementsAre("I am here"));
}

class StoppingTest : public RosTest {
 protected:
  /// The robot drives forward, as it would for ever, since some time.
  void start_driving() {
    start_all({"--drive", "command"});
    drive({0.3, 0.0, 0.0}, 1.0);
    ASSERT_FALSE(journal().velocities.empty());
    ASSERT_FALSE(journal().velocities.back().is_zero());
  }
  void expect_zero_within(double seconds, std::int64_t since) {
    listen_for(seconds + 0.3);
    const auto zero = journal().zero_after(since);
    ASSERT_TRUE(zero) << "the robot drives on";
    std::cout << "zero after " << seconds_between(since, *zero) << " s\n";
    EXPECT_LE(seconds_between(since, *zero), seconds);
    EXPECT_TRUE(journal().velocities.back().is_zero());
  }
};

TEST_F(StoppingTest, WhenCommandsStop) {
  start_driving();
  expect_zero_within(0.3, journal().velocities.back().time);
}

/// Though the driver goes on.
TEST_F(StoppingTest, WhenTheBridgeIsToldToEnd) {
  for (const int number : {SIGTERM, SIGINT}) {
    start_driving();
    const std::int64_t then = monotonic();
    bridge_->signal(number);
    drive({0.3, 0.0, 0.0}, 0.5);
    expect_zero_within(0.3, then);
    EXPECT_EQ(bridge_->wait(Seconds(7)), 0);
    kill(robot_);
    kill(master_);
  }
}

TEST_F(StoppingTest, WhenTheBridgeIsKilledAndStartedAgain) {
  const fs::path file = scratch_ / "launch.json";
  std::ofstream(file)
      << R"({"processes": [{"name": "bridge", "command": ["pico-bridge", "--source", "ros"]}]})";
  const Process launcher({source("tools/launch"), file, "--bin", program(".")},
                         scratch_ / "bridge.log");
  start_master();
  start_robot({"--drive", "command"});
  ASSERT_TRUE(data_comes(Seconds(10)));
  drive({0.3, 0.0, 0.0}, 1.0);
  const std::string parent = std::to_string(launcher.pid());
  const Finished found = run({"pgrep", "-P", parent, "-f", "/pico-bridge"});
  ASSERT_EQ(found.exit_code, 0);
  const std::int64_t then = monotonic();
  ::kill(static_cast<pid_t>(std::stol(found.output)), SIGKILL);
  expect_zero_within(1.5, then);
}

/// A robot that drives on after its own restart, or another that has just connected.
TEST_F(StoppingTest, WhenARobotConnects) {
  start_all();
  kill(robot_);
  start_robot({"--drive", "command"});
  ASSERT_TRUE(data_comes(Seconds(5)));
  listen_for(0.3);
  ASSERT_FALSE(journal().velocities.empty());
  EXPECT_TRUE(journal().velocities.front().is_zero());
}

class RestartTest : public RosTest {
 protected:
  void expect_data_within(double seconds) {
    const std::int64_t then = monotonic();
    EXPECT_TRUE(data_comes(Seconds(seconds))) << bridge_status().note;
    std::cout << "data after " << seconds_since(then) << " s\n";
  }
};

TEST_F(RestartTest, OfTheRobot) {
  start_all();
  listen_for(1.0);
  kill(robot_);
  EXPECT_TRUE(status_says("nothing on /pico/laser, nothing on /pico/odom"));
  EXPECT_TRUE(status_.wait_until([&] { return state_of("/pico/laser") == 2; }, Seconds(4)));
  start_robot();
  expect_data_within(3.0);
  EXPECT_TRUE(status_.wait_until([&] { return state_of("/pico/laser") == 1; }, Seconds(2)));
  EXPECT_EQ(bridge_status().note.find("nothing on"), std::string::npos) << bridge_status().note;
}

TEST_F(RestartTest, OfMasterAndRobot) {
  start_all();
  kill(robot_);
  kill(master_);
  EXPECT_TRUE(status_says("does not answer"));
  start_master();
  start_robot();
  expect_data_within(3.0);
  EXPECT_TRUE(status_.wait_until(
      [&] { return bridge_status().note.find("does not answer") == std::string::npos; },
      Seconds(2)));
  // Commands find their way as well.
  drive({0.2, 0.0, 0.0}, 1.5);
  ASSERT_FALSE(journal().velocities.empty());
  EXPECT_EQ(journal().velocities.back().twist.vx, 0.2);
}

/// A robot that outlives its master goes on; one that then restarts is found by the new master.
TEST_F(RestartTest, OfTheMasterAlone) {
  start_all();
  listen_for(1.0);
  kill(master_);
  start_master();
  scans_.clear();
  listen_for(4.0);
  EXPECT_NEAR(static_cast<double>(scans_.size()), 4.0 * 36.0, 8.0) << "it went on";
  kill(robot_);
  start_robot();
  expect_data_within(3.0);
}

TEST_F(RestartTest, WithoutAMasterAtFirst) {
  start_bridge();
  EXPECT_TRUE(status_says("ROS master http://localhost:11311 does not answer"));
  EXPECT_TRUE(status_says("waiting for /pico/laser, /pico/odom"));
  start_master();
  start_robot();
  expect_data_within(3.0);
  EXPECT_EQ(bridge_->stop(), 0);
}

/// One that accepts and says nothing, as over a radio link that has gone.
TEST_F(RestartTest, AMasterThatHangsHoldsNothingUp) {
  start_all();
  kill(robot_);
  master_->signal(SIGSTOP);
  EXPECT_TRUE(status_says("does not answer"));
  const std::int64_t seq = bridge_status().seq;
  listen_for(3.0);
  EXPECT_GE(bridge_status().seq, seq + 2) << "STATUS goes on";
  master_->signal(SIGCONT);
  start_robot();
  expect_data_within(3.0);
  master_->signal(SIGSTOP);
  bridge_->signal(SIGTERM);
  EXPECT_EQ(bridge_->wait(Seconds(3)), 0) << "it does not wait to take its leave";
}

TEST_F(RosTest, BrokenMessagesAreCountedAndCostNothing) {
  start_all({"--broken-period", "0.05"});
  listen_for(3.0);
  const pico::status_t& status = bridge_status();
  EXPECT_GT(rejected(status, "/pico/laser", "shorter than its lengths say"), 20);
  EXPECT_GT(scans_.size(), 80U);
  EXPECT_TRUE(kSanitized || status.rss_bytes < 50'000'000) << status.rss_bytes;
  EXPECT_EQ(bridge_->stop(), 0);
}

TEST_F(RosTest, AnotherBridgeOfTheSameNameTakesOver) {
  start_all();
  const Process other({program("pico-bridge"), "--source", "ros"}, scratch_ / "other.log");
  EXPECT_EQ(bridge_->wait(Seconds(10)), 1);
  EXPECT_THAT(said_by_bridge(), HasSubstr("with the name /pico_bridge"));
  EXPECT_TRUE(data_comes(Seconds(3))) << "from the other";
}

TEST_F(RosTest, AMasterThatIsNoAddressIsAnErrorOfUse) {
  setenv("ROS_MASTER_URI", "pico", 1);
  const Finished finished = run({program("pico-bridge"), "--source", "ros"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.output, HasSubstr("http://HOST:PORT"));
}

}  // namespace
}  // namespace perceptor::test
