// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where a layer shows its own picture: fitted into its place, moved inside of it, and a region.

#include "support.hpp"

#include "balcony/picture.hpp"

namespace balcony::camera::layer_fit_test {

namespace {

constexpr double tolerance = 1e-12;

// A camera of aspect 2. Its map has ranges; or it adapts to any aspect.
Camera wide(bool adapts = false) {
    Camera::Parts parts;
    parts.name = "wide";
    parts.aspect = 2.0;
    const PictureMapperPointer square =
        stage<PictureMapper>(StageKind::picture_mapper, "square_v",
                             {{"u_first", numbers({1.0})}, {"u_last", numbers({-1.0})}});
    parts.eye = {adapts ? square : range(0.0, 1.0, 0.0, 1.0), {}, object("sphere"), {}};
    parts.look = look("normal");
    return camera(std::move(parts));
}

PictureArrangerPointer place(double x0, double y0, double x1, double y1) {
    return stage<PictureArranger>(StageKind::picture_arranger, "place",
                                  {{"from", numbers({x0, y0})}, {"to", numbers({x1, y1})}});
}

PictureArrangerPointer shift(double x, double y) {
    return stage<PictureArranger>(StageKind::picture_arranger, "shift", {{"by", numbers({x, y})}});
}

Picture picture(std::vector<Layer> layers, std::optional<double> aspect = {}) {
    const auto made =
        Picture::make({.name = "p", .layers = std::move(layers), .size = {}, .aspect = aspect});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

Layer layer(const Camera& camera, Fit fit = Fit::fit) {
    return {.name = "one", .content = camera, .fit = fit};
}

struct Seen {
    double u, v, coverage;
};

// (u, v) and the coverage of an element at a point; wide() has 0 .. 1 from the left and the bottom.
Seen seen(const Picture& picture, double x, double y, double width, double height,
          std::size_t element = 0) {
    Graph graph;
    const auto all = picture.emit(graph, width, height);
    const PictureExpressions::Element& one = all.elements.at(element);
    const std::vector<double> r = expr::evaluate(
        std::array{one.ray->parameters.u, one.ray->parameters.v, one.coverage}, {x, y, 0.0, {}});
    return {r[0], r[1], r[2]};
}

void expect_seen(const Seen& found, double u, double v, double coverage = 1.0) {
    EXPECT_NEAR(found.u, u, tolerance);
    EXPECT_NEAR(found.v, v, tolerance);
    EXPECT_EQ(found.coverage, coverage);
}

}  // namespace

// In a square of 100 pixels, the picture of aspect 2 is 100 x 50, or 200 x 100.
TEST(LayerFit, KeepsTheAspectOfACamera) {
    const Picture fitted = picture({layer(wide())});
    expect_seen(seen(fitted, 10.0, 50.0, 100.0, 100.0), 0.1, 0.5);
    expect_seen(seen(fitted, 10.0, 30.0, 100.0, 100.0), 0.1, 0.9);
    EXPECT_EQ(seen(fitted, 10.0, 20.0, 100.0, 100.0).coverage, 0.0) << "above it";
    const Picture filled = picture({layer(wide(), Fit::fill)});
    expect_seen(seen(filled, 50.0, 20.0, 100.0, 100.0), 0.5, 0.8);
    expect_seen(seen(filled, 10.0, 20.0, 100.0, 100.0), 0.3, 0.8);
    const Picture stretched = picture({layer(wide(), Fit::stretch)});
    expect_seen(seen(stretched, 10.0, 20.0, 100.0, 100.0), 0.1, 0.8);
}

TEST(LayerFit, IsTheSameInBothDirections) {
    // 400 x 100: the picture is 200 x 100 in the middle, or 400 x 200.
    const Picture fitted = picture({layer(wide())});
    expect_seen(seen(fitted, 150.0, 20.0, 400.0, 100.0), 0.25, 0.8);
    EXPECT_EQ(seen(fitted, 90.0, 20.0, 400.0, 100.0).coverage, 0.0) << "to the left";
    const Picture filled = picture({layer(wide(), Fit::fill)});
    expect_seen(seen(filled, 100.0, 0.0, 400.0, 100.0), 0.25, 0.75);
}

TEST(LayerFit, LeavesNoGapForSizesInWholePixels) {
    // 101 pixels are 50.5 high.
    const Picture fitted = picture({layer(wide())});
    Graph graph;
    EXPECT_TRUE(fitted.emit(graph, 101.0, 51.0).elements[0].coverage.is_constant(1.0));
    EXPECT_TRUE(fitted.emit(graph, 101.0, 50.0).elements[0].coverage.is_constant(1.0));
    EXPECT_FALSE(fitted.emit(graph, 101.0, 53.0).elements[0].coverage.is_constant(1.0));
}

TEST(LayerFit, DoesNotConcernCamerasThatAdapt) {
    EXPECT_EQ(wide().fixed_aspect(), 2.0);
    EXPECT_EQ(wide(true).fixed_aspect(), std::nullopt);
    Graph graph;
    const Picture any = picture({layer(wide(true))});
    EXPECT_TRUE(any.emit(graph, 100.0, 300.0).elements[0].coverage.is_constant(1.0));
}

TEST(LayerFit, IsThatOfACameraByItself) {
    const Picture alone(wide());
    expect_seen(seen(alone, 10.0, 30.0, 100.0, 100.0), 0.1, 0.9);
    EXPECT_EQ(seen(alone, 10.0, 20.0, 100.0, 100.0).coverage, 0.0);
    expect_seen(seen(alone.with_fit(Fit::fill), 10.0, 20.0, 100.0, 100.0), 0.3, 0.8);
    expect_seen(seen(alone.with_fit(Fit::stretch), 10.0, 20.0, 100.0, 100.0), 0.1, 0.8);
    EXPECT_NE(alone.with_fit(Fit::fill).only_camera(), nullptr);
}

// A picture with an aspect is fitted as a whole; one without takes any.
TEST(LayerFit, IsThatOfAPictureInASizeOfAnotherAspect) {
    Layer left = layer(wide(), Fit::stretch);
    left.arrangers = {place(0.0, 0.0, 0.5, 1.0)};
    const Picture whole = picture({left}, 2.0);
    expect_seen(seen(whole, 25.0, 50.0, 100.0, 100.0), 0.5, 0.5);
    EXPECT_EQ(seen(whole, 25.0, 20.0, 100.0, 100.0).coverage, 0.0) << "above the picture";
    expect_seen(seen(picture({left}), 25.0, 20.0, 100.0, 100.0), 0.5, 0.8);
    expect_seen(seen(whole.with_fit(Fit::stretch), 25.0, 20.0, 100.0, 100.0), 0.5, 0.8);
}

TEST(LayerFit, IsThatOfANestedPicture) {
    const auto inner = std::make_shared<const Picture>(picture({layer(wide(true))}, 4.0));
    const std::vector<ShownCamera> shown =
        shown_cameras(picture({{.name = "a", .content = inner}}));
    const auto sides = size_of(shown[0].uses[0], 200.0, 200.0);
    EXPECT_NEAR(sides[0], 200.0, tolerance);
    EXPECT_NEAR(sides[1], 50.0, tolerance);
}

TEST(InnerArrangers, MoveWhatIsInTheWindow) {
    Layer inset = layer(wide(), Fit::stretch);
    inset.arrangers = {place(0.5, 0.0, 1.0, 1.0)};
    inset.inner_arrangers = {shift(0.25, 0.0)};
    const Picture moved = picture({inset});
    expect_seen(seen(moved, 150.0, 50.0, 200.0, 100.0), 0.25, 0.5);
    EXPECT_EQ(seen(moved, 110.0, 50.0, 200.0, 100.0).coverage, 0.0) << "nothing came there";
    EXPECT_EQ(seen(moved, 90.0, 50.0, 200.0, 100.0).coverage, 0.0) << "not in the window";
}

TEST(ShownRegion, FillsTheWindow) {
    Layer closeup = layer(wide());
    closeup.show = PictureRegion{{0.25, 0.5}, {0.5, 1.0}};
    const Picture magnified = picture({closeup});
    // A region of aspect 1.
    expect_seen(seen(magnified, 50.0, 50.0, 100.0, 100.0), 0.375, 0.25);
    expect_seen(seen(magnified, 0.0, 0.0, 100.0, 100.0), 0.25, 0.5);
    EXPECT_EQ(seen(magnified, 20.0, 50.0, 200.0, 100.0).coverage, 0.0) << "beside it";
}

// What the window shows moves, and there is more than the region.
TEST(ShownRegion, MovesInsideTheWindow) {
    Layer closeup = layer(wide());
    closeup.show = PictureRegion{{0.25, 0.5}, {0.5, 1.0}};
    closeup.inner_arrangers = {shift(0.5, 0.0)};
    expect_seen(seen(picture({closeup}), 0.0, 0.0, 100.0, 100.0), 0.125, 0.5);
}

// A camera that adapts has the aspect that it has in the layer below.
TEST(ShownRegion, IsOneOfTheLayerBelow) {
    const Camera adapting = wide(true);
    Layer below = layer(adapting);
    below.arrangers = {place(0.0, 0.5, 1.0, 1.0)};
    Layer closeup = layer(adapting);
    closeup.arrangers = {place(0.0, 0.0, 1.0, 0.5)};
    closeup.show = PictureRegion{{0.25, 0.0}, {0.75, 1.0}};
    const Picture both = picture({below, closeup}, 1.0);
    EXPECT_EQ(source_of(both.parts(), 1), 0U);
    EXPECT_EQ(source_of(both.parts(), 0), std::nullopt);
    // The picture below is 200 x 100, and so the region 100 x 100, in the middle of 200 x 100.
    const Seen low = seen(both, 80.0, 170.0, 200.0, 200.0, 0);
    const Seen high = seen(both, 80.0, 70.0, 200.0, 200.0, 1);
    EXPECT_NEAR(low.u, high.u, tolerance);
    EXPECT_NEAR(low.v, high.v, tolerance);
    EXPECT_EQ(seen(both, 40.0, 70.0, 200.0, 200.0, 1).coverage, 0.0);
}

TEST(ShownRegion, IsTheTargetOfALeaderWithoutCorners) {
    const Camera same = wide();
    Layer below = layer(same);
    below.arrangers = {place(0.0, 0.5, 1.0, 1.0)};
    Layer closeup = layer(same);
    closeup.arrangers = {place(0.4, 0.05, 0.6, 0.25)};
    closeup.show = PictureRegion{{0.25, 0.25}, {0.5, 0.75}};
    closeup.leaders = {Leader{.region = {}, .stroke = {0.02}}};
    const Picture led = picture({below, closeup}, 1.0);
    Graph graph;
    const auto all = led.emit(graph, 200.0, 200.0);
    const auto drawn = [&](double x, double y) {
        return expr::evaluate(std::span(&all.elements[1].coverage, 1), {x, y, 0.0, {}})[0];
    };
    // From (50, 125) to (100, 175), with an outline of 4 pixels outside.
    EXPECT_EQ(drawn(48.0, 150.0), 1.0);
    EXPECT_EQ(drawn(102.0, 150.0), 1.0);
    EXPECT_EQ(drawn(75.0, 177.0), 1.0);
    EXPECT_EQ(drawn(75.0, 150.0), 0.0);
    EXPECT_EQ(drawn(30.0, 150.0), 0.0);
}

TEST(ShownRegion, HasAnArea) {
    Layer empty = layer(wide());
    empty.show = PictureRegion{{0.5, 0.2}, {0.5, 0.4}};
    const auto refused = Picture::make({.name = "p", .layers = {empty}, .size = {}, .aspect = {}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics[0].message, "the region that layer 'one' shows has no area");
}

}  // namespace balcony::camera::layer_fit_test
