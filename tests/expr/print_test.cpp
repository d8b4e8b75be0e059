// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Printed formulas are read back by a reader that knows only the usual precedences.

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "random_formula.hpp"

namespace balcony::expr::print_test {

namespace {

// From the loosest to the tightest; operators of one level group from the left.
const std::vector<std::vector<Op>> levels{
    {Op::logical_or},        {Op::logical_and},          {Op::less_equal, Op::less, Op::equal},
    {Op::add, Op::subtract}, {Op::multiply, Op::divide},
};

class Reader {
public:
    explicit Reader(Graph& graph) : graph_(&graph) {}

    /// The formula of the last line.
    Expr read(const std::string& text) {
        std::istringstream lines(text);
        Expr last;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t equals = line.find(" = ");
            rest_ = std::string_view(line).substr(equals + 3);
            last = binary(0);
            EXPECT_TRUE(rest_.empty()) << line;
            named_[line.substr(0, equals)] = last;
        }
        return last;
    }

private:
    bool take(std::string_view token) {
        while (rest_.starts_with(' ')) {
            rest_.remove_prefix(1);
        }
        if (!rest_.starts_with(token)) {
            return false;
        }
        rest_.remove_prefix(token.size());
        return true;
    }

    Expr binary(std::size_t level) {
        if (level == levels.size()) {
            return prefix();
        }
        Expr left = binary(level + 1);
        for (bool found = true; found;) {
            found = false;
            for (const Op op : levels[level]) {
                if (take(operation(op).infix)) {
                    left = graph_->apply(op, std::array{left, binary(level + 1)});
                    found = true;
                    break;
                }
            }
        }
        return left;
    }

    Expr prefix() {
        if (take("-")) {
            return -prefix();
        }
        if (take("!")) {
            return !prefix();
        }
        if (take("(")) {
            const Expr inner = binary(0);
            EXPECT_TRUE(take(")"));
            return inner;
        }
        return word();
    }

    Expr word() {
        (void)take(" ");
        std::size_t length = 0;
        while (length < rest_.size() &&
               (std::isalnum(static_cast<unsigned char>(rest_[length])) != 0 ||
                rest_[length] == '_' || rest_[length] == '.' ||
                (length > 0 && rest_[length - 1] == 'e' && std::isdigit(rest_[0]) != 0))) {
            ++length;
        }
        const std::string text(rest_.substr(0, length));
        rest_.remove_prefix(length);
        if (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0) {
            return graph_->constant(std::stod(text));
        }
        if (const auto known = named_.find(text); known != named_.end()) {
            return result_of(known->second);
        }
        if (std::find(formula_inputs.begin(), formula_inputs.end(), text) != formula_inputs.end()) {
            return graph_->input(text);
        }
        if (text == formula_native()->name()) {
            return result_of(native_call());
        }
        return text == "nan"   ? graph_->constant(std::nan(""))
               : text == "inf" ? graph_->constant(HUGE_VAL)
                               : call(text);
    }

    // A call, of whose results one may be named behind it.
    Expr result_of(Expr call) {
        if (!take("[")) {
            return call;
        }
        const std::size_t number = take("1") ? 1 : 0;
        EXPECT_TRUE(number == 1 || take("0"));
        EXPECT_TRUE(take("]"));
        return graph_->call(formula_native(),
                            std::array{call.argument(0), call.argument(1)})[number];
    }

    Expr native_call() {
        EXPECT_TRUE(take("("));
        const Expr a = binary(0);
        EXPECT_TRUE(take(","));
        const Expr b = binary(0);
        EXPECT_TRUE(take(")"));
        return graph_->call(formula_native(), std::array{a, b})[0].argument(0);
    }

    Expr call(const std::string& name) {
        for (const Operation& row : operations()) {
            if (row.name == name && row.scalar != nullptr) {
                std::vector<Expr> arguments;
                EXPECT_TRUE(take("("));
                for (int i = 0; i < row.arity; ++i) {
                    EXPECT_TRUE(i == 0 || take(","));
                    arguments.push_back(binary(0));
                }
                EXPECT_TRUE(take(")"));
                return graph_->apply(row.op, arguments);
            }
        }
        ADD_FAILURE() << "unknown word '" << name << "'";
        return graph_->constant(0.0);
    }

    Graph* graph_;
    std::string_view rest_;
    std::map<std::string, Expr> named_;
};

std::string printed(Expr e) {
    const std::string text = print(e);
    return text.substr(text.rfind("f = ") + 4, text.size() - text.rfind("f = ") - 5);
}

}  // namespace

TEST(Print, RandomFormulasReadBackAsWhatTheyAre) {
    std::mt19937_64 random(61);
    std::uniform_real_distribution<double> range(-3.0, 3.0);
    std::size_t compared = 0;
    for (int i = 0; i < 3000; ++i) {
        Graph graph;
        const Expr formula =
            build(graph, random_formula(random, 2 + static_cast<std::size_t>(i) % 30));
        Graph other;
        const Expr read = Reader(other).read(print(formula));
        ASSERT_FALSE(HasFailure()) << print(formula);
        const Point point{range(random), range(random), range(random), {}, further_input_values};
        const Bounded wanted = evaluate_bounded(formula, point);
        const Bounded found = evaluate_bounded(read, point);
        if (wanted.error < 1e-6 && found.error < 1e-6) {
            ++compared;
            // a + (b + c) is printed as a sum of three, which groups otherwise.
            EXPECT_NEAR(found.value, wanted.value, 2.0 * (wanted.error + found.error))
                << print(formula);
        }
    }
    EXPECT_GT(compared, 1500U);
}

TEST(Print, WritesOnlyParenthesesThatAreNeeded) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    EXPECT_EQ(printed((x + y) * x), "x * (x + y)");
    EXPECT_EQ(printed(x - (y - 1.0 / x)), "x - (y - 1 / x)");
    EXPECT_EQ(printed(x / (y / x)), "x / (y / x)");
    EXPECT_EQ(printed(-(x * y)), "-(x * y)");
    EXPECT_EQ(printed((x < y || y < x) && x < 1.0), "(x < y || y < x) && x < 1");
    EXPECT_EQ(printed(!(x < y)), "!(x < y)");
    EXPECT_EQ(printed(select(x < y, sin(x + y), -2.0 * x)), "select(x < y, sin(x + y), x * -2)");
}

TEST(Print, NamesWhatIsSharedFirst) {
    Graph graph;
    const Expr shared = sin(graph.picture_x());
    const std::array roots{shared, shared * graph.time()};
    const std::array names{std::string("a"), std::string("b")};
    EXPECT_EQ(print(roots, names), "s1 = sin(x)\na = s1\nb = s1 * t\n");
}

TEST(Print, NamesStepsAndWhatTheyAreMadeOf) {
    Graph graph;
    const Expr u = 2.0 * graph.picture_x() + 1.0;
    const Expr sine = sin(u);
    const Expr eye = sine * sine + sine;
    const Expr left = eye * graph.time() + u;
    const std::array steps{NamedStep{"map", {u}, {"u"}}, NamedStep{"eye", {eye}, {"x"}},
                           NamedStep{"look", {cos(u)}, {"x"}}};
    const std::array roots{left * left, u};
    const std::array names{std::string("a"), std::string("u")};
    // What no expression needs is not written, and the name of an expression goes first.
    EXPECT_EQ(print(roots, names, steps),
              "u = x * 2 + 1\n"
              "eye_1 = sin(u)\n"
              "eye_x = eye_1 + eye_1 * eye_1\n"
              "s1 = u + eye_x * t\n"
              "a = s1 * s1\n");
}

}  // namespace balcony::expr::print_test
