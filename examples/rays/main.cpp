// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints the rays of a camera, a line for each pixel that has one: the origin and the direction.
// The argument is a camera file or the name of a built-in camera.

#include <cstdio>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"

using namespace balcony;

int fail(const Diagnostics& diagnostics) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
}

int main(int argc, char** argv) {
    constexpr std::size_t width = 64;
    constexpr std::size_t height = 36;
    const auto camera = lang::make_camera(argc > 1 ? argv[1] : "panorama", "");
    if (!camera) {
        return fail(camera.diagnostics);
    }
    const auto program = rays::compile(*camera, width, height, {});
    if (!program) {
        return fail(program.diagnostics);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run({.width = width, .height = height}, scratch, batch);

    for (std::size_t i = 0; i < batch.size(); ++i) {
        if (batch.valid(i)) {
            const rays::V3d o = batch.origin(i);
            const rays::V3d d = batch.direction(i);
            std::printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", o.x, o.y, o.z, d.x, d.y, d.z);
        }
    }
}
