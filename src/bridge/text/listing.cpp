// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/listing.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "bridge/text/coarse_table.hpp"
#include "bridge/text/unused_branches.hpp"

namespace balcony::bridge {

namespace {

using expr::Graph;
using expr::Node;
using expr::NodeId;
using expr::Precedence;

/// A formula: its text, how tightly it binds, and the names in it.
struct Formula {
    std::string text;
    Precedence binding = Precedence::atom;
    bool condition = false;
    std::set<std::string> uses{};
};

std::string enclosed(const std::string& text, bool enclose) {
    return enclose ? "(" + text + ")" : text;
}

class Lister {
public:
    Lister(const CameraFormulas& formulas, const Dialect& dialect, Names& names,
           std::string_view prefix, const InputText& input_text)
        : formulas_(formulas),
          graph_(*formulas.graph),
          dialect_(dialect),
          names_(names),
          prefix_(prefix),
          input_text_(input_text),
          uses_(graph_.size(), 0),
          sections_(graph_.size(), 0),
          stage_names_(graph_.size()),
          formulas_of_nodes_(graph_.size()) {}

    Listing run() {
        const std::vector<NodeId> nodes = expr::reachable(graph_, formulas_.roots);
        count_uses(nodes);
        assign_sections(nodes);
        const std::size_t section_count = formulas_.stages.size() + 1;
        for (std::size_t section = 0; section < section_count; ++section) {
            ListedSection listed{section < formulas_.stages.size()
                                     ? formulas_.stages[section].written
                                     : "the ray, with a direction of unit length",
                                 {}};
            for (const NodeId id : nodes) {
                if (sections_[id.value()] == section) {
                    list(id, listed.lines);
                }
            }
            if (!listed.lines.empty() || !is_listed(listed.comment)) {
                made_.sections.push_back(std::move(listed));
            }
        }
        for (std::size_t i = 0; i < formulas_.roots.size(); ++i) {
            const bool condition = i == formulas_.condition;
            Formula root = in_form(formula(formulas_.roots[i].id()), condition);
            made_.roots.push_back({{}, std::move(root.text), condition, std::move(root.uses)});
        }
        return std::move(made_);
    }

private:
    void count_uses(const std::vector<NodeId>& nodes) {
        for (const NodeId id : nodes) {
            for (const NodeId argument : graph_.arguments(id)) {
                ++uses_[argument.value()];
            }
        }
        for (const Expr root : formulas_.roots) {
            ++uses_[root.id().value()];
        }
    }

    // Stages that serve both paths of a camera are listed once.
    [[nodiscard]] bool is_listed(const std::string& comment) const {
        return std::any_of(
            made_.sections.begin(), made_.sections.end(),
            [&comment](const ListedSection& section) { return section.comment == comment; });
    }

    // A node belongs to the first stage whose values are made of it, or to the ray; so does what it
    // is made of, or to an earlier one.
    void assign_sections(const std::vector<NodeId>& nodes) {
        std::vector<bool> needed(graph_.size(), false);
        for (const NodeId id : nodes) {
            needed[id.value()] = true;
        }
        std::fill(sections_.begin(), sections_.end(), formulas_.stages.size());
        for (std::size_t i = formulas_.stages.size(); i-- > 0;) {
            const StageFormulas& stage = formulas_.stages[i];
            for (const NodeId id : expr::reachable(graph_, stage.values)) {
                sections_[id.value()] = i;
            }
        }
        for (const StageFormulas& stage : formulas_.stages) {
            for (std::size_t i = 0; i < stage.values.size(); ++i) {
                const NodeId id = stage.values[i].id();
                if (needed[id.value()] && stage_names_[id.value()].empty()) {
                    stage_names_[id.value()] = stage.names[i];
                }
            }
        }
    }

    [[nodiscard]] static bool is_leaf(Op op) {
        return op == Op::constant || op == Op::input || op == Op::variable;
    }

    // Writes a node's formula; as a line of its own if it has a name, several users or a long text.
    void list(NodeId id, std::vector<ListedLine>& lines) {
        constexpr std::size_t longest = 160;
        const Op op = graph_[id].op;
        Formula text = write(id);
        const std::string& stage_name = stage_names_[id.value()];
        const bool named =
            !stage_name.empty() || uses_[id.value()] > 1 || text.text.size() > longest;
        if (named && !is_leaf(op) && op != Op::call) {
            const std::string name = names_.unique(
                stage_name.empty() ? fmt::format("s{}", ++shared_count_) : stage_name);
            lines.push_back({name, text.text, text.condition, text.uses});
            text = {name, Precedence::atom, text.condition, {name}};
        }
        formulas_of_nodes_[id.value()] = std::move(text);
    }

