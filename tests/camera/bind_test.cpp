// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Stages made by a C++ program: what is checked, and which value each error is about.

#include <limits>
#include <numbers>

#include "balcony/make_stage.hpp"
#include "support.hpp"

namespace balcony::camera::bind_test {
namespace {

using Kind = ArgumentError::Kind;

const StageEntry& row() {
    static const StageEntry made{
        .name = "stage",
        .parameters = {
            {.name = "radius",
             .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
             .meaning = "how large"},
            {.name = "angle",
             .type = NumberParameter{.unit = Unit::angle, .default_value = 0.5},
             .meaning = "how far"},
            {.name = "n",
             .type =
                 CountParameter{.default_value = 2.0, .range = {.minimum = 1.0, .maximum = 9.0}},
             .meaning = "how many"},
            {.name = "size",
             .type = PairParameter{.default_value = std::array{1.0, 2.0}, .one_for_both = true},
             .meaning = "how wide"},
            {.name = "axis",
             .type = TripleParameter{.default_value = std::array{0.0, 0.0, 1.0},
                                     .range = {.minimum = -1.0},
                                     .names_axes = true},
             .meaning = "where to"},
            {.name = "by", .type = ChoiceParameter{.choices = {"one", "two"}}, .meaning = "how"},
            {.name = "points",
             .type = PointsParameter{.coordinates = {2, 3}, .min_points = 2},
             .optional = true,
             .meaning = "the corners"},
            {.name = "curve",
             .type = NestedStageParameter{.kind = StageKind::object_generator, .dimension = 1},
             .optional = true,
             .meaning = "the path"},
            {.name = "weight",
             .type = FormulaParameter{.shape = {2, 1, 1}},
             .optional = true,
             .meaning = "weight(u, v) = [w]"}}};
    return made;
}

Binding bound(std::initializer_list<NamedValue> values) {
    return bind(row(), std::span(values.begin(), values.size()));
}

/// The only error.
ArgumentError found(std::initializer_list<NamedValue> values) {
    const Binding made = bound(values);
    EXPECT_FALSE(made.arguments);
    EXPECT_EQ(made.errors.size(), 1U);
    return made.errors.empty() ? ArgumentError{Kind::missing, {}} : made.errors.front();
}

TEST(Bind, GivesValuesAndDefaults) {
    const Binding made = bound({{"radius", 3.0}, {"size", {4.0, 5.0}}, {"by", "two"}});
    ASSERT_TRUE(made.arguments);
    EXPECT_EQ(made.arguments->number("radius").constant(), 3.0);
    EXPECT_EQ(made.arguments->number("angle").constant(), 0.5);
    EXPECT_EQ(made.arguments->count("n"), 2U);
    EXPECT_EQ(made.arguments->pair("size")[1].constant(), 5.0);
    EXPECT_EQ(made.arguments->triple("axis")[2].constant(), 1.0);
    EXPECT_EQ(made.arguments->choice("by"), "two");
    EXPECT_FALSE(made.arguments->has("points"));
}

TEST(Bind, OneNumberMayBeForBothAndAWordAnAxis) {
    const Binding made = bound({{"radius", 1.0}, {"size", 4.0}, {"axis", "-x"}});
    ASSERT_TRUE(made.arguments);
    EXPECT_EQ(made.arguments->pair("size")[1].constant(), 4.0);
    EXPECT_EQ(made.arguments->triple("axis")[0].constant(), -1.0);
}

TEST(Bind, AFindingTellsWhichValueItIsAbout) {
    const ArgumentError unknown = found({{"radius", 1.0}, {"radios", 2.0}});
    EXPECT_EQ(unknown.kind, Kind::unknown_name);
    EXPECT_EQ(unknown.value, 1U);
    EXPECT_EQ(unknown.diagnostic.message, "'stage' has no argument 'radios'");
    EXPECT_EQ(unknown.diagnostic.remedy, "did you mean 'radius'?");

    const ArgumentError twice = found({{"radius", 1.0}, {"n", 2.0}, {"radius", 2.0}});
    EXPECT_EQ(twice.kind, Kind::given_twice);
    EXPECT_EQ(twice.value, 2U);
    EXPECT_EQ(twice.earlier, 0U);

    const ArgumentError missing = found({{"n", 2.0}});
    EXPECT_EQ(missing.kind, Kind::missing);
    EXPECT_EQ(missing.value, std::nullopt);
    EXPECT_EQ(missing.diagnostic.message, "'stage' needs its argument 'radius' (how large)");

    const ArgumentError axis = found({{"radius", 1.0}, {"axis", {0.0, -2.0, 0.0}}});
    EXPECT_EQ(axis.kind, Kind::out_of_range);
    EXPECT_EQ(axis.element, std::vector<std::size_t>{1});

    const ArgumentError point =
        found({{"radius", 1.0}, {"points", Points{{0.0, 0.0}, {degrees(1), 1.0}}}});
    EXPECT_EQ(point.kind, Kind::angle_for_number);
    EXPECT_EQ(point.element, (std::vector<std::size_t>{1, 0}));
}

TEST(Bind, ChecksRangesFormsAndUnits) {
    EXPECT_EQ(found({{"radius", 0.0}}).diagnostic.message,
              "'radius' of 'stage' must be above 0, but is 0");
    EXPECT_EQ(found({{"radius", 1.0}, {"n", 2.5}}).diagnostic.remedy, "write 2 or 3");
    EXPECT_EQ(found({{"radius", 1.0}, {"n", 10.0}}).diagnostic.message,
              "'n' of 'stage' must be from 1 to 9, but is 10");
    EXPECT_EQ(found({{"radius", degrees(30)}}).kind, Kind::angle_for_number);
    EXPECT_EQ(found({{"radius", 1.0}, {"angle", 30.0}}).kind, Kind::number_for_angle);
    EXPECT_EQ(found({{"radius", 1.0}, {"by", "three"}}).diagnostic.message,
              "'by' of 'stage' cannot be 'three'");
    EXPECT_EQ(found({{"radius", 1.0}, {"by", 3.0}}).diagnostic.message,
              "'by' of 'stage' takes a name");
    EXPECT_EQ(found({{"radius", "large"}}).diagnostic.message,
              "'radius' of 'stage' takes a number, but this is a word");
    EXPECT_EQ(found({{"radius", 1.0}, {"axis", "w"}}).diagnostic.message,
              "'axis' of 'stage' takes three numbers (a, b, c) or x, y or z, but this is a word");
    EXPECT_EQ(found({{"radius", 1.0}, {"points", Points{{0.0, 0.0}}}}).diagnostic.message,
              "'points' of 'stage' needs at least 2 points, but has 1");
    EXPECT_EQ(found({{"radius", 1.0}, {"points", Points{{0.0, 0.0}, {1.0}}}}).kind,
              Kind::wrong_coordinates);
    EXPECT_EQ(
        bound({{"radius", 1.0}, {"angle", degrees(180)}}).arguments->number("angle").constant(),
        std::numbers::pi);
    EXPECT_TRUE(bound({{"radius", 1.0}, {"angle", 0.0}}).arguments) << "0 has every unit";
}

TEST(Bind, RefusesWhatIsNotFinite) {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(found({{"radius", value}}).diagnostic.message,
                  "'radius' of 'stage' is not finite");
        EXPECT_EQ(found({{"radius", 1.0}, {"points", Points{{0.0, value}, {1.0, 1.0}}}}).element,
                  (std::vector<std::size_t>{0, 1}));
    }
}

TEST(Bind, ChecksNestedStages) {
    EXPECT_TRUE(bound({{"radius", 1.0}, {"curve", object("circle")}}).arguments);
    EXPECT_EQ(found({{"radius", 1.0}, {"curve", object("sphere")}}).diagnostic.message,
              "'curve' of 'stage' takes a curve, but this is a surface");
    EXPECT_EQ(found({{"radius", 1.0}, {"curve", move("scale")}}).diagnostic.message,
              "'curve' of 'stage' takes a curve, but this is a stage of another kind");
    EXPECT_EQ(found({{"radius", 1.0}, {"curve", 1.0}}).diagnostic.message,
              "'curve' of 'stage' takes a curve, but this is a number");
}

Formula sum_of(std::size_t parameters) {
    return formula(parameters, [](Graph&, const std::vector<Expr>& p) {
        Expr sum = p.front();
        for (std::size_t i = 1; i < p.size(); ++i) {
            sum = sum + p[i];
        }
        return std::vector{sum};
    });
}

TEST(Bind, ChecksFormulas) {
    EXPECT_TRUE(bound({{"radius", 1.0}, {"weight", sum_of(2)}}).arguments);
    EXPECT_EQ(found({{"radius", 1.0}, {"weight", sum_of(1)}}).diagnostic.message,
              "the formula 'weight' has 2 parameters, but this one has 1");
    const auto graph = std::make_shared<Graph>();
    const Expr u = graph->fresh_variable();
    const Expr v = graph->fresh_variable();
    const Formula angle(graph, {u, v}, {u + v}, {Unit::angle});
    EXPECT_EQ(found({{"radius", 1.0}, {"weight", angle}}).kind, Kind::angle_for_number);
}

// Time is a formula without parameters.
Scalar time_dependent() {
    auto graph = std::make_shared<Graph>();
    const Expr time = graph->time();
    return Scalar(Formula(graph, {}, {time}));
}

TEST(Bind, HoldsWhatChangesWithTimeInItsRange) {
    const Binding made = bound({{"radius", time_dependent()}});
    ASSERT_TRUE(made.arguments);
    const auto at = [&](double time) {
        Graph graph;
        const std::array root{made.arguments->number("radius").emit(graph)};
        return expr::evaluate(root, {0.0, 0.0, time, {}}).front();
    };
    EXPECT_EQ(at(2.0), 2.0);
    EXPECT_EQ(at(-2.0), 0.0);
    EXPECT_EQ(found({{"radius", 1.0}, {"n", time_dependent()}}).kind, Kind::changes_with_time);
}

TEST(Bind, JudgesNothingThatHasFailed) {
    const Binding made = bound({{"radius", Failed{}}});
    EXPECT_FALSE(made.arguments);
    EXPECT_TRUE(made.errors.empty());
}

TEST(MakeStage, MakesAStageOfItsPort) {
    const auto torus = make_stage<ObjectGenerator>("torus", {{"major", 10.0}, {"minor", 2.0}});
    ASSERT_TRUE(torus) << to_text(torus.diagnostics);
    EXPECT_EQ((*torus)->dimension(), 2);
    const auto turn =
        make_stage<ObjectTransformer>("rotate", {{"axis", "z"}, {"angle", degrees(30)}});
    EXPECT_TRUE(turn) << to_text(turn.diagnostics);
    const auto surface = make_stage(StageKind::object_generator, "sphere");
    EXPECT_TRUE(surface);
}

TEST(MakeStage, MakesAStageOfAFormula) {
    const Formula plane = formula(2, [](Graph& graph, const std::vector<Expr>& p) {
        return std::vector{p[0], p[1], graph.constant(0.0)};
    });
    EXPECT_TRUE(make_stage<ObjectGenerator>("surface", {{"surface", plane}}));
    EXPECT_NE(to_text(make_stage<ObjectGenerator>("surface").diagnostics)
                  .find("'surface' needs a formula"),
              std::string::npos);
}

TEST(MakeStage, ReportsWhatIsWrong) {
    EXPECT_NE(to_text(make_stage<ObjectGenerator>("tours").diagnostics)
                  .find("there is no object generator named 'tours'"),
              std::string::npos);
    EXPECT_NE(to_text(make_stage<ObjectGenerator>("torus", {{"minor", -1.0}}).diagnostics)
                  .find("'minor' of 'torus' must be"),
              std::string::npos);
}

// A maker that makes something else is a program's mistake, and no reason to crash.
TEST(MakeStage, RefusesAMakerOfAnotherKind) {
    Catalogue own;
    ASSERT_TRUE(own.add({.kind = StageKind::object_transformer,
                         .name = "liar",
                         .make = [](const Arguments&) -> Result<std::shared_ptr<const Stage>> {
                             return {object("sphere")};
                         }})
                    .empty());
    EXPECT_EQ(make_stage<ObjectTransformer>("liar", {}, own).diagnostics.front().message,
              "the maker of 'liar' does not return an object transformer");
}

}  // namespace
}  // namespace balcony::camera::bind_test
