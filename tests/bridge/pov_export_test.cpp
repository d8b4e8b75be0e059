// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The functions for POV-Ray of all examples, read and evaluated as POV-Ray does.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "bridge/text/camera_formulas.hpp"
#include "examples.hpp"
#include "pov_interpreter.hpp"

namespace balcony::bridge::pov_export_test {
namespace {

using test::Example;
using test::ExportedRay;
using test::PovScene;

Result<std::string> exported(const camera::Camera& camera,
                             std::vector<ExportParameter> parameters = {},
                             ExportOptions options = {}) {
    return find_export_target("pov")->write({camera, std::move(parameters)}, options);
}

// Names of POV-Ray begin with a capital letter.
std::string pov_name(std::string name) {
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

camera::Camera without_lens(const camera::Camera& camera) {
    camera::Camera::Parts parts = camera.parts();
    parts.lens = nullptr;
    return *camera::Camera::make(std::move(parts)).value;
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
        const PovScene scene(*text, test::width, test::height);
        const Example pinhole{example.name, without_lens(example.camera)};
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
        const auto formulas = formulas_of(pinhole.camera, {Axes::y_up, false});
        EXPECT_LE(scene.cost().operations, rays.size() * 6 * (operations(*formulas) + 10))
            << example.name;
    }
    EXPECT_GE(expressed + 2, test::examples().size()) << "not expressed:\n" << refused;
}

}  // namespace
}  // namespace balcony::bridge::pov_export_test
