// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/scope.hpp"

#include <algorithm>
#include <numbers>
#include <unordered_set>

#include <fmt/format.h>

#include "lang/names/evaluate.hpp"
#include "lang/names/function_calls.hpp"

namespace balcony::lang {

bool Scope::define(std::string_view name, Definition definition) {
    return definitions_.try_emplace(name, std::move(definition)).second;
}

Definition* Scope::find_here(std::string_view name) {
    const auto found = definitions_.find(name);
    return found == definitions_.end() ? nullptr : &found->second;
}

Definition* Scope::find(std::string_view name) {
    for (Scope* scope = this; scope != nullptr; scope = scope->outer_) {
        if (Definition* definition = scope->find_here(name)) {
            return definition;
        }
    }
    return nullptr;
}

const camera::FormulaFunction* Scope::find_function(std::string_view name) const {
    for (const Scope* scope = this; scope != nullptr; scope = scope->outer_) {
        for (const camera::FormulaFunction* function : scope->functions_) {
            if (function->name == name) {
                return function;
            }
        }
    }
    return nullptr;
}

std::vector<std::string> Scope::function_names() const {
    std::vector<std::string> names;
    for (const Scope* scope = this; scope != nullptr; scope = scope->outer_) {
        for (const camera::FormulaFunction* function : scope->functions_) {
            names.emplace_back(function->name);
        }
        for (const auto& [name, definition] : scope->definitions_) {
            if (definition.function) {
                names.emplace_back(name);
            }
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

void Scope::announce(std::string_view name, std::string_view why_not_yet) {
    announced_.emplace(name, why_not_yet);
}

std::string_view Scope::announced(std::string_view name) const {
    for (const Scope* scope = this; scope != nullptr; scope = scope->outer_) {
        const auto found = scope->announced_.find(name);
        if (found != scope->announced_.end()) {
            return found->second;
        }
    }
    return {};
}

void Scope::copy_from(const Scope& other,
                      const std::function<void(std::string_view, const Definition&,
                                               const Definition&)>& on_conflict) {
    std::vector<std::pair<std::string_view, const Definition*>> sorted;
    for (const auto& [name, definition] : other.definitions_) {
        sorted.emplace_back(name, &definition);
    }
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [name, definition] : sorted) {
        const auto [found, is_new] = definitions_.try_emplace(name, *definition);
        const SourceSpan& place = found->second.place;
        const bool same =
            place.source == definition->place.source && place.begin == definition->place.begin;
        if (!is_new && !same) {
            on_conflict(name, found->second, *definition);
        }
    }
}

std::vector<std::string> Scope::names() const {
    std::vector<std::string> names;
    for (const Scope* scope = this; scope != nullptr; scope = scope->outer_) {
        for (const auto& [name, definition] : scope->definitions_) {
            names.emplace_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

std::unique_ptr<Scope> constants(expr::Graph& graph) {
    auto scope = std::make_unique<Scope>();
    scope->define(
        "pi", {{graph.constant(std::numbers::pi), Unit::number, nullptr}, {}, "constant", true});
    scope->define("t", {{graph.time(), Unit::number, nullptr}, {}, "time", true});
    return scope;
}

void report_duplicate(const Identifier& name, SourceSpan place, const SourceSpan& earlier,
                      Reporter& reporter) {
    Diagnostic diagnostic = error(fmt::format("'{}' is defined twice", name.text), std::move(place),
                                  "rename one of the two");
    diagnostic.notes.push_back({earlier, "first defined here"});
    reporter.add(std::move(diagnostic));
}

void report_given_twice(const Identifier& name, SourceSpan place, const SourceSpan& earlier,
                        Reporter& reporter) {
    Diagnostic diagnostic =
        error(fmt::format("'{}' is given twice", name.text), std::move(place), "remove one");
    diagnostic.notes.push_back({earlier, "first given here"});
    reporter.add(std::move(diagnostic));
}

namespace {

// Depth-first search over the lets, without recursion: a let is evaluated after those it uses.
class LetOrder {
public:
    LetOrder(const SyntaxTree& tree, Scope& scope, const Context& context)
        : tree_(tree), scope_(scope), context_(context), reporter_(context.reporter) {}

    void add(const Statement& let) {
        if (let.let().name.text.empty()) {
            return;
        }
        const SourceSpan place = tree_.at(let.let().name.span);
        if (Definition* earlier = scope_.find_here(let.let().name.text)) {
            report_duplicate(let.let().name, place, earlier->place, reporter_);
            earlier->value = {};
        } else if (const auto known = numbers_.find(let.let().name.text); known != numbers_.end()) {
            report_duplicate(let.let().name, place,
                             tree_.at(lets_[known->second].let->let().name.span), reporter_);
            lets_[known->second].failed = true;
        } else {
            numbers_.emplace(let.let().name.text, lets_.size());
            Entry entry{&let, State::fresh, let.let().value.valid() ? first_node(let) : 0, {}};
            for (const Identifier& parameter : let.let().parameters) {
                entry.parameters.insert(parameter.text);
            }
            lets_.push_back(std::move(entry));
        }
    }

    void run() {
        for (std::size_t i = 0; i < lets_.size(); ++i) {
            visit(i);
        }
    }

private:
    enum class State : std::uint8_t { fresh, open, done };
    struct Entry {
        const Statement* let;
        State state;
        std::size_t next_node;  // Where the search for names in its expression continues.
        std::unordered_set<std::string_view> parameters;
        bool failed = false;  // It is part of a reported cycle.
    };

    [[nodiscard]] std::size_t first_node(const Statement& let) const {
        return tree_[let.let().value].first.value();
    }

    // Whether a node names a value or a function other than a parameter.
    static bool mentions(const Entry& entry, const Expression& node) {
        return (node.kind == ExpressionKind::name || node.kind == ExpressionKind::call) &&
               !entry.parameters.contains(node.name.text);
    }

    // The next let that an open let uses.
    std::optional<std::size_t> next_used(Entry& entry) {
        if (!entry.let->let().value.valid()) {
            return std::nullopt;
        }
        while (entry.next_node <= entry.let->let().value.value()) {
            const Expression& node = tree_.expressions[entry.next_node++];
            if (mentions(entry, node)) {
                if (const auto found = numbers_.find(node.name.text); found != numbers_.end()) {
                    return found->second;
                }
            }
        }
        return std::nullopt;
    }

    void visit(std::size_t start) {
        std::vector<std::size_t> path;
        if (lets_[start].state == State::fresh) {
            lets_[start].state = State::open;
            path.push_back(start);
        }
        while (!path.empty()) {
            const std::optional<std::size_t> used = next_used(lets_[path.back()]);
            if (!used) {
                finish(path.back());
                path.pop_back();
            } else if (lets_[*used].state == State::open) {
                report_circle(path, *used);
            } else if (lets_[*used].state == State::fresh) {
                lets_[*used].state = State::open;
                path.push_back(*used);
            }
        }
    }

    void finish(std::size_t i) {
        const LetSyntax& let = lets_[i].let->let();
        lets_[i].state = State::done;
        const bool good = !lets_[i].failed && let.value.valid() && !lets_[i].let->broken;
        Definition made{{}, tree_.at(let.name.span), "let", false};
        if (good && let.parameters.empty()) {
            made.value = evaluate_any(tree_, let.value, scope_, context_);
        } else if (good && check_function({tree_, let, scope_}, context_)) {
            made.function = std::make_shared<const LetFunction>(LetFunction{tree_, let, scope_});
        }
        scope_.define(let.name.text, std::move(made));
    }

    void report_circle(const std::vector<std::size_t>& path, std::size_t begin) {
        const auto first = std::find(path.begin(), path.end(), begin);
        std::string circle;
        std::size_t shown = 0;
        for (auto i = first; i != path.end(); ++i) {
            lets_[*i].failed = true;
            if (shown <= max_shown) {
                circle += shown < max_shown ? fmt::format("{} -> ", lets_[*i].let->let().name.text)
                                            : std::string("... -> ");
            }
            ++shown;
        }
        const LetSyntax& let = lets_[begin].let->let();
        circle += let.name.text;
        Diagnostic diagnostic =
            let.parameters.empty()
                ? error(
                      fmt::format("'{}' is defined in terms of itself: {}", let.name.text, circle),
                      tree_.at(let.name.span), "define one of them without the others")
                : error(fmt::format("the function '{}' is recursive: {}", let.name.text, circle),
                        tree_.at(let.name.span),
                        "a function cannot call itself; write its terms out, or repeat a stage "
                        "with repeat(n, ...)");
        for (auto i = first; i != path.end(); ++i) {
            if (*i != begin && diagnostic.notes.size() + 1 < max_shown) {
                diagnostic.notes.push_back(
                    {tree_.at(lets_[*i].let->let().name.span),
                     fmt::format("through '{}'", lets_[*i].let->let().name.text)});
            }
        }
        reporter_.add(std::move(diagnostic));
    }

    static constexpr std::size_t max_shown = 6;

    const SyntaxTree& tree_;
    Scope& scope_;
    const Context& context_;
    Reporter& reporter_;
    std::vector<Entry> lets_;
    std::unordered_map<std::string_view, std::size_t> numbers_;
};

}  // namespace

void define_lets(const SyntaxTree& tree, const std::vector<const Statement*>& lets, Scope& scope,
                 const Context& context) {
    LetOrder order(tree, scope, context);
    for (const Statement* let : lets) {
        order.add(*let);
    }
    order.run();
}

}  // namespace balcony::lang
