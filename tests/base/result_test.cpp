// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <type_traits>

#include <gtest/gtest.h>

#include "balcony/base.hpp"

namespace balcony::result_test {
namespace {

TEST(Result, HoldsAValueThatNeedNotBeCopyable) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
    ASSERT_TRUE(result);
    EXPECT_EQ(**result, 7);
    EXPECT_TRUE(result.diagnostics.empty());
    const std::unique_ptr<int> taken = std::move(*result);
    EXPECT_EQ(*taken, 7);
}

TEST(Result, AValueMayComeWithWarnings) {
    const Result<std::string> result(std::string("made"), Diagnostics{warning("odd")});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->size(), 4U);
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_FALSE(has_errors(result.diagnostics));
}

TEST(Result, AFailureHasADiagnostic) {
    const Result<int> one = error("not this");
    EXPECT_FALSE(one);
    EXPECT_TRUE(has_errors(one.diagnostics));
    const Result<int> several = Diagnostics{warning("odd"), error("not this")};
    EXPECT_FALSE(several);
    EXPECT_EQ(several.diagnostics.size(), 2U);
}

TEST(Result, FalsehoodIsAValueToo) {
    const Result<bool> result = false;
    EXPECT_TRUE(static_cast<bool>(result));
    EXPECT_FALSE(*result);
}

TEST(StrongIndex, StartsInvalidAndKeepsItsValue) {
    using Index = StrongIndex<struct Tag>;
    EXPECT_FALSE(Index().valid());
    EXPECT_TRUE(Index(0).valid());
    EXPECT_EQ(Index(41).value(), 41U);
    EXPECT_LT(Index(1), Index(2));
    EXPECT_NE(Index(1), Index());
}

TEST(StrongIndex, KindsDoNotMix) {
    using One = StrongIndex<struct OneTag>;
    using Other = StrongIndex<struct OtherTag>;
    EXPECT_FALSE((std::is_convertible_v<One, Other>));
    EXPECT_FALSE((std::is_convertible_v<int, One>));
}

}  // namespace
}  // namespace balcony::result_test
