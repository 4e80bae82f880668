/// Every process has the same face.
#include <fstream>
#include <utility>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

class FaceTest : public testing::TestWithParam<std::string> {
 protected:
  static Finished call(const std::string& option, const std::string& value = {}) {
    std::vector<std::string> command = {program("pico-" + GetParam()), option};
    if (!value.empty()) command.push_back(value);
    return run(command, Seconds(20));
  }
};

TEST_P(FaceTest, HelpTeaches) {
  const Finished help = call("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"--config", "--set", "--lcm-url", "--print-config", "Examples", "Exit"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
}

TEST_P(FaceTest, SaysItsVersion) {
  const Finished version = call("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.output, "pico-" + GetParam() + " " + PERCEPTOR_VERSION + "\n");
}

TEST_P(FaceTest, PrintsAConfigurationThatItReadsBack) {
  const Finished printed = call("--print-config");
  EXPECT_EQ(printed.exit_code, 0);
  const ScratchFolder scratch;
  const auto file = scratch / "printed.json";
  ASSERT_EQ(run({"sh", "-c",
                 program("pico-" + GetParam()).string() + " --print-config >" + file.string()})
                .exit_code,
            0);
  const Finished again = run({program("pico-" + GetParam()), "--config", file, "--print-config"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.output, printed.output);
}

TEST_P(FaceTest, ATypoInAKeyExitsWithTwo) {
  const Finished unknown = call("--set", "no_such_key=1");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.output.find("no_such_key"), std::string::npos);
}

TEST_P(FaceTest, AnUnknownOptionExitsWithTwo) { EXPECT_EQ(call("--nonsense").exit_code, 2); }

TEST_P(FaceTest, AFileThatIsNotThereExitsWithTwo) {
  const Finished missing = call("--config", "/nowhere/at_all.json");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.output.find("/nowhere/at_all.json"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Every, FaceTest,
                         testing::Values("bridge", "locate", "proximity", "scan", "merge",
                                         "identify", "globalmap", "localize", "viewer"),
                         [](const auto& which) { return which.param; });

TEST(Face, NamesTheNearestKeyAndTheFile) {
  const ScratchFolder scratch;
  const auto file = scratch / "scan.json";
  ASSERT_EQ(run({"sh", "-c", "echo '{\"methot\": 1}' >" + file.string()}).exit_code, 0);
  const Finished typo = run({program("pico-scan"), "--config", file});
  EXPECT_EQ(typo.exit_code, 2);
  for (const std::string& word :
       {file.string(), std::string("/methot"), std::string("did you mean \"method\"")})
    EXPECT_NE(typo.output.find(word), std::string::npos) << word << " not in " << typo.output;
}

TEST(Face, ALoneConfigurationFileTakesTheMapsAndWorldsThatThereAre) {
  const ScratchFolder scratch;
  const auto file = scratch / "mine.json";
  std::ofstream(file) << "{}";
  for (const auto& [component, option] :
       {std::pair("globalmap", "--map"), std::pair("localize", "--map"),
        std::pair("bridge", "--world")}) {
    const Finished refused = run({program(std::string("pico-") + component), "--config", file,
                                  "--lcm-url", "memq://", option, "no_such"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.output.find("hospital"), std::string::npos) << refused.output;
  }
}

}  // namespace
}  // namespace perceptor::test
