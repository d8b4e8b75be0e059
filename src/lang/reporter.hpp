// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "balcony/base.hpp"
#include "balcony/names.hpp"

namespace balcony::lang {

/// Collects errors and warnings up to a limit of each. Identical diagnostics of a camera that is
/// used twice are reported once.
class Reporter {
public:
    static constexpr std::size_t max_errors = 20;
    static constexpr std::size_t max_warnings = 100;

    void add(Diagnostic diagnostic);
    void add(const Diagnostics& diagnostics);
    /// What is wrong with something that is named in a file: there, if it has no place, or with a
    /// note there if it has a place elsewhere.
    void add(Diagnostics found, const SourceSpan& named);
    /// All that another one has collected.
    void add(const Reporter& other);
    void error(SourceSpan span, std::string message, std::string remedy = {});
    /// The same with a remedy that takes long to find: it is asked for only if the error is said.
    void error(SourceSpan span, std::string message, const std::function<std::string()>& remedy);
    /// An error about a name that a file lacks. All places that use the name are one mistake, so
    /// only the first is said.
    void missing(std::string_view name, SourceSpan span, std::string message,
                 const std::function<std::string()>& remedy);
    void warning(SourceSpan span, std::string message, std::string remedy = {});

    /// The number of all errors, including repeated and omitted ones. If it has increased during a
    /// piece of work, that work has failed.
    [[nodiscard]] std::size_t error_count() const { return errors_; }
    /// Adds a note to the diagnostics after the first `count`: where their part of a file is used.
    void annotate(std::size_t count, const Diagnostic::Note& note);
    /// How many diagnostics there are.
    [[nodiscard]] std::size_t count() const { return diagnostics_.size(); }
    /// Whether the limit is reached, so that further reading is useless.
    [[nodiscard]] bool full() const { return errors_said_ >= max_errors; }
    /// All diagnostics, sorted by source, with a final one for each limit that was exceeded.
    [[nodiscard]] Diagnostics take();

private:
    Diagnostics diagnostics_;
    std::set<std::pair<const SourceText*, std::string>> missing_;
    std::size_t errors_ = 0;
    std::size_t errors_said_ = 0;
    std::size_t warnings_said_ = 0;
    bool left_out_errors_ = false;
    bool left_out_warnings_ = false;
};

}  // namespace balcony::lang
