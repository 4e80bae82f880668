#include "tools/plot/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include <cairo.h>
#include <gmock/gmock.h>

#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using testing::HasSubstr;
using viewer::Layer;
using viewer::Mark;
using viewer::Scene;

constexpr std::uint32_t kDoorColour = 0x009E73;

/// How many pixels of a PNG have a colour [0xRRGGBB].
int count_pixels(const std::filesystem::path& png, std::uint32_t colour) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
      cairo_image_surface_create_from_png(png.c_str()), cairo_surface_destroy);
  EXPECT_EQ(cairo_surface_status(image.get()), CAIRO_STATUS_SUCCESS);
  const unsigned char* bytes = cairo_image_surface_get_data(image.get());
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(image.get());
  int count = 0;
  for (int y = 0; y < cairo_image_surface_get_height(image.get()); ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + y * stride);
    for (int x = 0; x < cairo_image_surface_get_width(image.get()); ++x)
      if ((row[x] & 0xFFFFFFU) == colour) ++count;
  }
  return count;
}

Scene scene_with_door() {
  Scene scene;
  scene[Layer::identified].items = {{Mark::door, {{0.0, 0.0}, {0.9, 0.0}}, "door", "door"}};
  return scene;
}

TEST(Drawing, ADoorIsDrawnAndExplained) {
  const TemporaryFolder folder;
  const auto file = folder / "door.png";
  draw(scene_with_door(), file);
  const int with_door = count_pixels(file, kDoorColour);
  draw({}, file);
  EXPECT_EQ(count_pixels(file, kDoorColour), 0);
  EXPECT_GT(with_door, 1000) << "a line of 7 px across most of the picture, and the legend";
}

TEST(Drawing, WhatIsHiddenIsNeitherDrawnNorExplained) {
  const TemporaryFolder folder;
  const auto file = folder / "door.png";
  DrawingOptions options;
  options.hidden = {Layer::identified};
  draw(scene_with_door(), file, options);
  EXPECT_EQ(count_pixels(file, kDoorColour), 0);
}

TEST(Drawing, TheSizeIsWhatWasAskedFor) {
  const TemporaryFolder folder;
  const auto file = folder / "door.svg";
  draw(scene_with_door(), file, {.width = 640, .height = 480});
  std::ifstream in(file);
  const std::string svg{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("640"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
}

TEST(Drawing, AFileThatCannotBeWrittenIsAnError) {
  EXPECT_THROW(draw({}, "/nowhere/plot.png"), std::runtime_error);
  EXPECT_THROW(draw({}, "/nowhere/plot.svg"), std::runtime_error);
  EXPECT_THROW(draw({}, "plot.jpg"), std::runtime_error);
}

}  // namespace
}  // namespace perceptor
