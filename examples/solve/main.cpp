// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera from what its picture is to show: the corners of a facade where a photo has them.

#include <cstdio>

#include "balcony/lang.hpp"
#include "balcony/solve.hpp"

using namespace balcony;

int main() {
    const auto photo = lang::Workspace().make_open_camera("pinhole", "", {},
                                                          {{"fov", "px", "py", "yaw", "pitch"}});
    if (!photo) {
        std::fputs(to_text(photo.diagnostics).c_str(), stderr);
        return 1;
    }
    solve::Problem problem;
    for (const lang::OpenParameter& parameter : photo->open) {
        problem.unknowns.push_back(
            {lang::parameter_input(parameter.name), parameter.value, parameter.limits});
    }
    // The facade is 8 m wide and 6 m high, and the ground is 1.6 m below the camera.
    problem.marks = {{{20, 4, -1.6}}, {{20, -4, -1.6}}, {{20, 4, 4.4}}, {{20, -4, 4.4}}};
    problem.constraints = {{solve::ConstraintKind::at, {0}, {155, 347}},
                           {solve::ConstraintKind::at, {1}, {446, 346}},
                           {solve::ConstraintKind::at, {2}, {158, 129}},
                           {solve::ConstraintKind::inside, {3}}};
    const auto found = solve::solve(photo->camera, 640, 480, problem);
    if (!found) {
        std::fputs(to_text(found.diagnostics).c_str(), stderr);
        return 1;
    }
    for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
        std::printf("%s = %.4f +- %.4f\n", photo->open[i].name.c_str(), found->values[i],
                    found->deviations[i]);
    }
    for (const solve::Miss& miss : found->misses) {
        std::printf("missed by %.2f pixels\n", miss.deviations);
    }
}
