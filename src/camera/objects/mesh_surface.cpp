// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the surface of a triangle mesh by its texture coordinates.

#include <algorithm>
#include <cmath>

#include "camera/families.hpp"
#include "camera/stage_parameters.hpp"

namespace balcony::camera {

namespace {

using expr::Native;
using expr::Table;
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

/// The number of the first triangle that contains a point (u, v), -1 if there is none. The cells of
/// a uniform grid over all texture coordinates list the triangles that may overlap them.
class TriangleFinder final : public Native {
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

    [[nodiscard]] std::string_view name() const override { return "triangle_at"; }
    [[nodiscard]] std::size_t arity() const override { return 2; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            results[i] = find(arguments[0][i], arguments[1][i]);
        }
    }
    [[nodiscard]] std::shared_ptr<const Native> derivative(std::size_t) const override {
        return nullptr;
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

    [[nodiscard]] double find(double u, double v) const {
        if (std::isnan(u) || std::isnan(v)) {
            return -1.0;
        }
        const std::size_t c = cell(v, 1) * side_ + cell(u, 0);
        for (std::size_t i = begins_[c]; i < begins_[c + 1]; ++i) {
            if (triangles_[lists_[i]].contains(u, v)) {
                return lists_[i];
            }
        }
        return -1.0;
    }

    std::vector<Barycentric> triangles_;
    std::array<double, 2> min_{}, max_{}, margin_{};
    std::size_t side_ = 1;
    std::vector<std::size_t> begins_;
    std::vector<std::uint32_t> lists_;  // The triangles of each cell in the order of the file.
};

/// A vector that is an affine function of (u, v) in each triangle: a + b u + c v.
class AffineByTriangle {
public:
    using Values = std::array<std::array<double, 3>, 3>;  // At the three corners.

    template <class ValuesOf>
    AffineByTriangle(const std::vector<Triangle>& triangles, const ValuesOf& values_of) {
        for (auto& of_axis : tables_) {
            for (auto& table : of_axis) {
                table = std::make_shared<Table>();
                table->axes = {{0.0, static_cast<double>(triangles.size()), triangles.size(), 0}};
                table->coefficients.reserve(triangles.size());
            }
        }
        for (const Triangle& triangle : triangles) {
            add(Barycentric(triangle), values_of(triangle));
        }
    }

    [[nodiscard]] ObjectVector emit(Expr triangle, const ParameterPoint& p) const {
        Graph& graph = triangle.graph();
        const auto along = [&](std::size_t axis) {
            const auto coefficient = [&](std::size_t k) {
                return graph.lookup(tables_[axis][k], triangle);
            };
            return coefficient(0) + coefficient(1) * p.u + coefficient(2) * p.v;
        };
        return {along(0), along(1), along(2)};
    }

private:
    void add(const Barycentric& barycentric, const Values& values) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double a = values[0][axis];
            const double b = values[1][axis] - a;
            const double c = values[2][axis] - a;
            const auto& m = barycentric.matrix;
            const double by_u = b * m[0][0] + c * m[1][0];
            const double by_v = b * m[0][1] + c * m[1][1];
            const double at_origin = a - by_u * barycentric.at[0] - by_v * barycentric.at[1];
            tables_[axis][0]->coefficients.push_back(at_origin);
            tables_[axis][1]->coefficients.push_back(by_u);
            tables_[axis][2]->coefficients.push_back(by_v);
        }
    }

    std::array<std::array<std::shared_ptr<Table>, 3>, 3> tables_;
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

AffineByTriangle::Values positions_of(const Triangle& t) {
    return {t[0].position, t[1].position, t[2].position};
}

AffineByTriangle::Values smooth_normals_of(const Triangle& t) {
    return {t[0].normal, t[1].normal, t[2].normal};
}

AffineByTriangle::Values flat_normals_of(const Triangle& t) {
    const std::array<double, 3> normal = face_normal(t);
    return {normal, normal, normal};
}

/// Piecewise affine: in each triangle, (u, v) are the texture coordinates.
class MeshSurface final : public ObjectGenerator {
public:
    MeshSurface(const std::vector<Triangle>& triangles, bool smooth)
        : finder_(std::make_shared<const TriangleFinder>(triangles)),
          position_(triangles, positions_of),
          normal_(triangles, smooth ? smooth_normals_of : flat_normals_of) {}

    int dimension() const override { return 2; }

    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr triangle = triangle_at(p, emit);
        emit.require(0.0 <= triangle);
        const ObjectVector from_origin = position_.emit(triangle, p);
        return {from_origin.x, from_origin.y, from_origin.z};
    }

    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        return normal_.emit(triangle_at(p, emit), p);
    }

private:
    [[nodiscard]] Expr triangle_at(const ParameterPoint& p, const Emitter& emit) const {
        const std::array at{p.u, p.v};
        return emit.graph().native(finder_, at);
    }

    std::shared_ptr<const TriangleFinder> finder_;
    AffineByTriangle position_, normal_;
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

Result<std::shared_ptr<const Stage>> make_mesh(const Arguments& a) {
    std::vector<Triangle> triangles;
    const auto& all = a.mesh("file")->triangles;
    std::copy_if(all.begin(), all.end(), std::back_inserter(triangles), usable);
    if (triangles.empty()) {
        return error(
            "no triangle of this mesh has an area both in space and in texture coordinates", {},
            "unwrap the mesh in the modelling program and export it again");
    }
    return made<MeshSurface>(triangles, a.choice("normals") == "smooth");
}

}  // namespace

std::vector<StageEntry> mesh_surface() {
    return {
        {StageKind::object_generator,
         "mesh",
         "the surface of a triangle mesh from a file, by its texture coordinates",
         {{.name = "file",
           .type = ParameterType::mesh,
           .meaning = "mesh file with texture coordinates; (0, 0) is the bottom left"},
          {.name = "normals",
           .type = ParameterType::choice,
           .choices = {"smooth", "flat"},
           .meaning = "normals interpolated from the vertices, or those of the faces"}},
         make_mesh,
         {},
         2,
         R"(
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
