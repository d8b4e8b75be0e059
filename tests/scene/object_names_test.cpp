// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Names and patterns of objects.

#include "balcony/object_names.hpp"

#include <gtest/gtest.h>

namespace balcony::scene::object_names_test {
namespace {

Scene with_objects(const std::vector<std::string>& names) {
    Scene scene;
    for (const std::string& name : names) {
        scene.objects.push_back({name});
    }
    return scene;
}

using Found = std::vector<std::uint32_t>;

TEST(ObjectNames, ANameIsThatOfAllObjectsThatHaveIt) {
    const Scene scene = with_objects({"vase", "table", "vase", "Vase"});
    EXPECT_EQ(objects_named(scene, "vase"), (Found{0, 2}));
    EXPECT_EQ(objects_named(scene, "table"), Found{1});
    EXPECT_EQ(objects_named(scene, "vases"), Found{});
    EXPECT_EQ(objects_named(scene, ""), Found{});
}

TEST(ObjectNames, PatternsStandForCharacters) {
    const Scene scene =
        with_objects({"vase 1", "vase 2", "vase 12", "big vase", "", "abab", "aab"});
    EXPECT_EQ(objects_named(scene, "vase*"), (Found{0, 1, 2}));
    EXPECT_EQ(objects_named(scene, "*vase*"), (Found{0, 1, 2, 3}));
    EXPECT_EQ(objects_named(scene, "vase ?"), (Found{0, 1}));
    EXPECT_EQ(objects_named(scene, "vase ??"), Found{2});
    EXPECT_EQ(objects_named(scene, "*ab"), (Found{5, 6}));
    EXPECT_EQ(objects_named(scene, "a*b"), (Found{5, 6}));
    EXPECT_EQ(objects_named(scene, "a*ba*"), Found{5});
    EXPECT_EQ(objects_named(scene, "*"), (Found{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(objects_named(scene, "*z"), Found{});
}

TEST(ObjectNames, ANameThatLooksLikeAPatternIsAName) {
    const Scene scene = with_objects({"a*", "ab", "a?"});
    EXPECT_EQ(objects_named(scene, "a*"), Found{0});
    EXPECT_EQ(objects_named(scene, "a?"), Found{2});
}

// A pattern that could be tried in very many ways: matching takes time in proportion to the product
// of both lengths.
TEST(ObjectNames, LongPatternsAreMatchedAtOnce) {
    std::string pattern;
    for (int i = 0; i < 2000; ++i) {
        pattern += "a*";
    }
    const Scene scene = with_objects({std::string(20000, 'a'), std::string(20000, 'a') + "b"});
    EXPECT_EQ(objects_named(scene, pattern + "b"), Found{1});
}

TEST(ObjectNames, UnknownOnesHaveASuggestion) {
    const Scene scene = with_objects({"vase", "table"});
    EXPECT_EQ(no_object(scene, "m", "vaze", {}).remedy, "did you mean 'vase'?");
    EXPECT_NE(no_object(scene, "m", "q", {}).remedy.find("info --objects"), std::string::npos);
}

}  // namespace
}  // namespace balcony::scene::object_names_test
