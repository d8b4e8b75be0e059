// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/language_service.hpp"

#include "lang/built_in_cameras.hpp"
#include "lang/service/known_text.hpp"

namespace balcony::lang {

class EditedText::Implementation : public KnownText {
public:
    using KnownText::KnownText;
};

EditedText::EditedText(std::shared_ptr<const SourceText> text, std::filesystem::path folder,
                       camera::Catalogue catalogue)
    : implementation_(std::make_unique<Implementation>(std::move(text), std::move(folder),
                                                       std::move(catalogue))) {}
EditedText::EditedText(EditedText&&) noexcept = default;
EditedText& EditedText::operator=(EditedText&&) noexcept = default;
EditedText::~EditedText() = default;

const std::shared_ptr<const SourceText>& EditedText::text() const {
    return implementation_->source;
}

Completions EditedText::complete(std::size_t offset) const {
    return lang::complete(*implementation_, offset);
}

std::optional<Hover> EditedText::hover(std::size_t offset) const {
    return lang::hover(*implementation_, offset);
}

std::optional<Signature> EditedText::signature(std::size_t offset) const {
    return lang::signature(*implementation_, offset);
}

std::optional<SourceSpan> EditedText::definition(std::size_t offset) const {
    return lang::definition(*implementation_, offset);
}

std::vector<SourceSpan> EditedText::references(std::size_t offset) const {
    return lang::references(*implementation_, offset);
}

Result<std::vector<TextEdit>> EditedText::rename(std::size_t offset,
                                                 std::string_view new_name) const {
    return lang::rename(*implementation_, offset, new_name);
}

std::vector<KnownValue> EditedText::values() const { return lang::values(*implementation_); }

std::vector<DeclaredName> EditedText::declared() const { return lang::declared(*implementation_); }

std::vector<Handle> EditedText::handles(std::string_view camera) const {
    return lang::handles(*implementation_, camera);
}

Result<std::vector<TextEdit>> EditedText::moved(std::string_view camera, const Handle& handle,
                                                const std::vector<HandleMove>& moves) const {
    return lang::moved(*implementation_, camera, handle, moves);
}

Result<std::vector<TextEdit>> EditedText::with_values(std::string_view camera,
                                                      const std::vector<ParameterMove>& values,
                                                      const KeyTime& at) const {
    return lang::with_values(*implementation_, camera, values, at);
}

std::vector<ParameterKeys> EditedText::keys(std::string_view camera) const {
    return lang::keys(*implementation_, camera);
}

Result<std::vector<TextEdit>> EditedText::without_keys(std::string_view camera,
                                                       const KeyTime& at) const {
    return lang::without_keys(*implementation_, camera, at);
}

std::string_view built_in_text(std::string_view name) {
    const BuiltInCamera* const camera = find_built_in_camera(name);
    return camera != nullptr ? camera->text : std::string_view();
}

}  // namespace balcony::lang
