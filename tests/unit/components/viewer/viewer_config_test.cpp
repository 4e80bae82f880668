#include <filesystem>

#include <gtest/gtest.h>

#include "common/config/fields.hpp"
#include "components/viewer/viewer_component.hpp"

namespace perceptor {
namespace {

TEST(ViewerConfig, FileHoldsTheDefaults) {
  ViewerConfig defaults;
  ViewerConfig read;
  read.server.port = 1;
  config::load_file(std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config" / "viewer.json",
                    [&read](config::Fields& fields) { describe(fields, read); });
  const auto text = [](ViewerConfig& config) {
    return config::print([&config](config::Fields& fields) { describe(fields, config); });
  };
  EXPECT_EQ(text(read), text(defaults));
}

}  // namespace
}  // namespace perceptor
