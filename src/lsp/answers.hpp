// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The answers of the language service as JSON of the Language Server Protocol.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "lsp/open_text.hpp"

namespace balcony::lsp {

/// With the blanks of whole calls as tab stops if the client knows snippets.
[[nodiscard]] nlohmann::json completion_answer(OpenText& text, std::size_t offset, bool snippets);
[[nodiscard]] nlohmann::json hover_answer(OpenText& text, std::size_t offset);
[[nodiscard]] nlohmann::json signature_answer(OpenText& text, std::size_t offset);
[[nodiscard]] nlohmann::json definition_answer(OpenText& text, std::size_t offset);
[[nodiscard]] nlohmann::json references_answer(OpenText& text, std::size_t offset);
/// What a rename would change, or null if the name cannot be renamed.
[[nodiscard]] nlohmann::json prepare_rename_answer(OpenText& text, std::size_t offset);
/// The changes, or in `refusal` why there are none.
[[nodiscard]] nlohmann::json rename_answer(OpenText& text, std::size_t offset,
                                           const std::string& name, std::string& refusal);
/// Null for a text with errors.
[[nodiscard]] nlohmann::json formatting_answer(OpenText& text);
[[nodiscard]] nlohmann::json values_answer(OpenText& text, std::size_t begin, std::size_t end);
[[nodiscard]] nlohmann::json symbols_answer(OpenText& text);
/// The fixes of what was last found in a part of a text.
[[nodiscard]] nlohmann::json fixes_answer(OpenText& text, std::size_t begin, std::size_t end);
/// As a text shows it; at its begin if it is about something else.
[[nodiscard]] nlohmann::json diagnostic_of(const SourceText& text, const Diagnostic& one);
[[nodiscard]] nlohmann::json edit_in(const SourceText& text, const lang::TextEdit& edit);
/// The parameters of publishDiagnostics.
[[nodiscard]] nlohmann::json diagnostics_of(const std::string& uri, const SourceText& text,
                                            const Diagnostics& found, int version);

}  // namespace balcony::lsp
