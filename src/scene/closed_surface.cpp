// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <bit>
#include <unordered_map>
#include <utility>

#include "balcony/scene.hpp"

namespace balcony::scene {

namespace {

std::uint64_t mixed(std::uint64_t seed, std::uint64_t value) {
    const std::uint64_t product = (seed ^ value) * 0x9e3779b97f4a7c15U;
    return product ^ product >> 32U;
}

struct PointHash {
    std::size_t operator()(const V3f& p) const {
        std::uint64_t hash = 0;
        for (const float component : {p.x, p.y, p.z}) {
            hash = mixed(hash, std::bit_cast<std::uint32_t>(component));
        }
        return hash;
    }
};

/// Points by position, and the number of times that edges between them are traversed.
class SurfaceEdges {
public:
    void add(const std::array<V3f, 3>& corners) {
        const std::array<std::uint64_t, 3> points = {number(corners[0]), number(corners[1]),
                                                     number(corners[2])};
        if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) {
            return;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t from = points[i];
            const std::uint64_t to = points[(i + 1) % 3];
            auto& [forward, backward] = edges_[std::min(from, to) << 32U | std::max(from, to)];
            ++(from < to ? forward : backward);
        }
        // Six times the volume between the triangle and the first point.
        const V3d a(corners[0] - first_);
        volume_ += a.dot(V3d(corners[1] - first_).cross(V3d(corners[2] - first_)));
    }

    [[nodiscard]] bool enclose_volume() const {
        for (const auto& [edge, passed] : edges_) {
            if (passed != std::pair(1, 1)) {
                return false;
            }
        }
        return volume_ > 0.0;
    }

private:
    std::uint64_t number(const V3f& place) {
        if (numbers_.empty()) {
            first_ = place;
        }
        // 0 and -0 are the same position.
        const V3f key(place.x + 0.0F, place.y + 0.0F, place.z + 0.0F);
        return numbers_.try_emplace(key, numbers_.size()).first->second;
    }

    std::unordered_map<V3f, std::uint64_t, PointHash> numbers_;
    std::unordered_map<std::uint64_t, std::pair<int, int>> edges_;
    V3f first_{0.0F};
    double volume_ = 0.0;
};

}  // namespace

bool encloses_volume(const Scene& scene, std::uint32_t object) {
    SurfaceEdges edges;
    for (const Instance& instance : scene.instances) {
        if (instance.object != object) {
            continue;
        }
        const Mesh& mesh = scene.meshes[instance.mesh.value()];
        const bool mirrored = instance.world_from_mesh.determinant() < 0.0;
        for (const auto& triangle : mesh.triangles) {
            std::array<V3f, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = V3f(V3d(mesh.positions[triangle[i]]) * instance.world_from_mesh);
            }
            if (mirrored) {
                std::swap(corners[1], corners[2]);
            }
            edges.add(corners);
        }
    }
    return edges.enclose_volume();
}

}  // namespace balcony::scene
