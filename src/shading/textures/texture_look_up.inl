// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The mean of an image over a footprint. `Footprint` has the members of TextureFootprint. `Texels`
// has rows(level, width, columns), the rows of a level of this width; of these, rows(number) has
// the colours of the two columns of a TexelPair as `first` and `second`.

/// The ellipse of a footprint, in texels: the images of a circle of diameter 1, a pixel.
struct FootprintEllipse {
    Float length;  ///< The longer diameter.
    Float width;
    Float2 axis;  ///< The longer diameter as a vector.
};

/// Under the linear map with these columns.
BALCONY_FORMULA FootprintEllipse footprint_ellipse(const Float2& x, const Float2& y) {
    const Float apart = 0.5F * (x.x * x.x + y.x * y.x - x.y * x.y - y.y * y.y);
    const Float across = x.x * x.y + y.x * y.y;
    const Float distance = root(apart * apart + across * across);
    const Float length = root(0.5F * (dot(x, x) + dot(y, y)) + distance);
    const Float area = absolute(x.x * y.y - x.y * y.x);
    // Of the two forms of the eigenvector, the one without cancellation.
    const Float2 direction =
        select(apart >= 0.0F, Float2{distance + apart, across}, Float2{across, distance - apart});
    // A circle has no longer axis; next to one, the eigenvector may underflow.
    const Float scale = length / root(dot(direction, direction));
    return {length, or_zero(length > 0.0F, area / length),
            select(is_finite(scale), direction * scale, Float2{length, 0.0F})};
}

/// From 0 to 1.
BALCONY_FORMULA Float wrapped(Float position, scene::Wrap wrap) {
    if (wrap == scene::Wrap::clamp) {
        return smaller(larger(position, 0.0F), 1.0F);
    }
    if (wrap == scene::Wrap::repeat) {
        return position - floored(position);
    }
    const Float in_period = position - 2.0F * floored(0.5F * position);
    return select(in_period > 1.0F, 2.0F - in_period, in_period);
}

/// Two neighbouring texels of a row or column, and the weight of the second.
struct TexelPair {
    Int first;
    Int second;
    Float weight;
};

BALCONY_FORMULA TexelPair texels_around(Float position, Int count, scene::Wrap wrap) {
    const Float x = wrapped(position, wrap) * as_float(count) - 0.5F;
    const Float below = floored(x);
    const Int last = count - 1;
    // Also of a number that is not finite, so that no texel outside the image is read.
    const Int found = smaller(larger(truncated(below), Int(-1)), last);
    const bool repeats = wrap == scene::Wrap::repeat;
    return {select(found < 0, repeats ? last : Int(0), found),
            select(found < last, found + 1, repeats ? Int(0) : last), x - below};
}

/// The nearest texel twice, where asked for.
BALCONY_FORMULA TexelPair nearest_of(Where asked, const TexelPair& found) {
    const Int nearest = select(found.weight < 0.5F, found.first, found.second);
    return {select(asked, nearest, found.first), select(asked, nearest, found.second),
            found.weight};
}

BALCONY_FORMULA Int side_of_level(std::int32_t of_image, Int level) {
    return larger(Int(of_image) >> level, Int(1));
}

template <class Texels>
BALCONY_FORMULA auto bilinear(const ImageLevels& image, const Texels& texels, Int level,
                              const Float2& at) {
    const Int width = side_of_level(image.width, level);
    const Int height = side_of_level(image.height, level);
    TexelPair columns = texels_around(at.x, width, image.wrap_u);
    TexelPair lines = texels_around(at.y, height, image.wrap_v);
    if (!image.interpolated) {
        columns = nearest_of(level == 0, columns);
        lines = nearest_of(level == 0, lines);
    }
    const auto rows = texels.rows(level, width, columns);
    const auto above = rows(lines.first);
    const auto below = rows(lines.second);
    return mix(mix(above.first, above.second, columns.weight),
               mix(below.first, below.second, columns.weight), lines.weight);
}

// The probes lie at equal distances on the longer axis of the footprint. Each is as wide as the
// footprint, but at least as their distance, so that there are no gaps.
template <class Texels, class Footprint>
BALCONY_FORMULA auto mean_within(const ImageLevels& image, const Texels& texels,
                                 const Footprint& footprint) {
    const Float2 size{static_cast<float>(image.width), static_cast<float>(image.height)};
    const FootprintEllipse ellipse =
        footprint_ellipse(footprint.along_x * size, footprint.along_y * size);
    const Float aspect = smaller(ellipse.length / larger(ellipse.width, 1.0F),
                                 static_cast<float>(ImageLevels::max_probes));
    const Int probes = larger(truncated(aspect + 0.7F), Int(1));
    const Float spacing = 1.0F / as_float(probes);
    const Float width = larger(larger(ellipse.width, ellipse.length * spacing), 1.0F);

    // Level n has texels with a side of 2^n. The width is 2^n times 1 + the share of the next
    // level.
    const Int last = image.last;
    const Int level = smaller(exponent_of(width), last);
    const Int blurred = smaller(level + 1, last);
    const Float share = or_zero(level < last, fraction_of(width));
    const bool between_levels = any(share > 0.0F);

    const Float2 step = spacing * ellipse.axis / size;
    Float2 at = footprint.at - 0.5F * (as_float(probes) - 1.0F) * step;
    auto sum = Texels::black();
    for (std::int32_t done = 0; any(Int(done) < probes); ++done) {
        const auto sharper = bilinear(image, texels, level, at);
        const auto color =
            between_levels ? mix(sharper, bilinear(image, texels, blurred, at), share) : sharper;
        sum = sum + or_zero(Int(done) < probes, color);
        at = at + step;
    }
    return sum * spacing;
}

BALCONY_FORMULA Where in_range_of_image(const Float2& v) {
    return both(absolute(v.x) < ImageLevels::max_coordinate,
                absolute(v.y) < ImageLevels::max_coordinate);
}

/// White where the point is out of range; without a filter where the footprint is.
template <class Texels, class Footprint>
BALCONY_FORMULA auto mean_over(const ImageLevels& image, const Texels& texels,
                               const Footprint& footprint) {
    const Where inside = in_range_of_image(footprint.at);
    const Where filtered = both(
        inside, both(in_range_of_image(footprint.along_x), in_range_of_image(footprint.along_y)));
    const auto mean =
        mean_within(image, texels,
                    Footprint{or_zero(inside, footprint.at), or_zero(filtered, footprint.along_x),
                              or_zero(filtered, footprint.along_y)});
    return select(inside, mean, Texels::white());
}
