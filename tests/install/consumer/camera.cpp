// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A program of somebody else: makes a camera of a text and runs it, without a scene.

#include <array>
#include <cmath>
#include <cstdio>

#include "balcony/lang.hpp"
#include "balcony/program.hpp"

int main() {
    const auto text = std::make_shared<const balcony::SourceText>(
        "walls.cam",
        "camera walls { map u = 180deg .. -180deg, v = -60deg .. 60deg  eye sphere(2) }");
    const auto camera = balcony::lang::make_camera(text, "walls");
    if (!camera) {
        std::fputs(balcony::to_text(camera.diagnostics).c_str(), stdout);
        return 1;
    }
    balcony::expr::Graph graph;
    const auto ray = camera->emit(graph, 8.0, 4.0);
    const std::array roots{ray.direction.x, ray.direction.y, ray.direction.z, ray.valid};
    const balcony::program::Program program(roots);

    std::array<double, 32> x, y, z, valid;
    const std::array<double*, 4> results{x.data(), y.data(), z.data(), valid.data()};
    balcony::program::Scratch scratch;
    balcony::program::run(program, {.width = 8, .height = 4}, scratch, results);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (valid[i] != 1.0 || std::fabs(std::hypot(x[i], y[i], z[i]) - 1.0) > 1e-12) {
            std::printf("ray %zu is wrong\n", i);
            return 1;
        }
    }
    return 0;
}
