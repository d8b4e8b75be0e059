// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/reporter.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

bool same(const Diagnostic& a, const Diagnostic& b) {
    return a.severity == b.severity && a.span.source && a.span.source == b.span.source &&
           a.span.begin == b.span.begin && a.span.end == b.span.end && a.message == b.message;
}

}  // namespace

void Reporter::add(Diagnostic diagnostic) {
    const bool is_error = diagnostic.severity == Severity::error;
    errors_ += is_error ? 1 : 0;
    if (std::any_of(diagnostics_.begin(), diagnostics_.end(),
                    [&](const Diagnostic& reported) { return same(reported, diagnostic); })) {
        return;
    }
    if (is_error ? full() : warnings_said_ == max_warnings) {
        (is_error ? left_out_errors_ : left_out_warnings_) = true;
        return;
    }
    ++(is_error ? errors_said_ : warnings_said_);
    diagnostics_.push_back(std::move(diagnostic));
}

void Reporter::add(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        add(diagnostic);
    }
}

void Reporter::add(Diagnostics found, const SourceSpan& named) {
    for (Diagnostic& diagnostic : found) {
        if (!diagnostic.span.source) {
            diagnostic.span = named;
        } else if (diagnostic.span.source != named.source || diagnostic.span.begin < named.begin ||
                   diagnostic.span.end > named.end) {
            diagnostic.notes.push_back({named, "used here"});
        }
        add(std::move(diagnostic));
    }
}

void Reporter::add(const Reporter& other) {
    const std::size_t errors_before = errors_;
    add(other.diagnostics_);
    errors_ = errors_before + other.errors_;
    left_out_errors_ = left_out_errors_ || other.left_out_errors_;
    left_out_warnings_ = left_out_warnings_ || other.left_out_warnings_;
}

void Reporter::error(SourceSpan span, std::string message, std::string remedy) {
    add(balcony::error(std::move(message), std::move(span), std::move(remedy)));
}

void Reporter::error(SourceSpan span, std::string message,
                     const std::function<std::string()>& remedy) {
    error(std::move(span), std::move(message), full() ? std::string() : remedy());
}

void Reporter::missing(std::string_view name, SourceSpan span, std::string message,
                       const std::function<std::string()>& remedy) {
    if (missing_.emplace(span.source.get(), name).second) {
        error(std::move(span), std::move(message), remedy);
    } else {
        ++errors_;
    }
}

void Reporter::warning(SourceSpan span, std::string message, std::string remedy) {
    add(balcony::warning(std::move(message), std::move(span), std::move(remedy)));
}

void Reporter::annotate(std::size_t count, const Diagnostic::Note& note) {
    constexpr std::size_t max_notes = 3;
    for (std::size_t i = count; i < diagnostics_.size(); ++i) {
        std::vector<Diagnostic::Note>& notes = diagnostics_[i].notes;
        if (notes.size() < max_notes) {
            notes.push_back(note);
        }
    }
}

Diagnostics Reporter::take() {
    // Sources are sorted by their first diagnostic.
    std::vector<const SourceText*> sources;
    const auto rank = [&sources](const Diagnostic& diagnostic) {
        const SourceText* source = diagnostic.span.source.get();
        const auto found = std::find(sources.begin(), sources.end(), source);
        if (found == sources.end()) {
            sources.push_back(source);
            return sources.size() - 1;
        }
        return static_cast<std::size_t>(found - sources.begin());
    };
    std::vector<std::pair<std::size_t, std::size_t>> keys;
    std::vector<std::size_t> order;
    for (const Diagnostic& diagnostic : diagnostics_) {
        keys.emplace_back(rank(diagnostic), diagnostic.span.begin);
        order.push_back(order.size());
    }
    std::stable_sort(order.begin(), order.end(),
                     [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    Diagnostics sorted;
    for (const std::size_t i : order) {
        sorted.push_back(std::move(diagnostics_[i]));
    }
    if (left_out_errors_) {
        sorted.push_back(balcony::error(
            fmt::format("there are more errors; only the first {} are shown", max_errors)));
    }
    if (left_out_warnings_) {
        sorted.push_back(balcony::warning(
            fmt::format("there are more warnings; only the first {} are shown", max_warnings)));
    }
    diagnostics_.clear();
    return sorted;
}

}  // namespace balcony::lang
