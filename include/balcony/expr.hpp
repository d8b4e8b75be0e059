// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Expr: the expression graph to which every camera is compiled.
//
// A Graph is an append-only arena of immutable nodes; equal nodes are shared (hash-consing). An
// argument always precedes the node that uses it, so iteration by index is
// topological order, and no function recurses.
//
// Semantics. Values are IEEE doubles, conditions are 1 or 0. The graph's algebra is that of real
// numbers: a rewriting may assume that values are finite (0*x is 0, x - x is 0) and may regroup
// sums and products. It never makes a sum of squares finite if one of the squared values is
// not, so that one test of the sum covers all of them. A NaN never represents the absence of
// a value: a stage that can fail must state a condition, and the camera collects these in its
// validity root. Outside its domain, an operation gives NaN or an infinity, as IEEE 754 and C
// define; min(a, b) is b if b < a, else a (max alike); comparisons with NaN are false; sign(0) is
// 0; mod(a, b) is a - b*floor(a/b).

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/operations.hpp"

namespace balcony::expr {

class Graph;
class Expr;

using NodeId = StrongIndex<struct NodeTag>;
using InputId = StrongIndex<struct InputTag>;
using CallId = StrongIndex<struct CallTag>;

/// The inputs that every graph has: the point of the picture in pixels, x from the left and y from
/// the top, and time. Further inputs are numbered from 3 in the order of their first use.
namespace inputs {
inline constexpr InputId x{0};
inline constexpr InputId y{1};
inline constexpr InputId t{2};
}  // namespace inputs

/// The inputs on which a value depends, and possibly a free variable. Inputs numbered 62
/// and above are not distinguished: a set that contains one of them contains all.
class Dependence {
public:
    constexpr Dependence() = default;
    [[nodiscard]] static constexpr Dependence on(InputId input) {
        return Dependence(std::uint64_t{1} << std::min(input.value(), last_input));
    }
    [[nodiscard]] static constexpr Dependence on_variable() {
        return Dependence(std::uint64_t{1} << variable);
    }

    [[nodiscard]] constexpr Dependence operator|(Dependence other) const {
        return Dependence(set_ | other.set_);
    }
    [[nodiscard]] constexpr bool intersects(Dependence other) const {
        return (set_ & other.set_) != 0;
    }
    [[nodiscard]] constexpr bool empty() const { return set_ == 0; }
    constexpr bool operator==(const Dependence&) const = default;

private:
    static constexpr std::uint32_t last_input = 62;
    static constexpr std::uint32_t variable = 63;

    constexpr explicit Dependence(std::uint64_t set) : set_(set) {}
    std::uint64_t set_ = 0;
};

/// How often a value must be computed for a grid of picture points: once, once per column, once
/// per row, or at every point.
enum class Rate : std::uint8_t { uniform, column, row, pixel };

/// The rates of a graph's inputs, declared by the user of the graph: x changes by column and y by
/// row; any other input is uniform unless declared. A value that depends on a variable has rate
/// pixel.
class Rates {
public:
    constexpr void declare(InputId input, Rate rate) {
        const Dependence on_input = Dependence::on(input);
        if (rate == Rate::column || rate == Rate::pixel) {
            by_column_ = by_column_ | on_input;
        }
        if (rate == Rate::row || rate == Rate::pixel) {
            by_row_ = by_row_ | on_input;
        }
    }
    /// The rate of what depends on these.
    [[nodiscard]] constexpr Rate operator()(Dependence dependence) const {
        const bool x = dependence.intersects(by_column_);
        const bool y = dependence.intersects(by_row_);
        return x ? (y ? Rate::pixel : Rate::column) : (y ? Rate::row : Rate::uniform);
    }

private:
    Dependence by_column_ = Dependence::on(inputs::x) | Dependence::on_variable();
    Dependence by_row_ = Dependence::on(inputs::y) | Dependence::on_variable();
};

struct Node {
    static constexpr std::size_t max_operands = 3;

    double value = 0.0;  ///< Of a constant.
    /// The arguments of a node that is no call; Graph::arguments() has those of any.
    std::array<NodeId, max_operands> operands{};
    /// An InputId, the number of a variable, a CallId, which result of a call.
    std::uint32_t detail = 0;
    Op op = Op::constant;

    bool operator==(const Node&) const;
};

/// A piecewise polynomial in one, two or three variables over the equal cells of a box; outside,
/// the border cells extrapolate. In a cell the value is the sum of c[i, j, k] r^i s^j t^k, with r,
/// s and t in [0, 1) from the cell's lower corner along each axis.
struct Table {
    struct Axis {
        double first = 0.0;
        double last = 1.0;
        std::size_t cells = 1;
        std::size_t degree = 3;  ///< At most max_degree.
    };
    static constexpr std::size_t max_degree = 7;
    static constexpr std::size_t max_axes = 3;

