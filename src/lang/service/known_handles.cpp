// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a hand can move, by the types of the parameters of stages.

#include "lang/service/known_handles.hpp"

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "lang/build/resolved_layer.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

using camera::Range;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

HandleKind kind_of_number(bool is_angle, const Range& range) {
    return is_angle               ? HandleKind::angle
           : range.minimum >= 0.0 ? HandleKind::size
                                  : HandleKind::number;
}

// Of two numbers of a stage; nothing if each is one by itself.
std::optional<HandleKind> kind_of(const camera::PairParameter& type, StageKind stage) {
    const bool is_free = !std::isfinite(type.range.minimum) && !std::isfinite(type.range.maximum);
    if (type.one_for_both || !is_free || type.unit == camera::Unit::angle) {
        return std::nullopt;
    }
    if (type.unit == camera::Unit::either) {
        return HandleKind::parameter_point;
    }
    switch (stage) {
        case StageKind::picture_arranger:
        case StageKind::clip_shape: return HandleKind::picture_point;
        case StageKind::object_generator: return HandleKind::space_point;
        default: return std::nullopt;
    }
}

// Of points with so many coordinates: what each begins with, as often as it can; the numbers that
// are left are numbers.
struct PointParts {
    std::optional<HandleKind> kind;
    std::size_t size = 1;
    std::size_t count = 0;
};

PointParts parts_of(const camera::PointsParameter& type, StageKind stage, std::size_t coordinates) {
    const bool in_plane = coordinates % 2 == 0 &&
                          (type.unit == camera::Unit::either || stage == StageKind::clip_shape);
    if (in_plane) {
        return {stage == StageKind::clip_shape ? HandleKind::picture_point
                                               : HandleKind::parameter_point,
                2, coordinates / 2};
    }
    const bool in_space = type.unit == camera::Unit::number && coordinates > 1;
    return !in_space          ? PointParts{}
           : coordinates == 2 ? PointParts{HandleKind::space_point, 2, 1}
                              : PointParts{HandleKind::space_point, 3, coordinates / 3};
}

// Whether three numbers of a row, from this one on, are a point in space: x, y and z, which are
// 0 if nothing is said of them. Factors are 1.
bool is_point(std::span<const StageParameter> parameters) {
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    if (parameters.size() < names.size()) {
        return false;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto* number = parameters[i].as<camera::NumberParameter>();
        if (number == nullptr || parameters[i].name != names[i] ||
            number->unit != camera::Unit::number || number->default_value.value_or(0.0) != 0.0) {
            return false;
        }
    }
    return true;
}

class HandleCollector {
public:
    HandleCollector(const KnownText& text, HandNumbers& numbers) : text_(text), numbers_(numbers) {}

    std::vector<KnownHandle> collect(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) {
            add(statement);
        }
        return std::move(made_);
    }

