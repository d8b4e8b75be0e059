// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/base.hpp"

namespace balcony::lang {

/// Collects what there is to say, up to a bound: more errors than fit a screen help nobody. What a
/// camera that is used twice has to say is said once.
class Reporter {
public:
    static constexpr std::size_t max_errors = 20;

    void add(Diagnostic diagnostic);
    void add(const Diagnostics& diagnostics);
    void error(SourceSpan span, std::string message, std::string remedy = {});
    void warning(SourceSpan span, std::string message, std::string remedy = {});

    /// All errors, also those that are said already or left out: no part of the work in which it
    /// grew has succeeded.
    [[nodiscard]] std::size_t error_count() const { return errors_; }
    /// So many errors that reading on is in vain.
    [[nodiscard]] bool full() const { return errors_said_ >= max_errors; }
    /// Everything in the order of the sources, with a closing line if something was left out.
    [[nodiscard]] Diagnostics take();

private:
    Diagnostics diagnostics_;
    std::size_t errors_ = 0;
    std::size_t errors_said_ = 0;
    bool left_out_ = false;
};

/// 'a', 'b' or 'c'; the empty string for no names.
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);
/// 'a', 'b' and 'c'.
[[nodiscard]] std::string all_of(const std::vector<std::string>& names);

/// What to say when a name is unknown: the nearest one there is, or `otherwise` and all of them.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                                     std::string_view otherwise);

}  // namespace balcony::lang
