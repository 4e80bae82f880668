/// @file config::print: the present values as JSON, in the order of description.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "common/config/fields.hpp"

namespace perceptor::config {
namespace {

using Json = nlohmann::ordered_json;

class Printer final : public Fields {
 public:
  explicit Printer(Json& object) : object_(object) { object_ = Json::object(); }

  void number(std::string_view key, double& value, Range /*allowed*/,
              std::string_view /*help*/) override {
    member(key) = value;
  }
  void integer(std::string_view key, std::int64_t& value, IntegerRange /*allowed*/,
               std::string_view /*help*/) override {
    member(key) = value;
  }
  void boolean(std::string_view key, bool& value, std::string_view /*help*/) override {
    member(key) = value;
  }
  void text(std::string_view key, std::string& value, std::string_view /*help*/) override {
    member(key) = value;
  }
  void word(std::string_view key, std::string& value, const std::vector<std::string>& /*allowed*/,
            std::string_view /*help*/) override {
    member(key) = value;
  }
  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view /*help*/) override {
    Printer group(member(key));
    inner(group);
  }
  void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
               const std::function<void(Fields&, std::size_t)>& element,
               std::string_view /*help*/) override {
    Json& list = member(key) = Json::array();
    const std::size_t size = resize(kKeepSize);
    for (std::size_t i = 0; i < size; ++i) {
      Printer item(list.emplace_back());
      element(item, i);
    }
  }

 private:
  Json& member(std::string_view key) { return object_[std::string(key)]; }

  Json& object_;
};

bool is_flat(const Json& object) {
  return std::all_of(object.begin(), object.end(),
                     [](const Json& value) { return !value.is_structured() || value.empty(); });
}

/// As JSON's own dump writes a value, save that what is no UTF-8 does not throw.
std::string on_one_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// An object on one line, with spaces for the eye.
std::string flat(const Json& object) {
  std::string text;
  for (const auto& [key, value] : object.items())
    text += (text.empty() ? "" : ", ") + Json(key).dump() + ": " + on_one_line(value);
  return "{" + text + "}";
}

/// Two spaces a level; a list's elements that hold nothing nested take one line each.
std::string layout(const Json& value, const std::string& indent) {
  if (!value.is_structured() || value.empty()) return on_one_line(value);
  const std::string inner_indent = indent + "  ";
  std::string text;
  for (const auto& [key, inner] : value.items()) {
    text += (text.empty() ? "\n" : ",\n") + inner_indent;
    if (value.is_object()) text += Json(key).dump() + ": ";
    const bool takes_one_line = value.is_array() && inner.is_object() && is_flat(inner);
    text += takes_one_line ? flat(inner) : layout(inner, inner_indent);
  }
  return value.is_array() ? "[" + text + "\n" + indent + "]" : "{" + text + "\n" + indent + "}";
}

}  // namespace

std::string print(const Describe& describe) {
  Json object;
  Printer printer(object);
  describe(printer);
  return layout(object, "") + "\n";
}

}  // namespace perceptor::config
