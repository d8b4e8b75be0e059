// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/lens_inputs.hpp"

#include "film/sums/tile_image.hpp"

namespace balcony::render {

std::vector<rays::Input> lens_inputs(const LensFocus& focus) {
    if (!focus.any_lens) {
        return {};
    }
    std::vector<rays::Input> inputs{{std::string(camera::lens_input_x), program::Rate::pixel},
                                    {std::string(camera::lens_input_y), program::Rate::pixel}};
    for (const std::string& object : focus.objects) {
        inputs.push_back({camera::distance_input(object), program::Rate::uniform});
    }
    return inputs;
}

void LensValues::set_middle(std::size_t count) {
    if (focus_.any_lens) {
        x_.assign(count, 0.0);
        y_.assign(count, 0.0);
    }
}

void LensValues::set_samples(const Region& region, const PassNumbers& numbers) {
    x_.resize(region.size());
    y_.resize(region.size());
    for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
        const Imath::V2f random = Sampler(x, y, numbers).next_pair();
        x_[i] = 2.0 * static_cast<double>(random.x) - 1.0;
        y_[i] = 2.0 * static_cast<double>(random.y) - 1.0;
    });
}

program::InputValues LensValues::of_layer(std::size_t layer) {
    values_.clear();
    if (focus_.any_lens) {
        values_.emplace_back(x_);
        values_.emplace_back(y_);
        for (std::size_t object = 0; object < focus_.objects.size(); ++object) {
            values_.emplace_back(&focus_.distances[layer][object], 1);
        }
    }
    return values_;
}

}  // namespace balcony::render
