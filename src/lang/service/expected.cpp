// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/expected.hpp"

#include <algorithm>

namespace balcony::lang {

namespace {

using What = Expected::What;

class Reader {
public:
    Reader(const TokenPlaces& places, std::size_t end, TokenPlaces::Around around,
           const camera::Catalogue& catalogue)
        : places_(places), end_(end), around_(around), catalogue_(catalogue) {}

    Expected read() {
        if (const auto block = places_.block_around(around_)) {
            made_.block = *block;
        }
        find_brackets();
        if (around_.statement == TokenPlaces::none || around_.statement >= end_) {
            made_.what = around_.opening == TokenPlaces::none ? What::item : What::statement;
            return made_;
        }
        const std::size_t first = brackets_.empty() ? end_ : brackets_.front();
        if (const StatementRow* row = places_.row(around_.statement)) {
            made_.statement = row;
            statement(*row, first);
        } else {
            item(first);
        }
        for (std::size_t i = 0; i < brackets_.size(); ++i) {
            enter(brackets_[i], i + 1 < brackets_.size() ? brackets_[i + 1] : end_);
        }
        return made_;
    }

private:
    // The open parentheses and brackets in the statement, from outside.
    void find_brackets() {
        for (std::size_t at = around_.opening; at != TokenPlaces::none && !places_[at].is("{");
             at = places_.at(at).opening) {
            brackets_.insert(brackets_.begin(), at);
        }
    }

    // The next token on the same level.
    [[nodiscard]] std::size_t next(std::size_t i) const {
        const std::size_t closing = places_.closing(i);
        return closing != TokenPlaces::none && closing < end_ ? closing + 1 : i + 1;
    }

    [[nodiscard]] bool is_word(std::size_t i) const { return places_[i].kind == TokenKind::name; }

    // Whether what precedes the place leaves something open.
    [[nodiscard]] bool goes_on(std::size_t end) const {
        const Token& last = places_[end - 1];
        return last.kind == TokenKind::symbol && !last.is(")") && !last.is("]") && !last.is("}");
    }

    void item(std::size_t end) {
        const std::size_t begin = around_.statement;
        const Token& word = places_[begin];
        std::size_t equals = TokenPlaces::none;
        for (std::size_t i = begin + 1; i < end; i = next(i)) {
            equals = equals == TokenPlaces::none && places_[i].is("=") ? i : equals;
        }
        if (word.is_name("let")) {
            made_.what = equals != TokenPlaces::none ? What::value : What::nothing;
            leave_complete(begin, end, What::item);
        } else if (!word.is_name("import") && equals != TokenPlaces::none) {
            made_.what = What::camera;
            leave_complete(begin, end, What::item);
        } else if (!word.is_name("import") && end < end_ && places_[end].is("(")) {
            in_parameters_ = true;
        } else if (end == end_ && end > begin + 1 &&
                   (places_[end - 1].is("}") || word.is_name("import"))) {
            made_.what = What::item;
        }
    }

    // Behind a whole statement or item, another one may follow.
    void leave_complete(std::size_t begin, std::size_t end, What following) {
        if (end == end_ && end > begin + 2 && !goes_on(end) && brackets_.empty() &&
            made_.what != What::nothing) {
            made_.what = following;
        }
    }

    void statement(const StatementRow& row, std::size_t end) {
        const std::size_t begin = around_.statement;
        // The part of a list that the place is in.
        std::size_t part = begin + 1;
        for (std::size_t i = begin + 1; i < end; i = next(i)) {
            part = places_[i].is(",") ? i + 1 : part;
        }
        const bool at_begin = part >= end;
        switch (row.shape) {
            case Shape::stage:
            case Shape::stages:
            case Shape::path: stage_of(row); break;
            case Shape::rule:
                stage_of(row);
                words_of_rule(part, end);
                break;
            case Shape::call: stage_of(row); break;
            case Shape::placements:
                stage_of(row);
                made_.what = made_.what == What::nothing ? What::value : made_.what;
                break;
            case Shape::layer: made_.what = What::camera; break;
            case Shape::morph: made_.what = part == begin + 1 ? What::camera : What::value; break;
            case Shape::let: made_.what = end > begin + 2 ? What::value : What::nothing; break;
            case Shape::ranges: made_.what = at_begin ? What::coordinate : What::value; break;
            case Shape::word:
            case Shape::nothing: made_.what = What::nothing; break;
            default: made_.what = What::value; break;
        }
        const bool has_content = end > begin + 1 || row.shape == Shape::nothing;
        const bool is_short = row.shape == Shape::let && end < begin + 4;
        if (end == end_ && has_content && !is_short && !goes_on(end) && brackets_.empty() &&
            made_.what != What::choice) {
            made_.what = What::statement;
        }
    }

    void stage_of(const StatementRow& row) {
        if (!row.stage_kind) {
            made_.what = What::value;
            return;
        }
        made_.what = What::stage;
        made_.kind = *row.stage_kind;
        made_.dimension.reset();
    }

    // normal outward: what follows the name on its line is an argument.
    void words_of_rule(std::size_t part, std::size_t end) {
        if (part >= end || !is_word(part) || end != end_ || !brackets_.empty() ||
            places_.at_new_line(std::min(end, places_.tokens().size() - 1))) {
            return;
        }
        const camera::StageEntry* row = catalogue_.find(made_.kind, places_[part].text);
        if (row == nullptr || (part + 1 < end && places_[part + 1].is("("))) {
            return;
        }
        made_.call = {part, row, false, end - part - 1, {}, false};
        fill(parameter_of(*row, made_.call));
        if (made_.what != What::choice) {
            made_.what = What::statement;
        }
    }

