// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The arguments of stages, by rows of the test's own: what each type of parameter takes and what it
// says of the rest.

#include <gtest/gtest.h>

#include <numbers>

#include "../files/temporary_folder.hpp"
#include "lang/build/stages.hpp"
#include "support.hpp"

namespace balcony::lang::arguments_test {
namespace {

using camera::Arguments;
using camera::ChoiceParameter;
using camera::CountParameter;
using camera::FormulaParameter;
using camera::ImageParameter;
using camera::MeshParameter;
using camera::NestedStageParameter;
using camera::NumberParameter;
using camera::PairParameter;
using camera::PointsParameter;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;
using camera::TripleParameter;
using camera::Unit;

struct Read {
    std::optional<Arguments> arguments;
    Diagnostics said;

    [[nodiscard]] std::string message() const { return said.empty() ? "" : said.front().message; }
    [[nodiscard]] std::string remedy() const { return said.empty() ? "" : said.front().remedy; }
};

/// Reads a call, such as stage(1, 2), by the parameters of a row. `a` is 2.
Read read(std::vector<StageParameter> parameters, const std::string& call,
          const std::string& statement = "eye", const std::filesystem::path& folder = {}) {
    const StageEntry row{.name = "stage", .parameters = std::move(parameters)};
    const camera::Catalogue catalogue;
    Files files(catalogue);
    Session session(files);
    const Module* module = session.load(
        std::make_shared<const SourceText>(
            "test.cam", test::joined({"let a = 2 camera c { ", statement, " ", call, " }"})),
        folder);
    const DefinitionSyntax& syntax = *own_definitions(*module).front().camera;
    if (syntax.statements.empty() || syntax.statements.front().stages().empty()) {
        return {std::nullopt, session.reporter().take()};
    }
    StageBuilder stages(*module, *module->scope, session);
    const ExpressionId id = syntax.statements.front().stages().front();
    std::optional<Arguments> made = stages.arguments(row, module->tree[id]);
    return {std::move(made), session.reporter().take()};
}

/// The message of a call that is an error, with the remedy.
std::string refused(const std::vector<StageParameter>& parameters, const std::string& call) {
    const Read made = read(parameters, call);
    EXPECT_FALSE(made.arguments) << call;
    EXPECT_EQ(made.said.size(), 1U) << to_text(made.said);
    return made.remedy().empty() ? made.message() : made.message() + "; " + made.remedy();
}

std::vector<StageParameter> count() {
    return {{.name = "n",
             .type = CountParameter{.range = {.minimum = 1, .maximum = 20}},
             .meaning = "its use"}};
}

TEST(StageArguments, ACountIsAWholeConstantNumber) {
    EXPECT_EQ(read(count(), "stage(3)").arguments->count("n"), 3U);
    EXPECT_EQ(read(count(), "stage(n = 4*a)").arguments->count("n"), 8U);
    EXPECT_EQ(refused(count(), "stage(2.5)"),
              "'n' of 'stage' must be a whole number, but is 2.5; write 2 or 3");
    EXPECT_EQ(refused(count(), "stage(0)"),
              "'n' of 'stage' must be from 1 to 20, but is 0; n: its use");
    EXPECT_EQ(refused(count(), "stage(1e30)"),
              "'n' of 'stage' must be from 1 to 20, but is 1e+30; n: its use");
    EXPECT_EQ(refused(count(), "stage(1 + t)"),
              "'n' of 'stage' cannot change with time; it determines the structure of the "
              "stage, which is the same for all times");
}

TEST(StageArguments, AConstantParameterTakesNoTime) {
    std::vector<StageParameter> row{
        {.name = "width", .type = PairParameter{}, .meaning = "its use"}};
    EXPECT_TRUE(read(row, "stage((1, t))").arguments);
    row.front().type = PairParameter{.constant = true};
    EXPECT_TRUE(read(row, "stage((1, a))").arguments);
    EXPECT_TRUE(refused(row, "stage((1, t))").starts_with("'width' of 'stage' cannot change"));
}

TEST(StageArguments, AnOptionalParameterMayBeMissing) {
    std::vector<StageParameter> row{{.name = "r", .type = NumberParameter{}, .meaning = "its use"}};
    EXPECT_FALSE(read(row, "stage").arguments);
    row.front().optional = true;
    ASSERT_TRUE(read(row, "stage").arguments);
    EXPECT_FALSE(read(row, "stage").arguments->has("r"));
    EXPECT_TRUE(read(row, "stage(1)").arguments->has("r"));
    row.front().type = NumberParameter{.default_value = 3.0};
    EXPECT_EQ(read(row, "stage").arguments->number("r").constant(), 3.0);
}

TEST(StageArguments, RangesHaveTheirEndsAndUnits) {
    const std::vector<StageParameter> angle{
        {.name = "fov",
         .type = NumberParameter{.unit = Unit::angle,
                                 .range = {.minimum = 0.0, .maximum = std::numbers::pi / 2}},
         .meaning = "its use"}};
    EXPECT_TRUE(read(angle, "stage(0deg)").arguments);
    EXPECT_TRUE(read(angle, "stage(90deg)").arguments);
    EXPECT_EQ(refused(angle, "stage(100deg)"),
              "'fov' of 'stage' must be from 0deg to 90deg, but is 100deg; fov: its use");
    const std::vector<StageParameter> above{
        {.name = "r",
         .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
         .meaning = "its use"}};
    EXPECT_TRUE(read(above, "stage(1/1000)").arguments);
    EXPECT_EQ(refused(above, "stage(0)"), "'r' of 'stage' must be above 0, but is 0; r: its use");
}

TEST(StageArguments, OneNumberMayBeForBoth) {
    const std::vector<StageParameter> row{
        {.name = "size",
         .type = PairParameter{.default_value = std::array{3.0, 4.0}, .one_for_both = true},
         .meaning = "its use"}};
    EXPECT_EQ(read(row, "stage").arguments->pair("size")[1].constant(), 4.0);
    EXPECT_EQ(read(row, "stage(a)").arguments->pair("size")[1].constant(), 2.0);
    EXPECT_EQ(read(row, "stage((1, a))").arguments->pair("size")[1].constant(), 2.0);
    EXPECT_EQ(refused(row, "stage((1, 2, 3))"),
              "'size' of 'stage' takes two numbers (a, b) or one number for both, but there are 3; "
              "for example size = (3, 4)");
}

std::vector<StageParameter> points(std::vector<std::size_t> coordinates, Unit unit = Unit::number) {
    return {
        {.name = "at",
         .type =
             PointsParameter{.unit = unit, .coordinates = std::move(coordinates), .min_points = 2},
         .meaning = "its use"}};
}

TEST(StageArguments, ValuesThatChangeWithTimeAreClamped) {
    const std::vector<StageParameter> row{
        {.name = "strength",
         .type = NumberParameter{.range = {.minimum = 0.0, .maximum = 0.99}},
         .meaning = "below 1"},
        {.name = "radius",
         .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
         .meaning = "above 0"},
        {.name = "height", .type = NumberParameter{}, .meaning = "any"}};
    const Read made = read(row, "stage(t, 1 + t, 2*t)");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    const auto at = [&](std::string_view name, double time) {
        expr::Graph graph;
        const std::array root{made.arguments->number(name).emit(graph)};
        return expr::evaluate(root, {0.0, 0.0, time, {}}).front();
    };
    EXPECT_EQ(at("strength", 0.5), 0.5);
    EXPECT_EQ(at("strength", 3.0), 0.99);
    EXPECT_EQ(at("strength", -3.0), 0.0);
    EXPECT_EQ(at("radius", 3.0), 4.0);
    EXPECT_EQ(at("radius", -3.0), 0.0);
    EXPECT_EQ(at("height", -3.0), -6.0);
}

TEST(StageArguments, PointsAreAList) {
    const Read pairs = read(points({2, 3}), "stage([(0, 1), (a, -a)])");
    ASSERT_TRUE(pairs.arguments) << to_text(pairs.said);
    const camera::PointList& list = pairs.arguments->points("at");
    EXPECT_EQ(list.coordinates, 2U);
    EXPECT_EQ(list.values, (std::vector<double>{0, 1, 2, -2}));
    EXPECT_EQ(list.size(), 2U);
    EXPECT_EQ(list[1][1], -2.0);
    const Read triples = read(points({2, 3}), "stage(at = [(0, 1, 2), (3, 4, 5)])");
    EXPECT_EQ(triples.arguments->points("at").coordinates, 3U);
    const Read numbers = read(points({1}), "stage([0, 1/2, 1])");
    EXPECT_EQ(numbers.arguments->points("at").values, (std::vector<double>{0, 0.5, 1}));
    const Read angles = read(points({1}, Unit::angle), "stage([0, 180deg])");
    EXPECT_EQ(angles.arguments->points("at").values[1], std::numbers::pi);
    EXPECT_TRUE(read(points({2}, Unit::either), "stage([(1, 30deg), (2, 0)])").arguments);
}

TEST(StageArguments, WrongPointsAreErrors) {
    EXPECT_EQ(refused(points({2}), "stage(3)"),
              "'at' of 'stage' takes a list of points; write it in brackets, for example "
              "[(0, 0), (1, 1)], or name a table, such as \"table.csv\"");
    EXPECT_EQ(refused(points({1}), "stage((1, 2))"),
              "'at' of 'stage' takes a list of numbers; write it in brackets, for example [0, 1], "
              "or name a table, such as \"table.csv\"");
    EXPECT_EQ(refused(points({2}), "stage([])"),
              "'at' of 'stage' needs at least 2 points, but has 0; at: its use; add 2 more");
    EXPECT_EQ(
        refused(points({2, 3}), "stage([(1, 2), 3])"),
        "a point of 'at' of 'stage' has 2 or 3 numbers, but this has 1; for example at = [(0, "
        "0), (1, 1)]");
    EXPECT_EQ(refused(points({1}), "stage([(1, 2), 3])"),
              "a point of 'at' of 'stage' has 1 number, but this has 2; for example at = [0, 1]");
    std::vector<StageParameter> triangle = points({1, 2, 3});
    triangle.front().type = PointsParameter{.coordinates = {1, 2, 3}, .min_points = 3};
    EXPECT_EQ(refused(triangle, "stage([(1, 2, 3, 4), 0, 0])"),
              "a point of 'at' of 'stage' has 1, 2 or 3 numbers, but this has 4; for example "
              "at = [0, 1, 2]");
    EXPECT_EQ(refused(points({2, 3}), "stage([(1, 2), (1, 2, 3)])"),
              "this point has 3 numbers, but the first has 2; give all points 2 numbers");
    EXPECT_EQ(refused(points({1}), "stage([1deg, 0])"),
              "'at' of 'stage' must be a plain number, but this is an angle; remove deg or rad, or "
              "divide the angle by 1rad");
    EXPECT_TRUE(refused(points({1}), "stage([1, t])").starts_with("'at' of 'stage' cannot change"));
    EXPECT_TRUE(refused(points({1}), "stage([1, [2]])")
                    .starts_with("a list contains numbers or points, but this is a list; "));
    EXPECT_TRUE(refused(points({1}), "stage([1, 1/0])").starts_with("division by 0; "));
}

TEST(StageArguments, TooManyPointsAreOneError) {
    std::string list = "0";
    for (int i = 0; i < 65536; ++i) {
        list += ",0";
    }
    EXPECT_EQ(
        refused(points({1}), "stage([" + list + "])"),
        "'at' of 'stage' needs at most 65536 numbers, but has 65537; keep one number out of 2");
    EXPECT_TRUE(read(points({1}), "stage([" + list.substr(2) + "])").arguments);
}

TEST(StageArguments, PointsMayComeFromATable) {
    const files::TemporaryFolder folder;
    folder.write("points.csv", "x,y\n0,1\n2,30deg\n");
    folder.write("numbers.csv", "0,0,0.5\n1,1\n");
    const Read pairs =
        read(points({2}, Unit::either), "stage(\"points.csv\")", "eye", folder.path());
    ASSERT_TRUE(pairs.arguments) << to_text(pairs.said);
    EXPECT_EQ(pairs.arguments->points("at").values,
              (std::vector<double>{0, 1, 2, std::numbers::pi / 6}));
    const Read knots = read(points({1}), "stage(at = \"numbers.csv\")", "eye", folder.path());
    EXPECT_EQ(knots.arguments->points("at").values, (std::vector<double>{0, 0, 0.5, 1, 1}));
    // What is wrong in the table is said of the table, with the place that names it.
    const Read angle = read(points({2}), "stage(\"points.csv\")", "eye", folder.path());
    ASSERT_EQ(angle.said.size(), 1U) << to_text(angle.said);
    EXPECT_EQ(angle.message(), "'at' of 'stage' must be a plain number, but this is an angle");
    EXPECT_EQ(to_text(angle.said).rfind((folder.path() / "points.csv").string() + ":3:3", 0), 0U);
    ASSERT_EQ(angle.said[0].notes.size(), 1U);
    EXPECT_EQ(angle.said[0].notes[0].span.source->name(), "test.cam");
    folder.write("short.csv", "0,1\n");
    EXPECT_EQ(read(points({2}), "stage(\"short.csv\")", "eye", folder.path()).message(),
              "'at' of 'stage' needs at least 2 points, but has 1");
    EXPECT_EQ(read(points({3}), "stage(\"points.csv\")", "eye", folder.path()).message(),
              "a point of 'at' of 'stage' has 3 numbers, but this has 2");
}

TEST(StageArguments, ImagesAndMeshesAreFiles) {
    const std::vector<StageParameter> row{
        {.name = "file", .type = MeshParameter{}, .meaning = "its use"}};
    const Read vase = read(row, "stage(\"vase.obj\")");
    ASSERT_TRUE(vase.arguments) << to_text(vase.said);
    EXPECT_GT(vase.arguments->file<camera::TexturedMesh>("file")->triangles.size(), 1000U);
    EXPECT_EQ(refused(row, "stage(vase)"),
              "'file' of 'stage' takes a mesh; write a file name in quotation marks, for example "
              "\"vase.obj\"");
    EXPECT_EQ(refused(row, "stage(\"vaze.obj\")"),
              "there is no file and no built-in file named 'vaze.obj'; did you mean "
              "'vase.obj'?");
    const std::vector<StageParameter> mask{
        {.name = "mask", .type = ImageParameter{}, .meaning = "its use"}};
    EXPECT_TRUE(refused(mask, "stage(\"vase.obj\")")
                    .starts_with("'standard/vase.obj' cannot be read as an image: "));
}

TEST(StageArguments, OfOneFileAreReadOnce) {
    const std::vector<StageParameter> row{
        {.name = "one", .type = MeshParameter{}, .meaning = "its use"},
        {.name = "other", .type = MeshParameter{}, .meaning = "its use"}};
    const Read made = read(row, "stage(\"vase.obj\", \"vase.obj\")");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    EXPECT_EQ(made.arguments->file<camera::TexturedMesh>("one"),
              made.arguments->file<camera::TexturedMesh>("other"));
}

TEST(StageArguments, AStageTakesAStageOfItsKind) {
    const std::vector<StageParameter> row{
        {.name = "inner",
         .type = NestedStageParameter{.kind = StageKind::parameter_transformer},
         .meaning = "its use"}};
    const Read made = read(row, "stage(rotate(10deg))");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    EXPECT_NE(made.arguments->stage<camera::ParameterTransformer>("inner"), nullptr);
    EXPECT_EQ(refused(row, "stage(sphere(1))"),
              "'sphere' is an object generator, but a parameter transformer is needed here; "
              "object generators belong to 'eye', 'toward' and 'object'");
    EXPECT_TRUE(refused(row, "stage(3)")
                    .starts_with("'inner' of 'stage' takes a parameter transformer, but this is a "
                                 "number; write a parameter "
                                 "transformer, for example "));
    EXPECT_EQ(refused(row, "stage"),
              "'stage' needs its argument 'inner' (its use); the syntax is stage(inner)");
}

TEST(StageArguments, StagesTakeAllThatIsLeft) {
    const std::vector<StageParameter> row{
        {.name = "n", .type = CountParameter{.range = {.minimum = 0.0}}, .meaning = "its use"},
        {.name = "stages",
         .type = NestedStageParameter{.kind = StageKind::object_transformer, .several = true},
         .meaning = "its use"}};
    const auto made = [&row](const std::string& call) {
        const Read read_call = read(row, call);
        EXPECT_TRUE(read_call.arguments) << to_text(read_call.said);
        return read_call.arguments->stages<camera::ObjectTransformer>("stages").size();
    };
    EXPECT_EQ(made("stage(3, scale(2), mirror(x), translate(1, 2, 3))"), 3U);
    EXPECT_EQ(made("stage(3, scale(2))"), 1U);
    EXPECT_EQ(made("stage(n = 3, stages = scale(2))"), 1U);
    EXPECT_TRUE(refused(row, "stage(3, stages = scale(2), stages = mirror(x))")
                    .starts_with("'stages' is given twice; "));
    EXPECT_EQ(refused(row, "stage(3)"),
              "'stage' needs its argument 'stages' (its use); the syntax is stage(n, stages, ...)");
    EXPECT_EQ(refused(row, "stage(3, scale(2), 1)"),
              "'stages' of 'stage' takes an object transformer, but this is a number; write an "
              "object transformer, for example translate(x, y, z)");
}

/// (a, b, c) to a + 10 b + 100 c and a.
class Digits final : public expr::Native {
public:
    std::string_view name() const override { return "digits"; }
    std::size_t argument_count() const override { return 3; }
    std::size_t result_count() const override { return 2; }
    void evaluate(std::size_t count, const double* const* a,
                  double* const* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            results[0][i] = a[0][i] + 10.0 * a[1][i] + 100.0 * a[2][i];
            results[1][i] = a[0][i];
        }
    }
    expr::Expr derivative(std::size_t, std::size_t, std::span<const expr::Expr>,
                          std::span<const expr::Expr>) const override {
        return {};
    }
};

TEST(StageArguments, AFormulaCallsTheFunctionsThatItsStageOffers) {
    const auto digits = std::make_shared<const Digits>();
    const std::vector<StageParameter> row{
        {.name = "weight",
         .type =
             FormulaParameter{.shape = {2, 1, 1, {{"digits", digits, 0}, {"first", digits, 1}}}},
         .meaning = "its use"},
        {.name = "other", .type = FormulaParameter{.shape = {1, 1, 1}}, .meaning = "its use"}};
    const Read made =
        read(row, "stage(weight(p, q) = [digits(p, 2*q, a) - first(q, 1, 1)], other(u) = [u])");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    expr::Graph graph;
    const std::array at{graph.picture_x(), graph.picture_y()};
    const auto results = made.arguments->formula("weight").emit(graph, at);
    EXPECT_EQ(expr::evaluate(results, {.x = 3.0, .y = 4.0})[0], 3.0 + 80.0 + 200.0 - 4.0);

    const std::string other = ", other(u) = [u])";
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [digits(u, v)]" + other),
              "'digits' takes 3 arguments, but 2 are given; the syntax is digits(a, b, c)");
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [first(u, v, 30deg)]" + other),
              "'first' takes plain numbers, but this is an angle; divide an angle by 1rad or 1deg "
              "for a plain number");
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [digit(u, v, 1)]" + other),
              "unknown function 'digit'; did you mean 'digits'?");
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [digits + u]" + other),
              "'digits' is a function; add its arguments: digits( ... )");
    EXPECT_TRUE(refused(row, "stage(weight(u, v) = [1], other(u) = [digits(u, u, u)])")
                    .starts_with("unknown function 'digits'; "))
        << "another formula of the stage is not offered it";
}

