#include "common/config/json_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "common/config/json_builder.hpp"

namespace perceptor::config {
namespace {

using nlohmann::json;

[[noreturn]] void fail_to_read(const std::filesystem::path& file, const std::string& reason) {
  throw Error(file.string() + ": cannot be read: " + reason);
}

/// Never takes in more than a little over kMaxFileSize, however long the file is.
std::string read_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) fail_to_read(file, "it is a directory");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail_to_read(file, std::strerror(errno));

  std::string text;
  std::array<char, 65536> block{};
  while (in && text.size() <= kMaxFileSize) {
    in.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) fail_to_read(file, std::strerror(errno));
  if (text.size() > kMaxFileSize)
    throw Error(file.string() + ": too large; allowed: " + std::to_string(kMaxFileSize) + " bytes");
  return text;
}

/// Counts brackets outside of strings, so that no parser ever sees a tower of them.
void check_nesting(std::string_view text, const std::string& source) {
  int depth = 0;
  int line = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '[' || c == '{')) {
      if (++depth > kMaxNesting)
        throw Error(source + ": line " + std::to_string(line) +
                    ": nests too deep; allowed: " + std::to_string(kMaxNesting) + " levels");
    } else if (!in_string && (c == ']' || c == '}')) {
      --depth;
    }
  }
}

}  // namespace

json read_json(const std::filesystem::path& file) {
  return parse_json(read_text(file), file.string());
}

json parse_json(std::string_view text, const std::string& source) {
  check_nesting(text, source);
  JsonBuilder builder(source, text);
  json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace perceptor::config
