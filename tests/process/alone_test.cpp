/// A process that starts alone waits, says for what, and costs nothing meanwhile.
#include <csignal>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

struct Waiting {
  std::string component;
  std::vector<std::string> inputs;
};

class AloneTest : public testing::TestWithParam<Waiting> {};

TEST_P(AloneTest, SaysWhatItWaitsForWithoutABusyLoop) {
  StatusListener status;
  Process process({program("pico-" + GetParam().component)});
  const auto& last = [&]() -> const pico::status_t& { return status.last(GetParam().component); };
  ASSERT_TRUE(status.wait_until([&] { return last().seq >= 3; }));
  for (const std::string& input : GetParam().inputs)
    EXPECT_NE(last().note.find(input), std::string::npos) << last().note;
  for (const auto& input : last().inputs) EXPECT_EQ(input.state, pico::status_input_t::WAITING);
  const double share = last().cpu_s / 3.0;  // three seconds between four STATUS messages
  EXPECT_LT(share, 0.10) << "of a core, while nothing happens";
  EXPECT_EQ(process.stop(), 0);
  EXPECT_TRUE(status.wait_until([&] { return last().last; }, Seconds(2)));
}

TEST_P(AloneTest, EndsCleanlyOnTerminate) {
  StatusListener status;
  Process process({program("pico-" + GetParam().component)});
  ASSERT_TRUE(status.wait_for({GetParam().component}));
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(Seconds(5)), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Every, AloneTest,
    testing::Values(Waiting{"locate", {"PICO_ODOMETRY"}}, Waiting{"proximity", {"PICO_LASER"}},
                    Waiting{"scan", {"PICO_LASER", "POSITION"}}, Waiting{"merge", {"CURRENT_MAP"}},
                    Waiting{"identify", {"LOCAL_MAP"}}, Waiting{"globalmap", {}}),
    [](const auto& which) { return which.param.component; });

TEST(NoBus, IsSaidWithWhatToDo) {
  const Finished refused =
      run({"unshare", "-n", program("pico-scan"), "--lcm-url", "udpm://239.1.2.3:7000?ttl=0"});
  if (refused.output.find("unshare") != std::string::npos)
    GTEST_SKIP() << "no network namespace inside this one";
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.output.find("ip route add 224.0.0.0/4 dev lo"), std::string::npos)
      << refused.output;
}

}  // namespace
}  // namespace perceptor::test
