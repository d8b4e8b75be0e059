// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/lenses/lenses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace balcony::dataset {

namespace {

using Imath::V2d;
using Matrix = Eigen::Matrix3d;
using Rows = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double tolerance = 1e-6;  // Of pixels.

/// Points of the picture and the directions that they show, in the axes of OpenCV.
struct Sights {
    std::span<const V2d> points;
    std::vector<V3d> directions;
};

V3d in_opencv(const V3d& v) { return {-v.y, -v.z, v.x}; }

// The numbers that solve rows * numbers = right best, with columns of about the same size.
Vector least_squares(Rows rows, const Vector& right) {
    Vector scales = rows.colwise().norm();
    for (Eigen::Index i = 0; i < scales.size(); ++i) {
        scales[i] = scales[i] > 0.0 ? scales[i] : 1.0;
        rows.col(i) /= scales[i];
    }
    const Vector found = rows.colPivHouseholderQr().solve(right);
    return found.cwiseQuotient(scales);
}

/// A model: where directions arrive, by numbers that begin with fx, fy, cx, cy.
struct Model {
    std::string_view name;
    std::vector<std::string_view> names;
    std::optional<std::vector<double>> (*numbers)(const Sights& sights);
    V2d (*project)(std::span<const double> numbers, const V3d& direction);
};

// ------------------------------------------------------------------------------------- pinhole

V2d project_pinhole(std::span<const double> n, const V3d& d) {
    return {n[0] * d.x / d.z + n[2], n[1] * d.y / d.z + n[3]};
}

std::optional<std::vector<double>> no_numbers(const Sights& /*sights*/) { return std::nullopt; }

// -------------------------------------------------------- distortion as a polynomial of x and y

// Both coordinates of the points are linear in what is sought: x = cx + fx * p(k, direction), and y
// likewise. `terms` gives, of a direction, the terms that k1, k2, ... multiply, of x and of y,
// behind that of the focal length.
template <class Terms>
std::optional<std::vector<double>> by_terms(const Sights& sights, const Terms& terms,
                                            std::size_t count) {
    const auto rows = static_cast<Eigen::Index>(sights.points.size());
    const auto columns = static_cast<Eigen::Index>(count + 2);
    Rows of_x(rows, columns);
    Vector right(rows);
    std::vector<std::vector<V2d>> all;
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto index = static_cast<std::size_t>(i);
        all.push_back(terms(sights.directions[index]));
        of_x(i, 0) = 1.0;
        for (Eigen::Index j = 1; j < columns; ++j) {
            of_x(i, j) = all.back()[static_cast<std::size_t>(j - 1)].x;
        }
        right[i] = sights.points[index].x;
    }
    const Vector x = least_squares(of_x, right);
    if (!(x[1] > 0.0)) {  // Otherwise a mirror image.
        return std::nullopt;
    }
    Rows of_y(rows, 2);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto index = static_cast<std::size_t>(i);
        double sum = all[index][0].y;
        for (std::size_t j = 1; j <= count; ++j) {
            sum += x[static_cast<Eigen::Index>(j + 1)] / x[1] * all[index][j].y;
        }
        of_y(i, 0) = 1.0;
        of_y(i, 1) = sum;
        right[i] = sights.points[index].y;
    }
    const Vector y = least_squares(of_y, right);
    if (!(y[1] > 0.0)) {
        return std::nullopt;
    }
    std::vector<double> numbers{x[1], y[1], x[0], y[0]};
    for (std::size_t j = 1; j <= count; ++j) {
        numbers.push_back(x[static_cast<Eigen::Index>(j + 1)] / x[1]);
    }
    return numbers;
}

template <class Terms>
V2d project_by_terms(std::span<const double> n, const V3d& direction, const Terms& terms) {
    const std::vector<V2d> all = terms(direction);
    V2d sum = all[0];
    for (std::size_t j = 1; j < all.size(); ++j) {
        sum += n[3 + j] * all[j];
    }
    return {n[0] * sum.x + n[2], n[1] * sum.y + n[3]};
}

// Of fx, k1, k2, p1, p2, k3: OpenCV's documentation of calib3d.
std::vector<V2d> opencv_terms(const V3d& d) {
    const V2d p(d.x / d.z, d.y / d.z);
    const double r2 = p.length2();
    return {p,
            r2 * p,
            r2 * r2 * p,
            {2.0 * p.x * p.y, r2 + 2.0 * p.y * p.y},
            {r2 + 2.0 * p.x * p.x, 2.0 * p.x * p.y},
            r2 * r2 * r2 * p};
}

// Of fx, k1 .. k4: OpenCV's documentation of fisheye, with the angle from the axis.
std::vector<V2d> fisheye_terms(const V3d& d) {
    const double across = std::hypot(d.x, d.y);
    const double angle = std::atan2(across, d.z);
    const V2d p = across > 0.0 ? angle / across * V2d(d.x, d.y) : V2d(0.0);
    const double a2 = angle * angle;
    return {p, a2 * p, a2 * a2 * p, a2 * a2 * a2 * p, a2 * a2 * a2 * a2 * p};
}

