/// @file Builds a JSON value from the parser's events, and refuses duplicate keys, which
/// the library takes in silence.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/config/place.hpp"

namespace perceptor::config {

/// Receives the events of nlohmann::json::sax_parse. Throws Error with the JSON pointer.
class JsonBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// `text` is what is being parsed: lines are counted in it.
  JsonBuilder(std::string source, std::string_view text);

  /// The whole value, once parsing is over.
  nlohmann::json take() { return std::move(root_); }

  bool null() override;
  bool boolean(bool value) override;
  bool number_integer(number_integer_t value) override;
  bool number_unsigned(number_unsigned_t value) override;
  bool number_float(number_float_t value, const string_t& written) override;
  bool string(string_t& value) override;
  bool binary(binary_t& value) override;
  bool start_object(std::size_t size) override;
  bool key(string_t& name) override;
  bool end_object() override;
  bool start_array(std::size_t size) override;
  bool end_array() override;
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& problem) override;

 private:
  nlohmann::json* add(nlohmann::json value);
  Place place() const;

  std::string source_;
  std::string_view text_;
  nlohmann::json root_;
  std::vector<nlohmann::json*> open_;  ///< the objects and arrays that are not closed yet
  std::vector<std::string> keys_;      ///< the present key of each of them; unused for arrays
};

}  // namespace perceptor::config
