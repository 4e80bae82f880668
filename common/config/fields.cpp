#include "common/config/fields.hpp"

#include <algorithm>

#include "common/config/checker.hpp"
#include "common/config/json_file.hpp"
#include "common/config/overrides.hpp"
#include "common/config/reader.hpp"

namespace perceptor::config {
namespace {

constexpr std::string_view kRobotGroup = "robot";

void read_file(const std::filesystem::path& file, const Describe& describe) {
  read_object(read_json(file), {file.string(), ""}, describe);
}

/// Reads a file into the group "robot"; where there is no such group, the file stays unread.
class RobotFile final : public Fields {
 public:
  explicit RobotFile(std::filesystem::path file) : file_(std::move(file)) {}

  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view /*help*/) override {
    if (key == kRobotGroup) read_file(file_, inner);
  }
  void number(std::string_view, double&, Range, std::string_view) override {}
  void integer(std::string_view, std::int64_t&, IntegerRange, std::string_view) override {}
  void boolean(std::string_view, bool&, std::string_view) override {}
  void text(std::string_view, std::string&, std::string_view) override {}
  void word(std::string_view, std::string&, const std::vector<std::string>&,
            std::string_view) override {}
  void list_of(std::string_view, const std::function<std::size_t(std::size_t)>&,
               const std::function<void(Fields&, std::size_t)>&, std::string_view) override {}

 private:
  std::filesystem::path file_;
};

}  // namespace

void Fields::integer(std::string_view key, int& value, IntegerRange allowed,
                     std::string_view help) {
  using Limits = std::numeric_limits<int>;
  const IntegerRange that_fits = {std::max<std::int64_t>(allowed.min, Limits::min()),
                                  std::min<std::int64_t>(allowed.max, Limits::max())};
  std::int64_t wide = value;
  integer(key, wide, that_fits, help);
  value = static_cast<int>(wide);
}

void Fields::require(bool /*holds*/, std::string_view /*key*/, std::string_view /*allowed*/) {}

void load(const Sources& sources, const Describe& describe) {
  if (!sources.robot_file.empty()) {
    RobotFile robot_file(sources.robot_file);
    describe(robot_file);
  }
  if (!sources.file.empty()) read_file(sources.file, describe);
  for (const std::string& assignment : sources.overrides) apply_override(assignment, describe);
  check(sources.file.empty() ? "configuration" : sources.file.string(), describe);
}

void load_file(const std::filesystem::path& file, const Describe& describe) {
  read_file(file, describe);
  check(file.string(), describe);
}

}  // namespace perceptor::config
