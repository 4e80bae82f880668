#include "tools/convert/words.hpp"

#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::size_t kMaxDetail = 40;

/// [s] Some thousand years: beyond it a time is a mistake.
constexpr double kMaxTime = 1e11;

template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
  return error == std::errc() && end == word.end();
}

}  // namespace

void Words::fail(std::string_view reason, std::string_view detail) {
  if (!fault_) fault_ = Dropped{reason, std::string(detail.substr(0, kMaxDetail))};
}

std::string_view Words::word() {
  const std::size_t begin = rest_.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) {
    rest_ = {};
    return {};
  }
  rest_.remove_prefix(begin);
  const std::string_view found = rest_.substr(0, rest_.find_first_of(kBlank));
  rest_.remove_prefix(found.size());
  return found;
}

void Words::number(double& value) {
  if (!good()) return;
  const std::string_view next = word();
  if (next.empty()) return fail(drop_reason::wrong_count, "too few numbers");
  if (!parse(next, value)) fail(drop_reason::bad_number, next);
}

void Words::number(float& value) {
  if (!good()) return;
  const std::string_view next = word();
  if (next.empty()) return fail(drop_reason::wrong_count, "too few numbers");
  if (!parse(next, value)) fail(drop_reason::bad_number, next);
}

void Words::finite(std::initializer_list<double*> values) {
  for (double* value : values) {
    number(*value);
    if (good() && !std::isfinite(*value)) fail(drop_reason::bad_number, std::to_string(*value));
  }
}

void Words::pose(Position& position) {
  finite({&position.x, &position.y, &position.a});
  if (std::abs(position.a) >= std::numbers::pi) position.a = wrap_angle(position.a);
}

void Words::time(std::int64_t& utime) {
  double seconds = 0.0;
  finite({&seconds});
  if (!good()) return;
  if (seconds < 0.0 || seconds > kMaxTime)
    return fail(drop_reason::bad_time, std::to_string(seconds));
  utime = std::llround(seconds * static_cast<double>(kMicrosecondsPerSecond));
}

std::size_t Words::count(std::int32_t most) {
  if (!good()) return 0;
  const std::string_view next = word();
  std::int64_t beams = 0;
  if (next.empty()) {
    fail(drop_reason::wrong_count, "too few numbers");
  } else if (!parse(next, beams)) {
    fail(drop_reason::bad_number, next);
  } else if (beams < 1) {
    fail(drop_reason::wrong_count, next);
  } else if (beams > most) {
    fail(drop_reason::too_many_beams, next);
  }
  return good() ? static_cast<std::size_t>(beams) : 0;
}

std::vector<float> Words::numbers(std::size_t count) {
  std::vector<float> values(good() ? count : 0);
  for (float& value : values) number(value);
  return values;
}

void Words::end() {
  if (good() && !at_end()) fail(drop_reason::wrong_count, "more numbers than announced");
}

bool Words::at_end() { return rest_.find_first_not_of(kBlank) == std::string_view::npos; }

}  // namespace perceptor