    [[nodiscard]] const Formula& formula(NodeId id) const { return formulas_of_nodes_[id.value()]; }

    // A formula as a condition or as a number.
    [[nodiscard]] Formula in_form(const Formula& given, bool condition) const {
        if (given.condition == condition) {
            return given;
        }
        const std::string_view pattern =
            condition ? dialect_.condition_of_number : dialect_.number_of_condition;
        if (pattern == "{0}") {
            return {given.text, given.binding, condition, given.uses};
        }
        return {filled(dialect_.spelled(pattern), {given.text}), Precedence::atom, condition,
                given.uses};
    }

    [[nodiscard]] static bool takes_condition(Op op, std::size_t operand) {
        return op == Op::logical_and || op == Op::logical_or || op == Op::logical_not ||
               (op == Op::select && operand == 0);
    }

    Formula write(NodeId id) {
        const Node& node = graph_[id];
        switch (node.op) {
            case Op::constant:
                return {dialect_.number(node.value),
                        std::signbit(node.value) ? Precedence::prefix : Precedence::atom};
            case Op::input: {
                const std::string text = input_text_(graph_.input_names()[node.detail]);
                return {text, Precedence::atom, false, {text}};
            }
            case Op::call: return call(table_name(graph_.call_of(id)), operands(id), false);
            case Op::result: return formula(node.operands[0]);
            default: return operation(id, node.op);
        }
    }

    [[nodiscard]] std::vector<Formula> operands(NodeId id) const {
        std::vector<Formula> made;
        const std::span<const NodeId> arguments = graph_.arguments(id);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            made.push_back(in_form(formula(arguments[i]), takes_condition(graph_[id].op, i)));
        }
        const HarmlessOperand* harmless = harmless_operand(graph_, id);
        if (harmless != nullptr && !dialect_.guarded.empty()) {
            Formula& operand = made[harmless->operand];
            operand.text = filled(dialect_.spelled(dialect_.guarded),
                                  {operand.text, dialect_.number(harmless->number)});
            operand.binding = Precedence::atom;
        }
        return made;
    }

    [[nodiscard]] static std::set<std::string> all_uses(const std::vector<Formula>& operands) {
        std::set<std::string> all;
        for (const Formula& operand : operands) {
            all.insert(operand.uses.begin(), operand.uses.end());
        }
        return all;
    }

    [[nodiscard]] static Formula call(std::string_view name, const std::vector<Formula>& operands,
                                      bool condition) {
        std::string text(name);
        for (std::size_t i = 0; i < operands.size(); ++i) {
            text += (i == 0 ? "(" : ", ") + operands[i].text;
        }
        return {text + ")", Precedence::atom, condition, all_uses(operands)};
    }

    Formula operation(NodeId id, Op op) {
        const Spelling& spelling = dialect_.spellings[static_cast<std::size_t>(op)];
        const bool condition = expr::operation(op).condition;
        const std::vector<Formula> given = operands(id);
        need(dialect_.spelled(spelling.helper));
        const std::string spelled = dialect_.spelled(spelling.text);
        if (spelling.form == Spelling::Form::standard) {
            return call(
                fmt::format("{}{}{}", dialect_.before_standard, spelled, dialect_.behind_standard),
                given, condition);
        }
        if (spelling.form == Spelling::Form::call) {
            return call(spelled, given, condition);
        }
        if (spelling.form == Spelling::Form::pattern) {
            std::vector<std::string> texts;
            for (const Formula& operand : given) {
                texts.push_back(enclosed(operand.text, operand.binding < Precedence::atom));
            }
            return {filled(spelled, texts), Precedence::atom, condition, all_uses(given)};
        }
        return with_symbol(op, spelled, given);
    }

    void need(std::string helper) {
        const auto& known = made_.helpers;
        if (!helper.empty() && std::find(known.begin(), known.end(), helper) == known.end()) {
            made_.helpers.push_back(std::move(helper));
        }
    }

