// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reflection of plain materials at sixteen points together, in the widest registers of the
// machine. The results are the same on all machines, and those of Bsdf, bit for bit.

#include <array>
#include <cstddef>
#include <cstdint>

#include <Imath/ImathVec.h>

#include "shading/lanes/lane_arrays.hpp"
#include "shading/materials/bsdf_material.hpp"

namespace balcony::render::plain_lanes {

inline constexpr std::size_t size = lane_count;
using Floats = LaneFloats;
using Vectors = LaneVectors;

/// As LayerReflectance.
template <class T>
struct Reflectance {
    T single{}, single_edge{}, all{}, all_edge{};
};

/// A point of a surface, with the normals of Bsdf.
struct Surface {
    PlainMaterial material;
    V3f normal;
    V3f side_normal;
};

/// The materials must outlive it.
struct alignas(64) Surfaces {
    void set_material(std::size_t lane, const PlainMaterial& material);
    void set(std::size_t lane, const Surface& surface);
    /// In a range of lanes.
    void fill(std::size_t first, std::size_t count, const Surface& surface);

    Vectors normal, side_normal;
    /// Of PlainMaterial.
    Reflectance<Vectors> specular;
    Reflectance<Floats> dielectric;
    Vectors diffuse;
    Floats per_mean_below{};
    Floats alpha{};  ///< Of the facets; 0 of a mirror.
    std::array<const LayerEnergies*, size> energies{};
};

/// LayerEnergy at a direction.
struct alignas(64) Energies {
    Floats scale{}, single{}, single_edge{}, all_edge{};
};

/// The cosines between normals and directions, and the entries of the tables of energies around
/// them.
struct alignas(64) Cosines {
    Floats cosine;
    std::array<std::int32_t, size> node;
    Floats fraction;
    alignas(64) std::array<EnergyEntry, size> lower;
    alignas(64) std::array<EnergyEntry, size> upper;
};

/// What the viewers' directions alone decide, as PlainView.
struct alignas(64) Views {
    Vectors direction;
    Floats cosine{};
    Energies energy;
    Floats below{};
    Floats specular{};
};

/// As Bsdf::Value.
struct alignas(64) Values {
    Vectors reflected;
    Floats pdf{};
};

/// The views in the lanes that are asked for; undefined in the others. The directions are unit and
/// point to the viewers.
void set_views(LaneBits lanes, const Surfaces& surfaces, const Vectors& to_viewer, Views& views);

/// As Bsdf::evaluate() in the lanes that are asked for, and 0 in the others.
void evaluate(LaneBits lanes, const Surfaces& surfaces, const Views& views, const Vectors& to_light,
              Values& values);

/// Directions to light, as those of BsdfSample.
struct alignas(64) Directions {
    Vectors to_light;
    Vectors facet_normal;
    LaneBits by_facet = 0;  ///< Where a facet reflects; the others are diffuse.
};

/// As Bsdf::sample() of rough materials: from three numbers in [0, 1) in each lane. Undefined in
/// lanes without a view.
void sample(const Surfaces& surfaces, const Views& views, const Vectors& random,
            Directions& directions);

}  // namespace balcony::render::plain_lanes
