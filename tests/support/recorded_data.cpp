#include "tests/support/recorded_data.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace perceptor::testing {
namespace {

std::filesystem::path data_folder() {
  // Tests do not change their environment.
  const char* folder = std::getenv("PERCEPTOR_DATA");  // NOLINT(concurrency-mt-unsafe)
  return folder != nullptr && *folder != '\0' ? folder : PERCEPTOR_DEFAULT_DATA;
}

/// For a shell, whatever is in the name.
std::string quoted(const std::string& name) {
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  std::array<char, 65536> block{};
  for (std::size_t got = 1; got > 0;) {
    got = std::fread(block.data(), 1, block.size(), pipe);
    output.append(block.data(), got);
  }
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return output;
}

}  // namespace

std::optional<std::filesystem::path> recorded(std::string_view relative) {
  const std::filesystem::path file = data_folder() / relative;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  return file;
}

std::string unpacked(const std::filesystem::path& file) {
  if (file.extension() == ".xz") return output_of("xz -dc -- " + quoted(file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string missing_data_message(std::string_view relative) {
  return "no recorded data here: " + (data_folder() / relative).string() +
         " is missing (PERCEPTOR_DATA names the folder)";
}

}  // namespace perceptor::testing
