// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Questions about what the view shows, answered in order and one at a time, on another thread than
// the server's and the view's.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "balcony/inspect.hpp"
#include "balcony/live.hpp"
#include "studio/session/worker.hpp"

namespace balcony::studio {

class Inspection {
public:
    /// Which questions are answered: all, or only the newest one, which stops those before it.
    enum class Answers : std::uint8_t { all, newest };

    /// Called on the thread of the questions.
    using Question =
        std::function<void(const std::function<live::Inspector&()>&, const std::stop_token&)>;

    Inspection(const live::View& view, std::filesystem::path folder, Answers answers = Answers::all)
        : view_(view), folder_(std::move(folder)), answers_(answers) {}

    /// The question gets what makes an inspector of something, or of what is shown by then, or
    /// throws a Refusal. Throws a Refusal if too many wait.
    void ask(Question question, std::optional<live::Shown> about = {});
    /// The answers of what was asked so far are of no use any more.
    void stop();

private:
    [[nodiscard]] live::Inspector& inspector(const std::optional<live::Shown>& shown,
                                             const std::stop_token& stop);

    const live::View& view_;
    std::filesystem::path folder_;
    Answers answers_;
    std::stop_source asked_;                    // Of the questions since the last stop.
    std::optional<live::Inspector> inspector_;  // Of the thread.
    Worker worker_;  // The last member, since its thread uses the others.
};

}  // namespace balcony::studio
