// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays followed to a triangle mesh, by a tree of boxes.

#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/objects/ray_targets.hpp"
#include "camera/objects/vector3.hpp"

namespace balcony::camera {

namespace {

using Which = RayTarget::Which;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct MeshRay {
    Vector3 from, direction;
};

struct MeshTriangle {
    Vector3 corner, b, c;  ///< A corner, and the sides from there.

    [[nodiscard]] Vector3 normal() const { return cross(b, c); }

    /// After Möller and Trumbore (1997); infinite where the ray misses the triangle.
    [[nodiscard]] double distance(const MeshRay& ray) const {
        // Neighbours overlap by as much as rounding could leave open between them.
        constexpr double slack = 1e-9;
        const Vector3 across = cross(ray.direction, c);
        const double determinant = dot(b, across);
        const Vector3 to = difference(ray.from, corner);
        const double p = dot(to, across) / determinant;
        const Vector3 q_vector = cross(to, b);
        const double q = dot(ray.direction, q_vector) / determinant;
        const double s = dot(c, q_vector) / determinant;
        const bool met = p >= -slack && q >= -slack && p + q <= 1.0 + slack &&
                         s > min_ray_distance && std::isfinite(s);
        return met ? s : infinity;
    }
};

struct TriangleBox {
    Vector3 min{infinity, infinity, infinity};
    Vector3 max{-infinity, -infinity, -infinity};

    void add(const Vector3& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            min[k] = std::min(min[k], p[k]);
            max[k] = std::max(max[k], p[k]);
        }
    }

    void add(const MeshTriangle& t) {
        for (const Vector3& side : {Vector3{}, t.b, t.c}) {
            add(Vector3{t.corner[0] + side[0], t.corner[1] + side[1], t.corner[2] + side[2]});
        }
    }

    /// Room for the overlap of triangles.
    void widen() {
        constexpr double share = 1e-8;
        double size = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            size = std::max({size, max[k] - min[k], std::abs(min[k]), std::abs(max[k])});
        }
        for (std::size_t k = 0; k < 3; ++k) {
            min[k] -= share * size;
            max[k] += share * size;
        }
    }

    /// Where a ray enters and leaves; it misses the box if it leaves before it enters.
    [[nodiscard]] std::array<double, 2> interval(const MeshRay& ray) const {
        double enters = 0.0, leaves = infinity;
        for (std::size_t k = 0; k < 3; ++k) {
            if (ray.direction[k] == 0.0) {
                leaves = ray.from[k] < min[k] || ray.from[k] > max[k] ? -infinity : leaves;
                continue;
            }
            const double a = (min[k] - ray.from[k]) / ray.direction[k];
            const double b = (max[k] - ray.from[k]) / ray.direction[k];
            enters = std::max(enters, std::min(a, b));
            leaves = std::min(leaves, std::max(a, b));
        }
        return {enters, leaves};
    }
};

class TriangleTree {
public:
    explicit TriangleTree(const std::vector<std::array<TexturedMesh::Corner, 3>>& triangles) {
        for (const auto& t : triangles) {
            triangles_.push_back({t[0].position, difference(t[1].position, t[0].position),
                                  difference(t[2].position, t[0].position)});
        }
        build(0, triangles_.size());
    }

    struct Found {
        double s;  ///< Infinite if the ray meets nothing.
        Vector3 normal;
    };
    [[nodiscard]] Found operator()(const MeshRay& ray, Which which) const {
        const bool first = which == Which::first;
        double best = first ? infinity : -infinity;
        std::size_t number = 0;
        std::array<std::size_t, max_depth> stack;
        std::size_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            const auto [enters, leaves] = node.box.interval(ray);
            // Of equal triangles the first one counts, whatever the order of the boxes.
            if (!(enters <= leaves) || (first ? enters > best : leaves < best)) {
                continue;
            }
            if (node.end == 0) {
                stack[depth++] = node.begin;
                stack[depth++] = node.begin + 1;
                continue;
            }
            for (std::size_t i = node.begin; i < node.end; ++i) {
                const double s = triangles_[i].distance(ray);
                const bool nearer = first ? s < best : s > best;
                if (s < infinity && (nearer || (s == best && i < number))) {
                    best = s;
                    number = i;
                }
            }
        }
        return {std::isfinite(best) ? best : infinity, triangles_[number].normal()};
    }

