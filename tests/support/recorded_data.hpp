/// @file Recordings that are not part of the project: where they are, and what to do where
/// they are not.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace perceptor::testing {

/// A file of the recorded data, named as in its README ("logs/csail.log.xz"). Looked for in
/// the folder that PERCEPTOR_DATA names, and without it in shared/data beside the project;
/// none where it is not there.
std::optional<std::filesystem::path> recorded(std::string_view relative);

/// The contents of a file, unpacked by `xz` where its name ends in .xz. Throws
/// std::runtime_error.
std::string unpacked(const std::filesystem::path& file);

/// For the test's output: what is missing and how to have it.
std::string missing_data_message(std::string_view relative);

}  // namespace perceptor::testing

/// Skips the test, and says so, where a recording is not there.
#define PERCEPTOR_REQUIRE_RECORDED(relative)     \
  if (!::perceptor::testing::recorded(relative)) \
  GTEST_SKIP() << ::perceptor::testing::missing_data_message(relative)
