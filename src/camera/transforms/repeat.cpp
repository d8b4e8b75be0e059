// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter and object transformers that apply a sequence of others a number of times.

#include <fmt/format.h>

#include "camera/families.hpp"
#include "camera/stage_parameters.hpp"

namespace balcony::camera {

namespace {

constexpr double max_times = 64.0;
/// The maximum number of stages in nested repeats.
constexpr std::size_t max_applied = 4096;

template <class Port, class Point>
class Repeat final : public Port {
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

private:
    std::size_t times_;
    std::vector<std::shared_ptr<const Port>> stages_;
};

template <class Port, class Point>
Result<std::shared_ptr<const Stage>> make_repeat(const Arguments& a) {
    auto repeat =
        std::make_shared<const Repeat<Port, Point>>(a.count("times"), a.stages<Port>("stages"));
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
         .parameters = parameters(parameter_kind),
         .make = make_repeat<ParameterTransformer, ParameterPoint>,
         .example = R"(camera repeat {
    map    u = 1.4 .. -1.4, v = square
    warp   repeat(5, zoom(at = (0.6, 0), radius = 0.6, strength = 1.4), rotate(72deg))
    eye    point
    toward plane((1, 0, 0))
})"},
        {.kind = object_kind,
         .name = "repeat",
         .meaning = "applies object transformers repeatedly",
         .parameters = parameters(object_kind),
         .make = make_repeat<ObjectTransformer, ObjectPoint>,
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
