// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any text → a lens of glass or errors → its optics near the axis and a spot → a camera with rays
// through it, which are finite and of unit length.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "balcony/data.hpp"
#include "balcony/lang.hpp"
#include "balcony/make_stage.hpp"
#include "balcony/prescription.hpp"
#include "balcony/rays.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;

// What passes a lens is found by tracing it some ten thousand times.
constexpr std::size_t most_surfaces = 8;

const char* const pinhole =
    "camera a { map u = 0.36 .. -0.36, v = square  eye point  toward plane((1, 0, 0)) }";

template <class T>
void demand_one_of_both(const Result<T>& result) {
    demand(result.value.has_value() != has_errors(result.diagnostics), "neither value nor error");
    (void)to_text(result.diagnostics);
}

void look_through(const camera::Camera& camera) {
    rays::CompileOptions options;
    options.points = true;
    options.inputs = {{std::string(camera::lens_input_x), program::Rate::pixel},
                      {std::string(camera::lens_input_y), program::Rate::pixel}};
    const auto program = rays::compile(camera, 2.0, 2.0, options);
    demand_one_of_both(program);
    if (!program) {
        return;
    }
    const std::array x{1.0, 1.0, 0.1, 1.9, 1.5};
    const std::array y{1.0, 1.0, 0.2, 1.1, 0.5};
    const std::array a{0.0, 0.7, 0.0, -0.3, 0.9};
    const std::array b{0.0, 0.1, 0.2, 0.6, -0.9};
    const std::array<std::span<const double>, 2> on_lens{a, b};
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run(rays::Points{x, y, 0.0, on_lens}, scratch, batch);
    for (std::size_t i = 0; i < batch.size(); ++i) {
        demand(!batch.valid(i) || (std::abs(batch.direction(i).length() - 1.0) < 1e-9 &&
                                   std::isfinite(batch.origin(i).length())),
               "a ray is not of unit length");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const Result<camera::Camera> camera =
        lang::make_camera(std::make_shared<const SourceText>("a.cam", pinhole), "");
    demand(camera.value.has_value(), "the camera is wrong");
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const char* name = text.find("SURF") == text.npos ? "fuzz.dat" : "fuzz.zmx";
    const auto lens =
        data::read_prescription(data::File::in_memory(name, name, std::span(bytes, count)));
    demand_one_of_both(lens);
    if (!lens) {
        return 0;
    }
    const camera::ParaxialLens near_axis = camera::paraxial(**lens);
    demand(near_axis.focal_length > 0.0, "a lens without a real image");
    if ((*lens)->surfaces.size() > most_surfaces) {
        return 0;
    }
    const auto spot = camera::spot_of(**lens, {.field = {0.0, 0.1}});
    demand(!spot || (std::isfinite(spot->middle[0] + spot->middle[1]) && spot->rms_radius >= 0.0 &&
                     spot->area > 0.0),
           "a spot is not finite");
    const auto made = camera::make_stage<camera::Lens>(
        "table", {{"file", *lens}, {"focus", 1e3 * near_axis.focal_length}, {"unit", 1.0}});
    demand_one_of_both(made);
    if (made) {
        camera::Camera::Parts parts = camera->parts();
        parts.lens = *made;
        const auto through = camera::Camera::make(std::move(parts));
        demand_one_of_both(through);
        if (through) {
            look_through(*through);
        }
    }
    return 0;
}
