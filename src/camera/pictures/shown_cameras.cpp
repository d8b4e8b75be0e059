// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras that a picture shows, and their positions.

#include <algorithm>

#include <fmt/format.h>

#include "balcony/picture.hpp"
#include "camera/machine/arrange.hpp"
#include "camera/pictures/layer_arrangers.hpp"

namespace balcony::camera {

namespace {

// `count` is the number of camera layers so far.
void add_layers(const Picture& picture, const ShownCamera::LayerUse& whole, std::size_t& count,
                std::vector<ShownCamera>& made) {
    const Picture::Parts& parts = picture.parts();
    for (std::size_t i = 0; i < parts.layers.size(); ++i) {
        const Layer& layer = parts.layers[i];
        ShownCamera::LayerUse use = whole;
        use.layer = fmt::format("{}{}{}", whole.layer, whole.layer.empty() ? "" : ".", i + 1);
        const std::vector<PictureArrangerPointer> own = arrangers_of(parts, i).all();
        use.arrangers.insert(use.arrangers.end(), own.begin(), own.end());
        use.objects.insert(use.objects.end(), layer.objects.begin(), layer.objects.end());
        const auto* camera = std::get_if<Camera>(&layer.content);
        if (camera == nullptr) {
            add_layers(*std::get<std::shared_ptr<const Picture>>(layer.content), use, count, made);
            continue;
        }
        use.index = count++;
        const auto known = std::find_if(made.begin(), made.end(), [camera](const ShownCamera& one) {
            return &one.camera.parts() == &camera->parts();
        });
        if (known != made.end()) {
            known->uses.push_back(std::move(use));
        } else {
            made.push_back({*camera, {std::move(use)}});
        }
    }
}

}  // namespace

std::vector<ShownCamera> shown_cameras(const Picture& picture) {
    std::vector<ShownCamera> made;
    std::size_t count = 0;
    ShownCamera::LayerUse whole;
    if (const PictureArrangerPointer fitted = fitting_of(picture)) {
        whole.arrangers.push_back(fitted);
    }
    add_layers(picture, whole, count, made);
    return made;
}

std::array<double, 2> size_of(const ShownCamera::LayerUse& use, double width, double height,
                              double time) {
    return arranged_size(use.arrangers, width, height, time);
}

}  // namespace balcony::camera
