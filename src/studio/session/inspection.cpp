// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/inspection.hpp"

#include <utility>

#include "lsp/rpc.hpp"

namespace balcony::studio {

void Inspection::ask(Question question, std::optional<live::Shown> about) {
    if (answers_ == Answers::newest) {
        stop();
    }
    worker_.give([this, question = std::move(question), about = std::move(about),
                  asked = asked_](const std::stop_token& ends) mutable {
        const std::stop_callback on_end(ends, [&asked] { asked.request_stop(); });
        const std::stop_token stop = asked.get_token();
        question(
            [&]() -> live::Inspector& { return inspector(about ? about : view_.shown(), stop); },
            stop);
    });
}

void Inspection::stop() {
    asked_.request_stop();
    asked_ = std::stop_source();
}

live::Inspector& Inspection::inspector(const std::optional<live::Shown>& shown,
                                       const std::stop_token& stop) {
    if (!shown) {
        throw lsp::Refusal{lsp::request_failed, "no picture is shown yet: ask again later"};
    }
    if (!inspector_) {
        // What is shown has a scene.
        inspector_.emplace(*view_.scene(), folder_);
    }
    if (const Diagnostics found = inspector_->show(*shown, stop); has_errors(found)) {
        throw lsp::Refusal{lsp::request_failed, to_text(found)};
    }
    return *inspector_;
}

}  // namespace balcony::studio
