// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter and object transformers that apply a sequence of others a number of times.

#include <algorithm>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

constexpr double max_times = 64.0;
/// The maximum number of stages in nested repeats.
constexpr std::size_t max_applied = 4096;

template <class Port, class Point>
class Repeat : public Port {
public:
    Repeat(std::size_t times, std::vector<std::shared_ptr<const Port>> stages)
        : times_(times), stages_(std::move(stages)) {}

    Point transform(const Point& p, Emitter& emit) const override {
        Point q = p;
        for (std::size_t i = 0; i < times_; ++i) {
            for (const auto& stage : stages_) {
                q = stage->transform(q, emit);
            }
        }
        return q;
    }

    /// The total number of stages that it applies.
    [[nodiscard]] std::size_t applied() const {
        std::size_t once = 0;
        for (const auto& stage : stages_) {
            const auto* repeat = dynamic_cast<const Repeat*>(stage.get());
            once += repeat != nullptr ? repeat->applied() : 1;
        }
        return times_ * once;
    }

protected:
    std::size_t times_;
    std::vector<std::shared_ptr<const Port>> stages_;
};

using ParameterRepeat = Repeat<ParameterTransformer, ParameterPoint>;

/// Its stages may need the normals of the object.
class ObjectRepeat final : public Repeat<ObjectTransformer, ObjectPoint> {
public:
    using Repeat::Repeat;
    int min_dimension() const override {
        int minimum = 0;
        for (const ObjectTransformerPointer& stage : stages_) {
            minimum = std::max(minimum, stage->min_dimension());
        }
        return minimum;
    }
    ObjectElement transform_element(const ObjectElement& e, Emitter& emit) const override {
        ObjectElement moved = e;
        for (std::size_t i = 0; i < times_; ++i) {
            for (const ObjectTransformerPointer& stage : stages_) {
                moved = stage->transform_element(moved, emit);
            }
        }
        return moved;
    }
};

template <class Concrete, class Port>
StageResult make_repeat(const Arguments& a) {
    auto repeat = std::make_shared<const Concrete>(a.count("times"), a.stages<Port>("stages"));
    if (const std::size_t applied = repeat->applied(); applied > max_applied) {
        return error(fmt::format("nested repeats apply {} stages", applied), {},
                     fmt::format("reduce the repetitions to at most {} stages", max_applied));
    }
    return {std::shared_ptr<const Stage>(std::move(repeat))};
}

std::vector<StageParameter> parameters(StageKind kind) {
    return {{.name = "times",
             .type = CountParameter{.range = {.minimum = 1.0, .maximum = max_times}},
             .meaning = "number of repetitions"},
            {.name = "stages",
             .type = NestedStageParameter{.kind = kind, .several = true},
             .meaning = "the stages to repeat, in sequence"}};
}

}  // namespace

std::vector<StageEntry> repeats() {
    const StageKind parameter_kind = StageKind::parameter_transformer;
    const StageKind object_kind = StageKind::object_transformer;
    return {
        {.kind = parameter_kind,
         .name = "repeat",
         .meaning = "applies parameter transformers repeatedly",
         .formula = R"(
(u′, v′) = (fₙ ∘ … ∘ f₂ ∘ f₁)^times (u, v)      f₁, …, fₙ   the stages
)",
         .parameters = parameters(parameter_kind),
         .make = make_repeat<ParameterRepeat, ParameterTransformer>,
         .example = R"(camera repeat {
    map    u = 1.4 .. -1.4, v = square
    warp   repeat(5, zoom(at = (0.6, 0), radius = 0.6, strength = 1.4), rotate(72deg))
    eye    point
    toward plane((1, 0, 0))
})"},
        {.kind = object_kind,
         .name = "repeat",
         .meaning = "applies object transformers repeatedly",
         .formula = R"(
p′ = (fₙ ∘ … ∘ f₂ ∘ f₁)^times (p)      f₁, …, fₙ   the stages
)",
         .parameters = parameters(object_kind),
         .make = make_repeat<ObjectRepeat, ObjectTransformer>,
         .example = R"(camera repeat {
    map    u = 1.6 .. -1.6, v = square
    eye    point
    toward {
        object plane((2, 0, 0))
        move   repeat(6, coin((2, 0.9, 0), strength = 0.6, radius = 0.5), rotate(x, 60deg))
    }
})"},
    };
}

}  // namespace balcony::camera