// The sphere of Mei and Rives (2007): a direction of unit length, seen from xi behind its centre.
// Of fx, k1, k2, p1, p2.
std::vector<V2d> omnidirectional_terms(const V3d& d, double xi) {
    const V3d unit = d.normalized();
    const V2d p(unit.x / (unit.z + xi), unit.y / (unit.z + xi));
    const double r2 = p.length2();
    return {p,
            r2 * p,
            r2 * r2 * p,
            {2.0 * p.x * p.y, r2 + 2.0 * p.y * p.y},
            {r2 + 2.0 * p.x * p.x, 2.0 * p.x * p.y}};
}

V2d project_opencv(std::span<const double> n, const V3d& d) {
    return project_by_terms(n, d, opencv_terms);
}
V2d project_fisheye(std::span<const double> n, const V3d& d) {
    return project_by_terms(n, d, fisheye_terms);
}
V2d project_omnidirectional(std::span<const double> n, const V3d& d) {
    const double xi = n.back();
    return project_by_terms(n.first(n.size() - 1), d,
                            [xi](const V3d& v) { return omnidirectional_terms(v, xi); });
}

bool all_ahead(const Sights& sights) {
    return std::all_of(sights.directions.begin(), sights.directions.end(),
                       [](const V3d& d) { return d.z > 0.0; });
}

std::optional<std::vector<double>> opencv_numbers(const Sights& sights) {
    constexpr std::size_t distortions = 5;
    return all_ahead(sights) ? by_terms(sights, opencv_terms, distortions) : std::nullopt;
}

std::optional<std::vector<double>> fisheye_numbers(const Sights& sights) {
    constexpr std::size_t distortions = 4;
    return by_terms(sights, fisheye_terms, distortions);
}

double largest_miss(const Model& model, std::span<const double> numbers, const Sights& sights) {
    double largest = 0.0;
    for (std::size_t i = 0; i < sights.points.size(); ++i) {
        const V2d miss = model.project(numbers, sights.directions[i]) - sights.points[i];
        const double length = miss.length();
        largest = std::isfinite(length) ? std::max(largest, length)
                                        : std::numeric_limits<double>::infinity();
    }
    return largest;
}

std::span<const Model> models();

// Linear but for xi, which a search by golden sections finds.
std::optional<std::vector<double>> omnidirectional_numbers(const Sights& sights) {
    constexpr std::size_t distortions = 4;
    const double lowest = std::min_element(sights.directions.begin(), sights.directions.end(),
                                           [](const V3d& a, const V3d& b) {
                                               return a.normalized().z < b.normalized().z;
                                           })
                              ->normalized()
                              .z;
    std::optional<std::vector<double>> best;
    const auto miss_at = [&](double xi) {
        best = by_terms(
            sights, [xi](const V3d& v) { return omnidirectional_terms(v, xi); }, distortions);
        if (!best) {
            return std::numeric_limits<double>::infinity();
        }
        best->push_back(xi);
        double sum = 0.0;
        for (std::size_t i = 0; i < sights.points.size(); ++i) {
            sum +=
                (project_omnidirectional(*best, sights.directions[i]) - sights.points[i]).length2();
        }
        return sum;
    };
    constexpr double largest_xi = 4.0;
    constexpr double golden = 0.6180339887498949;
    double low = std::max(0.0, -lowest + 1e-3);
    double high = largest_xi;
    for (int step = 0; step < 120; ++step) {
        const double a = high - golden * (high - low);
        const double b = low + golden * (high - low);
        const bool is_below = miss_at(a) < miss_at(b);
        (is_below ? high : low) = is_below ? b : a;
    }
    miss_at(0.5 * (low + high));
    return best;
}

