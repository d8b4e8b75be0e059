// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parameter derivatives: how the rays of a picture, and the positions at which it shows points,
// change with parameters of its camera. They are exact.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/solve.hpp"

namespace balcony::app {

/// What is differentiated.
struct DerivativeRequest {
    /// Parameters, whose derivatives come first and in this order. Those of others that are open
    /// follow. One that is not open, or is named twice, is an error of Kind::usage.
    std::optional<std::vector<std::string>> by{};
    std::array<std::size_t, 2> size{};  ///< Of the picture, in pixels.
    std::size_t layer = 0;              ///< A camera layer, from 0 at the back.
    double time = 0.0;                  ///< The value of t in the camera's formulas.
    std::optional<Axes> axes{};         ///< Of rays; by default those of the camera.
};

struct ParameterDerivatives {
    std::vector<std::string> by;       ///< The parameters, in the order of the derivatives.
    solve::Derivatives derivatives{};  ///< At the values that the parameters have.
};

/// Of the rays at points of the picture, in pixels, as solve::Solver::ray_derivatives().
[[nodiscard]] Result<ParameterDerivatives> ray_derivatives(const lang::OpenPicture& picture,
                                                           const DerivativeRequest& request,
                                                           std::span<const Imath::V2d> points,
                                                           const std::stop_token& stop = {});
/// Of the positions at which the layer shows points of space, the nearest if it shows one in
/// several, as solve::Solver::position_derivatives(). The locator is that of the picture with the
/// values of its parameters, and has the axes of the points.
[[nodiscard]] Result<ParameterDerivatives> position_derivatives(const lang::OpenPicture& picture,
                                                                const DerivativeRequest& request,
                                                                const analyse::Locator& locator,
                                                                std::span<const Imath::V3d> points,
                                                                const std::stop_token& stop = {});

}  // namespace balcony::app
