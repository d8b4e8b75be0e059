// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The optics of a prescription at one wavelength, for numbers and for expressions of a graph:
// matrices of rays near the axis, focusing, and refraction surface by surface.
//
// Rays run from the sensor to the scene, in millimetres: z along the axis towards the scene, 0 at
// the first surface, x and y across.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "balcony/expr.hpp"
#include "balcony/prescription.hpp"

namespace balcony::camera {

inline double select(bool condition, double a, double b) { return condition ? a : b; }

/// A constant of the same kind as a number.
inline double like(double, double value) { return value; }
inline expr::Expr like(const expr::Expr& number, double value) {
    return number.graph().constant(value);
}
inline bool always(double) { return true; }
inline expr::Expr always(const expr::Expr& number) { return like(number, 1.0); }

/// What a comparison of such numbers is.
template <class Number>
using Truth = std::conditional_t<std::same_as<Number, double>, bool, expr::Expr>;

/// The blades of a stop: the sides of a polygon with its corners on a circle.
struct Blades {
    std::size_t count = 0;  ///< 0: the circle.
    double rotation = 0.0;  ///< Of a corner from the top.
};

/// A surface as a ray from the sensor meets it.
struct RefractingSurface {
    LensSurface shape;
    double index = 1.0;        ///< On the side of the sensor.
    double index_after = 1.0;  ///< On the side of the scene.
    /// The same for the light that the lens is focused with.
    double focusing_index = 1.0, focusing_index_after = 1.0;

    [[nodiscard]] bool refracts() const { return index != index_after; }
};

struct LensOptics {
    std::vector<RefractingSurface> surfaces;  ///< From the scene to the sensor.
    std::size_t stop = 0;
    Blades blades{};
    double defocus = 0.0;  ///< How far behind the image of what is in focus the sensor is.
};

[[nodiscard]] LensOptics optics_of(const Prescription& lens, double wavelength,
                                   double focusing_wavelength);
/// Makes the stop as wide as an f-number says, if it is wider.
void narrow_stop(LensOptics& lens, const ParaxialLens& paraxial, double f_number);

// ------------------------------------------------------------------------------ near the axis

/// What becomes of a ray near the axis, of its height y and its slope times the index w:
/// (y, w) -> (a y + b w, c y + d w). Slopes are towards the sensor.
template <class Number>
struct RayMatrix {
    Number a, b, c, d;
};

/// From just before one surface to just behind another, with the gaps given.
template <class Number>
RayMatrix<Number> matrix_of(const LensOptics& lens, const std::vector<Number>& gaps,
                            std::size_t first, std::size_t last, const Number& zero) {
    RayMatrix<Number> m{zero + 1.0, zero, zero, zero + 1.0};
    for (std::size_t i = first; i <= last; ++i) {
        const RefractingSurface& s = lens.surfaces[i];
        const double power = (s.focusing_index - s.focusing_index_after) * s.shape.curvature;
        m.c = m.c - power * m.a;
        m.d = m.d - power * m.b;
        if (i < last) {
            const Number reduced = gaps[i] / s.focusing_index;
            m.a = m.a + reduced * m.c;
            m.b = m.b + reduced * m.d;
        }
    }
    return m;
}

template <class Number>
struct Pupils {
    Number entrance;      ///< From the first surface towards the sensor.
    Number exit;          ///< From the last surface towards the sensor.
    Number exit_by_stop;  ///< The radius of the exit pupil divided by that of the stop.
    Number stop_by_entrance;
};

template <class Number>
Pupils<Number> pupils_of(const LensOptics& lens, const std::vector<Number>& gaps,
                         const Number& zero) {
    // A surface that is the stop itself belongs to what is behind it.
    RayMatrix<Number> front{zero + 1.0, zero, zero, zero + 1.0};
    if (lens.stop > 0) {
        front = matrix_of(lens, gaps, 0, lens.stop - 1, zero);
        const Number reduced = gaps[lens.stop - 1] / lens.surfaces[lens.stop - 1].focusing_index;
        front.a = front.a + reduced * front.c;
        front.b = front.b + reduced * front.d;
    }
    const RayMatrix<Number> back = matrix_of(lens, gaps, lens.stop, lens.surfaces.size() - 1, zero);
    return {front.b / front.a, -(back.b / back.d), 1.0 / back.d, front.a};
}

/// Surfaces that move together along the axis to focus: from the first to the last of these.
struct FocusingGroup {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// A lens focused at a distance.
template <class Number>
struct FocusedOptics {
    std::vector<Number> vertices;  ///< The z of the surfaces on the axis.
    Number sensor;                 ///< The z of its plane.
    Truth<Number> valid;           ///< Whether the group can focus there.

