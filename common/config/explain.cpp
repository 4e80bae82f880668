/// @file config::explain: the lines about the keys in --help.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "common/config/allowed.hpp"
#include "common/config/fields.hpp"
#include "common/config/place.hpp"

namespace perceptor::config {
namespace {

struct Line {
  std::string key;
  std::string value;
  std::string meaning;
};

class Explainer final : public Fields {
 public:
  Explainer(std::vector<Line>& lines, std::string prefix, bool shows_values)
      : lines_(lines), prefix_(std::move(prefix)), shows_values_(shows_values) {}

  void number(std::string_view key, double& value, Range allowed, std::string_view help) override {
    add(key, value, help, allowed_number(allowed));
  }
  void integer(std::string_view key, std::int64_t& value, IntegerRange allowed,
               std::string_view help) override {
    add(key, value, help, allowed_integer(allowed));
  }
  void boolean(std::string_view key, bool& value, std::string_view help) override {
    add(key, value, help, "true or false");
  }
  void text(std::string_view key, std::string& value, std::string_view help) override {
    add(key, value, help, "text");
  }
  void word(std::string_view key, std::string& value, const std::vector<std::string>& allowed,
            std::string_view help) override {
    add(key, value, help, allowed_word(allowed));
  }
  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view help) override {
    lines_.push_back({name(key), "", std::string(help)});
    Explainer group(lines_, name(key) + ".", shows_values_);
    inner(group);
  }
  void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
               const std::function<void(Fields&, std::size_t)>& element,
               std::string_view help) override {
    const std::size_t size = resize(kKeepSize);
    lines_.push_back({name(key), std::to_string(size) + " listed", std::string(help)});
    // An empty list gets an element for the time that it takes to ask it for its keys.
    if (size == 0) resize(1);
    Explainer item(lines_, name(key) + ".N.", false);
    element(item, 0);
    if (size == 0) resize(0);
  }

 private:
  std::string name(std::string_view key) const { return prefix_ + std::string(key); }

  template <class Value>
  void add(std::string_view key, const Value& value, std::string_view help,
           const std::string& allowed) {
    lines_.push_back({name(key), shows_values_ ? excerpt(nlohmann::json(value)) : "",
                      std::string(help) + " (" + allowed + ")"});
  }

  std::vector<Line>& lines_;
  std::string prefix_;
  bool shows_values_;
};

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

}  // namespace

std::string explain(const Describe& describe) {
  std::vector<Line> lines;
  Explainer explainer(lines, "", true);
  describe(explainer);

  std::size_t key_width = 0;
  std::size_t value_width = 0;
  for (const Line& line : lines) {
    key_width = std::max(key_width, line.key.size());
    value_width = std::max(value_width, line.value.size());
  }
  std::string text;
  for (const Line& line : lines)
    text += "  " + padded(line.key, key_width) + "  " + padded(line.value, value_width) + "  " +
            line.meaning + "\n";
  return text;
}

}  // namespace perceptor::config
