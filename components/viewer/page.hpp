/// @file The page that the viewer serves. Its files are in the folder page, and compiled in.
#pragma once

#include <vector>

#include "components/viewer/scene_server.hpp"

namespace perceptor::viewer {

std::vector<PageFile> page_files();

}  // namespace perceptor::viewer