    std::vector<Axis> axes;
    /// By cell and within a cell by power; in both, the last axis varies fastest.
    std::vector<double> coefficients;

    [[nodiscard]] double operator()(std::span<const double> at) const;
    [[nodiscard]] double operator()(double x) const { return (*this)(std::span(&x, 1)); }
    /// The partial derivative with respect to the variable of an axis.
    [[nodiscard]] Table derivative(std::size_t axis) const;
};

/// Makes the cubic table with the given values and slopes (per unit of x) at equally spaced
/// knots.
[[nodiscard]] Table hermite_table(double first, double last, std::span<const double> values,
                                  std::span<const double> slopes);

/// An opaque function, computed for batches of points, such as a search in
/// a mesh or a map projection. Immutable, and callable by many threads at once; must not throw.
class Native {
public:
    Native() = default;
    Native(const Native&) = delete;
    Native& operator=(const Native&) = delete;
    virtual ~Native() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::size_t argument_count() const = 0;  ///< At least 1.
    [[nodiscard]] virtual std::size_t result_count() const = 0;    ///< At least 1.
    /// results[r][i] for all results r at the arguments arguments[0][i], arguments[1][i], ...; the
    /// same for the same arguments, whatever else is in the batch. No result stands where an
    /// argument stands.
    virtual void evaluate(std::size_t count, const double* const* arguments,
                          double* const* results) const = 0;
    /// The partial derivative of a result by an argument: any formula of the arguments and of all
    /// results, such as a result of another call. No node where it is 0 throughout.
    [[nodiscard]] virtual Expr derivative(std::size_t result, std::size_t argument,
                                          std::span<const Expr> arguments,
                                          std::span<const Expr> results) const = 0;
    /// Which result is the condition that the other ones hold: 1 where they do; where it is 0 they
    /// mean nothing. None if they always hold.
    [[nodiscard]] virtual std::optional<std::size_t> validity() const { return std::nullopt; }
};

/// What a call node calls, one of the two, and on what.
struct Call {
    std::shared_ptr<const Table> table;
    std::shared_ptr<const Native> native;
    std::vector<NodeId> arguments;

    /// Tells functions apart.
    [[nodiscard]] const void* function() const {
        return native ? static_cast<const void*>(native.get()) : table.get();
    }
    [[nodiscard]] std::size_t result_count() const { return native ? native->result_count() : 1; }
    /// As Native::evaluate().
    void evaluate(std::size_t count, const double* const* at, double* const* results) const;
};

/// Thrown by functions that add a node to a full graph. This exception and the next one are the
/// only ones of this layer. Functions of higher layers that build graphs catch them and return a
/// Diagnostic.
class GraphTooLarge : public std::length_error {
public:
    GraphTooLarge();
};

/// Thrown by functions that add a node to a graph after a stop.
class GraphStopped : public std::runtime_error {
public:
    GraphStopped();
};

inline constexpr std::size_t max_nodes = std::size_t{1} << 22U;

/// Functions that add nodes may throw GraphTooLarge, and GraphStopped if there is a token; what is
/// in the graph stays valid.
class Graph {
public:
    /// A graph of at most so many nodes.
    explicit Graph(std::stop_token stop = {}, std::size_t most = max_nodes)
        : stop_(std::move(stop)), most_(most) {}
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    [[nodiscard]] Expr constant(double value);
    /// The input of a name, which need not be known before. Who evaluates or compiles gives it a
    /// value by that name.
    [[nodiscard]] Expr input(std::string_view name);
    [[nodiscard]] Expr picture_x();  ///< The input "x".
    [[nodiscard]] Expr picture_y();  ///< The input "y".
    [[nodiscard]] Expr time();       ///< The input "t".
    /// A free variable, to be replaced by substitute(). Variables with the same number are equal.
    [[nodiscard]] Expr variable(std::uint32_t number);
    /// An unused variable.
    [[nodiscard]] Expr fresh_variable();
    /// The results of a function at a point, one argument for each that it takes. Constant if the
    /// arguments are.
    [[nodiscard]] std::vector<Expr> call(std::shared_ptr<const Native> function,
                                         std::span<const Expr> at);
    /// The table's value at a point, with one argument per axis.
    [[nodiscard]] Expr lookup(std::shared_ptr<const Table> table, std::span<const Expr> at);
    [[nodiscard]] Expr lookup(std::shared_ptr<const Table> table, Expr x);
    /// An operation on nodes of this graph, folded if they are constant, and rewritten if a local
    /// rule at the arguments' own arguments shows something simpler. Not for leaves, calls and
    /// their results.
    [[nodiscard]] Expr apply(Op op, std::span<const Expr> arguments);