TEST(StageArguments, AFormulaHasTheNameOfItsParameter) {
    const std::vector<StageParameter> row{
        {.name = "r", .type = NumberParameter{.default_value = 1.0}, .meaning = "its use"},
        {.name = "weight", .type = FormulaParameter{.shape = {2, 1, 1}}, .meaning = "its use"},
        {.name = "s", .type = NumberParameter{.default_value = 1.0}, .meaning = "its use"}};
    const Read made = read(row, "stage(3, weight(p, q) = [p/a + q + t], 4)");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    EXPECT_EQ(made.arguments->number("s").constant(), 4.0);
    expr::Graph graph;
    const std::array at{graph.constant(1.0), graph.constant(10.0)};
    const auto results = made.arguments->formula("weight").emit(graph, at);
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(expr::evaluate(results, {0, 0, 5, {}})[0], 15.5);

    EXPECT_TRUE(read(row, "stage(s = 4, weight(u, v) = [1])").arguments);
    EXPECT_EQ(refused(row, "stage(weight(u) = [u])"),
              "the formula 'weight' has 2 parameters, but this one has 1; the syntax is "
              "weight(u, v) = [a]");
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [u, v])"),
              "the formula 'weight' has 1 result, but this one has 2; the syntax is "
              "weight(u, v) = [a]");
    EXPECT_EQ(
        refused(row, "stage(weight(u, v) = [30deg])"),
        "'weight' of 'stage' must be a plain number, but this is an angle; remove deg or rad, "
        "or divide the angle by 1rad");
    EXPECT_EQ(refused(row, "stage(wieght(u, v) = [u])"),
              "'stage' has no argument 'wieght'; did you mean 'weight'?");
    EXPECT_EQ(refused(row, "stage(weight(pi, v) = [v])"),
              "'pi' is reserved: it is the number 3.14159...; choose another name, for example u");
    EXPECT_EQ(refused(row, "stage(weight = 0.5)"),
              "'weight' of 'stage' takes a formula; the syntax is weight(u, v) = [a]");
    EXPECT_EQ(refused(row, "stage(weight(u, v) = [u], weight(u, v) = [v])"),
              "'weight' is given twice; remove one; positional arguments have the order of "
              "stage(r, weight(u, v) = [a], s)");
    EXPECT_EQ(refused(row, "stage(1, 2, 3)"),
              "'stage' takes 2 arguments, but 3 are given; the syntax is "
              "stage(r, weight(u, v) = [a], s)");
}

