// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the programs of a picture are given beside the points: with a lens, a point of it for each
// ray and the distances of the objects in focus, and the values of open parameters.

#include <cstddef>
#include <span>
#include <vector>

#include "balcony/rays.hpp"
#include "render/job/focus.hpp"
#include "render/sampling/sampler.hpp"

namespace balcony::render {

struct PictureInputs {
    LensFocus focus{};
    std::vector<camera::KnownInput> parameters{};
};

/// The further inputs of a picture's cameras, each once: Camera::Parts::inputs.
[[nodiscard]] std::vector<camera::KnownInput> parameters_of(const camera::Picture& picture);

/// The inputs of a picture's programs.
[[nodiscard]] std::vector<rays::Input> declared(const PictureInputs& inputs);

/// Their values for a tile; belongs to one thread.
class InputArrays {
public:
    explicit InputArrays(PictureInputs inputs) : inputs_(std::move(inputs)) {}

    /// The middle of the lens for all rays.
    void set_middle(std::size_t count);
    /// The point of the lens for the sample of each pixel of a region in a pass.
    void set_samples(const Region& region, const PassNumbers& numbers);
    /// In the order of declared(), until the values are set again.
    [[nodiscard]] program::InputValues of_layer(std::size_t layer);

private:
    PictureInputs inputs_;
    std::vector<double> x_, y_;
    std::vector<std::span<const double>> values_;
};

}  // namespace balcony::render
