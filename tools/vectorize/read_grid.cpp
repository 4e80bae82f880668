#include "tools/vectorize/read_grid.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <stb/stb_image.h>
#include <yaml-cpp/yaml.h>

#include "common/config/fields.hpp"

namespace perceptor {
namespace {

constexpr double kWhite = 255.0;

CellState state_of(std::uint8_t value, const ImageMeaning& meaning) {
  const double dark = meaning.negate ? value / kWhite : (kWhite - value) / kWhite;
  if (dark >= meaning.occupied_thresh) return CellState::occupied;
  return dark < meaning.free_thresh ? CellState::free : CellState::unknown;
}

void check(const std::filesystem::path& file, bool is_right, const std::string& what) {
  if (!is_right) throw config::Error(file.string() + ": " + what);
}

}  // namespace

OccupancyGrid read_image(const std::filesystem::path& image, const ImageMeaning& meaning) {
  OccupancyGrid grid;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(image.c_str(), &grid.width, &grid.height, &channels, STBI_grey), stbi_image_free);
  check(image, pixels != nullptr,
        std::string("no image that can be read: ") +
            (pixels == nullptr ? stbi_failure_reason() : ""));
  grid.resolution = meaning.resolution;
  grid.grid_in_world = meaning.origin;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const auto row = static_cast<std::size_t>(grid.height - 1 - y);
      const auto at = row * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(x);
      grid.cells.push_back(state_of(pixels.get()[at], meaning));
    }
  return grid;
}

OccupancyGrid read_map_server(const std::filesystem::path& yaml) {
  try {
    const YAML::Node map = YAML::LoadFile(yaml.string());
    check(yaml, map.IsMap() && map["image"], "no key `image`: not a file of map_server");
    ImageMeaning meaning;
    meaning.resolution = map["resolution"].as<double>();
    check(yaml, std::isfinite(meaning.resolution) && meaning.resolution > 0.0,
          "resolution: has to be above 0");
    if (map["origin"]) {
      const auto origin = map["origin"].as<std::array<double, 3>>();
      meaning.origin = {origin[0], origin[1], origin[2]};
    }
    meaning.negate = map["negate"].as<int>(0) != 0;
    meaning.occupied_thresh = map["occupied_thresh"].as<double>(meaning.occupied_thresh);
    meaning.free_thresh = map["free_thresh"].as<double>(meaning.free_thresh);
    const std::filesystem::path image = map["image"].as<std::string>();
    return read_image(image.is_absolute() ? image : yaml.parent_path() / image, meaning);
  } catch (const YAML::Exception& error) {
    throw config::Error(yaml.string() + ": " + error.what());
  }
}

}  // namespace perceptor
