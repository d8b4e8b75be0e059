// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/tools/open_camera.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace balcony::lang {

std::string parameter_input(std::string_view parameter) {
    return fmt::format("parameter {}", parameter);
}

namespace {

// Origin, direction and validity at some points of a picture, with the open parameters at their
// values.
std::vector<double> some_rays(const camera::Camera& camera) {
    constexpr double height = 360.0;
    const double width = height * camera.parts().aspect;
    expr::Graph graph;
    const camera::RayExpressions ray = camera.emit(graph, width, height);
    const std::array roots{ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                           ray.direction.y, ray.direction.z, ray.valid};
    std::vector<expr::InputValue> inputs;
    for (const camera::KnownInput& input : camera.parts().inputs) {
        inputs.push_back({input.name, input.value});
    }
    std::vector<double> values;
    for (const double x : {0.07, 0.31, 0.5, 0.84}) {
        for (const double y : {0.11, 0.5, 0.77}) {
            const std::vector<double> r = expr::evaluate(
                roots, {.x = x * width, .y = y * height, .time = 0.25, .inputs = inputs});
            const bool valid = r.back() == 1.0;
            for (const double value : r) {
                values.push_back(valid ? value : 0.0);
            }
        }
    }
    return values;
}

// A stage may choose another formula if it does not know a number, but none that gives other rays.
bool same_rays(const camera::Camera& a, const camera::Camera& b) {
    const std::vector<double> of_a = some_rays(a);
    const std::vector<double> of_b = some_rays(b);
    constexpr double tolerance = 1e-9;
    return std::equal(of_a.begin(), of_a.end(), of_b.begin(), [](double one, double other) {
        return std::abs(one - other) <= tolerance * (1.0 + std::abs(one));
    });
}

// The attempt with these parameters open, if it gives the same rays.
std::optional<OpenAttempt> attempt(const MakeOpen& make, const std::vector<std::string>& open,
                                   const camera::Camera& closed) {
    Result<OpenAttempt> made = make(open);
    const bool good = made && !has_errors(made.diagnostics) && same_rays(closed, made->camera);
    return good ? std::move(made.value) : std::nullopt;
}

}  // namespace

OpenAttempt open_attempt(camera::Camera camera, const LocatedDefinition& place,
                         const std::vector<Override>& overrides, const std::vector<Value>& values) {
    OpenAttempt made{std::move(camera), {}, {}};
    const SyntaxTree& tree = place.module->tree;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DefinitionParameter& parameter = place.camera->parameters[i];
        const std::string name(parameter.name.text);
        if (!values[i].is_constant()) {
            made.others.push_back(name);
            continue;
        }
        std::string written(tree.text(tree[parameter.default_value].span));
        for (const Override& given : overrides) {
            written = given.name == name ? given.expression : written;
        }
        made.numbers.push_back(
            {name, written, values[i].constant(), values[i].dimension == Dimension::angle});
    }
    return made;
}

Result<OpenCamera> open_camera(const MakeOpen& make,
                               const std::optional<std::vector<std::string>>& requested) {
    Result<OpenAttempt> closed = make({});
    if (!closed) {
        return std::move(closed.diagnostics);
    }
    OpenCamera made{closed->camera, {}, closed->others};
    std::vector<std::string> candidates;
    for (const OpenParameter& number : closed->numbers) {
        if (!requested ||
            std::find(requested->begin(), requested->end(), number.name) != requested->end()) {
            candidates.push_back(number.name);
        }
    }
    const auto accept = [&](const OpenAttempt& opened, const std::vector<std::string>& names) {
        made.camera = opened.camera;
        made.open.clear();
        for (const OpenParameter& number : closed->numbers) {
            if (std::find(names.begin(), names.end(), number.name) != names.end()) {
                made.open.push_back(number);
            }
        }
    };
    if (const auto all = attempt(make, candidates, closed->camera)) {
        accept(*all, candidates);
        return {std::move(made), std::move(closed.diagnostics)};
    }
    std::vector<std::string> open;
    for (const std::string& name : candidates) {
        open.push_back(name);
        if (const auto more = attempt(make, open, closed->camera)) {
            accept(*more, open);
        } else {
            open.pop_back();
            made.closed.push_back(name);
        }
    }
    return {std::move(made), std::move(closed.diagnostics)};
}

}  // namespace balcony::lang
