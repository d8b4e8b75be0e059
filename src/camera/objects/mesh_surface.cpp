// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the surface of a triangle mesh by its texture coordinates.

#include <algorithm>
#include <cmath>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/objects/ray_targets.hpp"

namespace balcony::camera {

namespace {

using expr::Native;
using Corner = TexturedMesh::Corner;
using Triangle = std::array<Corner, 3>;

/// Barycentric coordinates (l1, l2) of a point (u, v) are matrix * ((u, v) - the first corner).
struct Barycentric {
    explicit Barycentric(const Triangle& t) : at(t[0].uv) {
        const double bu = t[1].uv[0] - at[0], bv = t[1].uv[1] - at[1];
        const double cu = t[2].uv[0] - at[0], cv = t[2].uv[1] - at[1];
        const double area = bu * cv - bv * cu;
        matrix = {{{cv / area, -cu / area}, {-bv / area, bu / area}}};
    }

    [[nodiscard]] bool finite() const {
        return std::isfinite(matrix[0][0] + matrix[0][1]) &&
               std::isfinite(matrix[1][0] + matrix[1][1]);
    }

    [[nodiscard]] bool contains(double u, double v) const {
        // Tolerance, so that rounding leaves no gap between neighbours.
        constexpr double slack = 1e-9;
        const double du = u - at[0], dv = v - at[1];
        const double l1 = matrix[0][0] * du + matrix[0][1] * dv;
        const double l2 = matrix[1][0] * du + matrix[1][1] * dv;
        return l1 >= -slack && l2 >= -slack && l1 + l2 <= 1.0 + slack;
    }

    std::array<double, 2> at;
    std::array<std::array<double, 2>, 2> matrix;
};

/// Finds the first triangle that contains a point (u, v). The cells of a uniform grid over all
/// texture coordinates list the triangles that may overlap them.
class TriangleFinder {
public:
    explicit TriangleFinder(const std::vector<Triangle>& triangles) {
        for (const Triangle& triangle : triangles) {
            triangles_.emplace_back(triangle);
        }
        measure(triangles);
        // About as many cells as triangles; fewer if large triangles would be listed too often.
        const auto count = static_cast<double>(triangles.size());
        side_ = static_cast<std::size_t>(std::clamp(std::sqrt(count), 1.0, 2048.0));
        constexpr std::size_t max_entries_per_triangle = 16;
        while (side_ > 1 && entries(triangles) > max_entries_per_triangle * triangles.size()) {
            side_ /= 2;
        }
        fill(triangles);
    }

    [[nodiscard]] std::optional<std::size_t> operator()(double u, double v) const {
        if (std::isnan(u) || std::isnan(v)) {
            return std::nullopt;
        }
        const std::size_t c = cell(v, 1) * side_ + cell(u, 0);
        for (std::size_t i = begins_[c]; i < begins_[c + 1]; ++i) {
            if (triangles_[lists_[i]].contains(u, v)) {
                return lists_[i];
            }
        }
        return std::nullopt;
    }

private:
    struct Cells {
        std::array<std::size_t, 2> first, last;
    };

    void measure(const std::vector<Triangle>& triangles) {
        min_ = max_ = triangles.front()[0].uv;
        for (const Triangle& triangle : triangles) {
            for (const Corner& corner : triangle) {
                for (std::size_t k = 0; k < 2; ++k) {
                    min_[k] = std::min(min_[k], corner.uv[k]);
                    max_[k] = std::max(max_[k], corner.uv[k]);
                }
            }
        }
        for (std::size_t k = 0; k < 2; ++k) {
            margin_[k] = 1e-6 * (max_[k] - min_[k]);
        }
    }

    // The cell of a coordinate along an axis; coordinates outside belong to the border cells.
    [[nodiscard]] std::size_t cell(double place, std::size_t axis) const {
        const double all = static_cast<double>(side_);
        const double at = (place - min_[axis]) / (max_[axis] - min_[axis]) * all;
        return static_cast<std::size_t>(std::clamp(at, 0.0, all - 1.0));
    }

    [[nodiscard]] Cells cells(const Triangle& t) const {
        Cells made{};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [minimum, maximum] = std::minmax({t[0].uv[k], t[1].uv[k], t[2].uv[k]});
            made.first[k] = cell(minimum - margin_[k], k);
            made.last[k] = cell(maximum + margin_[k], k);
        }
        return made;
    }

    [[nodiscard]] std::size_t entries(const std::vector<Triangle>& triangles) const {
        std::size_t count = 0;
        for (const Triangle& triangle : triangles) {
            const Cells c = cells(triangle);
            count += (c.last[0] - c.first[0] + 1) * (c.last[1] - c.first[1] + 1);
        }
        return count;
    }

