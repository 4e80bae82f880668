#include "common/config/json_builder.hpp"

#include <algorithm>
#include <utility>

namespace perceptor::config {

using nlohmann::json;

JsonBuilder::JsonBuilder(std::string source, std::string_view text)
    : source_(std::move(source)), text_(text) {}

bool JsonBuilder::null() { return add(nullptr) != nullptr; }
bool JsonBuilder::boolean(bool value) { return add(value) != nullptr; }
bool JsonBuilder::number_integer(number_integer_t value) { return add(value) != nullptr; }
bool JsonBuilder::number_unsigned(number_unsigned_t value) { return add(value) != nullptr; }
bool JsonBuilder::number_float(number_float_t value, const string_t& /*written*/) {
  return add(value) != nullptr;
}
bool JsonBuilder::string(string_t& value) { return add(std::move(value)) != nullptr; }
bool JsonBuilder::binary(binary_t& /*value*/) { return false; }  // never in JSON text

bool JsonBuilder::start_object(std::size_t /*size*/) {
  open_.push_back(add(json::object()));
  keys_.emplace_back();
  return true;
}

bool JsonBuilder::key(string_t& name) {
  keys_.back() = name;
  if (open_.back()->contains(name)) fail(place(), "is given twice; allowed: each key once");
  return true;
}

bool JsonBuilder::end_object() {
  open_.pop_back();
  keys_.pop_back();
  return true;
}

bool JsonBuilder::start_array(std::size_t /*size*/) {
  open_.push_back(add(json::array()));
  keys_.emplace_back();
  return true;
}

bool JsonBuilder::end_array() { return end_object(); }

bool JsonBuilder::parse_error(std::size_t position, const std::string& last_token,
                              const json::exception& problem) {
  const bool is_overflow = dynamic_cast<const json::out_of_range*>(&problem) != nullptr;
  if (is_overflow)
    fail(place(), "is " + cut(last_token) + "; allowed: a number that fits a double");

  const std::string_view before = text_.substr(0, position);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string_view what = problem.what();  // "[json.exception...] parse error at ...: ..."
  const auto detail = what.find(": ");
  throw Error(source_ + ": line " + std::to_string(line) + ": no JSON: " +
              cut(detail == std::string_view::npos ? what : what.substr(detail + 2)));
}

/// Puts a value where the parser is; the value's address stays good while it is open, as
/// nothing is added to its parent meanwhile.
json* JsonBuilder::add(json value) {
  if (open_.empty()) {
    root_ = std::move(value);
    return &root_;
  }
  json& parent = *open_.back();
  if (parent.is_array()) {
    parent.push_back(std::move(value));
    return &parent.back();
  }
  return &(parent[keys_.back()] = std::move(value));
}

/// Of the value that comes next.
Place JsonBuilder::place() const {
  Place here{source_, ""};
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const bool is_innermost = i + 1 == open_.size();
    if (!open_[i]->is_array())
      here = here.key(keys_[i]);
    else
      here = here.item(is_innermost ? open_[i]->size() : open_[i]->size() - 1);
  }
  return here;
}

}  // namespace perceptor::config
