// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The C functions of all examples, compiled by a C compiler and called.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <dlfcn.h>
#include <fmt/format.h>

#include "bridge/text/camera_formulas.hpp"
#include "examples.hpp"

namespace balcony::bridge::c_export_test {
namespace {

namespace fs = std::filesystem;
using test::Example;
using test::ExportedRay;

/// The functions of all examples in one library.
class Library {
public:
    explicit Library(bool single) {
        folder_ = fs::temp_directory_path() /
                  fmt::format("balcony-c-{}-{}", single ? "single" : "double", getpid());
        fs::create_directories(folder_);
        const fs::path source = folder_ / "all.c";
        std::ofstream text(source);
        for (const Example& example : test::examples()) {
            const auto made =
                export_camera(*find_export_target("c"), {example.camera}, {.single = single});
            text << (made ? made->text : "");
        }
        text.close();
        const std::string command = fmt::format(
            "{} -x c -std=c99 -Wall -Wextra -Werror -Wconversion -Wno-float-conversion -pedantic "
            "-O0 -ffp-contract=off -shared -fPIC '{}' -o '{}' -lm",
            BALCONY_C_COMPILER, source.string(), (folder_ / "all.so").string());
        compiled_ = std::system(command.c_str()) == 0;
        handle_ = dlopen((folder_ / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() {
        if (handle_ != nullptr) {
            dlclose(handle_);
        }
        fs::remove_all(folder_);
    }

    [[nodiscard]] bool compiled() const { return compiled_; }

    template <class Real>
    [[nodiscard]] std::vector<ExportedRay> rays(const Example& example, bool lens) const {
        using Pinhole = int (*)(Real, Real, Real, Real, Real, Real*, Real*);
        using Lens = int (*)(Real, Real, Real, Real, Real, Real, Real, Real*, Real*);
        void* symbol = dlsym(handle_, (example.name + "_ray").c_str());
        std::vector<ExportedRay> made;
        for (const auto& [x, y] : test::points()) {
            Real o[3];
            Real d[3];
            const auto px = static_cast<Real>(x);
            const auto py = static_cast<Real>(y);
            const auto w = static_cast<Real>(test::width);
            const auto h = static_cast<Real>(test::height);
            const int valid = lens ? reinterpret_cast<Lens>(symbol)(px, py, w, h, 0, 0, 0, o, d)
                                   : reinterpret_cast<Pinhole>(symbol)(px, py, w, h, 0, o, d);
            made.push_back({{o[0], o[1], o[2]}, {d[0], d[1], d[2]}, valid == 1});
        }
        return made;
    }

private:
    fs::path folder_;
    bool compiled_ = false;
    void* handle_ = nullptr;
};

// The C library computes both, so that all numbers are the same.
TEST(CExport, ComputesTheGraphToTheLastBit) {
    const Library library(false);
    ASSERT_TRUE(library.compiled());
    std::size_t compared = 0;
    for (const Example& example : test::examples()) {
        const auto formulas = formulas_of(example.camera, {example.camera.parts().axes, false});
        if (!formulas) {
            continue;
        }
        const std::vector<ExportedRay> rays = library.rays<double>(example, formulas->lens);
        const auto points = test::points();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::array<expr::InputValue, 4> inputs{
                {{"width", test::width}, {"height", test::height}, {"lens_x", 0}, {"lens_y", 0}}};
            const std::vector<double> r = expr::evaluate(
                formulas->roots, {.x = points[i].x, .y = points[i].y, .inputs = inputs});
            ASSERT_EQ(rays[i].valid, r[RayRoots::valid] == 1.0) << example.name;
            for (std::size_t k = 0; rays[i].valid && k < 3; ++k) {
                ASSERT_EQ(rays[i].origin[k], r[k]) << example.name;
                ASSERT_EQ(rays[i].direction[k], r[3 + k]) << example.name;
            }
        }
        const test::Comparison comparison = test::compare(example, rays);
        EXPECT_EQ(comparison.lost, 0U) << example.name;
        EXPECT_LT(comparison.largest, 1e-6) << example.name;
        ++compared;
    }
    EXPECT_GE(compared + 3, test::examples().size()) << "only meshes have no formula";
}

// The functions of the C library are not rounded as the reported ones are, and the points are
// others; but no camera is much worse than its report.
TEST(CExport, InSinglePrecisionDiffersAsMuchAsIsReported) {
    const Library library(true);
    ASSERT_TRUE(library.compiled());
    for (const Example& example : test::examples()) {
        if (!test::has_formulas(example)) {
            continue;
        }
        const bool lens = example.camera.parts().lens != nullptr;
        const auto exported = export_camera(*find_export_target("c"), {example.camera},
                                            {.single = true, .judged_in = {{160, 90}}});
        ASSERT_TRUE(exported && exported->single) << example.name;
        const SinglePrecision& reported = *exported->single;
        const test::Comparison comparison =
            test::compare(example, library.rays<float>(example, lens));
        EXPECT_LE(comparison.lost, reported.lost) << example.name;
        EXPECT_LT(comparison.largest, 1e-3 + 4.0 * reported.largest) << example.name;
    }
}

}  // namespace
}  // namespace balcony::bridge::c_export_test
