// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/implicit_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <tbb/parallel_for.h>

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V3d;

using Index = std::size_t;
using Corner = std::array<Index, 3>;

// The values of a field at the corners of cells.
class Lattice {
public:
    Lattice(const Field& field, const Imath::Box3d& box, double cell, double steepness)
        : field_(field), origin_(box.min), cell_(cell) {
        for (int axis = 0; axis < 3; ++axis) {
            const double blocks = std::ceil(box.size()[axis] / (cell * block));
            blocks_[Index(axis)] = std::max<Index>(1, static_cast<Index>(blocks));
            count_[Index(axis)] = blocks_[Index(axis)] * block + 1;
        }
        values_.resize(count_[0] * count_[1] * count_[2]);
        // A block far from the surface has the sign of its middle everywhere.
        const double reach = steepness * 0.5 * std::sqrt(3.0) * block * cell;
        tbb::parallel_for(Index{0}, blocks_[0] * blocks_[1] * blocks_[2], [&](Index i) {
            const Corner first{i % blocks_[0] * block, i / blocks_[0] % blocks_[1] * block,
                               i / blocks_[0] / blocks_[1] * block};
            const double middle = field(place(first) + V3d(0.5 * block * cell));
            fill(first, std::abs(middle) > reach ? &middle : nullptr);
        });
    }

    [[nodiscard]] const Corner& count() const { return count_; }
    [[nodiscard]] Index index(const Corner& c) const {
        return (c[2] * count_[1] + c[1]) * count_[0] + c[0];
    }
    [[nodiscard]] double value(const Corner& c) const { return values_[index(c)]; }
    [[nodiscard]] V3d place(const Corner& c) const {
        return origin_ + cell_ * V3d(double(c[0]), double(c[1]), double(c[2]));
    }

private:
    static constexpr Index block = 8;

    // Blocks own their corners but those on their upper sides, which the next block owns or which
    // are the lattice's last.
    void fill(const Corner& first, const double* constant) {
        Corner end;
        for (Index axis = 0; axis < 3; ++axis) {
            const bool last = first[axis] + block + 1 == count_[axis];
            end[axis] = first[axis] + block + (last ? 1 : 0);
        }
        for (Index z = first[2]; z < end[2]; ++z) {
            for (Index y = first[1]; y < end[1]; ++y) {
                for (Index x = first[0]; x < end[0]; ++x) {
                    const Corner corner{x, y, z};
                    values_[index(corner)] =
                        static_cast<float>(constant != nullptr ? *constant : field_(place(corner)));
                }
            }
        }
    }

    const Field& field_;
    V3d origin_;
    double cell_;
    Corner blocks_{};
    Corner count_{};
    std::vector<float> values_;
};

V3d gradient(const Field& field, const V3d& at, double step) {
    V3d slope;
    for (int axis = 0; axis < 3; ++axis) {
        V3d aside(0.0);
        aside[axis] = step;
        slope[axis] = (field(at + aside) - field(at - aside)) / (2.0 * step);
    }
    return slope;
}

// Where the field changes its sign along the edges of a cell, on average; false if nowhere.
bool crossing(const Lattice& lattice, const Corner& cell, V3d& middle) {
    V3d sum(0.0);
    int edges = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Corner from{cell[0] + (corner & 1U), cell[1] + (corner >> 1U & 1U),
                          cell[2] + (corner >> 2U)};
        for (Index axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1U) == 0) {
                Corner to = from;
                ++to[axis];
                const double a = lattice.value(from);
                const double b = lattice.value(to);
                if ((a < 0.0) != (b < 0.0)) {
                    const V3d start = lattice.place(from);
                    sum += start + (lattice.place(to) - start) * (a / (a - b));
                    ++edges;
                }
            }
        }
    }
    middle = sum / std::max(edges, 1);
    return edges > 0;
}

void add_unless_flat(Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const scene::V3f& a = mesh.positions[corners[0]];
    const scene::V3f across =
        (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
    if (across.length2() > 0.0F) {
        mesh.triangles.push_back(corners);
    }
}

}  // namespace

Mesh implicit_surface(const Field& field, const Imath::Box3d& box, double cell, double steepness) {
    const Lattice lattice(field, box, cell, steepness);
    const Corner& count = lattice.count();
    Mesh mesh;
    // A vertex for each cell that the surface passes through.
    std::vector<std::uint32_t> vertices(count[0] * count[1] * count[2]);
    std::vector<V3d> places;
    for (Index z = 0; z + 1 < count[2]; ++z) {
        for (Index y = 0; y + 1 < count[1]; ++y) {
            for (Index x = 0; x + 1 < count[0]; ++x) {
                V3d middle;
                if (crossing(lattice, {x, y, z}, middle)) {
                    vertices[lattice.index({x, y, z})] = static_cast<std::uint32_t>(places.size());
                    places.push_back(middle);
                }
            }
        }
    }
    mesh.positions.resize(places.size());
    mesh.normals.resize(places.size());
    tbb::parallel_for(Index{0}, places.size(), [&](Index i) {
        const V3d slope = gradient(field, places[i], 0.25 * cell);
        const V3d place = places[i] - slope * (field(places[i]) / std::max(slope.length2(), 0.1));
        mesh.positions[i] = scene::V3f(place);
        mesh.normals[i] = scene::V3f(gradient(field, place, 0.5 * cell).normalized());
    });
    // Two triangles for each edge that the surface crosses, between the four cells around it.
    for (Index z = 1; z + 1 < count[2]; ++z) {
        for (Index y = 1; y + 1 < count[1]; ++y) {
            for (Index x = 1; x + 1 < count[0]; ++x) {
                const Corner at{x, y, z};
                const bool inside = lattice.value(at) < 0.0;
                for (Index axis = 0; axis < 3; ++axis) {
                    Corner next = at;
                    ++next[axis];
                    if (inside == (lattice.value(next) < 0.0)) {
                        continue;
                    }
                    const auto around = [&](Index back_a, Index back_b) {
                        Corner corner = at;
                        corner[(axis + 1) % 3] -= back_a;
                        corner[(axis + 2) % 3] -= back_b;
                        return vertices[lattice.index(corner)];
                    };
                    const auto a = around(1, 1);
                    const auto b = inside ? around(0, 1) : around(1, 0);
                    const auto c = around(0, 0);
                    const auto d = inside ? around(1, 0) : around(0, 1);
                    add_unless_flat(mesh, {a, b, c});
                    add_unless_flat(mesh, {a, c, d});
                }
            }
        }
    }
    return mesh;
}

double smooth_min(double a, double b, double width) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * h * h * width;
}

}  // namespace balcony::plates
