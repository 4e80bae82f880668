#include "common/config/checker.hpp"

#include <utility>

#include "common/config/place.hpp"

namespace perceptor::config {
namespace {

class Checker final : public Fields {
 public:
  explicit Checker(Place place) : place_(std::move(place)) {}

  void require(bool holds, std::string_view key, std::string_view allowed) override {
    if (!holds) fail(place_.key(key), "does not fit the others; allowed: " + std::string(allowed));
  }
  void group_of(std::string_view key, const std::function<void(Fields&)>& inner,
                std::string_view /*help*/) override {
    Checker group(place_.key(key));
    inner(group);
  }
  void list_of(std::string_view key, const std::function<std::size_t(std::size_t)>& resize,
               const std::function<void(Fields&, std::size_t)>& element,
               std::string_view /*help*/) override {
    const std::size_t size = resize(kKeepSize);
    for (std::size_t i = 0; i < size; ++i) {
      Checker item(place_.key(key).item(i));
      element(item, i);
    }
  }

  void number(std::string_view, double&, Range, std::string_view) override {}
  void integer(std::string_view, std::int64_t&, IntegerRange, std::string_view) override {}
  void boolean(std::string_view, bool&, std::string_view) override {}
  void text(std::string_view, std::string&, std::string_view) override {}
  void word(std::string_view, std::string&, const std::vector<std::string>&,
            std::string_view) override {}

 private:
  Place place_;
};

}  // namespace

void check(const std::string& source, const Describe& describe) {
  Checker checker({source, ""});
  describe(checker);
}

}  // namespace perceptor::config
