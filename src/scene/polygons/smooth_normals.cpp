// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "scene/polygons/face_set.hpp"
#include "scene/polygons/triple_numbers.hpp"

namespace balcony::scene {

namespace {

constexpr double cos_of_sharpest_edge = 0.7071067811865476;  // 45 degrees

// The bits of a coordinate, so that 0 and -0 are the same.
std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0F); }

// The corners of faces without normals, by the point in space that they share.
class CornersByPoint {
public:
    CornersByPoint(const FaceSet& set, Import& import) {
        TripleNumbers points;
        point_of_position_.reserve(set.positions.size());
        for (const V3f& p : set.positions) {
            import.go_on(point_of_position_.size(), 4 * set.positions.size());
            point_of_position_.push_back(points.number({bits_of(p.x), bits_of(p.y), bits_of(p.z)}));
        }
        begins_.assign(points.triples().size() + 1, 0);
        const auto for_each_corner = [&](const auto& visit) {
            import.report(1, 4);
            for (std::uint32_t face = 0; face < set.faces.size(); ++face) {
                import.go_on(face, 4 * set.faces.size());
                const auto& corners = set.faces[face].corners;
                for (std::uint32_t i = 0; i < 3 && corners[0].normal == no_index; ++i) {
                    visit(point(corners[i]), 3 * face + i);
                }
            }
        };
        for_each_corner([&](std::uint32_t point, std::uint32_t) { ++begins_[point + 1]; });
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        corners_.resize(begins_.back());
        std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
        for_each_corner(
            [&](std::uint32_t point, std::uint32_t corner) { corners_[next[point]++] = corner; });
    }

    [[nodiscard]] std::uint32_t point(const Corner& corner) const {
        return point_of_position_[corner.position];
    }
    [[nodiscard]] std::size_t points() const { return begins_.size() - 1; }
    /// Corner i of a face has the number 3 * face + i.
    [[nodiscard]] std::span<const std::uint32_t> corners(std::size_t point) const {
        return std::span(corners_).subspan(begins_[point], begins_[point + 1] - begins_[point]);
    }

private:
    std::vector<std::uint32_t> point_of_position_;
    std::vector<std::uint32_t> begins_;
    std::vector<std::uint32_t> corners_;
};

/// Computes normals point by point. The faces around a point that are connected across smooth edges
/// share a normal there: the mean of theirs, weighted by their angles at the point (Thürmer and
/// Wüthrich 1998), so that it does not depend on the triangulation.
class Smoother {
public:
    Smoother(FaceSet& set, Import& import) : set_(set), import_(import), around_(set, import) {}

    void add_normals() {
        const std::size_t points = around_.points();
        import_.report(1, 2);
        for (std::size_t point = 0; point < points; ++point) {
            import_.go_on(points + point, 2 * points);
            collect(around_.corners(point));
            connect();
            add_normals_of_fans();
        }
    }

private:
    // A face at the point.
    struct Wedge {
        std::uint32_t corner;
        V3d normal;  // Unit length, or 0 for a triangle without area.
        double angle;
        std::uint32_t fan;                // An earlier wedge that it is connected to, or itself.
        std::uint32_t number = no_index;  // Of the fan's normal.
    };
    // An edge of a face, from the point to another.
    struct Edge {
        std::uint32_t other;
        std::uint32_t wedge;
        bool operator<(const Edge& edge) const {
            return other != edge.other ? other < edge.other : wedge < edge.wedge;
        }
    };

    void collect(std::span<const std::uint32_t> corners) {
        wedges_.clear();
        edges_.clear();
        for (const std::uint32_t corner : corners) {
            const auto& face = set_.faces[corner / 3].corners;
            const Corner& after = face[(corner + 1) % 3];
            const Corner& before = face[(corner + 2) % 3];
            const V3d at(set_.positions[face[corner % 3].position]);
            const V3d forward = V3d(set_.positions[after.position]) - at;
            const V3d backward = V3d(set_.positions[before.position]) - at;
            const V3d across = forward.cross(backward);
            const double area = across.length();
            const auto wedge = static_cast<std::uint32_t>(wedges_.size());
            wedges_.push_back({corner, area > 0.0 ? across / area : V3d(0.0),
                               std::atan2(area, forward.dot(backward)), wedge});
            edges_.push_back({around_.point(after), wedge});
            edges_.push_back({around_.point(before), wedge});
        }
    }

    // Connects faces with a common edge. Where several meet at an edge, each follows the previous
    // one of the file.
    void connect() {
        std::sort(edges_.begin(), edges_.end());
        for (std::size_t i = 1; i < edges_.size(); ++i) {
            const Edge& edge = edges_[i];
            const Edge& previous = edges_[i - 1];
            if (edge.other == previous.other &&
                is_smooth(wedges_[previous.wedge], wedges_[edge.wedge])) {
                const std::uint32_t a = fan_of(previous.wedge);
                const std::uint32_t b = fan_of(edge.wedge);
                wedges_[std::max(a, b)].fan = std::min(a, b);
            }
        }
    }

    [[nodiscard]] bool is_smooth(const Wedge& a, const Wedge& b) const {
        const Face& one = set_.faces[a.corner / 3];
        const Face& other = set_.faces[b.corner / 3];
        const bool same_object =
            set_.sections[one.section].object_number == set_.sections[other.section].object_number;
        return same_object && one.smoothing == other.smoothing && one.smoothing != flat &&
               (one.smoothing != smooth_by_angle || a.normal.dot(b.normal) >= cos_of_sharpest_edge);
    }

    std::uint32_t fan_of(std::uint32_t wedge) {
        while (wedges_[wedge].fan != wedge) {
            wedge = wedges_[wedge].fan = wedges_[wedges_[wedge].fan].fan;
        }
        return wedge;
    }

    void add_normals_of_fans() {
        sums_.assign(wedges_.size(), V3d(0.0));
        for (std::uint32_t i = 0; i < wedges_.size(); ++i) {
            sums_[fan_of(i)] += wedges_[i].angle * wedges_[i].normal;
        }
        for (std::uint32_t i = 0; i < wedges_.size(); ++i) {
            Wedge& fan = wedges_[fan_of(i)];
            if (fan.number == no_index) {
                fan.number = static_cast<std::uint32_t>(set_.normals.size());
                const V3d normal = sums_[fan_of(i)].normalized();
                set_.normals.push_back(normal == V3d(0.0) ? V3f(0.0F, 0.0F, 1.0F) : V3f(normal));
            }
            const std::uint32_t corner = wedges_[i].corner;
            set_.faces[corner / 3].corners[corner % 3].normal = fan.number;
        }
    }

    FaceSet& set_;
    Import& import_;
    CornersByPoint around_;
    std::vector<Wedge> wedges_;
    std::vector<Edge> edges_;
    std::vector<V3d> sums_;
};

}  // namespace

void add_missing_normals(FaceSet& set, Import& import) {
    if (std::any_of(set.faces.begin(), set.faces.end(),
                    [](const Face& face) { return face.corners[0].normal == no_index; })) {
        import.begin_phase(normals_begin, meshes_begin);
        Smoother smoother(set, import);
        smoother.add_normals();
    }
}

}  // namespace balcony::scene
