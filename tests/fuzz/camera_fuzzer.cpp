// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any text → camera and picture or errors → compiled rays of 16 pixels, of all layers. What a
// camera calls a ray must be one: finite, of unit length.

#include <cstdint>

#include "../laws/ray_laws.hpp"
#include "balcony/lang.hpp"
#include "demand.hpp"

using namespace balcony;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const auto source = std::make_shared<const SourceText>(
        "fuzz.cam", std::string(reinterpret_cast<const char*>(bytes), count));
    const Result<camera::Camera> made = lang::make_camera({source, "/nonexistent"}, "");
    demand(made.value.has_value() != has_errors(made.diagnostics), "neither camera nor error");
    (void)to_text(made.diagnostics);
    if (made) {
        demand_no(laws::broken_law(*made));
    }
    const Result<camera::Picture> picture = lang::make_picture({source, "/nonexistent"}, "");
    demand(picture.value.has_value() != has_errors(picture.diagnostics),
           "neither picture nor error");
    if (picture) {
        demand_no(laws::broken_law(*picture));
    }
    const Result<std::string> laid_out = lang::format(source);
    if (laid_out) {
        const auto again = lang::format(std::make_shared<const SourceText>("again", *laid_out));
        demand(again && *again == *laid_out, "laid out again it is not as it was");
    }
    return 0;
}
