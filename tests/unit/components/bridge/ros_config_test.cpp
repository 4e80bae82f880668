#include "components/bridge/ros/ros_config.hpp"

#include <string>

#include <gmock/gmock.h>

namespace perceptor {
namespace {

std::string fault_of(const std::string& setting) {
  RosParameters ros;
  try {
    config::load({{}, {}, {setting}}, [&](config::Fields& fields) { describe(fields, ros); });
  } catch (const config::Error& error) {
    return error.what();
  }
  return {};
}

TEST(RosConfig, TakesTopicsAsRosWritesThem) {
  for (const char* topic : {"/scan", "/pico/laser", "/a_1/B2/c"})
    EXPECT_EQ(fault_of(std::string("laser.topic=") + topic), "");
  for (const char* topic : {"", "/", "scan", "/pico//laser", "/pico/", "/1st", "/pico laser"})
    EXPECT_THAT(fault_of(std::string("laser.topic=") + topic), ::testing::HasSubstr("/laser/topic"))
        << topic;
}

TEST(RosConfig, TakesAMasterWithHostAndPort) {
  EXPECT_EQ(fault_of("master=http://pico:11311"), "");
  EXPECT_EQ(fault_of("master="), "");
  EXPECT_THAT(fault_of("master=pico"), ::testing::HasSubstr("http://HOST:PORT"));
}

TEST(RosConfig, TakesAPlainNameForTheNode) {
  EXPECT_EQ(fault_of("node=bridge_2"), "");
  EXPECT_THAT(fault_of("node=/bridge"), ::testing::HasSubstr("/node"));
  EXPECT_THAT(fault_of("node="), ::testing::HasSubstr("/node"));
}

TEST(RosConfig, TheMasterIsWhereItIsConfiguredToBe) {
  RosParameters ros;
  ros.master = "http://pico:11311";
  EXPECT_EQ(master_uri(ros), "http://pico:11311");
}

}  // namespace
}  // namespace perceptor
