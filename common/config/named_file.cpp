#include "common/config/named_file.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "common/config/fields.hpp"

namespace perceptor::config {
namespace {

std::string names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace

std::filesystem::path find_named(std::string_view kind, const std::string& name,
                                 const std::filesystem::path& folder) {
  for (const std::filesystem::path& candidate :
       {std::filesystem::path(name), folder / name, folder / (name + ".json")})
    if (std::filesystem::is_regular_file(candidate)) return candidate;
  const std::string what(kind);
  throw Error("/" + what + ": no file \"" + name + "\", and no " + what + " of that name in " +
              folder.string() + "; there are: " + names_in(folder));
}

}  // namespace perceptor::config
