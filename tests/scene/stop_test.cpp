// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Loading a scene tells how far it is, and can be stopped at any time.

#include <algorithm>
#include <sstream>
#include <stop_token>

#include "scene_files.hpp"

namespace balcony::scene::testing::stop_test {

namespace {

/// A file of a grid of triangles in each format.
class LoadingStops : public SceneFiles {
protected:
    static constexpr int side = 600;  // A multiple of 3.

    [[nodiscard]] std::vector<std::filesystem::path> large_files() const {
        Gltf gltf;
        std::vector<float> positions;
        std::ostringstream obj;
        std::ostringstream ply;
        std::ostringstream stl;
        ply << "ply\nformat ascii 1.0\nelement vertex " << side * side
            << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
            << side * side / 3 << "\nproperty list uchar int vertex_indices\nend_header\n";
        stl << "solid grid\n";
        std::ostringstream faces;
        for (int i = 0; i < side * side; ++i) {
            const int x = i % side;
            const int y = i / side + i % 3 * (i % 3);
            obj << "v " << x << ' ' << y << " 0\n";
            ply << x << ' ' << y << " 0\n";
            positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), 0});
            stl << (i % 3 == 0 ? "facet normal 0 0 1\nouter loop\n" : "") << "vertex " << x << ' '
                << y << " 0\n"
                << (i % 3 == 2 ? "endloop\nendfacet\n" : "");
            if (i % 3 == 2) {
                obj << "f -3 -2 -1\n";
                faces << "3 " << i - 2 << ' ' << i - 1 << ' ' << i << '\n';
            }
        }
        ply << faces.str();
        const std::size_t accessor = gltf.add_floats(positions, 3);
        for (std::size_t mesh = 0; mesh < 20; ++mesh) {
            gltf.json["meshes"].push_back(
                {{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
            gltf.add_node({{"mesh", mesh}, {"translation", {mesh, 0, 0}}});
        }
        return {write("grid.obj", obj.str()), write("grid.ply", ply.str()),
                write("grid.stl", stl.str()), write("grid.glb", gltf.glb())};
    }
};

}  // namespace

TEST_F(LoadingStops, ProgressGrowsToTheWhole) {
    for (const std::filesystem::path& file : large_files()) {
        std::vector<double> parts;
        const auto scene = load(file, [&](double part) { parts.push_back(part); });
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_GE(parts.size(), 10U) << file;
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << file;
        EXPECT_EQ(parts.front(), 0.0) << file;
        EXPECT_EQ(parts.back(), 1.0) << file;
    }
}

// Wherever it is requested, a stop ends the loading before there is much further progress.
TEST_F(LoadingStops, AStopIsObeyedEverywhere) {
    for (const std::filesystem::path& file : large_files()) {
        for (const double at : {0.0, 0.05, 0.2, 0.45, 0.6, 0.7, 0.9}) {
            std::stop_source stop;
            double last = 0.0;
            const auto scene = load(
                file,
                [&](double part) {
                    last = part;
                    if (part >= at) {
                        stop.request_stop();
                    }
                },
                stop.get_token());
            EXPECT_FALSE(scene) << file << at;
            EXPECT_EQ(kind_of_errors(scene.diagnostics), Kind::interrupted) << file << at;
            EXPECT_LE(last, at + 0.3) << file;
        }
    }
}

TEST_F(LoadingStops, AStopBeforehandReadsNothing) {
    std::stop_source stop;
    stop.request_stop();
    const auto file = write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(kind_of_errors(load(file, {}, stop.get_token()).diagnostics), Kind::interrupted);
    EXPECT_TRUE(load(file));
}

}  // namespace balcony::scene::testing::stop_test
