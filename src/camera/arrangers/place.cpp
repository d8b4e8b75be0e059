// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Picture arrangers, DCS → DCS: which part of the picture a camera fills.

#include "camera/families.hpp"

namespace balcony::camera {

namespace {

/// Clips to a rectangle of the picture and scales the camera's own picture into it. Corners are
/// fractions of the picture's size from its left and top edge.
class Place final : public PictureArranger {
public:
    Place(std::array<Scalar, 2> from, std::array<Scalar, 2> to)
        : from_(std::move(from)), to_(std::move(to)) {}

    ArrangedPoint arrange(const ArrangedPoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr x = point.x - emit(from_[0]) * size.width;
        const Expr y = point.y - emit(from_[1]) * size.height;
        const Expr width = (emit(to_[0]) - emit(from_[0])) * size.width;
        const Expr height = (emit(to_[1]) - emit(from_[1])) * size.height;
        emit.require(0.0 <= x && x < width && 0.0 <= y && y < height);
        return {{x, y}, {width, height}};
    }

private:
    std::array<Scalar, 2> from_, to_;
};

}  // namespace

std::vector<StageEntry> picture_arrangers() {
    using enum ParameterType;
    return {
        {StageKind::picture_arranger,
         "place",
         "puts the camera's picture into a part of the whole",
         {{.name = "from",
           .type = pair,
           .default_value = {0.0, 0.0},
           .meaning = "top left corner, as a fraction of the picture"},
          {.name = "to",
           .type = pair,
           .default_value = {1.0, 1.0},
           .meaning = "bottom right corner, as a fraction of the picture"}},
         [](const Arguments& a) -> Result<std::shared_ptr<const Stage>> {
             const auto from = a.pair("from");
             const auto to = a.pair("to");
             for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
                 const auto first = from[i].constant();
                 const auto last = to[i].constant();
                 if (first && last && *last <= *first) {
                     return error("this place has no area", {},
                                  "'from' is its top left corner, 'to' its bottom right one");
                 }
             }
             return made<Place>(from, to);
         }},
    };
}

}  // namespace balcony::camera
