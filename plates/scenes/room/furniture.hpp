// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The meshes of the furniture, one for each material. Everything stands on z = 0 and faces -y;
// what stands at a wall has its back at y = 0.

#include "balcony/scene.hpp"
#include "common/mesh_builder.hpp"
#include "common/painting.hpp"

namespace balcony::plates::room {

/// A cushion: a superellipsoid, rounder for a lower exponent (2 is an ellipsoid).
[[nodiscard]] scene::Mesh cushion(const V3d& middle, const V3d& half, double exponent);

/// A sofa or an armchair about the origin, 0.92 deep, without its feet.
[[nodiscard]] scene::Mesh upholstery(double width, int seats);
[[nodiscard]] MeshBuilder feet(double width);

[[nodiscard]] MeshBuilder chair();
[[nodiscard]] MeshBuilder round_table();   ///< 0.74 high.
[[nodiscard]] MeshBuilder coffee_table();  ///< 1.2 by 0.62, 0.42 high.

inline constexpr double bookcase_width = 2.6;
[[nodiscard]] MeshBuilder bookcase();
[[nodiscard]] scene::Mesh books();  ///< In it, with vertex colours.
/// A pile of books with a cover of 0.24 by 0.17, with vertex colours.
[[nodiscard]] scene::Mesh pile_of_books(int count, std::uint32_t seed);

inline constexpr double breast_width = 1.7;
inline constexpr double breast_depth = 0.34;
inline constexpr double mantel_height = 1.12;
struct Fireplace {
    MeshBuilder breast, surround, hearth, logs, flames;
};
/// With a chimney breast up to a ceiling.
[[nodiscard]] Fireplace fireplace(double ceiling);

struct LongcaseClock {
    MeshBuilder wood, brass;
};
inline constexpr double dial_height = 1.92;  ///< Of the middle of the dial, which is 0.19 before
                                             ///< the wall.
[[nodiscard]] LongcaseClock longcase_clock();

struct Dresser {
    MeshBuilder wood, knobs;
};
[[nodiscard]] Dresser dresser();  ///< 1.1 wide, 0.45 deep, 0.85 high.

struct Door {
    MeshBuilder leaf, handle;
};
[[nodiscard]] Door door();  ///< 1 by 2.1 m, with its frame.

struct Lamp {
    MeshBuilder metal, shade;
};
[[nodiscard]] Lamp floor_lamp();
[[nodiscard]] Lamp pendant();  ///< Hangs from z = 0.

/// A curtain that hangs down from the origin, in folds along x.
[[nodiscard]] scene::Mesh curtain(double width, double height);

}  // namespace balcony::plates::room
