// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformer, OCS → OCS: central projection onto a surface, as a projector throws a slide
// on a backdrop.

#include "balcony/ray_target.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

class Projection final : public ObjectTransformer {
public:
    using Which = RayTarget::Which;
    Projection(Triple from, std::shared_ptr<const RayTarget> onto, Triple at, Which which)
        : from_(std::move(from)), onto_(std::move(onto)), at_(std::move(at)), which_(which) {}

    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectPoint from = point_of(from_, emit);
        const ObjectVector way = p - from;
        const auto [s, met] = onto_->distance(from + -vector_of(at_, emit), way, which_, emit);
        emit.require_somewhere(
            met, error("no ray from the projector meets the surface of 'project': the backdrop "
                       "cannot be seen from there",
                       {},
                       "move `from` or the surface, or turn the projector: rays go from `from` "
                       "through the points of the object"));
        return from + s * way;
    }

private:
    Triple from_;
    std::shared_ptr<const RayTarget> onto_;
    Triple at_;
    Which which_;
};

StageResult make_projection(const Arguments& a) {
    std::shared_ptr<const RayTarget> target = a.stage<ObjectGenerator>("onto")->ray_target();
    if (!target) {
        return error("'project' cannot follow rays to this surface", {},
                     "give it a plane, sphere, cylinder, wall, folded_screen or mesh");
    }
    return made<Projection>(
        a.triple("from"), std::move(target), a.triple("at"),
        a.choice("hit") == "last" ? RayTarget::Which::last : RayTarget::Which::first);
}

}  // namespace

std::vector<StageEntry> projection() {
    return {
        {.name = "project",
         .meaning = "projects from a point onto a surface, as a projector throws a slide",
         .formula = R"(
p′ = from + s (p − from)
s   the least s > 0 with p′ on the surface (first), or the largest (last)
no ray where there is none
)",
         .parameters =
             {{.name = "from",
               .type = TripleParameter{},
               .meaning = "the centre of the projection, such as the lens of a projector"},
              {.name = "onto",
               .type = NestedStageParameter{.kind = StageKind::object_generator, .dimension = 2},
               .meaning =
                   "the surface: plane, sphere, cylinder, wall, folded_screen or mesh; planes, "
                   "spheres and cylinders are whole, folded screens have any height"},
              triple_parameter("at", {0.0, 0.0, 0.0}, "moves the surface to this point"),
              choice_parameter(
                  "hit", {"first", "last"},
                  "the point of a surface that a ray meets twice, such as the far side of "
                  "a cylinder")},
         .make = make_projection,
         .example = R"(
// A slide from a projector behind the seat, thrown into the corner of a folded screen.
camera slide {
    aspect 3/2
    map    u = 0.6 .. -0.6, v = -0.4 .. 0.4
    eye    point(0, 0, 0)
    toward {
        object plane((-1, 1, 0))
        move   project((-2, 1, 0), onto = folded_screen([(1, 3), (3, 0), (1, -3)]))
    }
}
)"},
    };
}

}  // namespace balcony::camera