    /// From the last surface to the sensor.
    [[nodiscard]] Number depth() const { return vertices.back() - sensor; }
};

/// `vergence` is 1 divided by the distance, in 1/mm, of what is sharp from the entrance pupil of
/// the lens focused at infinity. The sensor moves, or a group, while the sensor stays where it is
/// for infinity.
template <class Number>
FocusedOptics<Number> focused(const LensOptics& lens, const std::optional<FocusingGroup>& group,
                              const Number& vergence) {
    using std::sqrt;
    const Number zero = like(vergence, 0.0);
    const std::size_t count = lens.surfaces.size();
    std::vector<double> fixed;
    for (const RefractingSurface& s : lens.surfaces) {
        fixed.push_back(s.shape.gap);
    }
    const double pupil = pupils_of(lens, fixed, 0.0).entrance;
    const RayMatrix<double> whole = matrix_of(lens, fixed, 0, count - 1, 0.0);
    const double infinity = -whole.a / whole.c;

    struct Moved {
        std::vector<Number> gaps;
        Number first, to_sensor;  // How far the first surface moved to the scene.
    };
    const auto moved = [&](const Number& by) {
        Moved made{{}, zero, zero + infinity};
        for (const double gap : fixed) {
            made.gaps.push_back(zero + gap);
        }
        if (!group) {
            return made;
        }
        if (group->first == 0) {
            made.first = by;
        } else {
            made.gaps[group->first - 1] = made.gaps[group->first - 1] - by;
        }
        Number& behind = group->last + 1 == count ? made.to_sensor : made.gaps[group->last];
        behind = behind + by;
        return made;
    };
    // The height at the distance d behind the lens of a ray from the point in focus on the axis,
    // times the vergence: 0 where the image is.
    const auto height = [&](const Moved& m, const Number& d) {
        const RayMatrix<Number> matrix = matrix_of(lens, m.gaps, 0, count - 1, zero);
        const Number far = 1.0 - vergence * (pupil + m.first);
        return matrix.a * far + matrix.b * vergence + d * (matrix.c * far + matrix.d * vergence);
    };
    Moved made = moved(zero);
    Truth<Number> valid = always(vergence);
    if (group) {
        // A quadratic function of the movement, by three of its values.
        const auto at = [&](double by) {
            const Moved m = moved(zero + by);
            return height(m, m.to_sensor);
        };
        const Number c = at(0.0);
        const Number up = at(1.0);
        const Number down = at(-1.0);
        const Number b = 0.5 * (up - down);
        const Number a = 0.5 * (up + down) - c;
        const Number square = b * b - 4.0 * a * c;
        valid = 0.0 <= square;
        const Number root = sqrt(select(valid, square, zero));
        made = moved(-2.0 * c / (b + select(b < 0.0, -root, root)));
    } else {
        const Number on = height(made, zero);
        made.to_sensor = -on / (height(made, zero + 1.0) - on);
    }
    FocusedOptics<Number> all{{made.first}, zero, valid};
    for (std::size_t i = 0; i + 1 < count; ++i) {
        all.vertices.push_back(all.vertices.back() - made.gaps[i]);
    }
    all.sensor = all.vertices.back() - made.to_sensor - lens.defocus;
    return all;
}

// --------------------------------------------------------------------------------- refraction

/// A ray on its way through a lens.
template <class Number>
struct LensPath {
    std::array<Number, 3> point;
    std::array<Number, 3> direction;  ///< Unit length.
    Truth<Number> refracted;          ///< Whether it met all surfaces and was refracted there.
    Truth<Number> passed;             ///< Whether it also passed all holes.
    std::array<Number, 2> at_stop;
};

/// What the conic and the polynomial of a surface add, by the square of the distance from the axis.
template <class Number>
struct Profile {
    Number height;  ///< Towards the scene.
    Number slope;   ///< The derivative by the distance, divided by the distance.
    Truth<Number> exists;
};

template <class Number>
Profile<Number> profile_at(const LensSurface& s, const Number& h2) {
    using std::max;
    using std::sqrt;
    const double c = -s.curvature;
    const Number square = 1.0 - (1.0 + s.conic) * c * c * h2;
    const Number zero = like(h2, 0.0);
    const Number root = sqrt(max(square, zero));
    Number height = zero;
    Number slope = zero;
    for (std::size_t i = s.aspheric.size(); i-- > 0;) {
        const double power = 2.0 * static_cast<double>(i) + 4.0;
        height = h2 * height - s.aspheric[i];
        slope = h2 * slope - power * s.aspheric[i];
    }
    return {c * h2 / (1.0 + root) + h2 * h2 * height, c / root + h2 * slope, 0.0 < square};
}

/// A surface at a point (x, y).
template <class Number>
struct Height {
    Number height;      ///< Towards the scene.
    Number by_x, by_y;  ///< Its derivatives.
    Truth<Number> exists;
};

/// With the height p of the profile at y and k the horizontal curvature, a toroidal surface is a
/// circle of curvature k/(1 - k p) at the height p: k z² - 2 z = k p² - 2 p - k x², which is solved
/// so that nothing cancels where k is small.
template <class Number>
Height<Number> height_at(const LensSurface& s, const Number& x, const Number& y) {
    using std::max;
    using std::sqrt;
    if (!s.curvature_x) {
        const Profile<Number> p = profile_at(s, Number(x * x + y * y));
        return {p.height, p.slope * x, p.slope * y, p.exists};
    }
    const double k = -*s.curvature_x;
    const Profile<Number> p = profile_at(s, Number(y * y));
    const Number width = 1.0 - k * p.height;
    const Number square = width * width - k * k * (x * x);
    const Number root = sqrt(max(square, like(x, 0.0)));
    return {(p.height * (1.0 + width) + k * (x * x)) / (1.0 + root), k * x / root,
            width * (p.slope * y) / root, p.exists && 0.0 < square && 0.0 < width};
}

/// The quadric a x² + b y² + c z² = 2 z that a surface is, or is near to at its vertex.
struct Quadric {
    double x, y, z;
    bool exact;  ///< Whether the surface is nothing else.

