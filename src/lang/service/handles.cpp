// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lang/service/known_handles.hpp"
#include "lang/tools/rewrite.hpp"

namespace balcony::lang {

namespace {

using camera::Range;

bool is_same(const Handle& a, const Handle& b) {
    return a.statement == b.statement && a.stage == b.stage && a.parameter == b.parameter &&
           a.index == b.index && a.begin == b.begin && a.end == b.end;
}

double within(const Range& range, double value, double step) {
    const double least = range.minimum + (range.excludes_minimum ? step : 0.0);
    return std::min(std::max(value, least), range.maximum);
}

// A thousandth of what a number was.
double usual_step(double value) { return 1e-3 * (value == 0.0 ? 1.0 : std::abs(value)); }

std::string_view written_of(const KnownText& text, const HandLeaf& leaf) {
    return text.source->text().substr(leaf.literal.begin, leaf.literal.end - leaf.literal.begin);
}

// What a number's leaf becomes.
Result<std::string> digits_of(const KnownText& text, HandleKind kind, const HandNumber& number,
                              const HandleMove& move) {
    const HandLeaf& leaf = *number.leaf;
    const bool is_count = kind == HandleKind::count;
    const double step = is_count          ? 1.0
                        : move.step > 0.0 ? move.step
                                          : usual_step(number.number.value);
    const double wanted =
        within(number.number.limits, is_count ? std::round(move.value) : move.value, step);
    const std::optional<double> value = leaf_for(number, wanted);
    if (!value) {
        return error(fmt::format("no value of {} makes this number {}",
                                 leaf.parameter.empty() ? "the literal"
                                                        : fmt::format("'{}'", leaf.parameter),
                                 literal(wanted, number.number.is_angle)),
                     {text.source, leaf.literal.begin, leaf.literal.end}, "move it less far");
    }
    const std::optional<double> beside = leaf_for(number, wanted + step);
    const double leaf_step = beside ? std::abs(*beside - *value) : usual_step(*value);
    return hand_literal(*value, leaf.is_angle, leaf_step, written_of(text, leaf));
}

}  // namespace

std::string_view name_of(HandleKind kind) {
    constexpr std::array<std::string_view, 10> names{
        "number",          "size",          "count",          "angle",       "interval",
        "parameter_point", "picture_point", "picture_region", "space_point", "direction"};
    return names[static_cast<std::size_t>(kind)];
}

std::vector<Handle> handles(const KnownText& text, std::string_view camera) {
    std::vector<Handle> made;
    if (const auto written = text.definition_named(camera)) {
        for (KnownHandle& one : known_handles(text, *written)) {
            made.push_back(std::move(one.handle));
        }
    }
    return made;
}

Result<std::vector<TextEdit>> moved(const KnownText& text, std::string_view camera,
                                    const Handle& handle, const std::vector<HandleMove>& moves) {
    const auto written = text.definition_named(camera);
    if (!written) {
        return no_camera(camera);
    }
    const std::vector<KnownHandle> all = known_handles(text, *written);
    const auto known = std::find_if(all.begin(), all.end(), [&](const KnownHandle& one) {
        return is_same(one.handle, handle);
    });
    if (known == all.end()) {
        return error("the text has no such handle", {}, "ask for its handles again");
    }
    std::vector<TextEdit> edits;
    std::vector<Override> values;
    std::vector<HandLeaf> done;
    for (const HandleMove& move : moves) {
        if (move.number >= known->numbers.size() || !known->numbers[move.number].leaf) {
            return error(fmt::format("number {} of this handle does not move", move.number + 1), {},
                         "change the text where it is written");
        }
        const HandNumber& number = known->numbers[move.number];
        const HandLeaf& leaf = *number.leaf;
        if (std::find(done.begin(), done.end(), leaf) != done.end()) {
            continue;  // Both ends of an interval may be made of one number, which moves once.
        }
        const Result<std::string> digits = digits_of(text, handle.kind, number, move);
        if (!digits) {
            return digits.diagnostics;
        }
        done.push_back(leaf);
        if (leaf.parameter.empty()) {
            edits.push_back({leaf.literal.begin, leaf.literal.end, *digits});
        } else {
            values.push_back({leaf.parameter, *digits});
        }
    }
    if (!values.empty()) {
        const std::vector<TextEdit> more = edits_of_values(*text.module, *written, values);
        edits.insert(edits.end(), more.begin(), more.end());
    }
    return edits;
}

}  // namespace balcony::lang
