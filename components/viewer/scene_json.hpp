/// @file A scene as the JSON that the page draws, in parts: what did not change since the last
/// scene is not sent again.
#pragma once

#include <map>
#include <string>

#include <pico/status_t.hpp>

#include "components/viewer/scene.hpp"

namespace perceptor::viewer {

/// Name and JSON text of each part.
using JsonParts = std::map<std::string, std::string>;

/// `scene`: {frame, utime, robot: [x, y, a], poses: {layer: [x, y, a]}, notes}, and for each layer
/// `layer.<id>`: [[mark, [x, y, x, y, ...], text, label], ...] with whole millimetres in the
/// layer's frame.
JsonParts to_json(const Scene& scene);

/// How layers and marks look: {layers: [{id, title, key}], marks: [{layer, label, shape, colour,
/// width, dash, fill}]}.
std::string legend_json();

/// The last STATUS of each component: [{component, boot, utime, published, rejected, missed, p50,
/// p99, cpu, rss, degraded, note}], times of processing in microseconds, `published` by channel.
std::string to_json(const std::map<std::string, pico::status_t>& statuses);

}  // namespace perceptor::viewer
