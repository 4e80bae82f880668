#include "common/config/reader.hpp"

#include <algorithm>
#include <utility>

#include "common/config/allowed.hpp"
#include "common/config/nearest.hpp"

namespace perceptor::config {
namespace {

using nlohmann::json;

constexpr std::string_view kComment = "_comment";

template <class List, class Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool fits_int64(const json& integer) {
  return !integer.is_number_unsigned() ||
         integer.get<std::uint64_t>() <=
             static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
}

}  // namespace

double read_number(const json& value, const Place& place, Range allowed) {
  if (!value.is_number()) fail(place, value, allowed_number(allowed));
  const auto number = value.get<double>();
  if (number < allowed.min || number > allowed.max) fail(place, value, allowed_number(allowed));
  return number;
}

std::int64_t read_integer(const json& value, const Place& place, IntegerRange allowed) {
  if (value.is_number_float())
    fail(place, value,
         allowed_integer(allowed) + ", of at most 64 bits, without a fraction or an exponent");
  if (!value.is_number_integer() || !fits_int64(value))
    fail(place, value, allowed_integer(allowed));
  const auto number = value.get<std::int64_t>();
  if (number < allowed.min || number > allowed.max) fail(place, value, allowed_integer(allowed));
  return number;
}

void read_object(const json& value, const Place& place, const Describe& describe) {
  if (!value.is_object()) fail(place, value, "a group of keys {...}");
  Reader reader(value, place);
  describe(reader);
  reader.reject_unknown_keys();
}

Reader::Reader(const json& object, Place place) : object_(object), place_(std::move(place)) {}

void Reader::number(std::string_view key, double& value, Range allowed, std::string_view /*help*/) {
  if (const json* found = find(key)) value = read_number(*found, place_.key(key), allowed);
}

void Reader::integer(std::string_view key, std::int64_t& value, IntegerRange allowed,
                     std::string_view /*help*/) {
  if (const json* found = find(key)) value = read_integer(*found, place_.key(key), allowed);
}

void Reader::boolean(std::string_view key, bool& value, std::string_view /*help*/) {
  const json* found = find(key);
  if (found == nullptr) return;
  if (!found->is_boolean()) fail(place_.key(key), *found, "true or false");
  value = found->get<bool>();
}

void Reader::text(std::string_view key, std::string& value, std::string_view /*help*/) {
  const json* found = find(key);
  if (found == nullptr) return;
  if (!found->is_string()) fail(place_.key(key), *found, "text in quotes");
  value = found->get<std::string>();
}

void Reader::word(std::string_view key, std::string& value, const std::vector<std::string>& allowed,
                  std::string_view /*help*/) {
  const json* found = find(key);
  if (found == nullptr) return;
  if (!found->is_string()) fail(place_.key(key), *found, allowed_word(allowed));
  const auto written = found->get<std::string>();
  if (!contains(allowed, written))
    fail(place_.key(key), *found,
         allowed_word(allowed) + "; did you mean \"" + nearest(written, allowed) + "\"?");
  value = written;
}

void Reader::group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                      std::string_view /*help*/) {
  if (const json* found = find(key)) read_object(*found, place_.key(key), inner);
}

void Reader::list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
                     const std::function<void(Fields&, std::size_t)>& element,
                     std::string_view /*help*/) {
  const json* found = find(key);
  if (found == nullptr) return;
  const Place place = place_.key(key);
  if (!found->is_array()) fail(place, *found, "a list of groups [{...}, ...]");
  resize(found->size());
  for (std::size_t i = 0; i < found->size(); ++i)
    read_object((*found)[i], place.item(i), [&](Fields& fields) { element(fields, i); });
}

void Reader::reject_unknown_keys() const {
  for (const auto& [key, value] : object_.items()) {
    if (contains(known_, key)) continue;
    if (key != kComment) fail_unknown_key(place_.key(key), value, key, known_);
    if (!value.is_string()) fail(place_.key(key), value, "text in quotes");
  }
}

const json* Reader::find(std::string_view key) {
  known_.emplace_back(key);
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

void fail_unknown_key(const Place& place, const json& value, std::string_view key,
                      const std::vector<std::string>& known) {
  if (known.empty()) fail(place, "is " + excerpt(value) + ": unknown key; allowed: none here");
  std::string keys;
  for (const std::string& name : known) keys += (keys.empty() ? "" : ", ") + name;
  fail(place, "is " + excerpt(value) + ": unknown key; did you mean \"" + nearest(key, known) +
                  "\"? Allowed: " + keys);
}

}  // namespace perceptor::config
