// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The properties that plates 1 and 2 must show, measured from data layers of small renders.

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "balcony/median.hpp"
#include "gallery/gallery.hpp"
#include "measure.hpp"

namespace balcony::plates::gallery_plates_test {
namespace {

constexpr double painting_scale = 0.02;  // what hangs in the frames does not matter here

std::string picture_name(int number) { return fmt::format("picture {}", number); }

scene::Scene gallery() {
    auto made = make_gallery({.painting_scale = painting_scale});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

render::Film render_gallery(const scene::Scene& scene, const std::string& plate, std::size_t width,
                            std::size_t height, const std::vector<lang::Override>& overrides = {}) {
    const auto camera =
        lang::make_camera(BALCONY_PLATES "/" + plate + "/camera.cam", "", overrides);
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    const auto renderer = render::Renderer::make(std::make_shared<const scene::Scene>(scene));
    EXPECT_TRUE(renderer) << to_text(renderer.diagnostics);
    render::Settings settings;
    settings.samples = 1;
    settings.integrator = "preview";
    render::Film film = *render::make_film({.width = width, .height = height});
    const auto summary = render::render(*renderer, *camera, settings, film);
    EXPECT_TRUE(summary) << to_text(summary.diagnostics);
    EXPECT_EQ(summary->invalid_rays, 0U);
    return film;
}

/// What plate 2 promises of the pictures.
struct GalleryView {
    int wholly_visible = 0;
    int connected = 0;
    double median_anisotropy = 0.0;
    double most_bent = 0.0;

    [[nodiscard]] bool as_promised() const {
        return wholly_visible == 7 && connected == 7 && median_anisotropy <= 1.25 &&
               most_bent <= straight;
    }
    /// The paper asks for pictures that are almost undistorted. An ellipsoid would do by anisotropy
    /// alone in this room, but it bends edges by several per cent of a picture's diagonal.
    static constexpr double straight = 0.015;
};

GalleryView view_gallery(const scene::Scene& scene, const render::Film& film) {
    GalleryView gallery_view;
    std::vector<double> anisotropy;
    for (int number = 1; number <= 7; ++number) {
        const std::string name = picture_name(number);
        const View view = view_of(film, name, rectangle_of(scene, name));
        gallery_view.wholly_visible += view.share_seen == 1.0 ? 1 : 0;
        gallery_view.connected += view.regions == 1 ? 1 : 0;
        gallery_view.most_bent = std::max(gallery_view.most_bent, view.bend);
        anisotropy.insert(anisotropy.end(), view.anisotropy.begin(), view.anisotropy.end());
    }
    gallery_view.median_anisotropy = median(std::move(anisotropy)).value_or(0.0);
    return gallery_view;
}

constexpr std::size_t width = 1000;
constexpr std::size_t height = 200;

TEST(Plate1, ShowsAtMostFourPicturesWholly) {
    const scene::Scene scene = gallery();
    const GalleryView view = view_gallery(scene, render_gallery(scene, "01-gallery", 700, 350));
    EXPECT_LE(view.wholly_visible, 4);
    EXPECT_GE(view.wholly_visible, 1);
}

TEST(Plate2, ShowsAllPicturesWhollyAndNearlyUndistorted) {
    const scene::Scene scene = gallery();
    const GalleryView view =
        view_gallery(scene, render_gallery(scene, "02-superelliptic", width, height));
    EXPECT_EQ(view.wholly_visible, 7);
    EXPECT_EQ(view.connected, 7);
    EXPECT_LE(view.median_anisotropy, 1.25);
    EXPECT_LE(view.most_bent, GalleryView::straight);
    RecordProperty("median_anisotropy", fmt::format("{:.4f}", view.median_anisotropy));
    RecordProperty("most_bent", fmt::format("{:.4f}", view.most_bent));
}

// Twice the resolution halves the steps between neighbouring rays where the camera is continuous,
// and leaves a jump as it is. Corners bend fast, so that they are not quite halved.
TEST(Plate2, HasNoJumpInOriginOrDirection) {
    const scene::Scene scene = gallery();
    const RayStep coarse = max_step(render_gallery(scene, "02-superelliptic", width, height));
    const RayStep fine = max_step(render_gallery(scene, "02-superelliptic", 2 * width, 2 * height));
    constexpr double continuous = 0.6;
    EXPECT_LT(fine.origin, continuous * coarse.origin);
    EXPECT_LT(fine.direction, continuous * coarse.direction);
}

// The room is closed. Normals of nearly flat walls run along the axes but for a hair, which ray
// tracing kernels can trip over.
TEST(Plate2, HasNoHole) {
    const render::Film film = render_gallery(gallery(), "02-superelliptic", width, height);
    const auto& ids = film.layers->object;
    EXPECT_EQ(std::count(ids.begin(), ids.end(), 0U), 0);
}

// The measurement itself must be able to fail.
TEST(Plate2, AnEllipsoidDoesNotKeepThePromise) {
    const scene::Scene scene = gallery();
    const GalleryView view = view_gallery(
        scene, render_gallery(scene, "02-superelliptic", width, height, {{"gamma", "1"}}));
    EXPECT_FALSE(view.as_promised());
    EXPECT_GT(view.most_bent, GalleryView::straight);
}

TEST(Plate2, APictureMovedOutOfSightIsMissed) {
    scene::Scene scene = gallery();
    for (scene::Instance& instance : scene.instances) {
        if (scene.objects[instance.object].name == picture_name(3)) {
            instance.world_from_mesh *= scene::M44d().setTranslation(scene::V3d(0.0, 20.0, 0.0));
        }
    }
    const GalleryView view =
        view_gallery(scene, render_gallery(scene, "02-superelliptic", width, height));
    EXPECT_EQ(view.wholly_visible, 6);
    EXPECT_FALSE(view.as_promised());
}

}  // namespace
}  // namespace balcony::plates::gallery_plates_test
