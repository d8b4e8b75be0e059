// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/own_names.hpp"

#include <algorithm>

namespace balcony::lang {

namespace {

class NameCollector {
public:
    explicit NameCollector(const SyntaxTree& tree) : tree_(tree) {}

    std::vector<OwnName> collect() {
        const Span whole{0, tree_.source->text().size()};
        for (std::size_t i = 0; i < tree_.items.size(); ++i) {
            if (const auto* let = std::get_if<Statement>(&tree_.items[i])) {
                add_let(*let, whole, nullptr);
            } else if (const auto* one = std::get_if<DefinitionSyntax>(&tree_.items[i])) {
                add({OwnKind::camera, one->name, whole, one, nullptr, nullptr, one->span});
                // One whose brace is missing goes on to the next item.
                const Span inside{one->span.begin, begin_of(i + 1)};
                for (const DefinitionParameter& parameter : one->parameters) {
                    add({OwnKind::parameter, parameter.name, inside, one, &parameter, nullptr,
                         declaration_of(parameter)});
                }
                add_statements(one->statements, inside, one);
            }
        }
        return std::move(names_);
    }

private:
    [[nodiscard]] std::size_t begin_of(std::size_t item) const {
        if (item >= tree_.items.size()) {
            return tree_.source->text().size();
        }
        return std::visit([](const auto& one) { return one.span.begin; }, tree_.items[item]);
    }

    [[nodiscard]] Span declaration_of(const DefinitionParameter& parameter) const {
        std::size_t end = parameter.name.span.end;
        if (parameter.default_value.valid()) {
            end = tree_[parameter.default_value].span.end;
        }
        return {parameter.name.span.begin, std::max(end, parameter.limits.end)};
    }

    void add(OwnName name) {
        if (!name.name.text.empty()) {
            names_.push_back(name);
        }
    }

    void add_let(const Statement& statement, Span scope, const DefinitionSyntax* definition) {
        const LetSyntax& let = statement.let();
        add({OwnKind::let, let.name, scope, definition, nullptr, &let, statement.span});
        for (const Identifier& parameter : let.parameters) {
            add({OwnKind::function_parameter, parameter, statement.span, definition, nullptr, &let,
                 parameter.span});
        }
    }

    void add_statements(const std::vector<Statement>& statements, Span scope,
                        const DefinitionSyntax* definition) {
        for (const Statement& statement : statements) {
            if (statement.kind == StatementKind::let) {
                add_let(statement, scope, definition);
            } else if (statement.kind == StatementKind::loop) {
                if (const auto* loop = std::get_if<LoopSyntax>(&statement.content)) {
                    add({OwnKind::variable, loop->variable, statement.span, definition, nullptr,
                         nullptr, loop->variable.span});
                }
                add_statements(statement.block, statement.span, definition);
            }
        }
    }

    const SyntaxTree& tree_;
    std::vector<OwnName> names_;
};

}  // namespace

std::vector<OwnName> own_names(const SyntaxTree& tree) { return NameCollector(tree).collect(); }

const OwnName* find_name(const std::vector<OwnName>& names, std::string_view name,
                         std::size_t offset, bool of_camera) {
    const OwnName* found = nullptr;
    for (const OwnName& one : names) {
        const bool fits = (one.kind == OwnKind::camera) == of_camera && one.name.text == name &&
                          one.scope.begin <= offset && offset <= one.scope.end;
        if (fits && (found == nullptr ||
                     one.scope.end - one.scope.begin < found->scope.end - found->scope.begin)) {
            found = &one;
        }
    }
    return found;
}

}  // namespace balcony::lang
