// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What editors ask about the text of a camera file: what can stand at a place, what a word means,
// where it is defined, what values names have. Texts with mistakes are answered as far as they can
// be read. What there is to say comes from the catalogue and from the tables of the language.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/catalogue.hpp"
#include "balcony/handles.hpp"

namespace balcony::lang {

/// Puts a text in the place of the bytes [begin, end) of another one.
struct TextEdit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// The remedy of a diagnostic as a change of the text that its span is in.
struct Fix {
    std::string title;  ///< "write 'superellipse'"
    TextEdit edit;
};

/// The changes that remedy a diagnostic; none if its remedy is advice.
[[nodiscard]] std::vector<Fix> fixes_of(const Diagnostic& diagnostic);

/// What a word is.
enum class WordKind : std::uint8_t {
    keyword,
    stage,
    parameter,
    choice,
    function,
    value,   ///< A let, a constant, a measure of a scene or the variable of a loop.
    camera,  ///< A camera or a picture.
};

/// What could stand at a place.
struct Completion {
    /// The bytes [begin, end) of `text`, which wait for a value.
    struct Blank {
        std::size_t begin = 0;
        std::size_t end = 0;
    };

    std::string label;  ///< The word.
    WordKind kind = WordKind::keyword;
    std::string detail;         ///< How it is called, or its type and default.
    std::string meaning;        ///< One line; may be empty.
    std::string text;           ///< To insert: of a stage, the whole call with its defaults.
    std::vector<Blank> blanks;  ///< In the order of the text.
};

struct Completions {
    std::size_t begin = 0;  ///< The word that a completion replaces, which may be empty.
    std::size_t end = 0;
    std::vector<Completion>
        items;  ///< Of all words that could stand there, those of the place first.
};

/// What a word means.
struct Hover {
    std::size_t begin = 0;  ///< The word.
    std::size_t end = 0;
    std::string signature;  ///< How it is declared or called.
    std::string meaning;    ///< Plain text; may be empty, as the following.
    std::string formula;    ///< Of a stage.
    std::string example;    ///< A .cam text that shows a stage.
};

/// The call around a place.
struct Signature {
    struct Parameter {
        std::size_t begin = 0;  ///< Its bytes in `label`.
        std::size_t end = 0;
        std::string meaning;
    };
    std::string label;
    std::string meaning;
    std::vector<Parameter> parameters;
    std::size_t active = 0;  ///< Index into `parameters`; their number if none is meant.
};

/// The value of a let or a parameter that is not written as a number.
struct KnownValue {
    std::size_t offset = 0;  ///< Behind its expression.
    std::string text;        ///< "45deg"
};

/// A declaration of a text.
struct DeclaredName {
    std::string name;
    WordKind kind = WordKind::value;
    std::string detail;     ///< "camera", "picture", "let", "parameter", "function".
    std::size_t begin = 0;  ///< The whole declaration.
    std::size_t end = 0;
    std::size_t name_begin = 0;
    std::size_t name_end = 0;
    std::vector<DeclaredName> inside;  ///< Of a camera or a picture.
};

/// A text that is being edited, as it is at one moment. Offsets are bytes of its text; one behind
/// the end is the end. What it imports is read when it is made.
///
/// It belongs to one thread at a time.
class EditedText {
public:
    /// Imports and tables are looked for in `folder`.
    explicit EditedText(std::shared_ptr<const SourceText> text, std::filesystem::path folder = {},
                        camera::Catalogue catalogue = {});
    EditedText(EditedText&&) noexcept;
    EditedText& operator=(EditedText&&) noexcept;
    ~EditedText();

    [[nodiscard]] const std::shared_ptr<const SourceText>& text() const;

    [[nodiscard]] Completions complete(std::size_t offset) const;
    [[nodiscard]] std::optional<Hover> hover(std::size_t offset) const;
    /// Of the innermost call around the offset.
    [[nodiscard]] std::optional<Signature> signature(std::size_t offset) const;
    /// Where the name at an offset is declared, in this text or one that it imports. Nothing for
    /// what the language or the library has.
    [[nodiscard]] std::optional<SourceSpan> definition(std::size_t offset) const;
    /// Where a name that this text declares stands in it, in order, the declaration among them.
    [[nodiscard]] std::vector<SourceSpan> references(std::size_t offset) const;
    /// The changes that give a name of this text another spelling. Files that import this one stay
    /// as they are. It is an error if the text does not declare the name, or if the new one cannot
    /// be a name or is taken where the old one stands.
    [[nodiscard]] Result<std::vector<TextEdit>> rename(std::size_t offset,
                                                       std::string_view new_name) const;
    /// The values of lets and of defaults that are not plain numbers, in the order of the text.
    [[nodiscard]] std::vector<KnownValue> values() const;
    [[nodiscard]] std::vector<DeclaredName> declared() const;

    /// What a hand can move of a camera or a picture, the last one if `camera` is empty; in the
    /// order of its statements. None after errors.
    [[nodiscard]] std::vector<Handle> handles(std::string_view camera = {}) const;
    /// The changes of this text that give numbers of one of its handles other values, within their
    /// limits. Units, comments and layout are kept. It is an error if a number does not move, or if
    /// no value of its literal gives it the value.
    [[nodiscard]] Result<std::vector<TextEdit>> moved(std::string_view camera, const Handle& handle,
                                                      const std::vector<HandleMove>& moves) const;
    /// The changes that give parameters of a camera other values, as Workspace::with_values does.
    /// Of a parameter with keys, that is the value at a time.
    [[nodiscard]] Result<std::vector<TextEdit>> with_values(
        std::string_view camera, const std::vector<ParameterMove>& values,
        const KeyTime& at = {}) const;
    /// The parameters of a camera that have keys.
    [[nodiscard]] std::vector<ParameterKeys> keys(std::string_view camera) const;
    /// The changes that take the keys at a time away. One that is left is a number again.
    [[nodiscard]] Result<std::vector<TextEdit>> without_keys(std::string_view camera,
                                                             const KeyTime& at) const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// The text of a built-in camera, with its comments; empty if there is none of this name.
[[nodiscard]] std::string_view built_in_text(std::string_view name);

}  // namespace balcony::lang
