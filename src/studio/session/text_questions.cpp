// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/text_questions.hpp"

#include <memory>
#include <string>

#include "balcony/live.hpp"
#include "lsp/open_text.hpp"
#include "lsp/rpc.hpp"

namespace balcony::studio {

void TextQuestions::ask(const SharedText& text, Question question) {
    if (text.text().size() > lsp::longest_text) {
        throw lsp::Refusal{lsp::request_failed, std::string(lsp::too_long)};
    }
    auto source = std::make_shared<const SourceText>(std::string(live::text_name), text.text());
    worker_.give([this, version = text.version(), source = std::move(source),
                  question = std::move(question)](const std::stop_token&) {
        if (!known_ || version_ != version) {
            known_.emplace(source, folder_);
            version_ = version;
        }
        question(*known_);
    });
}

}  // namespace balcony::studio