    /// A node of this or another graph with arguments in this graph, as its function makes it:
    /// folded or rewritten where they allow it.
    [[nodiscard]] Expr remake(const Graph& source, const Node& node,
                              std::span<const Expr> arguments);
    /// The same without folding and rewriting, so that no value changes by rounding.
    [[nodiscard]] Expr copy(const Graph& source, const Node& node, std::span<const Expr> arguments);

    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    /// Work on the graph that adds no nodes ends with the same stop.
    [[nodiscard]] const std::stop_token& stop() const { return stop_; }
    [[nodiscard]] const Node& operator[](NodeId id) const { return nodes_[id.value()]; }
    [[nodiscard]] Dependence dependence(NodeId id) const { return dependences_[id.value()]; }
    /// The names of the inputs by their numbers, beginning with "x", "y" and "t".
    [[nodiscard]] std::span<const std::string> input_names() const { return inputs_; }
    /// The arguments of a node, any number. Good until a node is added.
    [[nodiscard]] std::span<const NodeId> arguments(NodeId id) const;
    /// What a call node calls.
    [[nodiscard]] const Call& call_of(NodeId id) const {
        assert((*this)[id].op == Op::call);
        return calls_[(*this)[id].detail];
    }
    /// The table of the derivatives of this one along an axis.
    [[nodiscard]] std::shared_ptr<const Table> derivative_table(
        const std::shared_ptr<const Table>& table, std::size_t axis);

private:
    /// The unique node equal to this one; created if missing.
    [[nodiscard]] Expr intern(const Node& node);
    [[nodiscard]] Dependence dependence_of(NodeId id) const;
    [[nodiscard]] Expr input(InputId id);
    [[nodiscard]] Expr call_node(Call call, std::span<const Expr> at);
    [[nodiscard]] Expr result_of(NodeId call, std::size_t number);

    struct Hash {
        std::size_t operator()(const Node& node) const;
    };

    std::stop_token stop_;
    std::size_t most_;
    std::vector<Node> nodes_;
    std::vector<Dependence> dependences_;  ///< By node.
    std::unordered_map<Node, NodeId, Hash> known_;
    std::vector<std::string> inputs_{"x", "y", "t"};
    std::vector<Call> calls_;
    std::map<std::pair<const void*, std::vector<NodeId>>, CallId> known_calls_;  ///< By function.
    std::map<std::pair<std::shared_ptr<const Table>, std::size_t>, std::shared_ptr<const Table>>
        derivative_tables_;
    std::uint32_t variables_ = 0;
};

/// A handle to a node of a graph, for writing formulas. A default-constructed handle is invalid.
class Expr {
public:
    Expr() = default;
    Expr(Graph& graph, NodeId id) : graph_(&graph), id_(id) {}

