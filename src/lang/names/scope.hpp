// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/data.hpp"
#include "lang/names/value.hpp"
#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// The work that calls of the files' functions have caused, which is bounded.
struct CallWork {
    std::size_t depth = 0;       ///< How deep the evaluation is in arguments and bodies of calls.
    std::size_t nodes = 0;       ///< How many nodes of expressions calls have evaluated.
    bool exceeds_limit = false;  ///< It has been reported.
};

/// The tables and images that expressions name in quotation marks.
class Tables {
public:
    Tables() = default;
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;
    virtual ~Tables() = default;
    /// The table of a file that a camera file names; null after an error, which is reported.
    [[nodiscard]] virtual const data::NumberTable* table(const SyntaxTree& tree,
                                                         const Identifier& file) = 0;
    /// The same of an image, as grey_table() makes it.
    [[nodiscard]] virtual std::shared_ptr<const expr::Table> grey(const SyntaxTree& tree,
                                                                  const Identifier& file) = 0;
};

/// What values are worked out with.
struct Context {
    expr::Graph& graph;
    Reporter& reporter;
    const camera::Catalogue& catalogue;
    CallWork& calls;
    Tables& tables;
};

class Scope;

/// A function that a file defines.
struct LetFunction {
    const SyntaxTree& tree;
    const LetSyntax& let;
    Scope& scope;  ///< Where it is defined; its body uses the names that are visible there.
};

/// A name that has a value or is a function.
struct Definition {
    Value value;  ///< None of a function.
    SourceSpan place;
    std::string_view what;  ///< "parameter", "let", ...
    bool used = false;
    std::shared_ptr<const LetFunction> function{};
};

/// The names visible at a position. Names that are not found are looked up in the enclosing scope.
class Scope {
public:
    explicit Scope(Scope* outer = nullptr) : outer_(outer) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

    /// Returns false and changes nothing if this scope already has the name.
    bool define(std::string_view name, Definition definition);
    [[nodiscard]] Definition* find(std::string_view name);
    [[nodiscard]] Definition* find_here(std::string_view name);
    /// Lets expressions here call a function, which must outlive this.
    void offer(const camera::FormulaFunction& function) { functions_.push_back(&function); }
    /// The function of a name that is offered here or further out; null if there is none.
    [[nodiscard]] const camera::FormulaFunction* find_function(std::string_view name) const;
    /// The names of all functions that are offered or defined here or further out.
    [[nodiscard]] std::vector<std::string> function_names() const;
    /// Stores the reason why a name that is defined later cannot be used yet.
    void announce(std::string_view name, std::string_view why_not_yet);
    /// The stored reason for such a name; empty for others.
    [[nodiscard]] std::string_view announced(std::string_view name) const;
    /// Marks the scope as incomplete after a reported error, so that unknown names are not
    /// reported.
    void mark_incomplete() { incomplete_ = true; }
    [[nodiscard]] bool incomplete() const {
        return incomplete_ || (outer_ != nullptr && outer_->incomplete());
    }
    /// Copies the names that another scope itself defines. Calls `on_conflict` for each name that
    /// is already defined differently.
    void copy_from(const Scope& other,
                   const std::function<void(std::string_view name, const Definition& here,
                                            const Definition& there)>& on_conflict);
    /// All visible names.
    [[nodiscard]] std::vector<std::string> names() const;

private:
    Scope* outer_;
    std::unordered_map<std::string_view, Definition> definitions_;
    std::unordered_map<std::string_view, std::string_view> announced_;
    std::vector<const camera::FormulaFunction*> functions_;
    bool incomplete_ = false;
};

/// The global scope with pi and t.
[[nodiscard]] std::unique_ptr<Scope> constants(expr::Graph& graph);

/// Reports that a name is defined twice, with both positions.
void report_duplicate(const Identifier& name, SourceSpan place, const SourceSpan& earlier,
                      Reporter& reporter);

/// Reports an argument that has been given before.
void report_given_twice(const Identifier& name, SourceSpan place, const SourceSpan& earlier,
                        Reporter& reporter);

/// Evaluates the lets of a scope in dependency order and defines them. Cyclic lets are
/// reported.
void define_lets(const SyntaxTree& tree, const std::vector<const Statement*>& lets, Scope& scope,
                 const Context& context);

}  // namespace balcony::lang
