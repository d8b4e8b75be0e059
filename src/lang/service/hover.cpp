// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What words mean, and the call around a place.

#include <algorithm>

#include <fmt/format.h>

#include "camera/catalogue/stage_text.hpp"
#include "lang/names/function_calls.hpp"
#include "lang/service/descriptions.hpp"
#include "lang/service/known_text.hpp"
#include "lang/tools/comments.hpp"

namespace balcony::lang {

namespace {

std::string_view without_blank_lines(std::string_view text) {
    const std::size_t begin = text.find_first_not_of('\n');
    return begin == std::string_view::npos
               ? std::string_view()
               : text.substr(begin, text.find_last_not_of('\n') + 1 - begin);
}

struct Telling {
    const KnownText& text;

    std::optional<Hover> operator()(std::monostate) const { return std::nullopt; }
    std::optional<Hover> operator()(const OwnName* own) const {
        const std::size_t begin =
            own->kind == OwnKind::parameter ? own->name.span.begin : own->declaration.begin;
        return Hover{0,  0, signature_of(text.tree(), *own), comment_above(text.tree(), begin),
                     {}, {}};
    }
    std::optional<Hover> operator()(const StatementRow* row) const {
        return Hover{0, 0, std::string(row->keyword), meaning_of(*row), {}, {}};
    }
    std::optional<Hover> operator()(const camera::StageEntry* row) const {
        std::string meaning = fmt::format("{}: {}", camera::name_of(row->kind), row->meaning);
        for (const camera::StageParameter& parameter : row->parameters) {
            meaning += fmt::format("\n- {}; {}", parameter_text(parameter), parameter.meaning);
        }
        return Hover{0,
                     0,
                     camera::call_text(*row),
                     std::move(meaning),
                     std::string(camera::stage_formula(*row)),
                     std::string(without_blank_lines(row->example))};
    }
    std::optional<Hover> operator()(const MeantParameter& meant) const {
        return Hover{0,  0, parameter_text(*meant.parameter), std::string(meant.parameter->meaning),
                     {}, {}};
    }
    std::optional<Hover> operator()(const MeantCamera& meant) const {
        const SyntaxTree& tree = meant.place.module->tree;
        return Hover{0,
                     0,
                     signature_of(tree, *meant.place.camera),
                     comment_above(tree, meant.place.camera->span.begin),
                     {},
                     {}};
    }
    std::optional<Hover> operator()(const MeantCameraParameter& meant) const {
        return Hover{0,  0,  declaration_text(meant.place.module->tree, *meant.parameter),
                     {}, {}, {}};
    }
    std::optional<Hover> operator()(const MeantImport& meant) const {
        const Definition& known = *meant.definition;
        const SourceSpan& place = known.place;
        const LineColumn at = place.source->locate(place.begin);
        const std::string_view line = place.source->line(at.line);
        return Hover{0,
                     0,
                     std::string(line.substr(line.find_first_not_of(' '))),
                     fmt::format("in {}", place.source->name()),
                     {},
                     {}};
    }
    std::optional<Hover> operator()(const MeantWord& meant) const {
        const bool is_measure = !text.module->scope->announced(meant.name).empty();
        return Hover{0,
                     0,
                     function_signature(meant.name),
                     is_measure ? std::string("measure of the scene, in fit statements")
                                : std::string(function_meaning(meant.name)),
                     {},
                     {}};
    }
    std::optional<Hover> operator()(const MeantFormulaParameter& meant) const {
        return Hover{
            0,  0, std::string(text.tree().text(meant.declaration)), "parameter of the formula",
            {}, {}};
    }
};

// Adds parameters in parentheses, separated by commas.
class SignatureWriter {
public:
    explicit SignatureWriter(std::string_view name) { made_.label = std::string(name) + "("; }

    void add(std::string_view text, std::string_view meaning) {
        made_.label += made_.parameters.empty() ? "" : ", ";
        const std::size_t begin = made_.label.size();
        made_.label += text;
        made_.parameters.push_back({begin, made_.label.size(), std::string(meaning)});
    }
    Signature finish(std::size_t active, std::string_view meaning) {
        made_.label += ")";
        made_.active = std::min(active, made_.parameters.size());
        made_.meaning = meaning;
        return std::move(made_);
    }

private:
    Signature made_;
};

Signature of_stage(const camera::StageEntry& row, const Expected::Call& call) {
    SignatureWriter writer(row.name);
    const camera::StageParameter* meant = parameter_of(row, call);
    std::size_t active = row.parameters.size();
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        const camera::StageParameter& parameter = row.parameters[i];
        const std::string built_in = camera::default_text(parameter);
        writer.add(fmt::format("{}{}", parameter.name, built_in.empty() ? "" : " = " + built_in),
                   fmt::format("{}; {}", parameter_text(parameter), parameter.meaning));
        active = &parameter == meant ? i : active;
    }
    return writer.finish(active, row.meaning);
}

std::optional<Signature> of_camera(const KnownText& text, const Expected::Call& call) {
    const auto camera = text.with_parameters(text.places[call.callee].text);
    if (!camera) {
        return std::nullopt;
    }
    SignatureWriter writer(text.places[call.callee].text);
    const std::vector<DefinitionParameter>& parameters = camera->camera->parameters;
    std::size_t active = parameters.size();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        writer.add(declaration_text(camera->module->tree, parameters[i]), "");
        active = parameters[i].name.text == call.name ? i : active;
    }
    return writer.finish(active, "");
}

std::optional<Signature> of_function(const KnownText& text, const Expected::Call& call) {
    const Token& name = text.places[call.callee];
    const OwnName* own = find_name(text.names, name.text, name.span.begin, false);
    if (own != nullptr && own->let != nullptr && !own->let->parameters.empty()) {
        SignatureWriter writer(name.text);
        for (const Identifier& parameter : own->let->parameters) {
            writer.add(parameter.text, "");
        }
        return writer.finish(call.argument, signature_of(text.tree(), *own));
    }
    const Function* function = find_function(name.text);
    if (own != nullptr || function == nullptr) {
        return std::nullopt;
    }
    SignatureWriter writer(name.text);
    for (std::size_t i = 0; i < function->arity; ++i) {
        writer.add(std::string(1, static_cast<char>('a' + i % 26)), "");
    }
    return writer.finish(call.argument, function_meaning(name.text));
}

}  // namespace

std::optional<Hover> hover(const KnownText& text, std::size_t offset) {
    const auto word = text.word_at(offset);
    if (!word) {
        return std::nullopt;
    }
    std::optional<Hover> told = std::visit(Telling{text}, text.meant_by(*word));
    if (told) {
        told->begin = text.places[*word].span.begin;
        told->end = text.places[*word].span.end;
    }
    return told;
}

std::optional<Signature> signature(const KnownText& text, std::size_t offset) {
    offset = std::min(offset, text.source->text().size());
    std::size_t token = text.places.first_behind(offset);
    while (token > 0 && text.places[token - 1].span.end > offset) {
        --token;
    }
    const Expected::Call call = text.expected(token).call;
    if (call.callee == TokenPlaces::none || text.is_in_comment(offset)) {
        return std::nullopt;
    }
    return call.stage != nullptr ? std::optional(of_stage(*call.stage, call))
           : call.is_camera      ? of_camera(text, call)
                                 : of_function(text, call);
}

}  // namespace balcony::lang
