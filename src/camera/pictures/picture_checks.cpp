// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/pictures/picture_checks.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace balcony::camera {

const Picture* nested(const Layer& layer) {
    const auto* picture = std::get_if<std::shared_ptr<const Picture>>(&layer.content);
    return picture != nullptr ? picture->get() : nullptr;
}

std::optional<std::array<double, 2>> sides_of(const Layer& layer) {
    const Picture* inner = nested(layer);
    return inner != nullptr ? inner->sides() : std::get<Camera>(layer.content).parts().sides;
}

namespace {

struct Extent {
    std::size_t layers = 0;
    std::size_t depth = 1;
};

Extent extent(const Picture::Parts& parts) {
    Extent all;
    for (const Layer& layer : parts.layers) {
        ++all.layers;
        if (const Picture* inner = nested(layer)) {
            const Extent within = extent(inner->parts());
            all.layers += within.layers;
            all.depth = std::max(all.depth, within.depth + 1);
        }
    }
    return all;
}

// The value of a number if it does not depend on time.
bool known_outside(const Scalar& value, double minimum, double maximum) {
    const auto known = value.constant();
    return known && !(minimum <= *known && *known <= maximum);
}

void check_stroke(const Stroke& stroke, const std::string& layer, Diagnostics& diagnostics) {
    if (known_outside(stroke.width, 0.0, 1.0)) {
        diagnostics.push_back(
            error(fmt::format("the width of a line of layer '{}' is not from 0 to 1", layer), {},
                  "the width is a fraction of the picture's height, such as 0.004"));
    }
}

void check_region(const PictureRegion& region, const std::string& layer, Diagnostics& diagnostics) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const auto first = region.from[i].constant();
        const auto last = region.to[i].constant();
        if (first && last && !(*first < *last)) {
            diagnostics.push_back(
                error(fmt::format("the region that layer '{}' shows has no area", layer), {},
                      "write its top left and its bottom right corner, such as (0.2, 0.1) .. (0.5, "
                      "0.4)"));
            return;
        }
    }
}

void check_layer(const Layer& layer, Diagnostics& diagnostics) {
    if (known_outside(layer.alpha, 0.0, 1.0)) {
        diagnostics.push_back(
            error(fmt::format("the alpha of layer '{}' is not from 0 to 1", layer.name), {},
                  "0 is transparent, 1 is opaque"));
    }
    if (known_outside(layer.softness, 0.0, 1.0)) {
        diagnostics.push_back(error(
            fmt::format("the width of the soft edge of layer '{}' is not from 0 to 1", layer.name),
            {}, "the width is a fraction of the layer's height, such as 0.05"));
    }
    if (layer.show) {
        check_region(*layer.show, layer.name, diagnostics);
    }
    if (layer.frame) {
        check_stroke(*layer.frame, layer.name, diagnostics);
    }
    if (layer.scale_bar && !sides_of(layer)) {
        diagnostics.push_back(error(
            fmt::format("layer '{}' has a scale bar, but what it shows has no scale", layer.name),
            {}, "write the sides of its picture in scene units: aspect (WIDTH, HEIGHT)"));
    }
    for (const Leader& leader : layer.leaders) {
        check_stroke(leader.stroke, layer.name, diagnostics);
    }
}

// How layers are composited. Depths are compared along the rays of a camera, and of what cameras
// see.
void check_compositing(const Picture::Parts& parts, Diagnostics& diagnostics) {
    const Layer* master = nullptr;
    for (std::size_t i = 0; i < parts.layers.size(); ++i) {
        const Layer& layer = parts.layers[i];
        master = layer.compositing == Compositing::depth ? master : &layer;
        if (layer.compositing == Compositing::order) {
            continue;
        }
        if (layer.blend != BlendMode::normal) {
            diagnostics.push_back(error(
                fmt::format("layer '{}' has a blend mode, but is not composited by its order",
                            layer.name),
                {}, fmt::format("remove the blend mode {}", blend_modes()[layer.blend].name)));
        }
        if (layer.compositing == Compositing::weight) {
            if (!layer.weight) {
                diagnostics.push_back(error(
                    fmt::format("layer '{}' is composited by a weight that is missing", layer.name),
                    {}, "give it a formula of the point of the picture"));
            }
            continue;
        }
        if (i == 0) {
            diagnostics.push_back(
                error(fmt::format("layer '{}' is composited by depth, but no layer is behind it",
                                  layer.name),
                      {}, "write the layer of the master camera before it"));
        } else if (nested(layer) != nullptr || nested(parts.layers[i - 1]) != nullptr) {
            const std::string& picture =
                nested(layer) != nullptr ? layer.name : parts.layers[i - 1].name;
            diagnostics.push_back(
                error(fmt::format("layer '{}' is composited by depth, but '{}' is a picture, "
                                  "which has no depth of its own",
                                  layer.name, picture),
                      {}, "show a camera in both layers"));
        } else if (master != nullptr && nested(*master) == nullptr &&
                   std::get<Camera>(master->content).parts().bend != nullptr) {
            diagnostics.push_back(
                error(fmt::format("layer '{}' is composited by depth along the rays of layer '{}', "
                                  "which are bent",
                                  layer.name, master->name),
                      {},
                      fmt::format("composite it by order, or show a camera without bend in "
                                  "layer '{}'",
                                  master->name)));
        }
    }
}

void check_extent(const Picture::Parts& parts, Diagnostics& diagnostics) {
    const Extent all = extent(parts);
    if (all.layers == 0) {
        diagnostics.push_back(error(fmt::format("picture '{}' has no layers", parts.name), {},
                                    "add one with: layer NAME"));
    }
    if (all.layers > max_layers) {
        diagnostics.push_back(
            error(fmt::format("picture '{}' has {} layers, including those of nested pictures; "
                              "the maximum is {}",
                              parts.name, all.layers, max_layers)));
    }
    if (all.depth > max_nested_pictures) {
        diagnostics.push_back(
            error(fmt::format("picture '{}' nests pictures {} levels deep; the maximum is {}",
                              parts.name, all.depth, max_nested_pictures)));
    }
}

}  // namespace

Diagnostics check_layers(const Picture::Parts& parts) {
    Diagnostics diagnostics;
    check_extent(parts, diagnostics);
    for (const Layer& layer : parts.layers) {
        check_layer(layer, diagnostics);
    }
    check_compositing(parts, diagnostics);
    return diagnostics;
}

}  // namespace balcony::camera
