/// @file What a fuzz target is: a reader of bytes that nobody vouches for.
///
/// Each target is linked twice: with libFuzzer (preset fuzz, tools/fuzz), which looks for inputs
/// that break it, and with seeds_main.cpp, which runs what is known and some thousand changes of it
/// as a test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace perceptor::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Good inputs of the target, from which others are made.
std::vector<Bytes> seeds();

inline Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// Ends the program where a promise is broken, so that the fuzzer keeps the input.
void require(bool holds, const char* promise);

/// A file that lives in memory, for readers that want a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> content = {});
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
