// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the programs of a picture with lenses are given beside the points: a point of the lens for
// each ray, and the distances of the objects in focus.

#include <cstddef>
#include <span>
#include <vector>

#include "balcony/rays.hpp"
#include "render/job/focus.hpp"
#include "render/sampling/sampler.hpp"

namespace balcony::render {

/// The inputs of a picture's programs; none without a lens.
[[nodiscard]] std::vector<rays::Input> lens_inputs(const LensFocus& focus);

/// Their values for a tile; belongs to one thread.
class LensValues {
public:
    explicit LensValues(LensFocus focus) : focus_(std::move(focus)) {}

    /// The middle of the lens for all rays.
    void set_middle(std::size_t count);
    /// The point of the lens for the sample of each pixel of a region in a pass.
    void set_samples(const Region& region, const PassNumbers& numbers);
    /// In the order of lens_inputs(), until the values are set again.
    [[nodiscard]] program::InputValues of_layer(std::size_t layer);

private:
    LensFocus focus_;
    std::vector<double> x_, y_;
    std::vector<std::span<const double>> values_;
};

}  // namespace balcony::render
