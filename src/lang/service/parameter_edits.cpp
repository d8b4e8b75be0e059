// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Other values for parameters of a camera: numbers, and keys between which they change.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lang/build/resolved_layer.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/service/hand_number.hpp"
#include "lang/tools/rewrite.hpp"

namespace balcony::lang {

namespace {

struct WrittenKey {
    Span span;   // With its parentheses.
    Span value;  // The number in it.
    double time = 0.0;
};

/// The parameters of a camera, and how the text writes them.
class WrittenParameters {
public:
    WrittenParameters(const KnownText& text, LocatedDefinition written, ResolvedLayer found)
        : text_(text),
          written_(std::move(written)),
          found_(std::move(found)),
          scope_(found_.place, found_.given, *text.session),
          numbers_(text, written_, found_.place, scope_),
          values_(scope_.values()) {}

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    /// The number of a parameter, or the error that there is none.
    [[nodiscard]] Result<std::size_t> find(std::string_view wanted) const {
        for (std::size_t i = 0; i < size(); ++i) {
            if (name(i) == wanted) {
                return i;
            }
        }
        return error(no_parameter(written_, wanted), {},
                     instead_of_parameter(*found_.place.camera, wanted));
    }
    [[nodiscard]] std::vector<TextEdit> edits(const std::vector<Override>& values) const {
        return edits_of_values(*text_.module, written_, values);
    }
    [[nodiscard]] std::string_view name(std::size_t i) const {
        return found_.place.camera->parameters[i].name.text;
    }
    [[nodiscard]] bool is_number(std::size_t i) const { return values_[i].is_constant(); }
    [[nodiscard]] std::string_view text_of(std::size_t i) const {
        return text_.tree().text(span(i));
    }
    [[nodiscard]] std::string_view text_of(Span span) const { return text_.tree().text(span); }
    /// Of its whole value.
    [[nodiscard]] Span span(std::size_t i) const {
        const ExpressionId id = numbers_.written_value(i);
        return id.valid() ? text_.tree()[id].span : Span();
    }
    [[nodiscard]] std::string number(std::size_t i, double value, double step,
                                     std::string_view instead_of) const {
        const bool is_angle = values_[i].unit == Unit::angle;
        return step > 0.0 ? hand_literal(value, is_angle, step, instead_of)
                          : literal(value, is_angle, instead_of);
    }
    /// What the text writes for a number, or would write.
    [[nodiscard]] std::string number_text(std::size_t i) const {
        const std::string_view written = text_of(i);
        return written.empty() ? number(i, values_[i].constant(), 0.0, {}) : std::string(written);
    }

    /// In the order of their times; nothing if the value is none of keys(...) with times and
    /// numbers that are written out.
    [[nodiscard]] std::optional<std::vector<WrittenKey>> keys(std::size_t i) {
        const ExpressionId id = numbers_.written_value(i);
        const SyntaxTree& tree = text_.tree();
        if (!id.valid() || values_[i].form != Value::Form::number ||
            tree[id].kind != ExpressionKind::call || tree[id].name.text != keys_function) {
            return std::nullopt;
        }
        std::vector<WrittenKey> made;
        for (const Argument& argument : tree[id].arguments) {
            const bool is_known = argument.name ? argument.name->text != "at"  // Not of the time.
                                                : add_key(argument.value, made);
            if (!is_known) {
                return std::nullopt;
            }
        }
        return made.empty() ? std::nullopt : std::optional(std::move(made));
    }

private:
    // A key, or a list of some.
    [[nodiscard]] bool add_key(ExpressionId id, std::vector<WrittenKey>& made) {
        const SyntaxTree& tree = text_.tree();
        const Expression& node = tree[id];
        if (node.kind == ExpressionKind::list) {
            return std::all_of(
                node.arguments.begin(), node.arguments.end(),
                [&](const Argument& element) { return add_key(element.value, made); });
        }
        if (node.kind != ExpressionKind::tuple || node.arguments.size() != 2) {
            return false;
        }
        const Value time =
            evaluate(tree, node.arguments.front().value, scope_.names(), text_.session->context());
        if (!time.is_constant()) {
            return false;
        }
        made.push_back({node.span, tree[node.arguments.back().value].span, time.constant()});
        return true;
    }

