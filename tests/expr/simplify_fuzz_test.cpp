// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Random formulas through the graph's local rules and through the simplifier, against the plain
// definitions of their operations.

#include <gtest/gtest.h>

#include "formula_trial.hpp"

namespace balcony::expr::simplify_fuzz_test {

namespace {

constexpr std::size_t formula_count = 20000;

}  // namespace

TEST(SimplifyFuzz, RandomFormulasKeepTheirValuesAndAreFinished) {
    std::mt19937_64 random(1996);
    Outcome all;
    for (std::size_t i = 0; i < formula_count; ++i) {
        const Formula formula = random_formula(random, 3 + i % 38);
        const Trial trial([&random](std::size_t count) { return random() % count; });
        const Outcome outcome = trial(formula);
        all.compared += outcome.compared;
        all.left_out += outcome.left_out;
        if (!outcome.failure.empty()) {
            const Formula small =
                minimised(formula, [&](const Formula& f) { return !trial(f).failure.empty(); });
            ADD_FAILURE() << "formula " << i << ": " << trial(small).failure << "\n"
                          << to_text(small);
            if (HasNonfatalFailure() && i > 200) {
                return;
            }
        }
    }
    // Operations outside their domains and points near jumps must not empty the test.
    EXPECT_GT(all.compared, all.left_out);
    RecordProperty("compared", static_cast<int>(all.compared));
    RecordProperty("left_out", static_cast<int>(all.left_out));
}

}  // namespace balcony::expr::simplify_fuzz_test