// A formula with the name of a stage is this stage, for any formulas of the row.
TEST(StageArguments, AFormulaMayBeAStageBesideFormulas) {
    const std::vector<StageParameter> row{
        {.name = "inner",
         .type = NestedStageParameter{.kind = StageKind::object_generator},
         .meaning = "its use"},
        {.name = "weight", .type = FormulaParameter{.shape = {1, 1, 1}}, .meaning = "its use"}};
    const Read made = read(row, "stage(weight(u) = [u], surface(u, v) = [u, v, 0])");
    ASSERT_TRUE(made.arguments) << to_text(made.said);
    EXPECT_EQ(made.arguments->stage<camera::ObjectGenerator>("inner")->dimension(), 2U);
}

TEST(StageArguments, WordsBehindARuleAreItsChoices) {
    const std::vector<StageParameter> row{{.name = "side",
                                           .type = ChoiceParameter{.choices = {"front", "back"}},
                                           .meaning = "its use"},
                                          {.name = "length",
                                           .type = ChoiceParameter{.choices = {"one", "own"}},
                                           .meaning = "its use"}};
    const auto choices = [&row](const std::string& call) {
        const Read made = read(row, call, "look");
        return made.arguments
                   ? made.arguments->choice("side") + " " + made.arguments->choice("length")
                   : to_text(made.said);
    };
    EXPECT_EQ(choices("stage"), "front one");
    EXPECT_EQ(choices("stage back"), "back one");
    EXPECT_EQ(choices("stage own"), "front own");
    EXPECT_EQ(choices("stage own back"), "back own");
    EXPECT_EQ(choices("stage back warp rotate(10deg)"), "back one");
    EXPECT_EQ(read(row, "stage bakc", "look").message(), "'stage' cannot be 'bakc'");
    EXPECT_EQ(read(row, "stage bakc", "look").remedy(), "did you mean 'back'?");
    EXPECT_EQ(read(row, "stage back front", "look").message(), "'side' is given twice");
    EXPECT_EQ(read({}, "stage back", "look").message(), "'stage' cannot be 'back'");
}

}  // namespace
}  // namespace balcony::lang::arguments_test