    const KnownText& text_;
    const LocatedDefinition written_;
    const ResolvedLayer found_;
    DefinitionScope scope_;
    HandNumbers numbers_;
    const std::vector<Value> values_;
};

// Null if the text has no such camera.
std::unique_ptr<WrittenParameters> parameters_of(const KnownText& text, std::string_view camera) {
    const auto written = text.definition_named(camera);
    const auto found =
        written ? resolve_base({*written, {}}, *text.session) : std::optional<ResolvedLayer>();
    return found ? std::make_unique<WrittenParameters>(text, *written, *found) : nullptr;
}

using Keys = std::vector<WrittenKey>;

Keys::const_iterator key_at(const Keys& keys, const KeyTime& at) {
    return std::find_if(keys.begin(), keys.end(), [&](const WrittenKey& one) {
        return std::abs(one.time - at.time) < 0.5 * at.frame;
    });
}

// A text with another one in place of a part.
std::string with(std::string_view text, Span whole, Span part, std::string_view instead) {
    return fmt::format("{}{}{}", text.substr(0, part.begin - whole.begin), instead,
                       text.substr(part.end - whole.begin));
}

// As far as frames are apart.
std::string time_text(const KeyTime& at) {
    constexpr double part_of_frame = 1.0 / 32;
    return hand_literal(at.time, false, part_of_frame * at.frame, {});
}

// The call of keys with another value at a time.
std::string with_key(const WrittenParameters& all, std::size_t i, const Keys& keys,
                     const ParameterMove& move, const KeyTime& at) {
    const Span whole = all.span(i);
    const std::string_view text = all.text_of(i);
    if (const auto there = key_at(keys, at); there != keys.end()) {
        return with(text, whole, there->value,
                    all.number(i, move.value, move.step, all.text_of(there->value)));
    }
    const auto next = std::find_if(keys.begin(), keys.end(),
                                   [&](const WrittenKey& one) { return one.time > at.time; });
    const std::string made =
        fmt::format("({}, {})", time_text(at), all.number(i, move.value, move.step, text));
    if (next == keys.end()) {
        const std::size_t end = keys.back().span.end;
        return with(text, whole, {end, end}, ", " + made);
    }
    const std::size_t begin = next->span.begin;
    return with(text, whole, {begin, begin}, made + ", ");
}

std::string without_key(const WrittenParameters& all, std::size_t i, const Keys& keys,
                        Keys::const_iterator there) {
    if (keys.size() <= 2) {
        const WrittenKey& left =
            there == keys.begin() ? keys.back() : keys.front();  // Of one, the same.
        return std::string(all.text_of(left.value));
    }
    const Span part = there == keys.begin() ? Span{there->span.begin, std::next(there)->span.begin}
                                            : Span{std::prev(there)->span.end, there->span.end};
    return with(all.text_of(i), all.span(i), part, "");
}

Result<std::string> moved_text(WrittenParameters& all, std::size_t i, const ParameterMove& move,
                               const KeyTime& at) {
    if (const auto keys = all.keys(i)) {
        return with_key(all, i, *keys, move, at);
    }
    if (!all.is_number(i)) {
        return error(fmt::format("'{}' is not one number", move.parameter), {},
                     "change the text where it is written");
    }
    const std::string number = all.number(i, move.value, move.step, all.text_of(i));
    return !at.begins_keys || at.time < 0.5 * at.frame
               ? number
               : fmt::format("keys((0, {}), ({}, {}))", all.number_text(i), time_text(at), number);
}

}  // namespace

Result<std::vector<TextEdit>> with_values(const KnownText& text, std::string_view camera,
                                          const std::vector<ParameterMove>& moves,
                                          const KeyTime& at) {
    const auto all = parameters_of(text, camera);
    if (!all) {
        return no_camera(camera);
    }
    std::vector<Override> values;
    for (const ParameterMove& move : moves) {
        const Result<std::size_t> parameter = all->find(move.parameter);
        if (!parameter) {
            return parameter.diagnostics;
        }
        Result<std::string> made = moved_text(*all, *parameter, move, at);
        if (!made) {
            return std::move(made.diagnostics);
        }
        values.push_back({move.parameter, std::move(*made)});
    }
    return all->edits(values);
}

std::vector<ParameterKeys> keys(const KnownText& text, std::string_view camera) {
    std::vector<ParameterKeys> made;
    const auto all = parameters_of(text, camera);
    for (std::size_t i = 0; all && i < all->size(); ++i) {
        if (const auto keys = all->keys(i)) {
            made.push_back({std::string(all->name(i))});
            for (const WrittenKey& one : *keys) {
                made.back().times.push_back(one.time);
            }
        }
    }
    return made;
}

Result<std::vector<TextEdit>> without_keys(const KnownText& text, std::string_view camera,
                                           const KeyTime& at) {
    const auto all = parameters_of(text, camera);
    if (!all) {
        return no_camera(camera);
    }
    std::vector<Override> values;
    for (std::size_t i = 0; i < all->size(); ++i) {
        const auto keys = all->keys(i);
        const auto there = keys ? key_at(*keys, at) : Keys::const_iterator();
        if (keys && there != keys->end()) {
            values.push_back({std::string(all->name(i)), without_key(*all, i, *keys, there)});
        }
    }
    if (values.empty()) {
        return error(fmt::format("no parameter has a key at {} s", time_text(at)), {},
                     "go to the frame of a key");
    }
    return all->edits(values);
}

}  // namespace balcony::lang
