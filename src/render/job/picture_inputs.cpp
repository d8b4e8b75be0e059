// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/picture_inputs.hpp"

#include <algorithm>

#include "film/sums/tile_image.hpp"

namespace balcony::render {

std::vector<camera::KnownInput> parameters_of(const camera::Picture& picture) {
    std::vector<camera::KnownInput> made;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        for (const camera::KnownInput& input : shown.camera.parts().inputs) {
            if (std::none_of(made.begin(), made.end(), [&](const camera::KnownInput& one) {
                    return one.name == input.name;
                })) {
                made.push_back(input);
            }
        }
    }
    return made;
}

std::vector<rays::Input> declared(const PictureInputs& inputs) {
    std::vector<rays::Input> made;
    if (inputs.focus.any_lens) {
        made.push_back({std::string(camera::lens_input_x), program::Rate::pixel});
        made.push_back({std::string(camera::lens_input_y), program::Rate::pixel});
        for (const std::string& object : inputs.focus.objects) {
            made.push_back({camera::distance_input(object), program::Rate::uniform});
        }
    }
    for (const camera::KnownInput& parameter : inputs.parameters) {
        made.push_back({parameter.name, program::Rate::uniform});
    }
    return made;
}

void InputArrays::set_middle(std::size_t count) {
    if (inputs_.focus.any_lens) {
        x_.assign(count, 0.0);
        y_.assign(count, 0.0);
    }
}

void InputArrays::set_samples(const Region& region, const PassNumbers& numbers) {
    x_.resize(region.size());
    y_.resize(region.size());
    for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
        const Imath::V2f random = Sampler(x, y, numbers).next_pair();
        x_[i] = 2.0 * static_cast<double>(random.x) - 1.0;
        y_[i] = 2.0 * static_cast<double>(random.y) - 1.0;
    });
}

program::InputValues InputArrays::of_layer(std::size_t layer) {
    values_.clear();
    if (inputs_.focus.any_lens) {
        values_.emplace_back(x_);
        values_.emplace_back(y_);
        for (const double& distance : inputs_.focus.distances_of(layer)) {
            values_.emplace_back(&distance, 1);
        }
    }
    for (const camera::KnownInput& parameter : inputs_.parameters) {
        values_.emplace_back(&parameter.value, 1);
    }
    return values_;
}

}  // namespace balcony::render
