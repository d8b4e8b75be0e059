// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/pictures/layer_arrangers.hpp"

#include <algorithm>
#include <array>

#include "camera/machine/arrange.hpp"

namespace balcony::camera {

namespace {

using NestedPicture = std::shared_ptr<const Picture>;

/// A picture of an aspect in the middle of another: as large as fits, or as small as covers it. The
/// aspect is that of a region of a picture with `aspect`.
class Fitting final : public PictureArranger {
public:
    Fitting(Fit fit, double aspect, PictureRegion region)
        : fit_(fit), aspect_(aspect), region_(std::move(region)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr aspect = aspect_ * (emit(region_.to[0]) - emit(region_.from[0])) /
                            (emit(region_.to[1]) - emit(region_.from[1]));
        const Expr width = side(size.width, size.height * aspect);
        const Expr height = side(size.height, size.width / aspect);
        return {{point.x - 0.5 * (size.width - width), point.y - 0.5 * (size.height - height)},
                {width, height}};
    }

private:
    /// The side of the place, or what follows from the other side. A difference of at most a pixel
    /// is none, so that sizes in whole pixels leave no gap.
    [[nodiscard]] Expr side(Expr place, Expr from_other_side) const {
        const Expr keeps =
            fit_ == Fit::fit ? place <= from_other_side + 1.0 : from_other_side <= place + 1.0;
        return select(keeps, place, from_other_side);
    }

    Fit fit_;
    double aspect_;
    PictureRegion region_;
};

/// A region of a picture as a whole.
class Cropping final : public PictureArranger {
public:
    explicit Cropping(PictureRegion region) : region_(std::move(region)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr left = emit(region_.from[0]);
        const Expr top = emit(region_.from[1]);
        const Expr width = size.width / (emit(region_.to[0]) - left);
        const Expr height = size.height / (emit(region_.to[1]) - top);
        return {{point.x + left * width, point.y + top * height}, {width, height}};
    }

private:
    PictureRegion region_;
};

constexpr std::array fit_rows = {
    Named{Fit::fit, "fit", "as large as the place permits, in its middle"},
    Named{Fit::fill, "fill", "covers the place; what is beyond it is cut off"},
    Named{Fit::stretch, "stretch", "stretched to the place"},
};

constexpr std::size_t reference_height = 1000;

std::array<double, 2> reference_size(const Picture::Parts& parts) {
    return {parts.aspect.value_or(default_aspect) * reference_height, reference_height};
}

std::optional<double> fixed_aspect(const Layer& layer) {
    const auto* inner = std::get_if<NestedPicture>(&layer.content);
    return inner != nullptr ? (*inner)->fixed_aspect()
                            : std::get<Camera>(layer.content).fixed_aspect();
}

// The aspect of a layer's own picture; nothing if it may be any. A region needs one: what adapts
// has that of the layer below that shows the same, at time 0, or that of the whole picture.
std::optional<double> aspect_of(const Picture::Parts& parts, std::size_t index) {
    const Layer& layer = parts.layers[index];
    const std::optional<double> fixed = fixed_aspect(layer);
    if (fixed || !layer.show) {
        return fixed;
    }
    const std::optional<std::size_t> source = source_of(parts, index);
    const auto [width, height] = reference_size(parts);
    const auto sides = source
                           ? arranged_size(arrangers_of(parts, *source).all(), width, height, 0.0)
                           : std::array{width, height};
    return sides[0] > 0.0 && sides[1] > 0.0 ? sides[0] / sides[1] : width / height;
}

bool show_the_same(const Layer& a, const Layer& b) {
    const auto* camera_a = std::get_if<Camera>(&a.content);
    const auto* camera_b = std::get_if<Camera>(&b.content);
    if (camera_a != nullptr && camera_b != nullptr) {
        return &camera_a->parts() == &camera_b->parts();
    }
    const auto* picture_a = std::get_if<NestedPicture>(&a.content);
    const auto* picture_b = std::get_if<NestedPicture>(&b.content);
    return picture_a != nullptr && picture_b != nullptr && *picture_a == *picture_b;
}

}  // namespace

Names<Fit> fits() { return Names<Fit>(fit_rows); }

std::optional<std::size_t> source_of(const Picture::Parts& parts, std::size_t layer) {
    for (std::size_t i = layer; i-- > 0;) {
        if (show_the_same(parts.layers[i], parts.layers[layer])) {
            return i;
        }
    }
    return std::nullopt;
}

PictureRegion shown_region(const Layer& layer) {
    return layer.show.value_or(PictureRegion{{0.0, 0.0}, {1.0, 1.0}});
}

PictureArrangerPointer fitting_of(const Picture& picture) {
    const Picture::Parts& parts = picture.parts();
    return parts.fit == Fit::stretch || !parts.aspect || picture.only_camera() != nullptr
               ? nullptr
               : fitting(parts.fit, *parts.aspect);
}

PictureArrangerPointer fitting(Fit fit, double aspect) {
    return std::make_shared<const Fitting>(fit, aspect, PictureRegion{{0.0, 0.0}, {1.0, 1.0}});
}

LayerArrangers arrangers_of(const Picture::Parts& parts, std::size_t index) {
    const Layer& layer = parts.layers[index];
    LayerArrangers made{layer.arrangers, layer.inner_arrangers};
    const std::optional<double> aspect = aspect_of(parts, index);
    if (aspect && layer.fit != Fit::stretch) {
        auto& fitted = layer.fit == Fit::fit ? made.window : made.content;
        fitted.push_back(std::make_shared<const Fitting>(layer.fit, *aspect, shown_region(layer)));
    }
    if (layer.show) {
        made.content.push_back(std::make_shared<const Cropping>(*layer.show));
    }
    return made;
}

std::vector<PictureArrangerPointer> LayerArrangers::all() const {
    std::vector<PictureArrangerPointer> joined = window;
    joined.insert(joined.end(), content.begin(), content.end());
    return joined;
}

}  // namespace balcony::camera
