// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The layers of frames: a row each, with the layers of a film that it is made of.

#include <string>
#include <string_view>

#include "balcony/layers.hpp"
#include "dataset/frames/frame_data.hpp"

namespace balcony::dataset {

struct FrameLayer {
    LayerInfo info;
    render::LayerSet needs{};
    bool is_of_light = false;  ///< Of all samples; otherwise of the middles of pixels.
    Result<std::string> (*bytes)(const FrameData& data) = nullptr;
};

/// One of layers().
[[nodiscard]] const FrameLayer& frame_layer(std::string_view name);

}  // namespace balcony::dataset
