// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/tools/open_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <span>

#include <fmt/format.h>

#include "lang/names/parameter_limits.hpp"

namespace balcony::lang {

OpenParameter MovingParameter::at(double time) const {
    expr::Graph graph;
    OpenParameter made = number;
    made.value = expr::evaluate(std::array{over_time.emit(graph)}, {.time = time}).front();
    return made;
}

std::string parameter_input(std::string_view parameter) {
    return fmt::format("parameter {}", parameter);
}

namespace {

using Elements = std::vector<camera::PictureExpressions::Element>;

// The numbers of an element of a picture: its coverage, its colours, and the ray, whose last number
// is its validity.
struct Numbers {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool of_ray = false;
};

void add_numbers(const Elements& elements, std::vector<expr::Expr>& roots,
                 std::vector<Numbers>& all) {
    const auto add = [&](const std::vector<expr::Expr>& some, bool of_ray) {
        all.push_back({roots.size(), roots.size() + some.size(), of_ray});
        roots.insert(roots.end(), some.begin(), some.end());
    };
    for (const camera::PictureExpressions::Element& element : elements) {
        add({element.coverage}, false);
        if (element.paint) {
            add({element.paint->begin(), element.paint->end()}, false);
        }
        if (element.ray) {
            const camera::RayExpressions& ray = *element.ray;
            std::vector<expr::Expr> values{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                           ray.direction.x, ray.direction.y, ray.direction.z,
                                           ray.valid};
            if (ray.bend) {
                const camera::ObjectVector& last = ray.bend->direction;
                values.insert(values.end(), {last.x, last.y, last.z});
                for (const camera::ObjectPoint& knot : ray.bend->knots) {
                    values.insert(values.end(), {knot.x, knot.y, knot.z});
                }
            }
            add(values, true);
        }
        add_numbers(element.group, roots, all);
    }
}

// What a picture shows at some points, with the open parameters at their values.
std::vector<double> some_values(const camera::Picture& picture) {
    constexpr double height = 360.0;
    const double width = height * picture.aspect();
    expr::Graph graph;
    std::vector<expr::Expr> roots;
    std::vector<Numbers> all;
    add_numbers(picture.emit(graph, width, height).elements, roots, all);
    std::vector<expr::InputValue> inputs;
    const std::vector<camera::ShownCamera> cameras = camera::shown_cameras(picture);
    for (const camera::ShownCamera& shown : cameras) {
        for (const camera::KnownInput& input : shown.camera.parts().inputs) {
            inputs.push_back({input.name, input.value});
        }
    }
    std::vector<double> values;
    for (const double x : {0.07, 0.31, 0.5, 0.84}) {
        for (const double y : {0.11, 0.5, 0.77}) {
            const std::vector<double> at = expr::evaluate(
                roots, {.x = x * width, .y = y * height, .time = 0.25, .inputs = inputs});
            for (const Numbers& numbers : all) {
                const bool valid = !numbers.of_ray || at[numbers.end - 1] == 1.0;
                for (std::size_t i = numbers.begin; i < numbers.end; ++i) {
                    values.push_back(valid && !std::isnan(at[i]) ? at[i] : 0.0);
                }
            }
        }
    }
    return values;
}

// A stage may choose another formula if it does not know a number, but none that shows something
// else.
bool show_the_same(const camera::Picture& a, const camera::Picture& b) {
    const std::vector<double> of_a = some_values(a);
    const std::vector<double> of_b = some_values(b);
    constexpr double tolerance = 1e-9;
    return std::equal(of_a.begin(), of_a.end(), of_b.begin(), [](double one, double other) {
        return std::abs(one - other) <= tolerance * (1.0 + std::abs(one));
    });
}

bool changes_with_time(const Value& value) {
    return value.form == Value::Form::number && value.expr.valid() &&
           value.expr.dependence() == expr::Dependence::on(expr::inputs::t);
}

double value_at_start(const Value& value) {
    return expr::evaluate(std::array{value.expr}, {}).front();
}

}  // namespace

std::string default_text(const ResolvedLayer& found, const DefinitionParameter& parameter) {
    const SyntaxTree& tree = found.place.module->tree;
    SourceSpan written = tree.at(tree[parameter.default_value].span);
    for (auto given = found.given.values.rbegin(); given != found.given.values.rend(); ++given) {
        written = given->name.text == parameter.name.text ? given->value_place : written;
    }
    return std::string(written.source->text().substr(written.begin, written.end - written.begin));
}

OpenAttempt open_attempt(camera::Picture picture, const ResolvedLayer& found,
                         const std::vector<Value>& values, Session& session) {
    OpenAttempt made{std::move(picture), {}, {}, {}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DefinitionParameter& parameter = found.place.camera->parameters[i];
        const std::string name(parameter.name.text);
        const bool is_moving = changes_with_time(values[i]);
        if (!values[i].is_constant()) {
            made.others.push_back(name);
        }
        if (!values[i].is_constant() && !is_moving) {
            continue;
        }
        std::string written = default_text(found, parameter);
        for (const Override& given : found.given.overrides) {
            written = given.name == name ? given.expression : written;
        }
        OpenParameter number{name, written, value_at_start(values[i]),
                             values[i].unit == Unit::angle,
                             limits_of(found.place, parameter, session)};
        if (is_moving) {
            made.moving.push_back(
                {std::move(number),
                 camera::Scalar(camera::Formula(session.graph(), {}, {values[i].expr}),
                                values[i].unit)});
        } else {
            made.numbers.push_back(std::move(number));
        }
    }
    return made;
}

Result<OpenPicture> open_picture(const MakeOpen& make,
                                 const std::optional<std::vector<std::string>>& requested) {
    Result<OpenAttempt> closed = make({});
    if (!closed) {
        return std::move(closed.diagnostics);
    }
    OpenPicture made{closed->picture, {}, closed->others, {}, std::move(closed->moving)};
    const std::set<std::string_view> wanted =
        requested ? std::set<std::string_view>(requested->begin(), requested->end())
                  : std::set<std::string_view>();
    std::vector<std::string> candidates;
    for (const OpenParameter& number : closed->numbers) {
        if (!requested || wanted.contains(number.name)) {
            candidates.push_back(number.name);
        }
    }
    // All at once, or else each half by itself, if that shows the same.
    std::vector<std::string> open;
    Diagnostics stopped;
    const std::function<void(std::span<const std::string>)> add =
        [&](std::span<const std::string> names) {
            std::vector<std::string> more = open;
            more.insert(more.end(), names.begin(), names.end());
            Result<OpenAttempt> opened = make(more);
            if (kind_of_errors(opened.diagnostics) == Kind::interrupted) {
                stopped = std::move(opened.diagnostics);
            } else if (opened && !has_errors(opened.diagnostics) &&
                       show_the_same(closed->picture, opened->picture)) {
                made.picture = std::move(opened->picture);
                open = std::move(more);
            } else if (names.size() == 1) {
                made.closed.push_back(names.front());
            } else {
                add(names.first(names.size() / 2));
                add(names.subspan(names.size() / 2));
            }
        };
    if (!candidates.empty()) {
        add(candidates);
    }
    if (!stopped.empty()) {
        return stopped;
    }
    const std::set<std::string_view> is_open(open.begin(), open.end());
    std::copy_if(closed->numbers.begin(), closed->numbers.end(), std::back_inserter(made.open),
                 [&](const OpenParameter& number) { return is_open.contains(number.name); });
    const std::set<std::string_view> is_closed(made.closed.begin(), made.closed.end());
    std::copy_if(closed->numbers.begin(), closed->numbers.end(), std::back_inserter(made.numbers),
                 [&](const OpenParameter& number) { return is_closed.contains(number.name); });
    return {std::move(made), std::move(closed.diagnostics)};
}

}  // namespace balcony::lang
