/// @file Binds names in a JSON configuration to variables, strictly.
///
/// A parameter struct is plain C++ with defaults. Beside it stands one function,
///
///     void describe(config::Fields& fields, LocateParameters& p) {
///       fields.number("max_speed", p.max_speed, {0.0, 10.0}, "[m/s] no robot drives faster");
///     }
///
/// which serves for reading, for printing, and for the list of known keys: each key is
/// named once. Reading rejects unknown keys (naming the nearest known one), wrong types,
/// values out of range, fractions where a whole number belongs, and duplicate keys.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace perceptor::config {

/// What is wrong, where (file, JSON pointer), the value, and what is allowed.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Both ends allowed.
struct Range {
  double min = -std::numeric_limits<double>::max();
  double max = std::numeric_limits<double>::max();
};

/// Both ends allowed.
struct IntegerRange {
  std::int64_t min = std::numeric_limits<std::int64_t>::min();
  std::int64_t max = std::numeric_limits<std::int64_t>::max();
};

/// The visitor that `describe` functions are written against.
class Fields {
 public:
  virtual ~Fields() = default;

  virtual void number(std::string_view key, double& value, Range allowed,
                      std::string_view help) = 0;
  virtual void integer(std::string_view key, std::int64_t& value, IntegerRange allowed,
                       std::string_view help) = 0;
  void integer(std::string_view key, int& value, IntegerRange allowed, std::string_view help);
  virtual void boolean(std::string_view key, bool& value, std::string_view help) = 0;
  virtual void text(std::string_view key, std::string& value, std::string_view help) = 0;

  /// One of a few words, each standing for a value of an enumeration.
  template <class Enum>
  void choice(std::string_view key, Enum& value,
              const std::vector<std::pair<std::string, Enum>>& choices, std::string_view help);

  /// A JSON object inside this one.
  template <class Struct>
  void group(std::string_view key, Struct& value, std::string_view help);

  /// A JSON array of objects, each described by `describe(Fields&, Element&)`. Reading
  /// replaces what the list held.
  template <class Element>
  void list(std::string_view key, std::vector<Element>& value, std::string_view help);

  /// What no single range can say ("valid_min below valid_max"): checked once everything is
  /// read, told as a fault of `key`. Describe functions are also called to print; so this
  /// does nothing but in `load` and `load_file`.
  virtual void require(bool holds, std::string_view key, std::string_view allowed);

 protected:
  virtual void word(std::string_view key, std::string& value,
                    const std::vector<std::string>& allowed, std::string_view help) = 0;
  virtual void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                        std::string_view help) = 0;
  /// `resize` sets the number of elements and gives it back; kKeepSize only asks.
  virtual void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
                       const std::function<void(Fields&, std::size_t)>& element,
                       std::string_view help) = 0;
  static constexpr std::size_t kKeepSize = std::numeric_limits<std::size_t>::max();
};

template <class Enum>
void Fields::choice(std::string_view key, Enum& value,
                    const std::vector<std::pair<std::string, Enum>>& choices,
                    std::string_view help) {
  std::vector<std::string> words;
  std::string current;
  for (const auto& [name, choice] : choices) {
    words.push_back(name);
    if (choice == value) current = name;
  }
  word(key, current, words, help);
  for (const auto& [name, choice] : choices)
    if (name == current) value = choice;
}

template <class Struct>
void Fields::group(std::string_view key, Struct& value, std::string_view help) {
  group_of(
      key, [&value](Fields& inner) { describe(inner, value); }, help);
}

template <class Element>
void Fields::list(std::string_view key, std::vector<Element>& value, std::string_view help) {
  list_of(
      key,
      [&value](std::size_t size) {
        if (size != kKeepSize) value.assign(size, Element{});
        return value.size();
      },
      [&value](Fields& inner, std::size_t i) { describe(inner, value[i]); }, help);
}

/// Where one configuration comes from; later wins.
struct Sources {
  std::filesystem::path file;          ///< the component's own JSON file; empty: defaults only
  std::filesystem::path robot_file;    ///< becomes the group "robot"; empty: defaults only
  std::vector<std::string> overrides;  ///< "key=value", "group.key=value", "list.0.key=value"
};

using Describe = std::function<void(Fields&)>;

/// Reads into what `describe` binds. Throws Error.
void load(const Sources& sources, const Describe& describe);

/// Reads one JSON file into what `describe` binds. Throws Error.
void load_file(const std::filesystem::path& file, const Describe& describe);

/// The present values as JSON text, in the order of description.
std::string print(const Describe& describe);

/// For --help: a line for each key: its name, present value, what is allowed, its help.
std::string explain(const Describe& describe);

}  // namespace perceptor::config
