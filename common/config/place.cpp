#include "common/config/place.hpp"

namespace perceptor::config {
namespace {

constexpr std::size_t kMaxExcerpt = 100;

/// RFC 6901: "~" and "/" inside a key are written "~0" and "~1".
std::string escaped(std::string_view key) {
  std::string result;
  for (const char c : key) {
    if (c == '~')
      result += "~0";
    else if (c == '/')
      result += "~1";
    else
      result += c;
  }
  return result;
}

}  // namespace

Place Place::key(std::string_view name) const { return {source, pointer + "/" + escaped(name)}; }

Place Place::item(std::size_t index) const {
  return {source, pointer + "/" + std::to_string(index)};
}

void fail(const Place& place, const nlohmann::json& value, std::string_view allowed) {
  fail(place, "is " + excerpt(value) + "; allowed: " + std::string(allowed));
}

void fail(const Place& place, std::string_view problem) {
  const std::string where = place.pointer.empty() ? "(the whole)" : cut(place.pointer);
  throw Error(place.source + ": " + where + " " + std::string(problem));
}

std::string excerpt(const nlohmann::json& value) {
  // Replace what is no UTF-8 (a command line may hold anything) rather than throw.
  return cut(value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string cut(std::string_view text) {
  if (text.size() <= kMaxExcerpt) return std::string(text);
  return std::string(text.substr(0, kMaxExcerpt)) + "...";
}

}  // namespace perceptor::config