    /// x a + y b, without what is 0.
    template <class Number>
    [[nodiscard]] Number weighted(const Number& a, const Number& b) const {
        return x == y ? x * (a + b) : x == 0.0 ? y * b : y == 0.0 ? x * a : x * a + y * b;
    }
    /// Of a unit vector, by its length where the surface is one of revolution.
    template <class Number>
    [[nodiscard]] Number along(const std::array<Number, 3>& d) const {
        if (x != y) {
            return weighted(d[0] * d[0], d[1] * d[1]) + z * (d[2] * d[2]);
        }
        return x == z ? like(d[2], x) : x + (z - x) * (d[2] * d[2]);
    }
    [[nodiscard]] bool is_plane() const { return exact && x == 0.0 && y == 0.0; }
    /// Spheres and round cylinders: (x, y, z) from their centre or axis is as long as their radius.
    [[nodiscard]] bool is_round() const {
        return exact && (x == z || x == 0.0) && (y == z || y == 0.0);
    }
};

inline Quadric quadric_of(const LensSurface& s) {
    const double c = -s.curvature;
    const double of_z = c * (1.0 + s.conic);
    if (!s.curvature_x) {
        return {c, c, of_z, !s.is_aspheric()};
    }
    const double k = -*s.curvature_x;
    const bool upright = c == 0.0 && !s.is_aspheric();
    const bool level = k == 0.0 && !s.is_aspheric();
    const double of_height = upright ? k : k == 0.0 ? of_z : 0.5 * (k + of_z);
    return {k, c, of_height, upright || level};
}

/// The steps of Newton's iteration to a surface that is no quadric, from one near to it, and how
/// far in millimetres the point may be off the surface afterwards. Each step squares the error, so
/// that few rays need more than two; one that is farther off misses the lens.
inline constexpr int newton_steps = 4;
inline constexpr double newton_tolerance = 1e-9;

/// Where a ray meets a surface, seen from its vertex.
template <class Number>
struct Meeting {
    std::array<Number, 3> point;
    std::array<Number, 3> normal;  ///< Unit length, towards the scene.
    Number cosine;                 ///< Of the angle between ray and normal.
    Truth<Number> exists;
};

/// From where the ray crosses the plane through the vertex to the quadric, in closed form (Spencer
/// and Murty, "General Ray-Tracing Procedure", 1962); for other surfaces from there by Newton's
/// iteration.
template <class Number>
Meeting<Number> meeting_of(const LensSurface& s, const std::array<Number, 2>& in_plane,
                           const std::array<Number, 3>& direction) {
    using std::max;
    using std::sqrt;
    const Number& x = in_plane[0];
    const Number& y = in_plane[1];
    const Number& dx = direction[0];
    const Number& dy = direction[1];
    const Number& dz = direction[2];
    const Number zero = like(dz, 0.0);
    const Quadric quadric = quadric_of(s);
    if (quadric.is_plane()) {
        return {{x, y, zero}, {zero, zero, like(dz, 1.0)}, dz, always(dz)};
    }
    const Number f = quadric.weighted(x * x, y * y);
    const Number g = dz - quadric.weighted(x * dx, y * dy);
    const Number a = quadric.along(direction);
    const Number square = g * g - a * f;
    const Number cosine = sqrt(max(square, zero));
    Number t = f / (g + cosine);
    std::array<Number, 3> q{x + t * dx, y + t * dy, t * dz};
    if (quadric.is_round()) {
        return {q,
                {-(quadric.x * q[0]), -(quadric.y * q[1]), 1.0 - quadric.z * q[2]},
                cosine,
                0.0 < square};
    }
    Height<Number> here = height_at(s, q[0], q[1]);
    for (int i = 0; !quadric.exact && i < newton_steps; ++i) {
        t = t - (q[2] - here.height) / (dz - (here.by_x * dx + here.by_y * dy));
        q = {x + t * dx, y + t * dy, t * dz};
        here = height_at(s, q[0], q[1]);
    }
    const Number off = q[2] - here.height;
    const Number length = sqrt(1.0 + here.by_x * here.by_x + here.by_y * here.by_y);
    const std::array<Number, 3> normal{-here.by_x / length, -here.by_y / length, 1.0 / length};
    return {q, normal, dx * normal[0] + dy * normal[1] + dz * normal[2],
            0.0 < square && here.exists && off * off < newton_tolerance * newton_tolerance};
}

/// Takes a ray to a surface and through it.
template <class Number>
void refract(const RefractingSurface& surface, const Number& vertex, LensPath<Number>& ray) {
    using std::max;
    using std::sqrt;
    const LensSurface& s = surface.shape;
    const std::array<Number, 3> d = ray.direction;
    const Number to_plane = (vertex - ray.point[2]) / d[2];
    const Meeting<Number> at = meeting_of(
        s, std::array<Number, 2>{ray.point[0] + to_plane * d[0], ray.point[1] + to_plane * d[1]},
        d);
    ray.refracted = ray.refracted && 0.0 < d[2] && at.exists;
    ray.point = {at.point[0], at.point[1], vertex + at.point[2]};
    ray.passed =
        ray.passed && at.point[0] * at.point[0] + at.point[1] * at.point[1] <= s.radius * s.radius;
    if (s.stop) {
        ray.at_stop = {at.point[0], at.point[1]};
    }
    if (!surface.refracts()) {
        return;
    }
    const double ratio = surface.index / surface.index_after;
    const Number square = 1.0 - ratio * ratio * (1.0 - at.cosine * at.cosine);
    const Number bend = sqrt(max(square, like(square, 0.0))) - ratio * at.cosine;
    ray.refracted = ray.refracted && 0.0 < square;
    ray.direction = {ratio * d[0] + bend * at.normal[0], ratio * d[1] + bend * at.normal[1],
                     ratio * d[2] + bend * at.normal[2]};
}

/// Whether a point of the stop's circle is inside of its blades.
template <class Number>
Truth<Number> inside_blades(const Blades& blades, const std::array<Number, 2>& p, double radius) {
    using std::atan2;
    using std::cos;
    using std::floor;
    using std::sqrt;
    const double step = 2.0 * std::numbers::pi / static_cast<double>(blades.count);
    const Number angle = atan2(p[1], p[0]) - (0.5 * std::numbers::pi + blades.rotation);
    const Number part = angle - step * floor(angle / step);
    return sqrt(p[0] * p[0] + p[1] * p[1]) * cos(part - 0.5 * step) <=
           radius * std::cos(0.5 * step);
}

/// The ray from a point of the sensor in a direction, behind the first surface.
template <class Number>
LensPath<Number> traced(const LensOptics& lens, const FocusedOptics<Number>& at,
                        const std::array<Number, 2>& sensor,
                        const std::array<Number, 3>& direction) {
    const Truth<Number> yes = always(at.sensor);
    LensPath<Number> ray{{sensor[0], sensor[1], at.sensor}, direction, yes, yes, sensor};
    for (std::size_t i = lens.surfaces.size(); i-- > 0;) {
        refract(lens.surfaces[i], at.vertices[i], ray);
    }
    if (lens.blades.count != 0) {
        ray.passed = ray.passed &&
                     inside_blades(lens.blades, ray.at_stop, lens.surfaces[lens.stop].shape.radius);
    }
    ray.passed = ray.passed && ray.refracted;
    return ray;
}

}  // namespace balcony::camera
