// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A text that was read for questions about it: its tokens, its tree, its names and imports.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "balcony/language_service.hpp"
#include "lang/names/session.hpp"
#include "lang/service/expected.hpp"
#include "lang/service/own_names.hpp"
#include "lang/service/token_places.hpp"

namespace balcony::lang {

/// A parameter of a stage.
struct MeantParameter {
    const camera::StageEntry* stage;
    const camera::StageParameter* parameter;
    std::string_view choice{};  ///< One of its words.
};
/// A camera or a picture that is not of the text.
struct MeantCamera {
    LocatedDefinition place;
};
/// A parameter of a camera.
struct MeantCameraParameter {
    LocatedDefinition place;
    const DefinitionParameter* parameter;
};
/// A let that is imported.
struct MeantImport {
    const Definition* definition;
};
/// A name of the language: a function, a constant, a measure of a scene.
struct MeantWord {
    std::string_view name;
};
/// A parameter of the formula around a place.
struct MeantFormulaParameter {
    Span declaration;
    Span formula;
};

/// What a word of a text means.
using Meant = std::variant<std::monostate, const OwnName*, const StatementRow*,
                           const camera::StageEntry*, MeantParameter, MeantCamera,
                           MeantCameraParameter, MeantImport, MeantWord, MeantFormulaParameter>;

class KnownText {
public:
    KnownText(std::shared_ptr<const SourceText> source, std::filesystem::path folder,
              camera::Catalogue known);

    [[nodiscard]] const SyntaxTree& tree() const { return module->tree; }
    /// The token at an offset, or that ends there, if it is a word.
    [[nodiscard]] std::optional<std::size_t> word_at(std::size_t offset) const;
    [[nodiscard]] Expected expected(std::size_t token) const;
    [[nodiscard]] Meant meant_by(std::size_t token) const;
    /// A camera or a picture that is visible in the text, or a built-in one; the last one of the
    /// text without a name.
    [[nodiscard]] std::optional<LocatedDefinition> definition_named(std::string_view name) const;
    /// A camera that is visible in the text, or a built-in one.
    [[nodiscard]] std::optional<LocatedDefinition> find_camera(std::string_view name) const;
    /// The one whose parameters a camera takes: its base's base.
    [[nodiscard]] std::optional<LocatedDefinition> with_parameters(std::string_view name) const;
    [[nodiscard]] bool is_in_comment(std::size_t offset) const;

    const std::shared_ptr<const SourceText> source;
    const camera::Catalogue catalogue;
    const TokenPlaces places;
    // Questions read built-in cameras and evaluate.
    std::unique_ptr<Files> files;
    std::unique_ptr<Session> session;
    Module* module;
    std::vector<OwnName> names;

private:
    [[nodiscard]] Meant meant_argument(const Expected& expected, std::size_t token) const;
    [[nodiscard]] Meant meant_value(const Expected& expected, std::size_t token) const;
};

// The questions, each in a file of its own.
[[nodiscard]] Completions complete(const KnownText& text, std::size_t offset);
[[nodiscard]] std::optional<Hover> hover(const KnownText& text, std::size_t offset);
[[nodiscard]] std::optional<Signature> signature(const KnownText& text, std::size_t offset);
[[nodiscard]] std::optional<SourceSpan> definition(const KnownText& text, std::size_t offset);
[[nodiscard]] std::vector<SourceSpan> references(const KnownText& text, std::size_t offset);
[[nodiscard]] Result<std::vector<TextEdit>> rename(const KnownText& text, std::size_t offset,
                                                   std::string_view new_name);
[[nodiscard]] std::vector<KnownValue> values(const KnownText& text);
[[nodiscard]] std::vector<DeclaredName> declared(const KnownText& text);
[[nodiscard]] std::vector<Handle> handles(const KnownText& text, std::string_view camera);
[[nodiscard]] Result<std::vector<TextEdit>> moved(const KnownText& text, std::string_view camera,
                                                  const Handle& handle,
                                                  const std::vector<HandleMove>& moves);
[[nodiscard]] Result<std::vector<TextEdit>> with_values(const KnownText& text,
                                                        std::string_view camera,
                                                        const std::vector<ParameterMove>& moves,
                                                        const KeyTime& at);
[[nodiscard]] std::vector<ParameterKeys> keys(const KnownText& text, std::string_view camera);
[[nodiscard]] Result<std::vector<TextEdit>> without_keys(const KnownText& text,
                                                         std::string_view camera,
                                                         const KeyTime& at);
/// The error of a name that is no camera.
[[nodiscard]] Diagnostic no_camera(std::string_view name);

}  // namespace balcony::lang
