/// @file Reads JSON values into the variables that a `describe` function binds, strictly.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/config/fields.hpp"
#include "common/config/place.hpp"

namespace perceptor::config {

/// Any JSON number in range. Throws Error.
double read_number(const nlohmann::json& value, const Place& place, Range allowed);

/// A JSON number in range that is written without fraction and exponent: 2, but not 2.0, as
/// whoever writes a fraction may take the key for something that can be cut finer. Throws Error.
std::int64_t read_integer(const nlohmann::json& value, const Place& place, IntegerRange allowed);

/// Reads a JSON object. Throws Error, also for a key that `describe` does not name, except
/// for a "_comment" that holds text. Keys that are missing leave their variables alone.
void read_object(const nlohmann::json& value, const Place& place, const Describe& describe);

/// One JSON object, as `describe` functions see it.
class Reader final : public Fields {
 public:
  /// `object` must be a JSON object, and outlive the reader.
  Reader(const nlohmann::json& object, Place place);

  void number(std::string_view key, double& value, Range allowed, std::string_view help) override;
  void integer(std::string_view key, std::int64_t& value, IntegerRange allowed,
               std::string_view help) override;
  void boolean(std::string_view key, bool& value, std::string_view help) override;
  void text(std::string_view key, std::string& value, std::string_view help) override;
  void word(std::string_view key, std::string& value, const std::vector<std::string>& allowed,
            std::string_view help) override;
  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view help) override;
  void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
               const std::function<void(Fields&, std::size_t)>& element,
               std::string_view help) override;

  /// To be called when all keys have been described.
  void reject_unknown_keys() const;

 private:
  const nlohmann::json* find(std::string_view key);

  const nlohmann::json& object_;
  Place place_;
  std::vector<std::string> known_;
};

/// Throws Error for a key that is not among the known ones, and names the nearest.
[[noreturn]] void fail_unknown_key(const Place& place, const nlohmann::json& value,
                                   std::string_view key, const std::vector<std::string>& known);

}  // namespace perceptor::config