    [[nodiscard]] Graph& graph() const { return *graph_; }
    [[nodiscard]] NodeId id() const { return id_; }
    [[nodiscard]] const Node& node() const { return (*graph_)[id_]; }
    [[nodiscard]] Op op() const { return node().op; }
    [[nodiscard]] Expr argument(std::size_t i) const {
        return {*graph_, graph_->arguments(id_)[i]};
    }
    [[nodiscard]] bool valid() const { return graph_ != nullptr; }
    [[nodiscard]] Dependence dependence() const { return graph_->dependence(id_); }
    [[nodiscard]] Rate rate(const Rates& rates = {}) const { return rates(dependence()); }
    [[nodiscard]] bool is_constant() const { return op() == Op::constant; }
    [[nodiscard]] bool is_constant(double value) const {
        return is_constant() && node().value == value;
    }
    /// Compares nodes, not values.
    [[nodiscard]] bool same(Expr other) const { return graph_ == other.graph_ && id_ == other.id_; }

private:
    Graph* graph_ = nullptr;
    NodeId id_;
};

Expr operator-(Expr a);
Expr operator+(Expr a, Expr b);
Expr operator+(Expr a, double b);
Expr operator+(double a, Expr b);
Expr operator-(Expr a, Expr b);
Expr operator-(Expr a, double b);
Expr operator-(double a, Expr b);
Expr operator*(Expr a, Expr b);
Expr operator*(Expr a, double b);
Expr operator*(double a, Expr b);
Expr operator/(Expr a, Expr b);
Expr operator/(Expr a, double b);
Expr operator/(double a, Expr b);

Expr operator<(Expr a, Expr b);
Expr operator<(Expr a, double b);
Expr operator<(double a, Expr b);
Expr operator<=(Expr a, Expr b);
Expr operator<=(Expr a, double b);
Expr operator<=(double a, Expr b);
Expr equal(Expr a, Expr b);
Expr operator&&(Expr a, Expr b);
Expr operator||(Expr a, Expr b);
Expr operator!(Expr a);
Expr is_finite(Expr a);
Expr select(Expr condition, Expr if_true, Expr if_false);

Expr mod(Expr a, Expr b);
Expr min(Expr a, Expr b);
Expr max(Expr a, Expr b);
Expr abs(Expr a);
Expr sign(Expr a);
Expr floor(Expr a);
Expr sqrt(Expr a);
Expr pow(Expr a, Expr b);
/// An exponent that is a multiple of 1/8 with an absolute value of at most 64 becomes products and
/// square roots: within |b| + 3 units in the last place, if neither the result nor its reciprocal
/// leaves the range of normal numbers.
Expr pow(Expr a, double b);
Expr exp(Expr a);
Expr log(Expr a);
Expr sin(Expr a);
Expr cos(Expr a);
Expr tan(Expr a);
Expr asin(Expr a);
Expr acos(Expr a);
Expr atan(Expr a);
Expr atan2(Expr y, Expr x);
Expr sinh(Expr a);
Expr cosh(Expr a);
Expr tanh(Expr a);
Expr asinh(Expr a);
Expr acosh(Expr a);
Expr atanh(Expr a);

/// sign(x) |x|^p, the paper's x^[p].
Expr signed_power(Expr x, Expr p);

/// d expression / d leaf, exactly, by the derivative rules of the operations. The leaf is an input
/// or a variable.
[[nodiscard]] std::vector<Expr> differentiate(std::span<const Expr> expressions, Expr leaf);
[[nodiscard]] Expr differentiate(Expr expression, Expr leaf);

/// Leaves and their replacements.
struct Substitution {
    Expr leaf;
    Expr replacement;
};

/// The expressions with leaves replaced. They may be in another graph than the replacements,
/// which copies a formula into a camera's graph: the result is in `target`, and other leaves
/// are copied unchanged, inputs by name.
[[nodiscard]] std::vector<Expr> substitute(Graph& target, std::span<const Expr> expressions,
                                           std::span<const Substitution> substitutions);

/// Rewrites for speed: collects sums of scaled terms (affine chains become one), orders products so
/// that factors that depend only on the column or only on the row stay together, and extracts
/// common factors. Values change by rounding only. Idempotent, except for chains of many thousands
/// of factors, whose regrouping stops after a bounded number of passes.
[[nodiscard]] std::vector<Expr> simplify(std::span<const Expr> expressions,
                                         const Rates& rates = {});

/// The nodes below the given ones, including these, arguments first.
[[nodiscard]] std::vector<NodeId> reachable(const Graph& graph, std::span<const Expr> expressions);

struct InputValue {
    std::string_view name;
    double value;
};

/// Values of the leaves. A leaf without a value is not a number.
struct Point {
    double x = 0.0;
    double y = 0.0;
    double time = 0.0;
    std::span<const double> variables{};   ///< Of variable 0, 1, ...
    std::span<const InputValue> inputs{};  ///< Of inputs other than x, y and t, in any order.
};

/// Evaluates one point by the scalar definitions, for tests and single points.
[[nodiscard]] std::vector<double> evaluate(std::span<const Expr> expressions, const Point& point);

/// Expressions ready to be evaluated by the scalar definitions at many points at a time.
class BatchEvaluator {
public:
    /// The expressions are in one graph, which must outlive the evaluator.
    explicit BatchEvaluator(std::span<const Expr> expressions);

    /// Fills in the values of an input or a variable at the points of a batch.
    using FillLeaf = std::function<void(const Node& leaf, std::span<double> values)>;
    /// The values of expression r at the points of a batch, from r * count on.
    [[nodiscard]] std::vector<double> operator()(std::size_t count, const FillLeaf& fill) const;
    /// The inputs and variables below the expressions.
    [[nodiscard]] std::span<const NodeId> leaves() const { return leaves_; }

private:
    std::vector<Expr> expressions_;
    std::vector<NodeId> nodes_;  ///< Arguments first.
    std::vector<NodeId> leaves_;
    std::vector<std::size_t> places_;  ///< By node: which run of values is its.
    std::size_t place_count_ = 0;
};

/// Values on the way to other expressions, for print().
struct NamedStep {
    std::string name;
    std::vector<Expr> values;
    std::vector<std::string> value_names;  ///< One for each: "x" of the step "eye" is eye_x.
};

/// The expressions as readable formulas, one per line; shared parts are named first: eye_1, eye_2
/// where they are part of the values of the step "eye" and of no earlier step, s1, s2 elsewhere.
[[nodiscard]] std::string print(std::span<const Expr> expressions,
                                std::span<const std::string> names,
                                std::span<const NamedStep> steps = {});
[[nodiscard]] std::string print(Expr expression);

}  // namespace balcony::expr