    template <class Visit>
    void for_each_entry(const std::vector<Triangle>& triangles, const Visit& visit) const {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Cells c = cells(triangles[i]);
            for (std::size_t row = c.first[1]; row <= c.last[1]; ++row) {
                for (std::size_t column = c.first[0]; column <= c.last[0]; ++column) {
                    visit(row * side_ + column, static_cast<std::uint32_t>(i));
                }
            }
        }
    }

    // Counting sort: begins_[c] is first the end of a cell's list, then its start.
    void fill(const std::vector<Triangle>& triangles) {
        begins_.assign(side_ * side_ + 1, 0);
        for_each_entry(triangles, [&](std::size_t c, std::uint32_t) { ++begins_[c + 1]; });
        for (std::size_t c = 0; c < side_ * side_; ++c) {
            begins_[c + 1] += begins_[c];
        }
        std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
        lists_.resize(begins_.back());
        for_each_entry(triangles,
                       [&](std::size_t c, std::uint32_t number) { lists_[next[c]++] = number; });
    }

    std::vector<Barycentric> triangles_;
    std::array<double, 2> min_{}, max_{}, margin_{};
    std::size_t side_ = 1;
    std::vector<std::size_t> begins_;
    std::vector<std::uint32_t> lists_;  // The triangles of each cell in the order of the file.
};

/// A value that is an affine function of (u, v) in a triangle.
struct Affine {
    double at_origin, by_u, by_v;

    /// With these values at the corners.
    static Affine through(const Barycentric& barycentric, const std::array<double, 3>& values) {
        const double b = values[1] - values[0];
        const double c = values[2] - values[0];
        const auto& m = barycentric.matrix;
        const double by_u = b * m[0][0] + c * m[1][0];
        const double by_v = b * m[0][1] + c * m[1][1];
        return {values[0] - by_u * barycentric.at[0] - by_v * barycentric.at[1], by_u, by_v};
    }

    [[nodiscard]] double operator()(double u, double v) const {
        return at_origin + by_u * u + by_v * v;
    }
};

std::array<double, 3> face_normal(const Triangle& t) {
    const auto side = [&t](std::size_t i, std::size_t k) {
        return t[i].position[k] - t[0].position[k];
    };
    std::array<double, 3> normal{side(1, 1) * side(2, 2) - side(1, 2) * side(2, 1),
                                 side(1, 2) * side(2, 0) - side(1, 0) * side(2, 2),
                                 side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)};
    // The side of the vertex normals, regardless of the winding.
    double agreement = 0.0;
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        agreement += normal[k] * (t[0].normal[k] + t[1].normal[k] + t[2].normal[k]);
        length += normal[k] * normal[k];
    }
    const double factor = (agreement < 0.0 ? -1.0 : 1.0) / std::sqrt(length);
    for (double& coordinate : normal) {
        coordinate *= factor;
    }
    return normal;
}

/// Position and normal, each along x, y and z.
constexpr std::size_t value_count = 6;
using Values = std::array<Affine, value_count>;

Values values_in(const Triangle& triangle, bool smooth) {
    const Barycentric barycentric(triangle);
    const std::array<double, 3> flat = face_normal(triangle);
    Values values{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, 3> position{};
        std::array<double, 3> normal{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            position[corner] = triangle[corner].position[axis];
            normal[corner] = smooth ? triangle[corner].normal[axis] : flat[axis];
        }
        values[axis] = Affine::through(barycentric, position);
        values[3 + axis] = Affine::through(barycentric, normal);
    }
    return values;
}

/// The triangles of a mesh by their texture coordinates.
class Triangles {
public:
    Triangles(const std::vector<Triangle>& triangles, bool smooth) : finder_(triangles) {
        for (const Triangle& triangle : triangles) {
            values_.push_back(values_in(triangle, smooth));
        }
    }

    struct Found {
        const Values& values;
        bool inside;  ///< Else the values are those of any triangle.
    };
    [[nodiscard]] Found operator()(double u, double v) const {
        const std::optional<std::size_t> number = finder_(u, v);
        return {values_[number.value_or(0)], number.has_value()};
    }

private:
    TriangleFinder finder_;
    std::vector<Values> values_;
};

/// (u, v) to how each value changes by u and by v; constant in each triangle.
class MeshSlopes final : public Native {
public:
    explicit MeshSlopes(std::shared_ptr<const Triangles> triangles)
        : triangles_(std::move(triangles)) {}

    std::string_view name() const override { return "mesh_slopes"; }
    std::size_t argument_count() const override { return 2; }
    std::size_t result_count() const override { return 2 * value_count; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            const Values& values = (*triangles_)(arguments[0][i], arguments[1][i]).values;
            for (std::size_t k = 0; k < value_count; ++k) {
                results[2 * k][i] = values[k].by_u;
                results[2 * k + 1][i] = values[k].by_v;
            }
        }
    }
    Expr derivative(std::size_t, std::size_t, std::span<const Expr>,
                    std::span<const Expr>) const override {
        return {};
    }

