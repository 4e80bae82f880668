/// @file A file that lives as long as its test.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

namespace perceptor {

class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view text, const std::string& name = "test.json")
      : path_(std::filesystem::path(testing::TempDir()) / (unique() + name)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  /// Tests run side by side, and a test may have several files.
  static std::string unique() {
    static int count = 0;
    return std::to_string(getpid()) + "_" + std::to_string(count++) + "_";
  }

  std::filesystem::path path_;
};

}  // namespace perceptor
