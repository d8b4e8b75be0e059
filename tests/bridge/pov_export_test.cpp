// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The functions for POV-Ray of all examples, read and evaluated as POV-Ray does.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "bridge/text/camera_formulas.hpp"
#include "bridge/text/middle_of_lens.hpp"
#include "examples.hpp"
#include "pov_interpreter.hpp"

namespace balcony::bridge::pov_export_test {
namespace {

using test::Example;
using test::ExportedRay;
using test::PovScene;

Result<ExportedCamera> exported(const camera::Camera& camera) {
    return export_camera(*find_export_target("pov"), {camera});
}

// Names of POV-Ray begin with a capital letter.
std::string pov_name(std::string name) {
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

// From POV-Ray's left-handed world with y up to Balcony's with y up.
std::array<double, 3> from_left(const std::array<double, 3>& v) { return {v[0], v[1], -v[2]}; }
// And to the world of a camera.
std::array<double, 3> in_axes(const std::array<double, 3>& v, Axes axes) {
    const auto [x, y, z] = from_left(v);
    return axes == Axes::y_up ? std::array{x, y, z} : std::array{x, -z, y};
}

// Of a look into a table: three for each coefficient of a cell (the look, a product, a sum), and
// along each axis eight that find the cell and the position in it.
std::size_t operations(const expr::Table& table) {
    std::size_t coefficients = 1;
    for (const expr::Table::Axis& axis : table.axes) {
        coefficients *= axis.degree + 1;
    }
    return 3 * coefficients + 8 * table.axes.size();
}

std::size_t operations(const CameraFormulas& formulas) {
    std::size_t count = 0;
    for (const expr::NodeId id : expr::reachable(*formulas.graph, formulas.roots)) {
        const bool call = (*formulas.graph)[id].op == Op::call;
        count += call ? operations(*formulas.graph->call_of(id).table) : 1;
    }
    return count;
}

TEST(PovExport, ComputesTheRaysOfAllExamplesThatItCanExpress) {
    std::size_t expressed = 0;
    std::string refused;
    for (const Example& example : test::examples()) {
        const auto text = exported(example.camera);
        if (!text) {
            EXPECT_FALSE(text.diagnostics.front().remedy.empty()) << example.name;
            refused += fmt::format("{}: {}\n", example.name, text.diagnostics.front().message);
            continue;
        }
        ++expressed;
        const PovScene scene(text->text, test::width, test::height);
        const Example pinhole{example.name, *with_middle_of_lens(example.camera, "", "").value};
        const Axes axes = example.camera.parts().axes;
        std::vector<ExportedRay> rays;
        for (const auto& [x, y] : test::points()) {
            const PovScene::Ray ray = scene.ray(pov_name(example.name), x, y);
            rays.push_back({in_axes(ray.location, axes), in_axes(ray.direction, axes), ray.valid});
        }
        const test::Comparison comparison = test::compare(pinhole, rays);
        EXPECT_EQ(comparison.lost, 0U) << example.name;
        EXPECT_LT(comparison.largest, 1e-6) << example.name;
        EXPECT_LE(scene.max_parameters(), 56U) << example.name;
        // Everything is computed at most once for each of six coordinates; besides, there are the
        // conversion of the point, the choice of the coordinate, and helpers of several operations.
        const auto formulas = formulas_of(pinhole.camera, {"pov", Axes::y_up});
        EXPECT_LE(scene.cost().operations, rays.size() * 6 * (operations(*formulas) + 10))
            << example.name;
    }
    EXPECT_GE(expressed + 2, test::examples().size()) << "not expressed:\n" << refused;
}

// A camera whose rays say what it was given.
constexpr const char* swaying = R"(
    camera sway(height = 3, lean = 10deg) {
        map    u = -180deg .. 180deg, v = -1 .. 1
        eye    surface(u, v) = [t, 2, height]
        toward surface(u, v) = [t + cos(u)*cos(lean), 2 + sin(u), height + v]
    })";

lang::OpenCamera open_camera(const char* text) {
    auto made = lang::Workspace().make_open_camera(
        std::make_shared<const SourceText>("test.cam", text), "", {}, {});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

ExportSource open_source(const lang::OpenCamera& opened) {
    ExportSource source{opened.camera};
    for (const lang::OpenParameter& parameter : opened.open) {
        source.parameters.push_back({parameter.name, lang::parameter_input(parameter.name),
                                     parameter.written, parameter.value, parameter.is_angle});
    }
    return source;
}

TEST(PovExport, DeclaresParametersUnlessTheSceneDoes) {
    const ExportSource source = open_source(open_camera(swaying));
    const auto text = export_camera(*find_export_target("pov"), source);
    ASSERT_TRUE(text) << to_text(text.diagnostics);
    const PovScene own(text->text, 160, 90);
    EXPECT_EQ(own.number("Sway_height"), 3.0);
    EXPECT_NEAR(own.number("Sway_lean"), std::acos(-1.0) / 18.0, 1e-15);
    EXPECT_EQ(own.ray("Sway", 30, 40).location, (std::array{0.0, 3.0, 2.0}));
    const PovScene changed(text->text, 160, 90, 0.0, {{"Sway_height", 7.0}});
    EXPECT_EQ(changed.ray("Sway", 30, 40).location, (std::array{0.0, 7.0, 2.0}));
}

TEST(PovExport, TakesTheTimeFromTheClock) {
    const auto text = export_camera(*find_export_target("pov"), open_source(open_camera(swaying)));
    const PovScene scene(text->text, 160, 90, 0.25);
    EXPECT_EQ(scene.ray("Sway", 30, 40).location[0], 0.25);
}

TEST(PovExport, HasTheUpAxisThatIsAskedFor) {
    const ExportSource source = open_source(open_camera(swaying));
    const auto text = export_camera(*find_export_target("pov"), source, {.axes = Axes::z_up});
    const PovScene::Ray z_up = PovScene(text->text, 160, 90).ray("Sway", 30, 40);
    EXPECT_EQ(z_up.location, (std::array{0.0, -2.0, 3.0}));
    const auto y_up_text = export_camera(*find_export_target("pov"), source);
    const PovScene::Ray y_up = PovScene(y_up_text->text, 160, 90).ray("Sway", 30, 40);
    EXPECT_NEAR(z_up.direction[0], y_up.direction[0], 1e-15);
    EXPECT_NEAR(z_up.direction[1], -y_up.direction[2], 1e-15);
    EXPECT_NEAR(z_up.direction[2], y_up.direction[1], 1e-15);
}

camera::Camera camera_of(const std::string& text) {
    const auto made = lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

TEST(PovExport, LeavesALensOutWithAWarning) {
    const std::string pinhole =
        "camera c { map u = 1 .. -1, v = square  eye point(0, 0, 0)  toward plane((1, 0, 0)) ";
    const auto with_lens = exported(camera_of(pinhole + "lens(0.1, focus = 5) }"));
    const auto without = exported(camera_of(pinhole + "}"));
    ASSERT_TRUE(with_lens && without);
    EXPECT_EQ(with_lens->text, without->text);
    EXPECT_NE(to_text(with_lens.diagnostics).find("'balcony pov'"), std::string::npos);
    EXPECT_TRUE(without.diagnostics.empty());
}

TEST(PovExport, RefusesWhatHasMoreValuesThanAFunctionHasParameters) {
    std::string seeds;
    for (int i = 0; i < 40; ++i) {
        seeds +=
            fmt::format("{}({}, {}, {}, {}, 1, 2)", i == 0 ? "" : ", ", i, i % 5, i % 3, i % 7);
    }
    const auto text =
        exported(camera_of("camera c { map u = 0deg .. 360deg, v = -80deg .. 80deg  eye sphere(9)\n"
                           "  move inverse_distance([" +
                           seeds + "]) look normal }"));
    ASSERT_FALSE(text);
    EXPECT_NE(to_text(text.diagnostics).find("parameters"), std::string::npos);
    EXPECT_NE(to_text(text.diagnostics).find("'balcony pov'"), std::string::npos);
}

TEST(PovExport, RefusesALargeTableAndNamesTheStage) {
    std::string points;
    for (int i = 0; i < 100 * 100; ++i) {
        points += fmt::format("{}({}, {})", i == 0 ? "" : ", ", 0.001 * (i % 7), 0.001 * (i % 11));
    }
    const auto text = exported(camera_of(
        fmt::format("camera c {{ map u = 1 .. -1, v = square  warp grid([{}], columns = 100)\n"
                    "  eye point(0, 0, 0)  toward plane((1, 0, 0)) }}",
                    points)));
    ASSERT_FALSE(text);
    const std::string message = to_text(text.diagnostics);
    EXPECT_NE(message.find("warp grid"), std::string::npos) << message.substr(0, 300);
    EXPECT_NE(message.find("'balcony pov'"), std::string::npos);
}

}  // namespace
}  // namespace balcony::bridge::pov_export_test
