// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays followed to surfaces in closed form.

#include "camera/objects/ray_targets.hpp"

namespace balcony::camera {

namespace {

using Distance = RayTarget::Distance;
using Which = RayTarget::Which;

Expr is_ahead(Expr s) { return min_ray_distance < s && is_finite(s); }

/// The roots of a s² + 2 b s + c, of which one is wanted.
Distance wanted_root(Expr a, Expr b, Expr c, Which which) {
    const Expr discriminant = b * b - a * c;
    const Expr spread = sqrt(max(discriminant, 0.0 * discriminant));
    const Expr far = (spread - b) / a;
    const Expr near = (-spread - b) / a;
    const Expr s = which == Which::last ? far : select(min_ray_distance < near, near, far);
    return {s, 0.0 <= discriminant && is_ahead(s)};
}

class PlaneTarget final : public RayTarget {
public:
    PlaneTarget(Triple at, Triple along_u, Triple along_v)
        : at_(std::move(at)), along_u_(std::move(along_u)), along_v_(std::move(along_v)) {}
    Distance distance(const ObjectPoint& from, const ObjectVector& direction, Which,
                      Emitter& emit) const override {
        const ObjectVector n = cross(vector_of(along_u_, emit), vector_of(along_v_, emit));
        const Expr s = dot(n, point_of(at_, emit) - from) / dot(n, direction);
        return {s, is_ahead(s)};
    }

private:
    Triple at_, along_u_, along_v_;
};

class SphereTarget final : public RayTarget {
public:
    explicit SphereTarget(Scalar radius) : radius_(std::move(radius)) {}
    Distance distance(const ObjectPoint& from, const ObjectVector& d, Which which,
                      Emitter& emit) const override {
        const ObjectVector o{from.x, from.y, from.z};
        const Expr r = emit(radius_);
        return wanted_root(dot(d, d), dot(o, d), dot(o, o) - r * r, which);
    }

private:
    Scalar radius_;
};

class CylinderTarget final : public RayTarget {
public:
    explicit CylinderTarget(Scalar radius) : radius_(std::move(radius)) {}
    Distance distance(const ObjectPoint& from, const ObjectVector& d, Which which,
                      Emitter& emit) const override {
        const Expr r = emit(radius_);
        return wanted_root(d.x * d.x + d.y * d.y, from.x * d.x + from.y * d.y,
                           from.x * from.x + from.y * from.y - r * r, which);
    }

private:
    Scalar radius_;
};

// Neighbouring panels overlap by as much as rounding could leave open between them.
constexpr double panel_slack = 1e-12;

Expr in_unit_interval(Expr t) {
    return -panel_slack <= t && t <= t.graph().constant(1.0 + panel_slack);
}

class ParallelogramTarget final : public RayTarget {
public:
    using Vector3 = std::array<double, 3>;
    ParallelogramTarget(const Vector3& corner, const Vector3& along_u, const Vector3& along_v)
        : corner_(corner), along_u_(along_u), along_v_(along_v) {}
    // The point is corner + p along_u + q along_v.
    Distance distance(const ObjectPoint& from, const ObjectVector& direction, Which,
                      Emitter& emit) const override {
        const auto vector = [&emit](const Vector3& a) {
            return ObjectVector{emit(a[0]), emit(a[1]), emit(a[2])};
        };
        const ObjectVector along_u = vector(along_u_);
        const ObjectVector along_v = vector(along_v_);
        const ObjectVector corner = vector(corner_);
        const ObjectVector n = cross(along_u, along_v);
        const ObjectVector to_corner = corner + -ObjectVector{from.x, from.y, from.z};
        const Expr s = dot(n, to_corner) / dot(n, direction);
        const ObjectVector there = s * direction + -to_corner;
        const Expr p = dot(cross(there, along_v), n) / dot(n, n);
        const Expr q = dot(cross(along_u, there), n) / dot(n, n);
        return {s, is_ahead(s) && in_unit_interval(p) && in_unit_interval(q)};
    }

private:
    Vector3 corner_, along_u_, along_v_;
};

class PanelsTarget final : public RayTarget {
public:
    explicit PanelsTarget(PointList points) : points_(std::move(points)) {}
    // From above, a panel is a + t e, with t from 0 to 1.
    Distance distance(const ObjectPoint& from, const ObjectVector& d, Which which,
                      Emitter& emit) const override {
        const bool first = which == Which::first;
        Expr found = emit(0.0);
        Expr any = emit(0.0);
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            const double ex = points_[i + 1][0] - points_[i][0];
            const double ey = points_[i + 1][1] - points_[i][1];
            const Expr ax = points_[i][0] - from.x;
            const Expr ay = points_[i][1] - from.y;
            const Expr across = d.x * ey - d.y * ex;
            const Expr s = (ax * ey - ay * ex) / across;
            const Expr t = (ax * d.y - ay * d.x) / across;
            const Expr met = is_ahead(s) && in_unit_interval(t);
            found = select(met && (!any || (first ? s < found : found < s)), s, found);
            any = any || met;
        }
        return {found, any};
    }

private:
    PointList points_;
};

}  // namespace

std::shared_ptr<const RayTarget> plane_target(Triple at, Triple along_u, Triple along_v) {
    return std::make_shared<const PlaneTarget>(std::move(at), std::move(along_u),
                                               std::move(along_v));
}

std::shared_ptr<const RayTarget> sphere_target(Scalar radius) {
    return std::make_shared<const SphereTarget>(std::move(radius));
}

std::shared_ptr<const RayTarget> cylinder_target(Scalar radius) {
    return std::make_shared<const CylinderTarget>(std::move(radius));
}

std::shared_ptr<const RayTarget> parallelogram_target(const std::array<double, 3>& corner,
                                                      const std::array<double, 3>& along_u,
                                                      const std::array<double, 3>& along_v) {
    return std::make_shared<const ParallelogramTarget>(corner, along_u, along_v);
}

std::shared_ptr<const RayTarget> panels_target(PointList points) {
    return std::make_shared<const PanelsTarget>(std::move(points));
}

}  // namespace balcony::camera
