// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A program with a stage of its own: the shell of a snail, which the language then knows. A camera
// written in that language is drawn with characters: how bright its rays are in the light of one
// lamp.

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"

namespace {

using namespace balcony;
using camera::Emitter;
using camera::ObjectPoint;
using camera::ParameterPoint;
using camera::Scalar;

// A circle that winds round the z axis and grows by the factor e^(growth u) on its way:
// e^(growth u) ((2 + cos v) cos u, (2 + cos v) sin u, sin v - height).
class Shell : public camera::ObjectGenerator {
public:
    Shell(Scalar growth, Scalar height) : growth_(std::move(growth)), height_(std::move(height)) {}

    int dimension() const override { return 2; }

    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const auto size = exp(emit(growth_) * p.u);
        const auto radius = size * (2.0 + cos(p.v));
        return {radius * cos(p.u), radius * sin(p.u), size * (sin(p.v) - emit(height_))};
    }

private:
    Scalar growth_, height_;
};

camera::StageEntry shell() {
    return {
        .kind = camera::StageKind::object_generator,
        .name = "shell",
        .meaning = "a snail's shell: u goes along its spiral, v round its tube",
        .formula = "p = e^(growth u) ((2 + cos v) cos u, (2 + cos v) sin u, sin v - height)",
        .parameters = {{.name = "growth",
                        .type = camera::NumberParameter{.default_value = 0.1,
                                                        .range = {.minimum = 0.0, .maximum = 1.0}},
                        .meaning = "it becomes larger by e^growth for each radian"},
                       {.name = "height",
                        .type = camera::NumberParameter{.default_value = 1.5},
                        .meaning = "how steep the spiral is"}},
        .make = [](const camera::Arguments& a) -> Result<std::shared_ptr<const camera::Stage>> {
            return {std::make_shared<const Shell>(a.number("growth"), a.number("height"))};
        },
        .dimension = 2};
}

constexpr const char* text = R"(
// Two turns of the shell, unrolled: rays leave it at right angles.
camera unrolled(growth = 0.1) {
    aspect 4
    map    u = 0deg .. 720deg, v = -180deg .. 180deg
    eye    shell(growth, height = 2)
    look   normal
}
)";

int fail(const Diagnostics& diagnostics) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
}

}  // namespace

int main() {
    camera::Catalogue stages;
    if (const Diagnostics found = stages.add(shell()); !found.empty()) {
        return fail(found);
    }
    lang::Workspace workspace(stages);
    const auto source = std::make_shared<const SourceText>("unrolled.cam", text);
    const auto camera = workspace.make_camera(source, "unrolled", {{"growth", "1/8"}});
    if (!camera) {
        return fail(camera.diagnostics);
    }
    constexpr std::size_t width = 64;
    constexpr std::size_t height = 16;
    const auto program = rays::compile(*camera, width, height, {});
    if (!program) {
        return fail(program.diagnostics);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run({.width = width, .height = height}, scratch, batch);

    constexpr std::string_view shades = " .:-=+*#%@";
    const rays::V3d lamp = rays::V3d(1.0, -1.0, 1.0).normalized();
    std::string picture;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const double light = std::max(0.0, batch.direction(i).dot(lamp));
        picture += shades[static_cast<std::size_t>(light * 9.99)];
        picture += i % width == width - 1 ? "\n" : "";
    }
    std::fputs(picture.c_str(), stdout);
}
