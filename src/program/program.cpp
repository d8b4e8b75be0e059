// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/program.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <set>

#include "balcony/progress.hpp"
#include "base/precondition.hpp"
#include "program/tape.hpp"

namespace balcony::program {

namespace {

using expr::Expr;
using expr::Graph;

std::optional<Diagnostic> wrong_declaration(const Interface& interface) {
    std::set<std::string_view> names{"x", "y", "t"};
    for (const Input& input : interface.inputs) {
        if (!names.insert(input.name).second) {
            return error("the input '" + input.name + "' is declared twice", {},
                         "x, y and t are always there; give every further input its own name");
        }
    }
    return std::nullopt;
}

// A leaf that no value is declared for.
std::optional<Diagnostic> unknown_leaf(std::span<const Expr> roots, const Interface& interface) {
    std::set<std::string_view> known{"x", "y", "t"};
    for (const Input& input : interface.inputs) {
        known.insert(input.name);
    }
    const Graph& graph = roots.front().graph();
    for (const expr::NodeId id : expr::reachable(graph, roots)) {
        const expr::Node& node = graph[id];
        if (node.op == expr::Op::variable) {
            return error("a formula with a free variable cannot be compiled", {},
                         "put a value in the place of the variable");
        }
        if (node.op == expr::Op::input && !known.contains(graph.input_names()[node.detail])) {
            return error("a formula depends on the input '" + graph.input_names()[node.detail] +
                             "', which is not declared",
                         {}, "declare the input with its rate where the formula is compiled");
        }
    }
    return std::nullopt;
}

bool are_in_one_graph(std::span<const Expr> roots) {
    return std::all_of(roots.begin(), roots.end(), [&](const Expr& root) {
        return root.valid() && &root.graph() == &roots.front().graph();
    });
}

std::span<const Expr> of_x_y_and_time(std::span<const Expr> roots) {
    precondition(are_in_one_graph(roots), "the roots of a program are in one graph");
    precondition(roots.empty() || !unknown_leaf(roots, {}), "the roots depend on x, y and t alone");
    return roots;
}

std::shared_ptr<const Tape> simplified_tape(std::span<const Expr> roots,
                                            const Interface& interface) {
    if (roots.empty() || !interface.is_simplified) {
        return compile(roots, interface);
    }
    const std::vector<Expr> simplified =
        expr::simplify(roots, rates_of(roots.front().graph(), interface));
    const std::shared_ptr<Tape> tape = compile(simplified, interface);
    if (interface.sampling == Sampling::grid) {
        tape->shortening =
            Shortening::make(simplified, interface, tape->section(Rate::pixel).size());
    }
    return tape;
}

}  // namespace

Program::Program(std::shared_ptr<const Tape> tape) : tape_(std::move(tape)) {}

Program::Program(std::span<const Expr> roots, Sampling sampling)
    : Program(simplified_tape(of_x_y_and_time(roots), {sampling, {}})) {}

Result<Program> Program::make(std::span<const Expr> roots, const Interface& interface) {
    if (std::optional<Diagnostic> wrong = wrong_declaration(interface)) {
        return *std::move(wrong);
    }
    if (!are_in_one_graph(roots)) {
        return error(Kind::internal, "the roots of a program are not in one graph");
    }
    if (roots.empty()) {
        return Program(compile(roots, interface));
    }
    if (std::optional<Diagnostic> unknown = unknown_leaf(roots, interface)) {
        return *std::move(unknown);
    }
    try {
        return Program(simplified_tape(roots, interface));
    } catch (const expr::GraphStopped&) {
        return stopped();
    } catch (const expr::GraphTooLarge&) {
        return error("the formulas grow to more than 4 million operations when they are compiled",
                     {}, "use fewer or simpler stages");
    }
}

Sampling Program::sampling() const { return tape_->interface.sampling; }

std::span<const Input> Program::inputs() const { return tape_->interface.inputs; }

std::size_t Program::root_count() const { return tape_->roots.size(); }

Rate Program::rate(std::size_t root) const {
    precondition(root < root_count(), "a program has no such root");
    return tape_->roots[root].rate;
}

std::size_t Program::instruction_count(Rate rate) const { return tape_->section(rate).size(); }

namespace {

// Values of the inputs as many as count(rate) says.
template <class Count>
bool fits(std::span<const Input> declared, InputValues given, const Count& count) {
    return std::equal(declared.begin(), declared.end(), given.begin(), given.end(),
                      [&](const Input& input, std::span<const double> values) {
                          return values.size() == count(input.rate);
                      });
}

}  // namespace

bool fits(const Program& program, const Tile& tile) {
    return program.sampling() == Sampling::grid &&
           fits(program.inputs(), tile.inputs, [&](Rate rate) {
               const bool columns = rate == Rate::column || rate == Rate::pixel;
               const bool rows = rate == Rate::row || rate == Rate::pixel;
               return (columns ? tile.width : 1) * (rows ? tile.height : 1);
           });
}

bool fits(const Program& program, const Points& points) {
    return program.sampling() == Sampling::points && points.x.size() == points.y.size() &&
           fits(program.inputs(), points.inputs,
                [&](Rate rate) { return rate == Rate::uniform ? 1 : points.x.size(); });
}

namespace {

constexpr std::align_val_t alignment{register_alignment * sizeof(double)};

}  // namespace

void Scratch::Free::operator()(double* memory) const { ::operator delete[](memory, alignment); }

double* Scratch::reserve(std::size_t doubles) {
    if (doubles > size_) {
        memory_.reset(static_cast<double*>(::operator new[](doubles * sizeof(double), alignment)));
        size_ = doubles;
    }
    return memory_.get();
}

std::span<double* const> ResultArrays::reserve(std::size_t roots, std::size_t size) {
    constexpr std::size_t page = 4096 / sizeof(double);
    constexpr std::size_t offset = 2 * register_alignment;
    const std::size_t stride = (size + page - 1) / page * page + offset;
    double* const memory = memory_.reserve(roots * stride);
    arrays_.resize(roots);
    for (std::size_t root = 0; root < roots; ++root) {
        arrays_[root] = memory + root * stride;
    }
    return arrays_;
}

}  // namespace balcony::program
