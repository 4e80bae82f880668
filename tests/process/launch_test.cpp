/// The launcher starts, restarts and stops; a killed process comes back and the chain goes on.
#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kEveryone = {"bridge", "locate", "proximity",
                                            "scan",   "merge",  "identify"};

/// All six processes under tools/launch.
class LaunchTest : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path file = scratch_ / "launch.json";
    std::ofstream out(file);
    out << R"({"processes": [)";
    for (const std::string& name : kEveryone)
      out << (name == "bridge" ? "" : ",") << R"({"name": ")" << name << R"(", "command": ["pico-)"
          << name << R"("]})";
    out << "]}";
    out.close();
    launcher_ = std::make_unique<Process>(
        std::vector<std::string>{source("tools/launch"), file, "--bin", program(".")},
        scratch_ / "output");
    lcm_subscribe(
        status_.lcm().getUnderlyingLCM(), "IDENTIFIED_MAP",
        [](const lcm_recv_buf_t* buffer, const char*, void* self) {
          pico::map_t map;
          const Bus::Bytes bytes{static_cast<const std::uint8_t*>(buffer->data), buffer->data_size};
          if (!detail::decode(bytes, map).empty()) return;
          const bool has_walls = std::ranges::any_of(
              map.objects, [](const auto& o) { return o.type == pico::map_object_t::WALL; });
          static_cast<LaunchTest*>(self)->maps_with_walls_ += has_walls ? 1 : 0;
        },
        this);
    ASSERT_TRUE(status_.wait_for(kEveryone));
    ASSERT_TRUE(map_goes_on());
  }

  /// Ten more identified maps with walls in them come out of the chain.
  bool map_goes_on() {
    const int before = maps_with_walls_;
    return status_.wait_until([&] { return maps_with_walls_ > before + 10; });
  }

  /// The processes whose parent is the launcher, by the last word of their program's name.
  std::optional<pid_t> pid_of(const std::string& component) const {
    const Finished found = run(
        {"pgrep", "-P", std::to_string(launcher_->pid()), "-f", "/pico-" + component + "( |$)"});
    if (found.exit_code != 0) return std::nullopt;
    return static_cast<pid_t>(std::stol(found.output));
  }

  std::string output() const {
    std::ostringstream text;
    text << std::ifstream(scratch_ / "output").rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
  StatusListener status_;
  std::unique_ptr<Process> launcher_;
  int maps_with_walls_ = 0;
};

TEST_F(LaunchTest, EachKilledProcessIsBackWithinASecondAndNobodyElseStops) {
  std::map<std::string, std::int64_t> boots;
  for (const std::string& name : kEveryone) boots[name] = status_.last(name).boot;

  for (const std::string& victim : kEveryone) {
    const auto pid = pid_of(victim);
    ASSERT_TRUE(pid) << victim << " has no process\n" << output();
    kill(*pid, SIGKILL);
    EXPECT_TRUE(
        status_.wait_until([&] { return status_.last(victim).boot != boots[victim]; }, Seconds(1)))
        << victim << " is not back\n"
        << output();
    boots[victim] = status_.last(victim).boot;
    for (const std::string& name : kEveryone)
      EXPECT_EQ(status_.last(name).boot, boots[name]) << name << " stopped too, after " << victim;
    EXPECT_TRUE(map_goes_on()) << "after " << victim;
    status_.wait_until([] { return false; }, Seconds(3));
  }
  EXPECT_EQ(launcher_->stop(), 0) << output();
}

TEST_F(LaunchTest, OneThatHangsIsStartedAgainAndOneThatPausesIsNot) {
  const std::int64_t boot = status_.last("scan").boot;
  const auto stop_for = [&](Seconds time) {
    const auto pid = pid_of("scan");
    ASSERT_TRUE(pid) << output();
    kill(*pid, SIGSTOP);
    status_.wait_until([] { return false; }, time);
    kill(*pid, SIGCONT);
  };
  stop_for(Seconds(2));
  EXPECT_TRUE(map_goes_on());
  EXPECT_EQ(status_.last("scan").boot, boot) << output();
  stop_for(Seconds(3));
  EXPECT_TRUE(status_.wait_until([&] { return status_.last("scan").boot != boot; }, Seconds(1)));
  EXPECT_NE(output().find("scan hangs: no sign of life for"), std::string::npos) << output();
  EXPECT_TRUE(map_goes_on());
  EXPECT_EQ(launcher_->stop(), 0) << output();
}

TEST_F(LaunchTest, ALauncherThatWasStoppedItselfKillsNobody) {
  launcher_->signal(SIGSTOP);
  status_.wait_until([] { return false; }, Seconds(4));
  launcher_->signal(SIGCONT);
  status_.wait_until([] { return false; }, Seconds(1));
  EXPECT_EQ(output().find("hangs"), std::string::npos) << output();
  EXPECT_TRUE(map_goes_on());
  EXPECT_EQ(launcher_->stop(), 0) << output();
}

TEST_F(LaunchTest, ARestartedBridgeBeginsANewSessionAndEveryoneStartsFresh) {
  const auto pid = pid_of("bridge");
  ASSERT_TRUE(pid);
  kill(*pid, SIGKILL);
  for (const std::string& name : kPerceiving)
    EXPECT_TRUE(status_.wait_until([&] {
      const auto& inputs = status_.last(name).inputs;
      return !inputs.empty() && inputs.at(0).restarts == 1;
    })) << name;
  EXPECT_TRUE(map_goes_on());
  EXPECT_EQ(launcher_->stop(), 0) << output();
}

TEST_F(LaunchTest, StopsTheSourceFirstAndLeavesNobodyBehind) {
  EXPECT_EQ(launcher_->stop(), 0);
  for (const std::string& name : kEveryone) {
    EXPECT_TRUE(status_.wait_until([&] { return status_.last(name).last; }, Seconds(2))) << name;
    EXPECT_EQ(run({"pgrep", "-f", program("pico-" + name)}).exit_code, 1) << name;
  }
}

/// Needs no bus.
TEST(Launch, WhatNeedsAValueThatIsNotGivenIsLeftOut) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "set.json")
      << R"({"processes": [{"name": "source", "command": ["true"], "finishes": true},
                           {"name": "map", "command": ["sh", "-c", "exit 2"], "needs": "map"}]})";
  const auto launch = [&](const std::string& value) {
    return run({source("tools/launch"), scratch / "set.json", "--set", "map=" + value},
               Seconds(10));
  };
  EXPECT_EQ(launch("").exit_code, 0);
  const Finished given = launch("hospital");
  EXPECT_NE(given.exit_code, 0) << given.output;
  EXPECT_NE(given.output.find("map"), std::string::npos);
}

}  // namespace
}  // namespace perceptor::test