std::span<const Model> models() {
    static const std::array rows{
        Model{"pinhole", {"fx", "fy", "cx", "cy"}, no_numbers, project_pinhole},
        Model{"opencv",
              {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3"},
              opencv_numbers,
              project_opencv},
        Model{"opencv_fisheye",
              {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"},
              fisheye_numbers,
              project_fisheye},
        Model{"omnidirectional",
              {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "xi"},
              omnidirectional_numbers,
              project_omnidirectional},
    };
    return rows;
}

// --------------------------------------------------------------------------- a turned pinhole

Matrix cross_matrix(const V3d& v) {
    Matrix made;
    made << 0.0, -v.z, v.y, v.z, 0.0, -v.x, -v.y, v.x, 0.0;
    return made;
}

// The matrix from (x, y, 1) to a multiple of the direction, by the linear equations direction ×
// matrix * point = 0. Points are divided by a size, so that all numbers are near 1.
Matrix point_matrix(const SampledRays& rays, double size) {
    Rows rows(static_cast<Eigen::Index>(3 * rays.points.size()), 9);
    for (std::size_t i = 0; i < rays.points.size(); ++i) {
        const Matrix cross = cross_matrix(rays.directions[i]);
        const Eigen::Vector3d point(rays.points[i].x / size, rays.points[i].y / size, 1.0);
        for (Eigen::Index row = 0; row < 3; ++row) {
            for (Eigen::Index j = 0; j < 9; ++j) {
                rows(static_cast<Eigen::Index>(3 * i) + row, j) = cross(row, j / 3) * point[j % 3];
            }
        }
    }
    const Eigen::JacobiSVD<Rows> decomposed(rows, Eigen::ComputeFullV);
    const Vector solution = decomposed.matrixV().col(8);
    Matrix made;
    made << solution[0], solution[1], solution[2], solution[3], solution[4], solution[5],
        solution[6], solution[7], solution[8];
    return made;
}

double largest_size(const SampledRays& rays) {
    double size = 1.0;
    for (const V2d& point : rays.points) {
        size = std::max({size, point.x, point.y});
    }
    return size;
}

// A pinhole that looks anywhere: the matrix is a rotation times the inverse of the intrinsics.
std::optional<Lens> turned_pinhole(const SampledRays& rays) {
    const double size = largest_size(rays);
    Matrix matrix = point_matrix(rays, size);
    const Eigen::Vector3d first(rays.points[0].x / size, rays.points[0].y / size, 1.0);
    const V3d& d = rays.directions[0];
    if ((matrix * first).dot(Eigen::Vector3d(d.x, d.y, d.z)) < 0.0) {
        matrix = -matrix;
    }
    const Eigen::HouseholderQR<Matrix> decomposed(matrix);
    Matrix rotation = decomposed.householderQ();
    Matrix upper = decomposed.matrixQR().triangularView<Eigen::Upper>();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (upper(i, i) < 0.0) {
            upper.row(i) = -upper.row(i);
            rotation.col(i) = -rotation.col(i);
        }
        if (!(upper(i, i) > 0.0)) {
            return std::nullopt;
        }
    }
    if (rotation.determinant() < 0.0) {  // A mirror image.
        return std::nullopt;
    }
    Matrix intrinsics = upper.inverse();
    intrinsics /= intrinsics(2, 2);
    Lens lens;
    lens.model = models()[0].name;
    lens.names = models()[0].names;
    lens.numbers = {size * intrinsics(0, 0), size * intrinsics(1, 1), size * intrinsics(0, 2),
                    size * intrinsics(1, 2)};
    // The columns are OpenCV's axes; Balcony's are ahead, left and up.
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        lens.in_camera.rotation[i] = {rotation(row, 2), -rotation(row, 0), -rotation(row, 1)};
    }
    return lens;
}

Sights sights_of(const SampledRays& rays, const camera::Pose& in_camera) {
    Sights made{rays.points, {}};
    const camera::Pose turn{.rotation = in_camera.rotation, .position = {}};
    for (const V3d& d : rays.directions) {
        made.directions.push_back(in_opencv(app::point_at(turn, d)));
    }
    return made;
}

// What is nearly the camera's own axes is that exactly.
void settle(camera::Pose& pose) {
    constexpr double rounding = 1e-12;
    const camera::Pose own;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (std::abs(pose.rotation[i][j] - own.rotation[i][j]) > rounding) {
                return;
            }
        }
    }
    pose.rotation = own.rotation;
}

// A coefficient of a distortion that rounding has left is none.
void settle(std::vector<double>& numbers) {
    constexpr std::size_t first_coefficient = 4;
    constexpr double rounding = 1e-12;
    for (std::size_t i = first_coefficient; i < numbers.size(); ++i) {
        numbers[i] = std::abs(numbers[i]) < rounding ? 0.0 : numbers[i];
    }
}

}  // namespace

double Lens::number(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? numbers[static_cast<std::size_t>(found - names.begin())] : 0.0;
}

std::optional<V3d> viewpoint_of(const SampledRays& rays) {
    constexpr double rounding = 1e-12;
    if (rays.origins.empty()) {
        return std::nullopt;
    }
    const V3d& first = rays.origins.front();
    const bool is_one = std::all_of(rays.origins.begin(), rays.origins.end(), [&](const V3d& o) {
        return (o - first).length() <= rounding * std::max(1.0, first.length());
    });
    return is_one ? std::optional(first) : std::nullopt;
}

std::optional<Lens> lens_of(const SampledRays& rays) {
    constexpr std::size_t fewest = 12;
    const std::optional<V3d> viewpoint = viewpoint_of(rays);
    if (!viewpoint || rays.points.size() < fewest) {
        return std::nullopt;
    }
    const std::array position{viewpoint->x, viewpoint->y, viewpoint->z};
    if (std::optional<Lens> pinhole = turned_pinhole(rays)) {
        settle(pinhole->in_camera);
        const Sights sights = sights_of(rays, pinhole->in_camera);
        if (all_ahead(sights) && largest_miss(models()[0], pinhole->numbers, sights) < tolerance) {
            pinhole->in_camera.position = position;
            return pinhole;
        }
    }
    camera::Pose in_camera;
    const Sights sights = sights_of(rays, in_camera);
    in_camera.position = position;
    for (const Model& model : models()) {
        auto numbers = model.numbers(sights);
        if (numbers) {
            settle(*numbers);
        }
        if (numbers && largest_miss(model, *numbers, sights) < tolerance) {
            return Lens{model.name, model.names, *numbers, in_camera};
        }
    }
    return std::nullopt;
}

}  // namespace balcony::dataset
