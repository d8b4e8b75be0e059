// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Questions about the shared text, answered in order and one at a time, on another thread than the
// server's.

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "balcony/language_service.hpp"
#include "studio/session/shared_text.hpp"
#include "studio/session/worker.hpp"

namespace balcony::studio {

class TextQuestions {
public:
    /// Called on the thread of the questions.
    using Question = std::function<void(const lang::EditedText&)>;

    /// Imports are looked for in the folder.
    explicit TextQuestions(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// About the text as it is now. Throws a Refusal if that is too long, or if too many wait.
    void ask(const SharedText& text, Question question);

private:
    std::filesystem::path folder_;
    // Of the thread: the text that was asked about last.
    std::optional<lang::EditedText> known_;
    int version_ = 0;
    Worker worker_;  // The last member, since its thread uses the others.
};

}  // namespace balcony::studio
