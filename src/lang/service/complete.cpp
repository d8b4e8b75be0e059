// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What could stand at a place of a text.

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "camera/catalogue/stage_text.hpp"
#include "lang/built_in_cameras.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/names/scene_names.hpp"
#include "lang/names/value.hpp"
#include "lang/service/descriptions.hpp"
#include "lang/service/known_text.hpp"
#include "lang/service/stage_call.hpp"

namespace balcony::lang {

namespace {

using What = Expected::What;

constexpr std::array<std::string_view, 4> item_words{"camera", "picture", "let", "import"};

class CompletionCollector {
public:
    CompletionCollector(const KnownText& text, std::size_t token, std::size_t offset)
        : text_(text), here_(text.expected(token)), token_(token), offset_(offset) {}

    std::vector<Completion> collect() {
        parameters();
        switch (here_.what) {
            case What::nothing: break;
            case What::item:
                for (const std::string_view word : item_words) {
                    add(word, WordKind::keyword);
                }
                break;
            case What::statement: keywords(); break;
            case What::stage:
                stages();
                if (here_.takes_number) {
                    values();
                }
                break;
            case What::choice: choices(); break;
            case What::camera: cameras(); break;
            case What::coordinate:
                add("u", WordKind::value, {}, "from the left edge of the picture to the right");
                add("v", WordKind::value, {}, "from the bottom edge of the picture to the top");
                break;
            case What::value: values(); break;
        }
        return std::move(items_);
    }

private:
    void add(std::string_view label, WordKind kind, std::string detail = {},
             std::string_view meaning = {}) {
        if (label.empty() || !labels_.insert(std::string(label)).second) {
            return;
        }
        items_.push_back({std::string(label),
                          kind,
                          std::move(detail),
                          std::string(meaning),
                          std::string(label),
                          {}});
    }

    // Those that the call around the place has not been given.
    void parameters() {
        const Expected::Call& call = here_.call;
        if (call.callee == TokenPlaces::none || !call.begins_argument || !call.name.empty()) {
            return;
        }
        const std::set<std::string_view> given = given_to(call.callee + 1);
        if (call.stage != nullptr) {
            for (const camera::StageParameter& parameter : call.stage->parameters) {
                if (!given.contains(parameter.name)) {
                    add_parameter(parameter);
                }
            }
        } else if (call.is_camera) {
            const auto camera = text_.with_parameters(text_.places[call.callee].text);
            if (!camera) {
                return;
            }
            const SyntaxTree& tree = camera->module->tree;
            for (const DefinitionParameter& parameter : camera->camera->parameters) {
                if (given.contains(parameter.name.text)) {
                    continue;
                }
                add(parameter.name.text, WordKind::parameter, declaration_text(tree, parameter));
                if (items_.back().label == parameter.name.text && parameter.default_value.valid()) {
                    fill(items_.back(), fmt::format("{} = ", parameter.name.text),
                         std::string(tree.text(tree[parameter.default_value].span)));
                }
            }
        }
    }

    void add_parameter(const camera::StageParameter& parameter) {
        const auto* nested = parameter.as<camera::NestedStageParameter>();
        if (nested != nullptr && nested->several) {
            return;
        }
        add(parameter.name, WordKind::parameter, parameter_text(parameter), parameter.meaning);
        const std::string argument = argument_of(parameter, text_.catalogue);
        const bool is_formula = parameter.as<camera::FormulaParameter>() != nullptr;
        const std::size_t begin = is_formula ? argument.find('[') + 1 : argument.find('=') + 2;
        const std::size_t end = argument.size() - (is_formula ? 1 : 0);
        fill(items_.back(), argument.substr(0, begin), argument.substr(begin, end - begin),
             argument.substr(end));
    }

    static void fill(Completion& item, const std::string& before, const std::string& blank,
                     const std::string& after = {}) {
        item.text = before + blank + after;
        item.blanks = {{before.size(), before.size() + blank.size()}};
    }

    [[nodiscard]] std::set<std::string_view> given_to(std::size_t opening) const {
        std::set<std::string_view> names;
        for (std::size_t i = opening + 1; i + 1 < text_.places.tokens().size(); ++i) {
            const bool ends = text_.places.closing(opening) == i ||
                              text_.places.at(i).statement != text_.places.at(opening).statement;
            if (ends) {
                break;
            }
            const bool is_name = text_.places.at(i).opening == opening && i != token_ &&
                                 text_.places[i].kind == TokenKind::name;
            if (is_name && text_.places[i + 1].is("=")) {
                names.insert(text_.places[i].text);
            }
        }
        return names;
    }

    void keywords() {
        for (const StatementRow& row : statement_rows()) {
            if (row.stands_in(here_.block)) {
                add(row.keyword, WordKind::keyword, {}, meaning_of(row));
                fill_call(row);
            }
        }
    }

