// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Colours for numbers.

#include <string>
#include <vector>

#include "analyse/draw/bitmap.hpp"

namespace balcony::analyse {

/// A perceptually uniform scale from dark to bright, readable without colour vision; s from 0 to 1.
[[nodiscard]] Color sequential_color(double s);

/// A range of numbers that a colour scale shows.
class ColorScale {
public:
    enum class Spacing : bool { linear, logarithmic };

    /// minimum < maximum, both positive if logarithmic.
    ColorScale(double minimum, double maximum, Spacing spacing);

    /// The position of a number on the scale, clamped to 0 to 1.
    [[nodiscard]] double position(double value) const;
    [[nodiscard]] Color color(double value) const { return sequential_color(position(value)); }
    /// The inverse of position().
    [[nodiscard]] double value(double position) const;

    struct Tick {
        double value;
        std::string text;
    };
    /// Round numbers on the scale, at most about so many.
    [[nodiscard]] std::vector<Tick> ticks(double wanted = 5.0) const;

private:
    double min_;
    double max_;
    Spacing spacing_;
};

}  // namespace balcony::analyse
