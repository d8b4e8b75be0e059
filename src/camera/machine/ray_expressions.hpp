// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The formulas of a ray after its direction is known: its stereo view, its lens, its bend and its
// time.

#include <optional>
#include <span>
#include <vector>

#include "balcony/camera.hpp"

namespace balcony::camera {

/// A ray with leaves replaced, in the graph of the replacements.
[[nodiscard]] RayExpressions substitute(Graph& target, const RayExpressions& ray,
                                        std::span<const expr::Substitution> put);

/// What stages compute with leaves replaced, in the same way.
[[nodiscard]] std::vector<StageValues> substitute(Graph& target,
                                                  std::span<const StageValues> stages,
                                                  std::span<const expr::Substitution> put);

/// The unit vector across a ray that points to the right in the picture: the direction in which a
/// point of the ray moves along picture x. The point is that at the distance 1 divided by the
/// vergence; without a vergence, one near the origin. If it does not move, the direction in which
/// the origin moves, or else that of the ray; if neither moves, the right of a viewer whose head is
/// up.
[[nodiscard]] ObjectVector right_across(const CentralRay& ray, std::optional<Expr> vergence,
                                        const Emitter& emit);

/// The ray of an eye, of the camera's own picture. `up` is that of StereoView::eye.
[[nodiscard]] RayExpressions seen_by_eye(const RayExpressions& ray, const StereoView& stereo,
                                         const ObjectVector& up, const PicturePoint& picture,
                                         Emitter& emit);

/// A ray of the camera's own picture with a lens.
[[nodiscard]] RayExpressions with_lens(const RayExpressions& ray, const Lens& lens,
                                       const PicturePoint& picture, Emitter& emit);

/// A ray of the camera's own picture on its way through space.
[[nodiscard]] RayExpressions bent(const RayExpressions& ray, const Bend& bend,
                                  const PicturePoint& picture, Emitter& emit);

/// A ray of a camera with these axes in a pose, with its lens and its bend.
[[nodiscard]] RayExpressions posed(const RayExpressions& ray, const Pose& pose, Axes axes,
                                   const Emitter& emit);

/// A ray of a camera with these axes, turned with its lens and its bend.
[[nodiscard]] RayExpressions turned(const RayExpressions& ray, const Turn& turn, Axes axes,
                                    const Emitter& emit);

/// The ray at another time, which replaces t.
[[nodiscard]] RayExpressions at_time(const RayExpressions& ray, Expr time);

}  // namespace balcony::camera
