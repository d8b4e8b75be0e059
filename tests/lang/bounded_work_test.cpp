// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Files of at most 1 MB that could need any amount of time, if the work were not in proportion to
// the text.

#include <gtest/gtest.h>

#include <ctime>
#include <functional>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::lang::bounded_work_test {

namespace {

/// Each test takes less than a second of the processor, whatever else the machine does, and more
/// than the limit without what it tests.
class BoundedWork : public testing::Test {
protected:
    void TearDown() override {
        EXPECT_LT(static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC, limit_);
    }

    double limit_ = 5.0;  ///< In seconds, with room for sanitizers.

private:
    std::clock_t began_ = std::clock();
};

constexpr const char* sphere = "{ map u = -1 .. 1, v = square eye sphere(1) }\n";

std::string repeated(std::size_t count, const std::function<std::string(std::size_t)>& piece,
                     std::string_view between = "\n") {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += fmt::format("{}{}", i == 0 ? "" : between, piece(i));
    }
    return text;
}

// a0 and then morphs, each between the one before and itself.
std::string chain_of_morphs(const std::string& first, std::size_t morphs,
                            const std::string& lets = "") {
    return first + repeated(morphs, [&](std::size_t i) {
               return fmt::format("camera a{} {{ {} morph a{} .. a{}, amount = y, by = rays }}",
                                  i + 1, lets, i, i);
           });
}

Result<camera::Picture> made(const std::string& text, std::string_view name = "") {
    Workspace workspace;
    return workspace.make_picture(CameraSource(std::make_shared<const SourceText>("a.cam", text)),
                                  name);
}

std::string first_said(const std::string& text) {
    const auto result = made(text);
    return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

}  // namespace

TEST_F(BoundedWork, MakesTheCamerasOfAChainOfMorphsOnce) {
    const std::string chain = chain_of_morphs(fmt::format("camera a0 {}", sphere), 16);
    EXPECT_TRUE(made(chain));
    Workspace workspace;
    const auto all =
        workspace.make_all(CameraSource(std::make_shared<const SourceText>("a.cam", chain)));
    ASSERT_TRUE(all) << to_text(all.diagnostics);
    EXPECT_EQ(all->size(), 17U);
}

TEST_F(BoundedWork, LimitsAChainOfMorphsAlikeHoweverItIsReached) {
    const std::string chain = chain_of_morphs(fmt::format("camera a0 {}", sphere), 17);
    const std::string message = "morphs are nested more than 16 levels deep";
    EXPECT_EQ(first_said(chain), message);
    Workspace workspace;
    const auto all =
        workspace.make_all(CameraSource(std::make_shared<const SourceText>("a.cam", chain)));
    ASSERT_FALSE(all.diagnostics.empty());
    EXPECT_EQ(all.diagnostics.front().message, message);
}

TEST_F(BoundedWork, FailsOnceInAChainOfMorphs) {
    const auto broken = made(
        chain_of_morphs("camera a0 { map u = -1 .. 1, v = square eye sphere(nothing) }\n", 16));
    ASSERT_EQ(broken.diagnostics.size(), 1U) << to_text(broken.diagnostics);
    EXPECT_EQ(broken.diagnostics.front().message, "unknown name 'nothing'");
    const auto broken_lets =
        made(chain_of_morphs(fmt::format("camera a0 {}", sphere), 16, "let q = nothing"));
    EXPECT_EQ(broken_lets.diagnostics.size(), 1U) << to_text(broken_lets.diagnostics);
}

TEST_F(BoundedWork, WarnsOfTheFirstUnusedNames) {
    constexpr std::size_t count = 30'000;
    const auto parameters = repeated(
        count, [](std::size_t i) { return fmt::format("p{} = 1", i); }, ", ");
    const auto result = made(fmt::format("camera a({}) {}", parameters, sphere));
    ASSERT_TRUE(result);
    ASSERT_EQ(result.diagnostics.size(), 101U);
    EXPECT_EQ(result.diagnostics[0].message, "the parameter 'p0' is unused");
    EXPECT_EQ(result.diagnostics[99].message, "the parameter 'p99' is unused");
    EXPECT_EQ(result.diagnostics[100].message,
              "there are more warnings; only the first 100 are shown");
}

TEST_F(BoundedWork, TakesManyValuesOfALayer) {
    constexpr std::size_t count = 40'000;
    const auto list = [](std::string_view value) {
        return repeated(
            count, [value](std::size_t i) { return fmt::format("p{} = {}", i, value); }, ", ");
    };
    EXPECT_TRUE(made(
        fmt::format("camera a({}) {}picture b {{ layer a({}) }}", list("1"), sphere, list("2"))));
}

TEST_F(BoundedWork, KnowsTheParametersOfManyFunctions) {
    const auto functions =
        repeated(45'000, [](std::size_t i) { return fmt::format("let f{}(a, b) = a", i); });
    const auto result = made(fmt::format("{}\ncamera a {}", functions, sphere));
    ASSERT_EQ(result.diagnostics.size(), 101U);
    EXPECT_EQ(result.diagnostics[1].message, "the parameter 'b' is unused");
}

TEST_F(BoundedWork, SaysTheFirstOfManyMissingNames) {
    const auto lets = repeated(
        20'000, [](std::size_t i) { return fmt::format("let some_name{} = other_name{}", i, i); });
    const auto result = made(fmt::format("{}\ncamera a {}", lets, sphere));
    ASSERT_EQ(result.diagnostics.size(), 21U);
    EXPECT_EQ(result.diagnostics.back().message,
              "there are more errors; only the first 20 are shown");
}

TEST_F(BoundedWork, FindsTheEndOfParenthesesThatDoNotClose) {
    const auto opened = repeated(
        60'000, [](std::size_t) { return "a b(c"; }, " ");
    EXPECT_EQ(made(opened).diagnostics.size(), 1U);
}

TEST_F(BoundedWork, WritesManyStagesThatChangeWithTime) {
    const auto moves = repeated(
        15'000, [](std::size_t i) { return fmt::format("translate(t + {}, {} * t, 0)", i, i); },
        ", ");
    EXPECT_TRUE(made(
        fmt::format("camera a {{ map u = -1 .. 1, v = square eye sphere(1) move {} }}", moves)));
}

TEST_F(BoundedWork, FindsTheCommentsOfManyDefinitions) {
    limit_ = 1.5;
    const auto cameras = repeated(
        25'000, [](std::size_t i) { return fmt::format("camera a{} {{ eye point }}", i); });
    const auto comments = repeated(100'000, [](std::size_t) { return "//"; });
    const std::string text = fmt::format("// The first.\n{}\n{}", cameras, comments);
    Workspace workspace;
    const auto described =
        workspace.describe(CameraSource(std::make_shared<const SourceText>("a.cam", text)));
    ASSERT_TRUE(described);
    EXPECT_EQ(described->front().comment, "The first.");
    EXPECT_EQ(described->back().comment, "");
}

}  // namespace balcony::lang::bounded_work_test
