// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/coincident.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "balcony/content_hash.hpp"
#include "balcony/motion.hpp"

namespace balcony::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using CornerBits = std::array<std::uint32_t, 3>;

// Of a corner's coordinates, so that 0 and -0 are the same.
CornerBits bits_of(const V3f& p) {
    return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F),
            std::bit_cast<std::uint32_t>(p.z + 0.0F)};
}

// The same for corners in any order. Multiplication and a shift, as in the finaliser of
// MurmurHash3.
std::uint64_t hash_of(const Mesh& mesh, const Triangle& triangle) {
    std::uint64_t sum = 0;
    for (const std::uint32_t corner : triangle) {
        std::uint64_t hash = 0x9e3779b97f4a7c15U;
        for (const std::uint32_t bits : bits_of(mesh.positions[corner])) {
            hash = (hash ^ bits) * 0xff51afd7ed558ccdU;
            hash ^= hash >> 32U;
        }
        sum += hash;
    }
    return sum;
}

std::array<CornerBits, 3> sorted_corners(const Mesh& mesh, const Triangle& triangle) {
    std::array<CornerBits, 3> corners{bits_of(mesh.positions[triangle[0]]),
                                      bits_of(mesh.positions[triangle[1]]),
                                      bits_of(mesh.positions[triangle[2]])};
    std::sort(corners.begin(), corners.end());
    return corners;
}

template <class Element>
void add(ContentHash& hash, std::span<const Element> elements) {
    hash.add(std::as_bytes(elements));
}

std::uint64_t hash_of(const Mesh& mesh) {
    ContentHash hash;
    add(hash, std::span<const V3f>(mesh.positions));
    add(hash, std::span<const Triangle>(mesh.triangles));
    return hash.value();
}

// Whether an instance moves or changes its shape, by its index.
std::vector<bool> moving_instances(const Scene& scene) {
    std::vector<bool> moves(scene.instances.size());
    if (scene.motion) {
        std::vector<bool> deforms(scene.meshes.size());
        for (const Deformation& deformation : scene.motion->deformations) {
            deforms[deformation.mesh.value()] = true;
        }
        for (std::size_t i = 0; i < moves.size(); ++i) {
            moves[i] = deforms[scene.instances[i].mesh.value()];
        }
        for (const MovingInstance& moving : scene.motion->instances) {
            moves[moving.instance] = true;
        }
    }
    return moves;
}

}  // namespace

// Triangles in one place have the same hash. A table of counts by a part of it tells for most
// triangles at once that there are few; the others are compared.
std::size_t drop_coincident_triangles(Mesh& mesh) {
    constexpr std::size_t per_count = 4;
    if (mesh.triangles.size() <= max_coincident) {
        return 0;
    }
    std::vector<std::uint8_t> counts(std::bit_ceil(mesh.triangles.size() / per_count + 1));
    const auto count_of = [&](const Triangle& triangle) -> std::uint8_t& {
        return counts[hash_of(mesh, triangle) >> 8U & (counts.size() - 1)];
    };
    for (const Triangle& triangle : mesh.triangles) {
        std::uint8_t& count = count_of(triangle);
        count = static_cast<std::uint8_t>(std::min<std::size_t>(count + 1U, max_coincident + 1));
    }
    std::map<std::array<CornerBits, 3>, std::size_t> places;
    return std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
        return count_of(triangle) > max_coincident &&
               ++places[sorted_corners(mesh, triangle)] > max_coincident;
    });
}

std::size_t drop_coincident_instances(Scene& scene) {
    if (scene.instances.size() <= max_coincident) {
        return 0;
    }
    std::vector<std::uint64_t> hashes(scene.meshes.size());
    std::transform(scene.meshes.begin(), scene.meshes.end(), hashes.begin(),
                   [](const Mesh& mesh) { return hash_of(mesh); });
    const std::vector<bool> moves = moving_instances(scene);
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> places;
    std::vector<Instance> kept;
    std::vector<std::uint32_t> index(scene.instances.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Instance& instance = scene.instances[i];
        ContentHash place;
        add(place, std::span<const double>(&instance.world_from_mesh[0][0], 16));
        index[i] = static_cast<std::uint32_t>(kept.size());
        if (moves[i] ||
            ++places[{hashes[instance.mesh.value()], place.value()}] <= max_coincident) {
            kept.push_back(instance);
        }
    }
    const std::size_t dropped = scene.instances.size() - kept.size();
    if (dropped > 0) {
        scene.instances = std::move(kept);
        if (scene.motion) {
            Motion motion = *scene.motion;
            for (MovingInstance& moving : motion.instances) {
                moving.instance = index[moving.instance];
            }
            scene.motion = std::make_shared<const Motion>(std::move(motion));
        }
    }
    return dropped;
}

}  // namespace balcony::scene
