#include "common/config/overrides.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/config/json_file.hpp"
#include "common/config/place.hpp"
#include "common/config/reader.hpp"

namespace perceptor::config {
namespace {

using nlohmann::json;

/// What is still to be walked, and what is to be set at its end.
struct Step {
  std::vector<std::string> path;  ///< keys and list indices; never empty
  json value;
  Place place;  ///< of the object in which path.front() is looked for

  Step next(const Place& inner_place, std::size_t walked) const {
    return {{path.begin() + static_cast<std::ptrdiff_t>(walked), path.end()}, value, inner_place};
  }
};

void set_in_group(const Step& step, const Describe& describe);

std::optional<std::size_t> index_of(const std::string& text, std::size_t size) {
  std::size_t index = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, index);
  if (problem != std::errc() || stop != end || index >= size) return std::nullopt;
  return index;
}

/// Passes every key by except the one that the path names.
class Override final : public Fields {
 public:
  explicit Override(Step step) : step_(std::move(step)) {}

  void number(std::string_view key, double& value, Range allowed, std::string_view help) override {
    set_here(key, [&](Reader& reader) { reader.number(key, value, allowed, help); });
  }
  void integer(std::string_view key, std::int64_t& value, IntegerRange allowed,
               std::string_view help) override {
    set_here(key, [&](Reader& reader) { reader.integer(key, value, allowed, help); });
  }
  void boolean(std::string_view key, bool& value, std::string_view help) override {
    set_here(key, [&](Reader& reader) { reader.boolean(key, value, help); });
  }
  void text(std::string_view key, std::string& value, std::string_view help) override {
    set_here(key, [&](Reader& reader) { reader.text(key, value, help); });
  }
  void word(std::string_view key, std::string& value, const std::vector<std::string>& allowed,
            std::string_view help) override {
    set_here(key, [&](Reader& reader) { reader.word(key, value, allowed, help); });
  }

  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view /*help*/) override {
    if (!is_meant(key)) return;
    const Place place = step_.place.key(key);
    if (step_.path.size() == 1)
      read_object(step_.value, place, inner);
    else
      set_in_group(step_.next(place, 1), inner);
  }

  void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
               const std::function<void(Fields&, std::size_t)>& element,
               std::string_view help) override {
    const bool is_whole_list = step_.path.size() == 1;
    if (is_whole_list) {
      set_here(key, [&](Reader& reader) { reader.list_of(key, resize, element, help); });
      return;
    }
    if (!is_meant(key)) return;
    const std::size_t size = resize(kKeepSize);
    const auto index = index_of(step_.path[1], size);
    if (!index)
      fail(step_.place.key(key).key(step_.path[1]), "is no element; allowed: an index below " +
                                                        std::to_string(size) +
                                                        ", the size of the list");
    const Place place = step_.place.key(key).item(*index);
    const Describe inner = [&](Fields& fields) { element(fields, *index); };
    if (step_.path.size() == 2)
      read_object(step_.value, place, inner);
    else
      set_in_group(step_.next(place, 2), inner);
  }

  void reject_if_unknown() const {
    const std::string& key = step_.path.front();
    if (!found_) fail_unknown_key(step_.place.key(key), step_.value, key, known_);
  }

 private:
  bool is_meant(std::string_view key) {
    known_.emplace_back(key);
    if (key != step_.path.front()) return false;
    found_ = true;
    return true;
  }

  template <class Read>
  void set_here(std::string_view key, const Read& read) {
    if (!is_meant(key)) return;
    if (step_.path.size() > 1)
      fail(step_.place.key(key), "is a single value; allowed: no further key after it");
    json object = json::object();
    object[std::string(key)] = step_.value;
    Reader reader(object, step_.place);
    read(reader);
  }

  Step step_;
  bool found_ = false;
  std::vector<std::string> known_;
};

void set_in_group(const Step& step, const Describe& describe) {
  Override fields(step);
  describe(fields);
  fields.reject_if_unknown();
}

std::vector<std::string> split_at_dots(const std::string& key) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace

void apply_override(const std::string& assignment, const Describe& describe) {
  const std::string source = "--set " + cut(assignment);
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) throw Error(source + ": allowed: key=value");
  const std::string written = assignment.substr(equals + 1);
  const json value = json::accept(written) ? parse_json(written, source) : json(written);
  set_in_group({split_at_dots(assignment.substr(0, equals)), value, {source, ""}}, describe);
}

}  // namespace perceptor::config
