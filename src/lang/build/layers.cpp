// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/layers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "balcony/picture.hpp"
#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using Visit = std::function<bool(const LayerPlace&)>;

/// A value of a loop's variable.
struct Pass {
    Value value;
    std::string key;
    std::string written;
};

class LayerWalk {
public:
    LayerWalk(const LocatedDefinition& picture, Session& session, const Visit& visit)
        : module_(*picture.module),
          tree_(module_.tree),
          session_(session),
          reporter_(session.reporter()),
          visit_(visit) {}

    // Returns whether to continue.
    bool walk(const std::vector<Statement>& statements, Scope& names, const std::string& key,
              const std::string& where) {
        for (const Statement& statement : statements) {
            if (reporter_.full()) {
                return false;
            }
            if (statement.broken) {
                continue;
            }
            if (statement.kind == StatementKind::layer) {
                if (!visit_({statement, names, key, where})) {
                    return false;
                }
                ++layers_;
            } else if (statement.kind == StatementKind::loop &&
                       !loop(statement, names, key, where)) {
                return false;
            }
        }
        return true;
    }

private:
    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    bool loop(const Statement& statement, Scope& names, const std::string& key,
              const std::string& where) {
        const bool repeats =
            std::any_of(statement.block.begin(), statement.block.end(), [](const Statement& one) {
                return one.broken || one.kind == StatementKind::layer ||
                       one.kind == StatementKind::loop;
            });
        if (!repeats) {
            error(statement.keyword, "this loop has no layers",
                  "write the layers to repeat in its braces");
            return true;
        }
        for (const Pass& pass : passes(statement.loop(), names)) {
            // Layers are limited as a whole; a loop in a loop has one at least.
            if (layers_ >= camera::max_layers) {
                error(statement.keyword,
                      fmt::format("the picture has more than {} layers", camera::max_layers),
                      "repeat fewer layers");
                return false;
            }
            const std::size_t diagnostics_before = reporter_.count();
            const std::size_t errors_before = reporter_.error_count();
            const std::string here =
                fmt::format("{}{}{}", where, where.empty() ? "" : ", ", pass.written);
            const bool more = run(statement, pass, names, key + pass.key, here);
            reporter_.annotate(diagnostics_before,
                               {tree_.at(statement.keyword),
                                fmt::format("in the pass of this loop with {}", pass.written)});
            if (!more) {
                return false;
            }
            // Other passes would repeat the error.
            if (reporter_.error_count() > errors_before) {
                return true;
            }
        }
        return true;
    }

    bool run(const Statement& statement, const Pass& pass, Scope& names, const std::string& key,
             const std::string& where) {
        const Identifier& variable = statement.loop().variable;
        Scope inner(&names);
        inner.define(variable.text,
                     {pass.value, tree_.at(variable.span), "variable of a loop", true});
        std::vector<const Statement*> lets;
        for (const Statement& one : statement.block) {
            if (one.kind == StatementKind::let) {
                lets.push_back(&one);
            }
        }
        define_lets(tree_, lets, inner, session_.context());
        return walk(statement.block, inner, key, where);
    }

    std::vector<Pass> passes(const LoopSyntax& loop, Scope& names) {
        return loop.last.valid() ? passes_of_range(loop, names) : passes_of_list(loop, names);
    }

    // Both ends belong to it, as in all ranges. It may count down.
    std::vector<Pass> passes_of_range(const LoopSyntax& loop, Scope& names) {
        const auto first = whole_number(loop.first, "the first value of a loop", names);
        const auto last = whole_number(loop.last, "the last value of a loop", names);
        std::vector<Pass> made;
        if (!first || !last) {
            return made;
        }
        const double count = std::abs(*last - *first) + 1.0;
        if (count > static_cast<double>(camera::max_layers)) {
            error({tree_[loop.first].span.begin, tree_[loop.last].span.end},
                  fmt::format("this loop has {:.6g} passes; the maximum is {}", count,
                              camera::max_layers),
                  "repeat fewer layers");
            return made;
        }
        const double step = *last < *first ? -1.0 : 1.0;
        for (double i = 0.0; i < count; ++i) {
            const double value = *first + step * i;
            made.push_back({{session_.graph()->constant(value)},
                            fmt::format("[{}]", value),
                            fmt::format("{} = {}", loop.variable.text, value)});
        }
        return made;
    }

    std::optional<double> whole_number(ExpressionId id, std::string_view what, Scope& names) {
        const auto value = StageBuilder(module_, names, session_).constant(id, what);
        if (value && std::floor(*value) != *value) {
            error(tree_[id].span,
                  fmt::format("{} is a whole number, but this is {:.6g}", what, *value),
                  "count in whole numbers, and compute others from them: 0.1*i");
            return std::nullopt;
        }
        return value;
    }

    std::vector<Pass> passes_of_list(const LoopSyntax& loop, Scope& names) {
        const Value list = evaluate_any(tree_, loop.first, names, session_.context());
        std::vector<Pass> made;
        if (list.failed()) {
            return made;
        }
        if (list.form != Value::Form::list) {
            const std::string_view written = tree_.text(tree_[loop.first].span);
            error(
                tree_[loop.first].span,
                fmt::format("expected a range or a list after 'in', but this is {}", form_of(list)),
                list.form == Value::Form::number
                    ? fmt::format("write for {} in 1 .. {}", loop.variable.text, written)
                    : "write a list in brackets, [ ... ]");
            return made;
        }
        if (list.elements->size() > camera::max_layers) {
            error(tree_[loop.first].span,
                  fmt::format("this loop has {} passes; the maximum is {}", list.elements->size(),
                              camera::max_layers),
                  "repeat fewer layers");
            return made;
        }
        for (const Element& element : *list.elements) {
            const std::size_t i = made.size();
            made.push_back({element.value, fmt::format("[{}]", i),
                            fmt::format("{} = element {}", loop.variable.text, i)});
        }
        return made;
    }

    const Module& module_;
    const SyntaxTree& tree_;
    Session& session_;
    Reporter& reporter_;
    const Visit& visit_;
    std::size_t layers_ = 0;
};

}  // namespace

void visit_layers(const LocatedDefinition& picture, Scope& names, Session& session,
                  const Visit& visit) {
    LayerWalk(picture, session, visit).walk(picture.camera->statements, names, {}, {});
}

}  // namespace balcony::lang
