// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/morph.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "balcony/make_stage.hpp"
#include "camera/machine/arrange.hpp"
#include "camera/pictures/layer_arrangers.hpp"
#include "camera/rules/great_circle.hpp"

namespace balcony::camera {

namespace {

/// A ray of one of the cameras, or one between.
struct MorphedRay {
    ObjectPoint origin;
    ObjectVector direction;
    Expr valid;
};

/// A camera in a picture of any aspect, as a layer shows it.
MorphedRay ray_of(const Camera& camera, const Morph& morph, const PicturePoint& whole) {
    Emitter emit(whole.size.width.graph());
    PicturePoint own = whole;
    const std::optional<double> aspect = camera.fixed_aspect();
    if (aspect && morph.fit != Fit::stretch) {
        own = fitting(morph.fit, *aspect)->arrange(whole, emit);
        emit.require(inside(own));
    }
    const RayExpressions ray = camera.emit(own);
    emit.require(ray.valid);
    const Axes axes = camera.parts().axes;
    return {turned(ray.origin, axes, morph.axes), turned(ray.direction, axes, morph.axes),
            emit.valid()};
}

/// What one camera has where the amount is 0 or 1, so that nothing of the other one matters there.
template <class Vector>
Vector chosen(Expr is_first, const Vector& first, Expr is_second, const Vector& second,
              const Vector& between) {
    const auto choose = [&](Expr a, Expr b, Expr c) {
        return select(is_first, a, select(is_second, b, c));
    };
    return {choose(first.x, second.x, between.x), choose(first.y, second.y, between.y),
            choose(first.z, second.z, between.z)};
}

MorphedRay ray_between(const Morph& morph, const PicturePoint& picture) {
    Graph& graph = picture.size.width.graph();
    const std::array fractions{picture.point.x / picture.size.width,
                               picture.point.y / picture.size.height};
    const Expr amount = morph.amount.emit(graph, fractions).front();
    const MorphedRay first = ray_of(morph.first, morph, picture);
    const MorphedRay second = ray_of(morph.second, morph, picture);
    const Expr is_first = expr::equal(amount, graph.constant(0.0));
    const Expr is_second = expr::equal(amount, graph.constant(1.0));
    Emitter both(graph);
    both.require(first.valid && second.valid);
    const ObjectPoint origin = first.origin + amount * (second.origin - first.origin);
    const ObjectVector direction = on_great_circle(first.direction, second.direction, amount, both);
    return {chosen(is_first, first.origin, is_second, second.origin, origin),
            chosen(is_first, first.direction, is_second, second.direction, direction),
            select(is_first, first.valid, select(is_second, second.valid, both.valid()))};
}

/// The origins or the directions of a morph, over the fractions of its picture.
class MorphObject final : public ObjectGenerator {
public:
    MorphObject(std::shared_ptr<const Morph> morph, int dimension, bool directions)
        : morph_(std::move(morph)), dimension_(dimension), directions_(directions) {}

    int dimension() const override { return dimension_; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        assert(emit.picture_size());
        const PictureSize& size = *emit.picture_size();
        const MorphedRay ray =
            ray_between(*morph_, {{p.u * size.width, (1.0 - p.v) * size.height}, size});
        emit.require(ray.valid);
        const ObjectPoint center{emit(0.0), emit(0.0), emit(0.0)};
        return directions_ ? center + ray.direction : ray.origin;
    }

private:
    std::shared_ptr<const Morph> morph_;
    int dimension_;
    bool directions_;
};

class FractionsOfPicture final : public PictureMapper {
public:
    explicit FractionsOfPicture(bool adapts) : adapts_(adapts) {}
    ParameterPoint map(const PicturePoint& picture, Emitter&) const override {
        return {picture.point.x / picture.size.width, 1.0 - picture.point.y / picture.size.height};
    }
    bool adapts_to_aspect() const override { return adapts_; }

private:
    bool adapts_;
};

// Two points are a point, if the amount is the same in the whole picture.
int dimension_of_origins(const Morph& morph) {
    Graph graph;
    const std::array fractions{graph.picture_x(), graph.picture_y()};
    const expr::Dependence dependence = morph.amount.emit(graph, fractions).front().dependence();
    const bool varies = dependence.intersects(expr::Dependence::on(expr::inputs::x) |
                                              expr::Dependence::on(expr::inputs::y));
    const int first = morph.first.parts().eye.generator->dimension();
    const int second = morph.second.parts().eye.generator->dimension();
    return first == 0 && second == 0 && !varies ? 0 : 2;
}

}  // namespace

Camera::Parts morphed(const Morph& morph) {
    const auto shared = std::make_shared<const Morph>(morph);
    const std::optional<double> aspects[] = {morph.aspect, morph.first.fixed_aspect(),
                                             morph.second.fixed_aspect(),
                                             morph.first.parts().aspect};
    const auto mapper = std::make_shared<const FractionsOfPicture>(!aspects[1] && !aspects[2]);
    Camera::Parts parts;
    parts.aspect = **std::find_if(std::begin(aspects), std::end(aspects),
                                  [](const auto& aspect) { return aspect.has_value(); });
    parts.axes = morph.axes;
    parts.eye.mapper = mapper;
    parts.eye.generator =
        std::make_shared<const MorphObject>(shared, dimension_of_origins(morph), false);
    parts.toward = Path{mapper, {}, std::make_shared<const MorphObject>(shared, 2, true), {}};
    parts.look = *make_stage<DirectionRule>("absolute", {});
    return parts;
}

}  // namespace balcony::camera
