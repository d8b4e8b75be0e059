// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

#include "balcony/make_stage.hpp"
#include "support.hpp"

namespace balcony::camera::catalogue_test {

namespace {

class EveryStage : public testing::TestWithParam<StageEntry> {};

std::string test_name(const testing::TestParamInfo<StageEntry>& row) {
    std::string name = std::string(name_of(row.param.kind)) + "_" + std::string(row.param.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

}  // namespace

TEST_P(EveryStage, SaysWhatItAndItsParametersMean) {
    EXPECT_FALSE(GetParam().meaning.empty());
    for (const StageParameter& parameter : GetParam().parameters) {
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
    }
}

// In lines that a terminal and a page show whole: 80 characters, which continuation bytes of UTF-8
// do not add to.
TEST_P(EveryStage, HasItsFormula) {
    std::istringstream formula{std::string(GetParam().formula)};
    std::string line;
    std::size_t lines = 0;
    while (std::getline(formula, line)) {
        const auto length = std::count_if(line.begin(), line.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        });
        EXPECT_LE(length, 80) << line;
        EXPECT_FALSE(line.ends_with(' ')) << line;
        lines += line.empty() ? 0 : 1;
    }
    EXPECT_GT(lines, 0U);
}

TEST_P(EveryStage, DoesNotContradictItself) { EXPECT_EQ(to_text(check(GetParam())), ""); }

TEST_P(EveryStage, IsFoundByItsKindAndName) {
    EXPECT_EQ(catalogue().find(GetParam().kind, GetParam().name)->meaning, GetParam().meaning);
}

TEST_P(EveryStage, CanBeMadeAndFitsItsPort) {
    const auto made = GetParam().make(arguments_for(GetParam(), {}));
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_TRUE(is_of_kind(**made, GetParam().kind));
}

// The dimension is the rank of the derivative: of a point no tangent moves, of a curve that along
// u, of a surface both, in different directions.
TEST_P(EveryStage, HasTheDimensionItStates) {
    if (GetParam().kind != StageKind::object_generator) {
        return;
    }
    const auto made = GetParam().make(arguments_for(GetParam(), {}));
    ASSERT_TRUE(made);
    const auto generator = std::dynamic_pointer_cast<const ObjectGenerator>(*made);
    ASSERT_NE(generator, nullptr);
    EXPECT_EQ(generator->dimension(), GetParam().dimension);
    const Sample s = GeneratorProbe(generator)(0.4, 0.3);
    EXPECT_EQ(length(s.along_u) > 0.0, GetParam().dimension >= 1);
    EXPECT_EQ(length(s.along_v) > 0.0, GetParam().dimension >= 2);
    EXPECT_EQ(length(cross(s.along_u, s.along_v)) > 1e-6, GetParam().dimension == 2);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryStage, testing::ValuesIn(catalogue()), test_name);

TEST(Catalogue, NamesAreUniqueWithinAKind) {
    std::set<std::pair<StageKind, std::string_view>> names;
    for (const StageEntry& row : catalogue()) {
        EXPECT_TRUE(names.emplace(row.kind, row.name).second) << row.name;
    }
    EXPECT_EQ(catalogue().find(StageKind::object_generator, "no such object"), nullptr);
}

TEST(Catalogue, EveryChoiceCanBeMade) {
    for (const StageEntry& row : catalogue()) {
        for (const StageParameter& parameter : row.parameters) {
            for (const std::string_view choice : choices_of(parameter)) {
                const auto made =
                    row.make(arguments_for(row, {{parameter.name, std::string(choice)}}));
                EXPECT_TRUE(made) << row.name << ' ' << choice;
            }
        }
    }
}

StageEntry halo() {
    return {.kind = StageKind::object_generator,
            .name = "halo",
            .meaning = "a row of this test",
            .parameters = {{.name = "radius",
                            .type = NumberParameter{.default_value = 1.0,
                                                    .range = {.minimum = 0.0,
                                                              .excludes_minimum = true}},
                            .meaning = "its radius"}},
            .make = [](const Arguments& a) -> Result<std::shared_ptr<const Stage>> {
                return {object("circle", {{"radius", numbers({*a.number("radius").constant()})}})};
            },
            .dimension = 1};
}

TEST(Catalogue, TakesRowsOfAProgram) {
    Catalogue own;
    const std::size_t built_in = own.size();
    EXPECT_EQ(to_text(own.add(halo())), "");
    EXPECT_EQ(own.size(), built_in + 1);
    EXPECT_EQ(catalogue().size(), built_in) << "a copy must not change the original";
    const auto* row = own.find(StageKind::object_generator, "halo");
    ASSERT_NE(row, nullptr);
    EXPECT_TRUE(std::is_sorted(own.begin(), own.end(),
                               [](const auto& a, const auto& b) { return a.kind < b.kind; }));
    EXPECT_NE(to_text(own.add(halo())).find("there is an object generator 'halo' already"),
              std::string::npos);
    EXPECT_EQ(own.size(), built_in + 1);
}

// Each change makes one contradiction; the message names it.
TEST(Catalogue, RefusesRowsThatContradictThemselves) {
    const auto refused = [](const std::function<void(StageEntry&)>& change) {
        StageEntry row = halo();
        change(row);
        Catalogue own;
        const Diagnostics found = own.add(row);
        EXPECT_EQ(own.size(), catalogue().size());
        return found.size() == 1 ? found.front().message : to_text(found);
    };
    EXPECT_EQ(refused([](StageEntry& row) { row.name = "two words"; }),
              "the row of 'two words': a name is made of letters, digits and _, and begins with a "
              "letter");
    EXPECT_EQ(refused([](StageEntry& row) { row.make = nullptr; }),
              "the row of 'halo': it has no maker");
    EXPECT_EQ(refused([](StageEntry& row) { row.parameters.push_back(row.parameters.front()); }),
              "the row of 'halo', parameter 'radius': there are two parameters of this name");
    const auto with_type = [&refused](const ParameterType& type) {
        return refused([&type](StageEntry& row) { row.parameters.front().type = type; });
    };
    const std::string of_radius = "the row of 'halo', parameter 'radius': ";
    EXPECT_EQ(with_type(NumberParameter{.default_value = 0.0,
                                        .range = {.minimum = 0.0, .excludes_minimum = true}}),
              of_radius + "its default value is outside its range");
    EXPECT_EQ(with_type(NumberParameter{.range = {.minimum = 2.0, .maximum = 1.0}}),
              of_radius + "its range is empty");
    EXPECT_EQ(
        with_type(CountParameter{.default_value = 1.5, .range = {.minimum = 0.0, .maximum = 9.0}}),
        of_radius + "its default value must be a whole number");
    EXPECT_EQ(with_type(CountParameter{}), of_radius + "its range must lie within 0 to 1000000");
    EXPECT_EQ(with_type(ChoiceParameter{}), of_radius + "it has no choices");
    EXPECT_EQ(with_type(PointsParameter{}), of_radius + "its points have no co-ordinates");
    EXPECT_EQ(with_type(FormulaParameter{}), of_radius + "its formula must have results");
    EXPECT_EQ(with_type(NestedStageParameter{.kind = StageKind::direction_rule, .dimension = 1}),
              of_radius + "only object generators have a dimension");
}

TEST(Arguments, ALaterValueTakesThePlaceOfAnEarlierOne) {
    Arguments arguments;
    arguments.set("radius", numbers({1.0}));
    arguments.set("radius", numbers({2.0}));
    EXPECT_EQ(arguments.number("radius").constant(), 2.0);
}

}  // namespace balcony::camera::catalogue_test
