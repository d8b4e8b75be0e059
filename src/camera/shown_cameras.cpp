// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras that a picture shows, and their positions.

#include <algorithm>

#include <fmt/format.h>

#include "balcony/picture.hpp"
#include "camera/arrange.hpp"

namespace balcony::camera {

namespace {

// `count` is the number of camera layers so far.
void add_layers(const Picture& picture, const ShownCamera::Place& whole, std::size_t& count,
                std::vector<ShownCamera>& made) {
    std::size_t number = 0;
    for (const Layer& layer : picture.parts().layers) {
        ++number;
        ShownCamera::Place place = whole;
        place.layer = fmt::format("{}{}{}", whole.layer, whole.layer.empty() ? "" : ".", number);
        place.arrangers.insert(place.arrangers.end(), layer.arrangers.begin(),
                               layer.arrangers.end());
        const auto* camera = std::get_if<Camera>(&layer.content);
        if (camera == nullptr) {
            add_layers(*std::get<std::shared_ptr<const Picture>>(layer.content), place, count,
                       made);
            continue;
        }
        place.index = count++;
        const auto known = std::find_if(made.begin(), made.end(), [camera](const ShownCamera& one) {
            return &one.camera.parts() == &camera->parts();
        });
        if (known != made.end()) {
            known->places.push_back(std::move(place));
        } else {
            made.push_back({*camera, {std::move(place)}});
        }
    }
}

}  // namespace

std::vector<ShownCamera> shown_cameras(const Picture& picture) {
    std::vector<ShownCamera> made;
    std::size_t count = 0;
    add_layers(picture, {}, count, made);
    return made;
}

std::array<double, 2> size_of(const ShownCamera::Place& place, double width, double height,
                              double time) {
    return arranged_size(place.arrangers, width, height, time);
}

}  // namespace balcony::camera