    // The argument in which the place is, in a bracket whose outside is `made_`.
    void enter(std::size_t opening, std::size_t end) {
        const bool is_call = places_[opening].is("(") && opening > 0 && is_word(opening - 1) &&
                             opening - 1 >= around_.statement;
        std::size_t begin = opening + 1;
        std::size_t number = 0;
        for (std::size_t i = opening + 1; i < end; i = next(i)) {
            if (places_[i].is(",")) {
                ++number;
                begin = i + 1;
            }
        }
        const bool is_named = begin + 1 < end && is_word(begin) && places_[begin + 1].is("=");
        if (in_parameters_) {
            parameter_declaration(begin, end, is_named);
        } else if (is_call) {
            Expected::Call call{opening - 1, nullptr, made_.what == What::camera, number, {}, true};
            call.name = is_named ? places_[begin].text : std::string_view();
            call.begins_argument = begin >= end;
            enter_call(call);
        } else if (places_[opening].is("[") && opening >= 2 && places_[opening - 1].is("=") &&
                   places_[opening - 2].is(")")) {
            enter_formula(opening);
        } else {
            made_.what = made_.what == What::nothing ? What::nothing : What::value;
            made_.call.begins_argument = false;
        }
    }

    void enter_call(const Expected::Call& call) {
        if (made_.what == What::nothing) {
            return;
        }
        const std::string_view callee = places_[call.callee].text;
        const bool is_formula_parameter =
            made_.call.stage != nullptr && find_parameter(*made_.call.stage, callee) != nullptr &&
            find_parameter(*made_.call.stage, callee)->as<camera::FormulaParameter>() != nullptr;
        const camera::StageEntry* stage =
            made_.what == What::stage ? catalogue_.find(made_.kind, callee) : nullptr;
        const bool is_formula = is_formula_parameter || (stage != nullptr && stage->shape);
        made_.call = call;
        made_.call.stage = stage;
        made_.parameter = nullptr;
        made_.what = What::value;
        if (is_formula) {
            made_.what = What::nothing;
        } else if (stage != nullptr) {
            fill(parameter_of(*stage, made_.call));
        }
    }

    // name(u, v) = [ ... ]: the names between the parentheses have values inside.
    void enter_formula(std::size_t opening) {
        std::size_t depth = 0;
        std::vector<std::size_t> names;
        for (std::size_t i = opening - 2; i > around_.statement; --i) {
            depth += places_[i].is(")") ? 1 : 0;
            if (places_[i].is("(") && --depth == 0) {
                break;
            }
            if (is_word(i)) {
                names.insert(names.begin(), i);
            }
        }
        made_.formula_parameters.insert(made_.formula_parameters.end(), names.begin(), names.end());
        made_.what = What::value;
        made_.parameter = nullptr;
        made_.call = {};
        made_.call.begins_argument = false;
    }

    // name = value above minimum to maximum
    void parameter_declaration(std::size_t begin, std::size_t end, bool is_named) {
        in_parameters_ = false;
        made_.what = begin < end && is_named ? What::value : What::nothing;
    }

    void fill(const camera::StageParameter* parameter) {
        made_.parameter = parameter;
        if (parameter == nullptr) {
            return;
        }
        if (const auto* nested = parameter->as<camera::NestedStageParameter>()) {
            made_.what = What::stage;
            made_.kind = nested->kind;
            made_.dimension = nested->dimension;
            made_.takes_number = !nested->of_number.empty();
        } else if (parameter->as<camera::ChoiceParameter>() != nullptr) {
            made_.what = What::choice;
        }
    }

    const TokenPlaces& places_;
    const std::size_t end_;
    const TokenPlaces::Around around_;
    const camera::Catalogue& catalogue_;
    std::vector<std::size_t> brackets_;
    bool in_parameters_ = false;
    Expected made_;
};

}  // namespace

const camera::StageParameter* find_parameter(const camera::StageEntry& row, std::string_view name) {
    const auto found = std::find_if(row.parameters.begin(), row.parameters.end(),
                                    [name](const auto& one) { return one.name == name; });
    return found != row.parameters.end() ? &*found : nullptr;
}

const camera::StageParameter* parameter_of(const camera::StageEntry& row,
                                           const Expected::Call& call) {
    if (!call.name.empty()) {
        return find_parameter(row, call.name);
    }
    // Formulas name themselves, and what takes several stages takes the rest.
    std::size_t position = 0;
    for (const camera::StageParameter& parameter : row.parameters) {
        const auto* nested = parameter.as<camera::NestedStageParameter>();
        if (parameter.as<camera::FormulaParameter>() != nullptr) {
            continue;
        }
        if (position == call.argument || (nested != nullptr && nested->several)) {
            return &parameter;
        }
        ++position;
    }
    return nullptr;
}

Expected expected_at(const TokenPlaces& places, std::size_t i, TokenPlaces::Around around,
                     const camera::Catalogue& catalogue) {
    return Reader(places, i, around, catalogue).read();
}

}  // namespace balcony::lang
