// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "balcony/catalogue.hpp"
#include "support.hpp"

namespace balcony::lang {

TEST(Explain, SaysStepsInTheOrderOfTheMachineWithTheirMeanings) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("a.cam",
                                   "camera a(r = 2, turn = 30deg) {\n"
                                   "    move rotate(z, turn)  // last but one\n"
                                   "    eye circle(r)\n"
                                   "    toward { object torus(r, /* thin */ 1) warp scale(2) }\n"
                                   "    map u = 0 .. 1,\n"
                                   "        v = square\n"
                                   "}\n");
    const auto made = explain(file, "", {{"r", "3 + 1"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->name, "a");
    ASSERT_EQ(made->parameters.size(), 2U);
    EXPECT_EQ(made->parameters[0].value, "4");
    EXPECT_EQ(made->parameters[1].value, "30deg");
    std::vector<std::string> said;
    for (const Explanation::Step& step : made->steps) {
        said.push_back(std::string(step.depth, '.') + step.statement + " " + step.written);
    }
    const std::vector<std::string> wanted = {
        "map u = 0 .. 1, v = square", "eye circle(r)",        "toward ",      ".warp scale(2)",
        ".object torus(r, 1)",        "move rotate(z, turn)", "look relative"};
    EXPECT_EQ(said, wanted);
    // The stage of the statement's own kind: rotate is a parameter transformer too.
    const auto* row = camera::find_stage(camera::StageKind::object_transformer, "rotate");
    EXPECT_EQ(made->steps[5].meanings, std::vector{"rotate: " + std::string(row->meaning)});
}

TEST(Explain, SaysWhatIsWrongInsteadOfExplainingIt) {
    const auto made = explain("nothing.cam", "");
    EXPECT_FALSE(made);
    EXPECT_TRUE(has_errors(made.diagnostics));
}

TEST(Explain, KnowsEveryStandardCamera) {
    for (const std::string& name : standard_cameras()) {
        const auto made = explain(name, "");
        ASSERT_TRUE(made) << name << to_text(made.diagnostics);
        for (const Explanation::Step& step : made->steps) {
            EXPECT_FALSE(step.meanings.empty() && !step.written.empty()) << name << step.statement;
        }
    }
}

}  // namespace balcony::lang