    // The keyword itself is what is called: lens(radius = 0.1, focus = 5).
    void fill_call(const StatementRow& row) {
        const camera::StageEntry* stage = row.shape == Shape::call && row.stage_kind
                                              ? text_.catalogue.find(*row.stage_kind, row.keyword)
                                              : nullptr;
        if (stage != nullptr && !is_call_written()) {
            items_.back().meaning = stage->meaning;
            fill_stage(*stage);
        }
    }

    void fill_stage(const camera::StageEntry& row) {
        StageCall call = whole_call(row, text_.catalogue);
        items_.back().text = std::move(call.text);
        items_.back().blanks = std::move(call.blanks);
    }

    void stages() {
        for (const camera::StageEntry& row : text_.catalogue) {
            const bool fits =
                row.kind == here_.kind && (!here_.dimension || row.dimension == *here_.dimension);
            if (!fits) {
                continue;
            }
            add(row.name, WordKind::stage, camera::call_text(row), row.meaning);
            if (!is_call_written()) {
                fill_stage(row);
            }
        }
    }

    // The word is followed by its arguments already.
    [[nodiscard]] bool is_call_written() const {
        const Token& word = text_.places[token_];
        return word.kind == TokenKind::name && word.span.begin <= offset_ &&
               text_.places[token_ + 1].is("(");
    }

    void choices() {
        for (const std::string_view word :
             here_.parameter->as<camera::ChoiceParameter>()->choices) {
            add(word, WordKind::choice, std::string(here_.parameter->name),
                here_.parameter->meaning);
        }
    }

    void cameras() {
        // The definition that the place is in cannot be a part of itself.
        const DefinitionSyntax* around = nullptr;
        for (const OwnName& own : text_.names) {
            const bool begins_before =
                own.kind == OwnKind::camera && own.definition->span.begin <= offset_;
            around = begins_before ? own.definition : around;
        }
        for (const LocatedDefinition& place : visible_definitions(*text_.module)) {
            const DefinitionSyntax& camera = *place.camera;
            if (&camera != around) {
                add(camera.name.text, WordKind::camera, std::string(word_for(camera)));
            }
        }
        for (const BuiltInCamera& camera : built_in_camera_files()) {
            add(camera.name, WordKind::camera, fmt::format("built-in camera: {}", camera.family),
                first_line(camera.text));
        }
    }

    void values() {
        for (auto i = here_.formula_parameters.rbegin(); i != here_.formula_parameters.rend();
             ++i) {
            add(text_.places[*i].text, WordKind::value, "parameter of the formula");
        }
        const std::size_t offset = text_.places[token_].span.begin;
        for (const OwnName& own : text_.names) {
            if (own.kind == OwnKind::camera ||
                find_name(text_.names, own.name.text, std::min(offset, offset_), false) != &own) {
                continue;
            }
            const bool is_function = own.let != nullptr && !own.let->parameters.empty();
            add(own.name.text, is_function ? WordKind::function : WordKind::value,
                signature_of(text_.tree(), own));
        }
        for (const std::string& name : text_.module->scope->names()) {
            Definition* known = text_.module->scope->find(name);
            add(name, known->function ? WordKind::function : WordKind::value,
                std::string(known->what));
        }
        if (here_.statement != nullptr && here_.statement->shape == Shape::assignments) {
            for (const std::string_view name : scene_names()) {
                add(name, WordKind::value, "measure of the scene");
            }
        }
        for (const std::string& name : function_names()) {
            add(name, WordKind::function, function_signature(name), function_meaning(name));
        }
    }

    const KnownText& text_;
    const Expected here_;
    const std::size_t token_;
    const std::size_t offset_;
    std::vector<Completion> items_;
    std::set<std::string, std::less<>> labels_;
};

}  // namespace

Completions complete(const KnownText& text, std::size_t offset) {
    offset = std::min(offset, text.source->text().size());
    Completions made{offset, offset, {}};
    std::size_t token = text.places.first_behind(offset);
    if (const auto word = text.word_at(offset)) {
        token = *word;
        made.begin = text.places[token].span.begin;
        made.end = text.places[token].span.end;
    } else if (text.places[token].kind != TokenKind::end &&
               text.places[token].span.begin < offset) {
        // In a number or a file name.
        return made;
    }
    const bool touches = token > 0 && text.places[token - 1].span.end == offset &&
                         text.places[token - 1].kind != TokenKind::symbol;
    if ((touches && made.begin == made.end) || text.is_in_comment(offset)) {
        return made;
    }
    made.items = CompletionCollector(text, token, offset).collect();
    return made;
}

}  // namespace balcony::lang