    // Languages differ in how comparisons and their combinations bind, so these are enclosed.
    [[nodiscard]] static Formula with_symbol(Op op, std::string_view symbol,
                                             const std::vector<Formula>& given) {
        const Precedence binding = expr::operation(op).precedence;
        const bool condition = expr::operation(op).condition;
        const auto loose = [&](const Formula& operand, bool right) {
            return condition ? operand.binding < Precedence::atom
                   : right   ? operand.binding <= binding
                             : operand.binding < binding;
        };
        if (given.size() == 1) {
            return {fmt::format("{}{}", symbol,
                                enclosed(given[0].text, given[0].binding < Precedence::atom)),
                    binding, condition, given[0].uses};
        }
        return {fmt::format("{} {} {}", enclosed(given[0].text, loose(given[0], false)), symbol,
                            enclosed(given[1].text, loose(given[1], true))),
                binding, condition, all_uses(given)};
    }

    std::string table_name(const expr::Call& call) {
        const auto [entry, is_new] = table_names_.try_emplace(call.table.get());
        if (is_new) {
            entry->second =
                names_.unique(fmt::format("{}table_{}", prefix_, made_.tables.size() + 1));
            made_.tables.push_back(
                {dialect_.single ? coarse_table(call.table) : call.table, entry->second});
        }
        return entry->second;
    }

    const CameraFormulas& formulas_;
    const Graph& graph_;
    const Dialect& dialect_;
    Names& names_;
    const std::string_view prefix_;
    const InputText& input_text_;
    std::vector<std::uint32_t> uses_;
    std::vector<std::size_t> sections_;
    std::vector<std::string> stage_names_;
    std::vector<Formula> formulas_of_nodes_;
    std::size_t shared_count_ = 0;
    std::map<const expr::Table*, std::string> table_names_;
    Listing made_;
};

bool is_part_of_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string with_point(std::string text) {
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

}  // namespace

std::string Dialect::spelled(std::string_view text) const {
    std::string made(text);
    for (const auto& [word, by] : words) {
        made = replaced(std::move(made), word, by);
    }
    return made;
}

bool Listing::uses(const std::string& name) const {
    const auto has = [&name](const ListedLine& line) { return line.uses.contains(name); };
    return std::any_of(roots.begin(), roots.end(), has) ||
           std::any_of(sections.begin(), sections.end(), [&has](const ListedSection& section) {
               return std::any_of(section.lines.begin(), section.lines.end(), has);
           });
}

Names::Names(const std::set<std::string_view>& reserved, std::string_view reserved_prefix)
    : taken_(reserved.begin(), reserved.end()), reserved_prefix_(reserved_prefix) {}

std::string Names::unique(std::string_view wanted) {
    std::string base;
    for (const char c : wanted) {
        // GLSL reserves names with two underscores in a row.
        const char kept = is_part_of_name(c) ? c : '_';
        if (kept != '_' || base.empty() || base.back() != '_') {
            base += kept;
        }
    }
    const bool is_reserved = !reserved_prefix_.empty() && base.starts_with(reserved_prefix_);
    if (base.empty() || (base.front() >= '0' && base.front() <= '9') || is_reserved) {
        base = "camera_" + base;
    }
    std::string name = base;
    for (std::size_t i = 2; !taken_.insert(name).second; ++i) {
        name = fmt::format("{}_{}", base, i);
    }
    return name;
}

Listing listing_of(const CameraFormulas& formulas, const Dialect& dialect, Names& names,
                   std::string_view prefix, const InputText& input_text) {
    return Lister(formulas, dialect, names, prefix, input_text).run();
}

std::string replaced(std::string text, std::string_view word, std::string_view by) {
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + by.size())) {
        text.replace(at, word.size(), by);
    }
    return text;
}

std::string filled(std::string_view pattern, const std::vector<std::string>& operands) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool hole = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        if (hole) {
            text += operands[static_cast<std::size_t>(pattern[i + 1] - '0')];
            i += 2;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

std::string wrapped(const std::vector<std::string>& numbers, std::size_t margin) {
    constexpr std::size_t widest = 100;
    std::string text;
    std::size_t column = widest;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::string item = numbers[i];
        item += i + 1 < numbers.size() ? "," : "";
        if (column + item.size() + 1 > widest) {
            text += '\n';
            text.append(margin, ' ');
            column = margin;
        } else {
            text += " ";
            ++column;
        }
        text += item;
        column += item.size();
    }
    return text;
}

std::string decimal(double value) { return with_point(fmt::format("{}", value)); }

std::string single_decimal(double value) {
    return with_point(fmt::format("{}", static_cast<float>(value)));
}

std::string comment_line(std::string_view text) {
    std::string line = printable(text);
    std::replace(line.begin(), line.end(), '\\', '/');
    return line;
}

}  // namespace balcony::bridge
