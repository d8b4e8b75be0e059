// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Which cameras a picture shows: each once, with all places where layers show it.

#include "balcony/picture.hpp"
#include "support.hpp"

namespace balcony::camera::shown_cameras_test {

namespace {

constexpr double tolerance = 1e-9;  // Rounding alone.

Camera named(std::string name) {
    Camera::Parts parts;
    parts.name = std::move(name);
    parts.eye = {range(-1.0, 1.0, -1.0, 1.0), {}, object("sphere"), {}};
    parts.look = look("normal");
    return camera(std::move(parts));
}

PictureArrangerPointer place(Scalar x_from, double y_from, double x_to, double y_to) {
    return stage<PictureArranger>(
        StageKind::picture_arranger, "place",
        {{"from", std::vector<Scalar>{std::move(x_from), y_from}}, {"to", numbers({x_to, y_to})}});
}

std::shared_ptr<const Picture> picture(std::vector<Layer> layers) {
    const auto made = Picture::make({.name = "p", .layers = std::move(layers), .size = {}});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::make_shared<const Picture>(*made);
}

/// "left at 1 and 3.1 (2), ...", with the index of those that are not the back one.
std::string described(const std::vector<ShownCamera>& cameras) {
    std::string text;
    for (const ShownCamera& one : cameras) {
        text += (text.empty() ? "" : ", ") + one.camera.name() + " at ";
        for (const ShownCamera::LayerUse& use : one.uses) {
            text += (&use == &one.uses.front() ? "" : " and ") + use.layer;
            text += use.index == 0 ? "" : " (" + std::to_string(use.index) + ")";
        }
    }
    return text;
}

}  // namespace

TEST(ShownCameras, OfACameraIsItselfOnTheWholePicture) {
    const Camera only = named("only");
    const std::vector<ShownCamera> shown = shown_cameras(Picture(only).with_fit(Fit::stretch));
    ASSERT_EQ(described(shown), "only at 1");
    EXPECT_EQ(&shown[0].camera.parts(), &only.parts());
    EXPECT_TRUE(shown[0].uses[0].arrangers.empty());
    EXPECT_EQ(size_of(shown[0].uses[0], 200, 100), (std::array{200.0, 100.0}));
}

TEST(ShownCameras, AreNumberedFromTheBackThroughThePicturesOfLayers) {
    const Camera far = named("far");
    const Camera near = named("near");
    const auto inner = picture({{"a", near}, {"b", far}});
    const auto middle = picture({{"a", inner}, {"b", near}});
    EXPECT_EQ(described(shown_cameras(*picture({{"a", far}, {"b", near}}))),
              "far at 1, near at 2 (1)");
    EXPECT_EQ(described(shown_cameras(*picture({{"a", far}, {"b", middle}, {"c", near}}))),
              "far at 1 and 2.1.2 (2), near at 2.1.1 (1) and 2.2 (3) and 3 (4)");
}

TEST(ShownCameras, OfOneNameAreTwoUnlessTheyAreCopies) {
    const Camera one = named("same");
    const Camera copy = one;
    EXPECT_EQ(described(shown_cameras(*picture({{"a", one}, {"b", named("same")}, {"c", copy}}))),
              "same at 1 and 3 (2), same at 2 (1)");
}

TEST(ShownCameras, HaveTheirArrangersFromTheWholePictureInwards) {
    const PictureArrangerPointer half = place(0.0, 0.0, 0.5, 1.0);
    const PictureArrangerPointer third = place(0.0, 0.0, 1.0, 0.25);
    const auto inner =
        picture({{.name = "a", .content = named("in"), .arrangers = {third}, .fit = Fit::stretch}});
    const std::vector<ShownCamera> shown =
        shown_cameras(*picture({{.name = "a", .content = inner, .arrangers = {half}},
                                {.name = "b", .content = named("beside"), .fit = Fit::stretch}}));
    ASSERT_EQ(described(shown), "in at 1.1, beside at 2 (1)");
    EXPECT_EQ(shown[0].uses[0].arrangers, (std::vector{half, third}));
    EXPECT_TRUE(shown[1].uses[0].arrangers.empty());
    const auto [width, height] = size_of(shown[0].uses[0], 200, 100);
    EXPECT_NEAR(width, 100.0, tolerance);
    EXPECT_NEAR(height, 25.0, tolerance);
}

TEST(SizeOf, IsThatOfItsTime) {
    const Formula moving =
        formula(0, [](Graph& graph, const auto&) { return std::vector{0.1 * graph.time()}; });
    const ShownCamera::LayerUse growing{.layer = "1", .arrangers = {place(moving, 0.0, 1.0, 0.5)}};
    EXPECT_NEAR(size_of(growing, 200, 100)[0], 200.0, tolerance);
    EXPECT_NEAR(size_of(growing, 200, 100, 5.0)[0], 100.0, tolerance);
    EXPECT_NEAR(size_of(growing, 200, 100, 5.0)[1], 50.0, tolerance);
}

// A layer whose size depends on the place has that in its middle.
TEST(SizeOf, IsThatInTheMiddleOfThePicture) {
    class Widening final : public PictureArranger {
    public:
        PicturePoint arrange(const PicturePoint& whole, Emitter&) const override {
            return {whole.point, {whole.point.x, 3.0 * whole.point.y}};
        }
    };
    const ShownCamera::LayerUse use{.layer = "1",
                                    .arrangers = {std::make_shared<const Widening>()}};
    EXPECT_EQ(size_of(use, 200, 100), (std::array{100.0, 150.0}));
}

}  // namespace balcony::camera::shown_cameras_test
