// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <set>

#include "support.hpp"

namespace balcony::camera {

namespace {

class EveryStage : public testing::TestWithParam<StageEntry> {};

std::string test_name(const testing::TestParamInfo<StageEntry>& row) {
    std::string name = std::string(name_of(row.param.kind)) + "_" + std::string(row.param.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

std::size_t numbers_in(ParameterType type) {
    switch (type) {
        case ParameterType::number:
        case ParameterType::count: return 1;
        case ParameterType::pair:
        case ParameterType::size: return 2;
        case ParameterType::triple:
        case ParameterType::axis: return 3;
        default: return 0;
    }
}

}  // namespace

TEST_P(EveryStage, SaysWhatItAndItsParametersMean) {
    EXPECT_FALSE(GetParam().meaning.empty());
    std::set<std::string_view> names;
    for (const StageParameter& parameter : GetParam().parameters) {
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
        EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " stands twice";
        EXPECT_EQ(parameter.type == ParameterType::choice, !parameter.choices.empty());
        EXPECT_EQ(parameter.type == ParameterType::points, !parameter.coordinates.empty());
        EXPECT_EQ(parameter.type == ParameterType::formula, parameter.shape.max_results > 0);
        // A count becomes a size: what a user can write must be one.
        if (parameter.type == ParameterType::count) {
            EXPECT_GE(parameter.minimum, 0.0) << parameter.name;
            EXPECT_LE(parameter.maximum, 1e6) << parameter.name;
        }
    }
}

TEST_P(EveryStage, HasDefaultsOfItsTypesInTheirRanges) {
    for (const StageParameter& parameter : GetParam().parameters) {
        EXPECT_LE(parameter.minimum, parameter.maximum);
        if (!parameter.default_value.empty()) {
            EXPECT_EQ(parameter.default_value.size(), numbers_in(parameter.type)) << parameter.name;
        }
        for (const double value : parameter.default_value) {
            EXPECT_GE(value, parameter.minimum) << parameter.name;
            EXPECT_LE(value, parameter.maximum) << parameter.name;
            EXPECT_FALSE(parameter.excludes_minimum && value == parameter.minimum)
                << parameter.name;
        }
    }
}

TEST_P(EveryStage, IsFoundByItsKindAndName) {
    EXPECT_EQ(find_stage(GetParam().kind, GetParam().name)->meaning, GetParam().meaning);
}

TEST_P(EveryStage, CanBeMadeAndFitsItsPort) {
    const auto made = GetParam().make(arguments_for(GetParam(), {}));
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    const Stage* stage = made->get();
    switch (GetParam().kind) {
        case StageKind::picture_arranger:
            EXPECT_NE(dynamic_cast<const PictureArranger*>(stage), nullptr);
            break;
        case StageKind::picture_mapper:
            EXPECT_NE(dynamic_cast<const PictureMapper*>(stage), nullptr);
            break;
        case StageKind::parameter_transformer:
            EXPECT_NE(dynamic_cast<const ParameterTransformer*>(stage), nullptr);
            break;
        case StageKind::object_generator:
            EXPECT_NE(dynamic_cast<const ObjectGenerator*>(stage), nullptr);
            break;
        case StageKind::object_transformer:
            EXPECT_NE(dynamic_cast<const ObjectTransformer*>(stage), nullptr);
            break;
        case StageKind::direction_rule:
            EXPECT_NE(dynamic_cast<const DirectionRule*>(stage), nullptr);
            break;
        case StageKind::clip_shape:
            EXPECT_NE(dynamic_cast<const ClipShape*>(stage), nullptr);
            break;
    }
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
    EXPECT_EQ(find_stage(StageKind::object_generator, "no such object"), nullptr);
}

TEST(Catalogue, EveryChoiceCanBeMade) {
    for (const StageEntry& row : catalogue()) {
        for (const StageParameter& parameter : row.parameters) {
            for (const std::string_view choice : parameter.choices) {
                const auto made =
                    row.make(arguments_for(row, {{parameter.name, std::string(choice)}}));
                EXPECT_TRUE(made) << row.name << ' ' << choice;
            }
        }
    }
}

TEST(Arguments, ALaterValueTakesThePlaceOfAnEarlierOne) {
    Arguments arguments;
    arguments.set("radius", numbers({1.0}));
    arguments.set("radius", numbers({2.0}));
    EXPECT_EQ(arguments.number("radius").constant(), 2.0);
}

}  // namespace balcony::camera
