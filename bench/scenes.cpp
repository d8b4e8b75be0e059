// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints how long a scene file of two million triangles takes to load.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/core.h>

#include "balcony/scene.hpp"
#include "bench_case.hpp"

namespace balcony::bench {

namespace {

constexpr std::uint32_t cells = 1000;
constexpr int load_passes = 5;

// Hills over a square, with normals and texture coordinates.
scene::Scene hills() {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.objects.resize(1);
    scene.instances = {{scene::MeshIndex(0), {}, 0}};
    scene::Mesh& mesh = scene.meshes.emplace_back().edit();
    mesh.material = scene::MaterialIndex(0);
    for (std::uint32_t row = 0; row <= cells; ++row) {
        for (std::uint32_t column = 0; column <= cells; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(cells);
            const float v = static_cast<float>(row) / static_cast<float>(cells);
            mesh.positions.emplace_back(10.0F * u, std::sin(30.0F * u) * std::cos(20.0F * v), v);
            mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
            mesh.texture_coordinates[0].emplace_back(u, v);
        }
    }
    for (std::uint32_t row = 0; row < cells; ++row) {
        for (std::uint32_t column = 0; column < cells; ++column) {
            const std::uint32_t a = row * (cells + 1) + column;
            const std::uint32_t b = a + cells + 1;
            mesh.triangles.push_back({a, b, a + 1});
            mesh.triangles.push_back({a + 1, b, b + 1});
        }
    }
    return scene;
}

// Writes a scene and reads it several times.
void print_row(const char* name, const scene::Scene& scene) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "balcony_bench_scene.glb";
    const std::vector<std::uint8_t> bytes = to_glb(scene);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    double fastest = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < load_passes; ++pass) {
        const auto start = std::chrono::steady_clock::now();
        const auto read = scene::load(file);
        if (!read || read->triangle_count() != scene.triangle_count()) {
            throw std::runtime_error("the scene cannot be read again");
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        fastest = std::min(fastest, taken.count());
    }
    std::filesystem::remove(file);
    fmt::print("{:<20}{:>10.0f}{:>12.2f}\n", name, 1e-6 * static_cast<double>(bytes.size()),
               fastest);
}

}  // namespace

void print_scenes() {
    scene::Scene scene = hills();
    fmt::print("\nseconds to load a GLB of {} triangles, one core\n\n", scene.triangle_count());
    fmt::print("{:<20}{:>10}{:>12}\n", "", "megabytes", "seconds");
    print_row("with normals", scene);
    scene.meshes[0].edit().normals.clear();
    print_row("without normals", scene);
}

}  // namespace balcony::bench