private:
    std::shared_ptr<const Triangles> triangles_;
};

/// (u, v) to the position and the normal there, and whether there is a triangle.
class MeshPoint final : public Native {
public:
    explicit MeshPoint(const std::shared_ptr<const Triangles>& triangles)
        : triangles_(triangles), slopes_(std::make_shared<const MeshSlopes>(triangles)) {}

    std::string_view name() const override { return "mesh"; }
    std::size_t argument_count() const override { return 2; }
    std::size_t result_count() const override { return value_count + 1; }
    std::optional<std::size_t> validity() const override { return value_count; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            const double u = arguments[0][i];
            const double v = arguments[1][i];
            const Triangles::Found found = (*triangles_)(u, v);
            for (std::size_t k = 0; k < value_count; ++k) {
                results[k][i] = found.values[k](u, v);
            }
            results[value_count][i] = found.inside ? 1.0 : 0.0;
        }
    }
    Expr derivative(std::size_t result, std::size_t argument, std::span<const Expr> at,
                    std::span<const Expr>) const override {
        return result == value_count ? Expr{}
                                     : at[0].graph().call(slopes_, at)[2 * result + argument];
    }

private:
    std::shared_ptr<const Triangles> triangles_;
    std::shared_ptr<const MeshSlopes> slopes_;
};

/// Piecewise affine: in each triangle, (u, v) are the texture coordinates.
class MeshSurface final : public ObjectGenerator {
public:
    /// The triangles are the usable ones of the mesh.
    MeshSurface(const std::vector<Triangle>& triangles, bool smooth,
                std::shared_ptr<const TexturedMesh> mesh)
        : point_(std::make_shared<const MeshPoint>(
              std::make_shared<const Triangles>(triangles, smooth))),
          mesh_(std::move(mesh)) {}

    int dimension() const override { return 2; }

    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> at = emit.call(point_, std::array{p.u, p.v});
        return {at[0], at[1], at[2]};
    }

    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> at = emit.call(point_, std::array{p.u, p.v});
        return ObjectVector{at[3], at[4], at[5]};
    }

    std::shared_ptr<const RayTarget> ray_target() const override {
        return triangles_target(mesh_->triangles);
    }

private:
    std::shared_ptr<const MeshPoint> point_;
    std::shared_ptr<const TexturedMesh> mesh_;
};

bool usable(const Triangle& triangle) {
    double sum = 0.0;
    for (const Corner& corner : triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum += corner.position[k] + corner.normal[k];
        }
    }
    const std::array<double, 3> normal = face_normal(triangle);
    return std::isfinite(sum) && std::isfinite(normal[0] + normal[1] + normal[2]) &&
           Barycentric(triangle).finite();
}

StageResult make_mesh(const Arguments& a) {
    std::vector<Triangle> triangles;
    const auto& all = a.file<TexturedMesh>("file")->triangles;
    std::copy_if(all.begin(), all.end(), std::back_inserter(triangles), usable);
    if (triangles.empty()) {
        return error(
            "no triangle of this mesh has an area both in space and in texture coordinates", {},
            "unwrap the mesh in the modelling program and export it again");
    }
    return made<MeshSurface>(triangles, a.choice("normals") == "smooth",
                             a.file<TexturedMesh>("file"));
}

}  // namespace

std::vector<StageEntry> mesh_surface() {
    return {
        {.name = "mesh",
         .meaning = "the surface of a triangle mesh from a file, by its texture coordinates",
         .formula = R"(
p = b₁P₁ + b₂P₂ + b₃P₃
in the triangle with (u, v) = b₁t₁ + b₂t₂ + b₃t₃,   bᵢ ≥ 0,   b₁ + b₂ + b₃ = 1
n = b₁n₁ + b₂n₂ + b₃n₃ for smooth, (P₂ − P₁) × (P₃ − P₁) for flat
Pᵢ, tᵢ, nᵢ   positions, texture coordinates and normals of the corners
no ray outside all triangles
)",
         .parameters = {{.name = "file",
                         .type = MeshParameter{},
                         .meaning =
                             "mesh file with texture coordinates; (0, 0) is the bottom left"},
                        choice_parameter(
                            "normals", {"smooth", "flat"},
                            "normals interpolated from the vertices, or those of the faces")},
         .make = make_mesh,
         .dimension = 2,
         .example = R"(
// An unrolled vase: every ray starts on it and follows its normal.
camera unrolled_vase {
    aspect 2
    map  u = 1 .. 0, v = 0 .. 1
    eye  mesh("vase.obj")
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
