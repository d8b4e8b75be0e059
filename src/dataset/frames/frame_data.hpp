// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/dataset.hpp"
#include "balcony/film.hpp"
#include "balcony/npy.hpp"

namespace balcony::dataset {

/// A frame that was rendered, of which its files are made.
struct FrameData {
    const Plan& plan;
    const Frame& frame;
    camera::Picture picture;  ///< In its pose.
    std::shared_ptr<const render::Film> film;
    render::DisplayOptions display{};
    std::vector<Imath::V2f> flow{};  ///< If it is wanted.

    [[nodiscard]] const PlannedScene& scene() const { return plan.scenes[frame.scene]; }
    [[nodiscard]] const PlannedCamera& camera() const { return plan.camera_of(frame); }
    [[nodiscard]] std::size_t pixels() const { return film->width * film->height; }
};

/// The bytes of an array of NumPy.
template <class Number>
[[nodiscard]] std::string npy_bytes(std::vector<std::size_t> shape,
                                    std::span<const Number> numbers) {
    constexpr char kind = std::is_floating_point_v<Number> ? 'f' : 'u';
    std::string bytes = npy_header(shape, sizeof(Number), 0, kind);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    return bytes;
}

}  // namespace balcony::dataset
