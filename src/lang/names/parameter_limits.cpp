// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/parameter_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "camera/catalogue/parameter_text.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

struct Limits {
    camera::Range range;
    bool of_angles = false;   ///< One of them is an angle.
    bool of_numbers = false;  ///< One of them is a plain number other than 0.
};

class LimitsReader {
public:
    LimitsReader(const LocatedDefinition& place, const DefinitionParameter& parameter,
                 Session& session)
        : tree_(place.module->tree),
          scope_(*place.module->scope),
          parameter_(parameter),
          session_(session) {}

    std::optional<Limits> run() {
        Limits read;
        read.range.excludes_minimum = parameter_.excludes_minimum;
        if (!limit(parameter_.minimum, read.range.minimum, read) ||
            !limit(parameter_.maximum, read.range.maximum, read)) {
            return std::nullopt;
        }
        const bool empty = read.range.excludes_minimum ? read.range.minimum >= read.range.maximum
                                                       : read.range.minimum > read.range.maximum;
        if (empty) {
            error(parameter_.limits,
                  fmt::format("no number is within the limits of '{}'", parameter_.name.text),
                  "write the lower one first: from 1 to 20");
            return std::nullopt;
        }
        return read;
    }

private:
    void error(Span span, std::string message, std::string remedy) {
        session_.reporter().error(tree_.at(span), std::move(message), std::move(remedy));
    }

    bool limit(ExpressionId id, double& number, Limits& read) {
        if (!id.valid()) {
            return true;
        }
        const Value value = evaluate(tree_, id, scope_, session_.context());
        if (value.failed()) {
            return false;
        }
        if (!value.is_constant()) {
            error(tree_[id].span, "a limit of a parameter is constant, but this changes with time",
                  "write a number");
            return false;
        }
        number = value.constant();
        read.of_angles = read.of_angles || value.is_angle();
        read.of_numbers = read.of_numbers || value.is_plain_number();
        return true;
    }

    const SyntaxTree& tree_;
    Scope& scope_;
    const DefinitionParameter& parameter_;
    Session& session_;
};

/// Times at which a formula of the time changes, as at a key.
std::vector<double> times_of_changes(expr::Expr value) {
    const expr::Graph& graph = value.graph();
    std::vector<double> times;
    for (const expr::NodeId id : expr::reachable(graph, std::array{value})) {
        const expr::Node& node = graph[id];
        if (node.op != expr::Op::less && node.op != expr::Op::less_equal) {
            continue;
        }
        const expr::Node& left = graph[node.operands[0]];
        const expr::Node& right = graph[node.operands[1]];
        const expr::Node& time = right.op == expr::Op::constant ? left : right;
        const expr::Node& key = right.op == expr::Op::constant ? right : left;
        if (key.op == expr::Op::constant && time.op == expr::Op::input &&
            time.detail == expr::inputs::t.value()) {
            times.push_back(key.value);
        }
    }
    std::sort(times.begin(), times.end());
    return times;
}

std::string must_be(const DefinitionParameter& parameter, const Limits& limits, Unit unit) {
    return fmt::format("'{}' must be {}", parameter.name.text,
                       camera::range_text(limits.range, unit));
}

Unit unit_of(const Limits& limits, const Value& value) {
    return limits.of_angles || value.is_angle() ? Unit::angle : Unit::number;
}

Value constant_within(const Value& value, const SourceSpan& span, const Limits& limits,
                      const LocatedDefinition& place, const DefinitionParameter& parameter,
                      Session& session) {
    if (camera::contains(limits.range, value.constant())) {
        return value;
    }
    const Unit unit = unit_of(limits, value);
    const SyntaxTree& tree = place.module->tree;
    const Span written = tree[parameter.default_value].span;
    const bool is_default = span.source == tree.source && span.begin == written.begin;
    session.reporter().error(span,
                             fmt::format("{}, but is {}", must_be(parameter, limits, unit),
                                         camera::number_text(value.constant(), unit)),
                             is_default ? "give it another value, or change its limits"
                                        : fmt::format("its default is {}", tree.text(written)));
    return {};
}

Value held_within(const Value& value, const SourceSpan& span, const Limits& limits,
                  const DefinitionParameter& parameter, Session& session) {
    const camera::Range& range = limits.range;
    std::vector<expr::InputValue> inputs;
    for (const camera::KnownInput& input : session.inputs()) {
        inputs.push_back({input.name, input.value});
    }
    for (const double time : times_of_changes(value.expr)) {
        const double there =
            expr::evaluate(std::array{value.expr}, {.time = time, .inputs = inputs}).front();
        if (!camera::contains(range, there)) {
            const Unit unit = unit_of(limits, value);
            session.reporter().warning(
                span,
                fmt::format("{}, but is {} at t = {:.6g}", must_be(parameter, limits, unit),
                            camera::number_text(there, unit), time),
                fmt::format(
                    "it is held at {}",
                    camera::number_text(std::clamp(there, range.minimum, range.maximum), unit)));
            break;
        }
    }
    Value made = value;
    expr::Graph& graph = *session.graph();
    if (std::isfinite(range.minimum)) {
        made.expr = max(made.expr, graph.constant(range.minimum));
    }
    if (std::isfinite(range.maximum)) {
        made.expr = min(made.expr, graph.constant(range.maximum));
    }
    return made;
}

}  // namespace

camera::Range limits_of(const LocatedDefinition& place, const DefinitionParameter& parameter,
                        Session& session) {
    const auto limits = LimitsReader(place, parameter, session).run();
    return limits ? limits->range : camera::Range();
}

Value within_limits(const Value& value, const SourceSpan& span, const LocatedDefinition& place,
                    const DefinitionParameter& parameter, Session& session) {
    const bool unlimited = !parameter.minimum.valid() && !parameter.maximum.valid();
    if (unlimited || value.failed()) {
        return value;
    }
    const auto limits = LimitsReader(place, parameter, session).run();
    if (!limits) {
        return value;
    }
    const bool fits = value.form == Value::Form::number &&
                      !(limits->of_numbers && value.is_angle()) &&
                      !(limits->of_angles && (limits->of_numbers || value.is_plain_number()));
    if (!fits) {
        session.reporter().error(
            place.module->tree.at(parameter.limits),
            fmt::format("the limits of '{}' do not fit its value", parameter.name.text),
            "write numbers for a number, and angles (30deg, 0.5rad) for an "
            "angle; tuples and lists have no limits");
        return {};
    }
    return value.is_constant() ? constant_within(value, span, *limits, place, parameter, session)
                               : held_within(value, span, *limits, parameter, session);
}

}  // namespace balcony::lang
