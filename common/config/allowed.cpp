#include "common/config/allowed.hpp"

#include <array>
#include <charconv>
#include <string_view>

namespace perceptor::config {
namespace {

/// The shortest text that reads back as the same number.
template <class Number>
std::string shortest(Number value) {
  std::array<char, 32> text{};
  const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

/// An end that lies at the type's own limit is no bound, and is not mentioned.
template <class AnyRange>
std::string bounds(const AnyRange& range) {
  const AnyRange unbounded;
  const bool has_min = range.min > unbounded.min;
  const bool has_max = range.max < unbounded.max;
  if (has_min && has_max) return " from " + shortest(range.min) + " to " + shortest(range.max);
  if (has_min) return " of at least " + shortest(range.min);
  if (has_max) return " of at most " + shortest(range.max);
  return "";
}

}  // namespace

std::string allowed_number(Range range) { return "a number" + bounds(range); }

std::string allowed_integer(IntegerRange range) { return "a whole number" + bounds(range); }

std::string allowed_word(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words)
    result.append(result.empty() ? "one of \"" : ", \"").append(word).append("\"");
  return result;
}

}  // namespace perceptor::config