private:
    /// A leaf has the triangles begin .. end, another node the nodes begin and begin + 1.
    struct Node {
        TriangleBox box;
        std::size_t begin = 0, end = 0;
    };
    // Halving 5 million triangles takes 23 levels, each of which leaves one node waiting.
    static constexpr std::size_t max_depth = 128;

    void build(std::size_t first, std::size_t last) {
        struct Work {
            std::size_t node, begin, end;
        };
        nodes_.resize(1);
        std::vector<Work> work{{0, first, last}};
        while (!work.empty()) {
            const Work now = work.back();
            work.pop_back();
            TriangleBox box, middles;
            for (std::size_t i = now.begin; i < now.end; ++i) {
                box.add(triangles_[i]);
                middles.add(middle(triangles_[i]));
            }
            box.widen();
            constexpr std::size_t triangles_of_leaf = 4;
            if (now.end - now.begin <= triangles_of_leaf) {
                nodes_[now.node] = {box, now.begin, now.end};
                continue;
            }
            const std::size_t half = split(now.begin, now.end, middles);
            const std::size_t children = nodes_.size();
            nodes_[now.node] = {box, children, 0};
            nodes_.resize(children + 2);
            work.push_back({children, now.begin, half});
            work.push_back({children + 1, half, now.end});
        }
    }

    static Vector3 middle(const MeshTriangle& t) {
        return {t.corner[0] + (t.b[0] + t.c[0]) / 3.0, t.corner[1] + (t.b[1] + t.c[1]) / 3.0,
                t.corner[2] + (t.b[2] + t.c[2]) / 3.0};
    }

    // Halves along the longest side of the box of the triangles' middles.
    std::size_t split(std::size_t begin, std::size_t end, const TriangleBox& middles) {
        std::size_t axis = 0;
        for (const std::size_t k : {1U, 2U}) {
            if (middles.max[k] - middles.min[k] > middles.max[axis] - middles.min[axis]) {
                axis = k;
            }
        }
        const std::size_t half = begin + (end - begin) / 2;
        const auto at = [this](std::size_t i) {
            return triangles_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(half), at(end),
                         [axis](const MeshTriangle& a, const MeshTriangle& b) {
                             return middle(a)[axis] < middle(b)[axis];
                         });
        return half;
    }

    std::vector<MeshTriangle> triangles_;
    std::vector<Node> nodes_;
};

/// A ray, as origin and direction, to the distance s of a triangle, the normal of the triangle, and
/// whether there is one.
class TreeHit final : public expr::Native {
public:
    TreeHit(std::shared_ptr<const TriangleTree> tree, Which which)
        : tree_(std::move(tree)), which_(which) {}

    std::string_view name() const override { return "mesh_hit"; }
    std::size_t argument_count() const override { return 6; }
    std::size_t result_count() const override { return 5; }
    std::optional<std::size_t> validity() const override { return 4; }
    void evaluate(std::size_t count, const double* const* a, double* const* r) const override {
        for (std::size_t i = 0; i < count; ++i) {
            const MeshRay ray{{a[0][i], a[1][i], a[2][i]}, {a[3][i], a[4][i], a[5][i]}};
            const TriangleTree::Found found = (*tree_)(ray, which_);
            const bool met = std::isfinite(found.s);
            r[0][i] = met ? found.s : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                r[1 + k][i] = found.normal[k];
            }
            r[4][i] = met ? 1.0 : 0.0;
        }
    }
    // In the plane of the triangle, n·(from + s d) is constant.
    Expr derivative(std::size_t result, std::size_t argument, std::span<const Expr> at,
                    std::span<const Expr> r) const override {
        if (result != 0) {
            return {};
        }
        const Expr slope = r[1] * at[3] + r[2] * at[4] + r[3] * at[5];
        const Expr by_origin = -(r[1 + argument % 3] / slope);
        return argument < 3 ? by_origin : r[0] * by_origin;
    }

private:
    std::shared_ptr<const TriangleTree> tree_;
    Which which_;
};

class TrianglesTarget final : public RayTarget {
public:
    explicit TrianglesTarget(const std::shared_ptr<const TriangleTree>& tree)
        : first_(std::make_shared<const TreeHit>(tree, Which::first)),
          last_(std::make_shared<const TreeHit>(tree, Which::last)) {}
    Distance distance(const ObjectPoint& from, const ObjectVector& d, Which which,
                      Emitter& emit) const override {
        const std::vector<Expr> hit =
            emit.graph().call(which == Which::first ? first_ : last_,
                              std::array{from.x, from.y, from.z, d.x, d.y, d.z});
        return {hit[0], equal(hit[4], emit(1.0))};
    }

private:
    std::shared_ptr<const TreeHit> first_, last_;
};

}  // namespace

std::shared_ptr<const RayTarget> triangles_target(
    const std::vector<std::array<TexturedMesh::Corner, 3>>& triangles) {
    return std::make_shared<const TrianglesTarget>(std::make_shared<const TriangleTree>(triangles));
}

}  // namespace balcony::camera
