// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace balcony::bridge::povray {

namespace {

std::size_t total(const MeshPicture& picture, std::size_t (*count)(const CameraMesh&)) {
    std::size_t sum = 0;
    for (const StripMesh& strip : picture.strips) {
        sum += count(strip.mesh);
    }
    return sum;
}

// Whether POV-Ray would exchange the first two vertices of this triangle, but, if its normals are
// nearly equal, not their normals: it sorts them by their order in the plane across the largest
// component of the triangle's own normal.
bool would_exchange(const V3d& a, const V3d& b, const V3d& c) {
    const V3d normal = (c - a) % (b - a);
    const V3d size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const auto turns = [&](double V3d::*u, double V3d::*v) {
        return (b.*u - c.*u) * (b.*v - a.*v) < (b.*v - c.*v) * (b.*u - a.*u);
    };
    if (size.x >= size.y && size.x >= size.z) {
        return turns(&V3d::y, &V3d::z);
    }
    return size.y >= size.z ? turns(&V3d::x, &V3d::z) : turns(&V3d::x, &V3d::y);
}

// Writes the blocks of a mesh2.
class MeshWriter {
public:
    MeshWriter(std::ofstream& file, const MeshPicture& picture, const AxesRow& axes)
        : file_(file), picture_(picture), axes_(axes) {}

    void write() {
        const std::size_t vertices =
            total(picture_, [](const CameraMesh& mesh) { return mesh.vertices.size(); });
        begin("vertex_vectors", vertices);
        for_each_mesh([&](const StripMesh& strip) {
            for (const V3f& vertex : strip.mesh.vertices) {
                add_vector(vertex);
            }
        });
        end();
        if (!picture_.single_faces) {
            begin("normal_vectors", vertices);
            for_each_mesh([&](const StripMesh& strip) {
                for (const V3f& normal : strip.mesh.normals) {
                    add_vector(normal);
                }
            });
            end();
            begin("uv_vectors", vertices);
            for_each_mesh([&](const StripMesh& strip) { add_places(strip); });
            end();
        }
        begin("face_indices",
              total(picture_, [](const CameraMesh& mesh) { return mesh.faces.size(); }));
        std::size_t first = 0;
        for_each_mesh([&](const StripMesh& strip) {
            for (const Face& face : strip.mesh.faces) {
                add_face(strip.mesh, face, first);
            }
            first += strip.mesh.vertices.size();
        });
        end();
        flush();
    }

private:
    template <class Visit>
    void for_each_mesh(const Visit& visit) {
        for (const StripMesh& strip : picture_.strips) {
            visit(strip);
        }
    }

    void begin(std::string_view name, std::size_t count) {
        fmt::format_to(std::back_inserter(text_), "{} {{ {}", name, count);
    }
    void end() { fmt::format_to(std::back_inserter(text_), " }}\n"); }

    [[nodiscard]] V3d in_scene(const V3f& v) const { return axes_.from_y_up(V3d(v)); }

    // The shortest text of each float.
    void add_vector(const V3f& v) {
        const V3f at(in_scene(v));
        fmt::format_to(std::back_inserter(text_), ",\n<{},{},{}>", at.x, at.y, at.z);
        flush_if_long();
    }

    // POV-Ray 3.7 looks for the pixel in column i and row j at (i/width, 1 - j/height).
    void add_places(const StripMesh& strip) {
        const auto width = static_cast<double>(picture_.width);
        const auto height = static_cast<double>(picture_.height);
        for (const V2d& place : strip.mesh.places) {
            const double row = place.y + static_cast<double>(strip.first_row);
            fmt::format_to(std::back_inserter(text_), ",\n<{:.12g},{:.12g}>", place.x / width,
                           1.0 - row / height);
            flush_if_long();
        }
    }

    void add_face(const CameraMesh& mesh, Face face, std::size_t first) {
        const V3d a = in_scene(mesh.vertices[face[0]]);
        const V3d b = in_scene(mesh.vertices[face[1]]);
        const V3d c = in_scene(mesh.vertices[face[2]]);
        if (picture_.single_faces) {
            // The ray leaves on the side where the vertices turn as the axes do.
            if (axes_turn()) {
                std::swap(face[1], face[2]);
            }
        } else if (would_exchange(a, b, c)) {
            std::swap(face[0], face[1]);
        }
        fmt::format_to(std::back_inserter(text_), ",\n<{},{},{}>", face[0] + first, face[1] + first,
                       face[2] + first);
        flush_if_long();
    }

    // Whether the scene's axes are the mirror image of those of the mesh.
    [[nodiscard]] bool axes_turn() const {
        const auto image = [&](double x, double y, double z) {
            return axes_.from_y_up(V3d(x, y, z));
        };
        return ((image(1.0, 0.0, 0.0) % image(0.0, 1.0, 0.0)) ^ image(0.0, 0.0, 1.0)) < 0.0;
    }

    void flush_if_long() {
        constexpr std::size_t long_text = 1 << 20;
        if (text_.size() > long_text) {
            flush();
        }
    }
    void flush() {
        file_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ofstream& file_;
    const MeshPicture& picture_;
    const AxesRow& axes_;
    fmt::memory_buffer text_;
};

}  // namespace

Diagnostics write_scene(const std::filesystem::path& file, std::string_view scene,
                        const MeshPicture& picture, const MeshFrame& frame, const AxesRow& axes) {
    std::ofstream out(file, std::ios::binary);
    out << scene;
    // Scenes for the versions before 3.5 have no mesh2 and no mesh_camera.
    out << "\n#declare Balcony_Version = version;\n"
           "#if (version < 3.5) #version 3.5; #end\n"
           "#declare Balcony_Mesh = mesh2 {\n";
    MeshWriter(out, picture, axes).write();
    const V3d center = axes.from_y_up(frame.center);
    // No ray meets the mesh, so it needs no hierarchy of bounding boxes.
    out << fmt::format("translate <{:.17g},{:.17g},{:.17g}>\nhierarchy off\n}}\n", center.x,
                       center.y, center.z);
    out << fmt::format(
        "camera {{ mesh_camera {{ 1 {} mesh {{ Balcony_Mesh }} {} }} "
        "location <0,0,{:.17g}> }}\n",
        picture.single_faces ? 0 : 3, picture.single_faces ? "" : "smooth",
        picture.single_faces ? 0.0 : -frame.offset);
    out << "#if (Balcony_Version < 3.5) #version Balcony_Version; #end\n";
    out.close();
    if (!out) {
        return {error(Kind::environment,
                      fmt::format("the temporary file '{}' cannot be written", file.string()),
                      "set TMPDIR to a folder on a disk with more space")};
    }
    return {};
}

}  // namespace balcony::bridge::povray