private:
    [[nodiscard]] const SyntaxTree& tree() const { return numbers_.tree(); }

    void add(const Statement& statement) {
        const StatementRow* const row = row_of(statement.kind);
        if (row == nullptr || statement.broken || statement.kind == StatementKind::let) {
            return;
        }
        around_ = {};
        around_.statement = row->keyword;
        if (const auto* const ranges = std::get_if<std::vector<MapRange>>(&statement.content)) {
            add_ranges(*ranges);
        } else if (const Corners* const corners = statement.corners()) {
            add_corners(*corners, *row);
        } else if (const auto* const id = std::get_if<ExpressionId>(&statement.content)) {
            add_value(*id, *row);
        }
        for (const ExpressionId id : statement.stages()) {
            add_value(id, *row);
        }
        for (const Statement& inner : statement.block) {
            add(inner);
        }
    }

    // The numbers of a handle, if all are such.
    void add_handle(HandleKind kind, std::span<const ExpressionId> ids, const Range& limits = {}) {
        KnownHandle made{around_, {}};
        made.handle.kind = kind;
        for (const ExpressionId id : ids) {
            auto number = id.valid() ? numbers_.read(id, limits) : std::nullopt;
            if (!number) {
                return;
            }
            made.handle.numbers.push_back(number->number);
            made.numbers.push_back(std::move(*number));
        }
        if (kind == HandleKind::number || kind == HandleKind::size) {
            made.handle.kind = kind_of_number(made.handle.numbers.front().is_angle, limits);
        }
        made_.push_back(std::move(made));
    }

    void place(Span span) {
        around_.begin = numbers_.is_of_text() ? span.begin : 0;
        around_.end = numbers_.is_of_text() ? span.end : 0;
    }

    void add_ranges(const std::vector<MapRange>& ranges) {
        for (const MapRange& range : ranges) {
            if (range.first.valid() && range.last.valid()) {
                around_.parameter = range.coordinate.text;
                place(range.span);
                add_handle(HandleKind::interval, std::array{range.first, range.last});
            }
        }
    }

    void add_corners(const Corners& corners, const StatementRow& row) {
        std::vector<ExpressionId> ids = elements_of(corners.first);
        const std::vector<ExpressionId> last = elements_of(corners.last);
        ids.insert(ids.end(), last.begin(), last.end());
        if (ids.size() == 4) {
            around_.meaning = row.meaning;
            place(corners.span);
            add_handle(HandleKind::picture_region, ids);
        }
    }

    void add_value(ExpressionId id, const StatementRow& row) {
        if (!id.valid()) {
            return;
        }
        const Expression& node = tree()[id];
        if (row.stage_kind) {
            add_stage(id, *row.stage_kind);
        } else if (row.shape == Shape::layer) {
            add_layer(node);
        } else if (row.shape == Shape::value) {
            around_.meaning = row.meaning;
            place(node.span);
            add_handle(HandleKind::number, std::array{id}, {.minimum = 0.0});
        }
    }

    // Arguments of the camera that a layer shows.
    void add_layer(const Expression& call) {
        around_.stage = call.name.text;
        place(call.span);
        for (const Argument& argument : call.arguments) {
            if (argument.name) {
                around_.parameter = argument.name->text;
                add_handle(HandleKind::number, std::array{argument.value});
            }
        }
    }

    [[nodiscard]] std::vector<ExpressionId> elements_of(ExpressionId id) const {
        std::vector<ExpressionId> ids;
        if (id.valid()) {
            const Expression& node = tree()[numbers_.named_by(id)];
            if (node.kind == ExpressionKind::tuple || node.kind == ExpressionKind::list) {
                for (const Argument& one : node.arguments) {
                    ids.push_back(one.value);
                }
            }
        }
        return ids;
    }

    // What each parameter of a row is given, in its order; several for one that takes the rest.
    [[nodiscard]] std::vector<std::vector<ExpressionId>> given(const StageEntry& row,
                                                               const Expression& call) const {
        std::vector<std::vector<ExpressionId>> made(row.parameters.size());
        Expected::Call place;
        place.stage = &row;
        for (const Argument& argument : call.arguments) {
            place.name = argument.name ? argument.name->text : std::string_view();
            const bool is_formula = tree()[argument.value].kind == ExpressionKind::formula;
            const StageParameter* const parameter =
                is_formula && place.name.empty() ? nullptr : parameter_of(row, place);
            if (parameter == nullptr) {
                continue;
            }
            const auto at = static_cast<std::size_t>(parameter - row.parameters.data());
            const std::vector<ExpressionId> spread = elements_of(argument.value);
            const auto is_number = [](const StageParameter& one) {
                return one.as<camera::NumberParameter>() != nullptr;
            };
            if (is_number(*parameter) && spread.size() > 1) {
                for (std::size_t i = 0; i < spread.size() && at + i < made.size(); ++i) {
                    made[at + i].push_back(spread[i]);
                }
                place.argument += spread.size();
            } else {
                made[at].push_back(argument.value);
                place.argument += argument.name ? 0 : 1;
            }
        }
        return made;
    }

    void add_stage(ExpressionId id, StageKind kind) {
        const Expression& node = tree()[id];
        const StageEntry* const row = text_.catalogue.find(kind, node.name.text);
        const bool is_call = node.kind == ExpressionKind::call || node.kind == ExpressionKind::name;
        if (row == nullptr || row->shape || !is_call) {
            return;
        }
        const Handle outside = around_;
        const auto values = given(*row, node);
        for (std::size_t i = 0; i < values.size(); ++i) {
            around_ = outside;
            around_.stage = row->name;
            around_.parameter = row->parameters[i].name;
            around_.meaning = row->parameters[i].meaning;
            place(node.span);
            const auto rest = std::span(row->parameters).subspan(i);
            if (is_point(rest) && values[i].size() == 1 && values[i + 1].size() == 1 &&
                values[i + 2].size() == 1) {
                around_.meaning = row->meaning;
                add_handle(HandleKind::space_point,
                           std::array{values[i][0], values[i + 1][0], values[i + 2][0]});
                i += 2;
                continue;
            }
            for (const ExpressionId value : values[i]) {
                std::visit([&](const auto& type) { add_argument(type, kind, value); },
                           row->parameters[i].type);
            }
        }
        around_ = outside;
    }

    // ------------------------------------------------------------------ by type of a parameter
    void add_argument(const camera::NumberParameter& type, StageKind, ExpressionId id) {
        add_handle(HandleKind::number, std::array{id}, type.range);
    }
    void add_argument(const camera::CountParameter& type, StageKind, ExpressionId id) {
        add_handle(HandleKind::count, std::array{id}, type.range);
    }
    void add_argument(const camera::PairParameter& type, StageKind stage, ExpressionId id) {
        const std::vector<ExpressionId> two = elements_of(id);
        const std::optional<HandleKind> kind = kind_of(type, stage);
        if (two.size() == 2 && kind) {
            add_handle(*kind, two, type.range);
        } else if (two.size() == 2) {
            add_numbers(two, type.range);
        } else if (type.one_for_both) {
            add_handle(HandleKind::number, std::array{id}, type.range);
        }
    }
    void add_argument(const camera::TripleParameter& type, StageKind, ExpressionId id) {
        if (const std::vector<ExpressionId> three = elements_of(id); three.size() == 3) {
            add_handle(type.names_axes ? HandleKind::direction : HandleKind::space_point, three,
                       type.range);
        }
    }
    void add_argument(const camera::PointsParameter& type, StageKind stage, ExpressionId id) {
        std::size_t next = 0;
        for (const ExpressionId point : elements_of(id)) {
            std::vector<ExpressionId> numbers = elements_of(point);
            numbers = numbers.empty() ? std::vector{point} : numbers;
            const PointParts parts = parts_of(type, stage, numbers.size());
            std::span<const ExpressionId> rest(numbers);
            for (std::size_t i = 0; i < parts.count; ++i) {
                around_.index = next++;
                add_handle(*parts.kind, rest.first(parts.size));
                rest = rest.subspan(parts.size);
            }
            for (const ExpressionId number : rest) {
                around_.index = next++;
                add_handle(HandleKind::number, std::array{number});
            }
        }
    }
    void add_argument(const camera::NestedStageParameter& type, StageKind, ExpressionId id) {
        if (tree()[id].kind == ExpressionKind::call) {
            add_stage(id, type.kind);
        } else if (const StageEntry* const row = text_.catalogue.find(type.kind, type.of_number)) {
            const auto* const number = row->parameters.front().as<camera::NumberParameter>();
            add_handle(HandleKind::number, std::array{id},
                       number != nullptr ? number->range : Range{});
        }
    }
    // Words, formulas, files.
    template <class Other>
    void add_argument(const Other&, StageKind, ExpressionId) {}

    void add_numbers(std::span<const ExpressionId> ids, const Range& range) {
        for (const ExpressionId id : ids) {
            add_handle(HandleKind::number, std::array{id}, range);
            ++around_.index;
        }
        around_.index = 0;
    }

    const KnownText& text_;
    HandNumbers& numbers_;
    Handle around_;
    std::vector<KnownHandle> made_;
};

}  // namespace

std::vector<KnownHandle> known_handles(const KnownText& text, const LocatedDefinition& written) {
    const auto found = resolve_base({written, {}}, *text.session);
    if (!found || found->place.camera->broken) {
        return {};
    }
    try {
        DefinitionScope scope(found->place, found->given, *text.session);
        HandNumbers numbers(text, written, found->place, scope);
        return HandleCollector(text, numbers).collect(found->place.camera->statements);
    } catch (const expr::GraphTooLarge&) {
        return {};  // Said when the camera is made.
    }
}

}  // namespace balcony::lang
