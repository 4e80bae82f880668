/// @file A ROS master and a robot that speaks ROS 1, for tests.
#pragma once

#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"

namespace perceptor::test {

/// Skips where there is no rosmaster to run. The master is where ROS expects it by default.
class RosFixture : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run({"which", "rosmaster"}).exit_code != 0)
      GTEST_SKIP() << "rosmaster is not installed (python3-rosmaster)";
    setenv("ROS_HOME", (scratch_ / "ros").c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    unsetenv("ROS_MASTER_URI");
  }

  void start_master() {
    master_ = std::make_unique<Process>(std::vector<std::string>{"rosmaster", "--core"},
                                        scratch_ / "master.log");
  }
  void start_robot(const std::vector<std::string>& options = {}) {
    std::vector<std::string> command{program("fake_pico"), "--world",
                                     source("config/worlds/hospital.json"), "--journal",
                                     scratch_ / "journal"};
    command.insert(command.end(), options.begin(), options.end());
    robot_ = std::make_unique<Process>(command, scratch_ / "robot.log");
  }

  /// SIGKILL, and gone.
  static void kill(std::unique_ptr<Process>& process) {
    process->signal(SIGKILL);
    process->wait(Seconds(5));
    process.reset();
  }

  ScratchFolder scratch_;
  std::unique_ptr<Process> master_;
  std::unique_ptr<Process> robot_;
};

}  // namespace perceptor::test
