// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a picture draws: the coverages of layers, frames and leader lines, and the bounds of a
// picture. All are of 200 x 100 pixels; an edge is a pixel wide, from 1 to 0.

#include "balcony/picture.hpp"
#include "support.hpp"

namespace balcony::camera::picture_elements_test {

namespace {

constexpr double width = 200.0;
constexpr double height = 100.0;
constexpr double tolerance = 1e-9;  // Rounding alone.

Layer layer(std::string name = "one") {
    Camera::Parts parts;
    parts.name = "any";
    parts.eye = {range(-1.0, 1.0, -1.0, 1.0), {}, object("sphere"), {}};
    parts.look = look("normal");
    Layer made{std::move(name), camera(std::move(parts))};
    made.fit = Fit::stretch;
    return made;
}

PictureArrangerPointer place(std::vector<double> from, std::vector<double> to) {
    return stage<PictureArranger>(
        StageKind::picture_arranger, "place",
        {{"from", numbers(std::move(from))}, {"to", numbers(std::move(to))}});
}

/// build({x, y}) gives {x', y'}.
template <class Build>
PictureArrangerPointer bend(const Build& build) {
    Arguments arguments;
    arguments.set_formula(
        formula(2, [&build](Graph&, const std::vector<Expr>& p) { return build(p); }));
    return std::dynamic_pointer_cast<const PictureArranger>(
        *catalogue().find(StageKind::picture_arranger, "formula")->make(arguments));
}

/// Has no place for the left half of a picture, though its formula has a value there.
class RightHalf final : public PictureArranger {
public:
    PicturePoint arrange(const PicturePoint& whole, Emitter& emit) const override {
        emit.require(0.5 * whole.size.width <= whole.point.x);
        return whole;
    }
};

Result<Picture> picture(std::vector<Layer> layers) {
    return Picture::make({.name = "p", .layers = std::move(layers), .size = {}});
}

class CoverageProbe {
public:
    explicit CoverageProbe(Layer only) {
        const auto made = picture({std::move(only)});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        all_ = made->emit(graph_, width, height);
    }
    [[nodiscard]] const std::vector<PictureExpressions::Element>& elements() const {
        return all_.elements;
    }
    [[nodiscard]] double operator()(std::size_t element, double x, double y) const {
        return expr::evaluate(std::span(&all_.elements[element].coverage, 1), {x, y, 0.0, {}})[0];
    }

private:
    Graph graph_;
    PictureExpressions all_;
};

/// A picture of n pictures one within the other.
Result<Picture> nested(std::size_t n) {
    Result<Picture> made = picture({layer()});
    for (std::size_t i = 1; made && i < n; ++i) {
        made = picture({{"in", std::make_shared<const Picture>(std::move(*made))}});
    }
    return made;
}

}  // namespace

TEST(LayerCoverage, IsTheAlphaInsideAndNothingOutside) {
    Layer half = layer();
    half.arrangers = {place({0.25, 0.2}, {0.75, 0.8})};
    half.alpha = 0.5;
    const CoverageProbe probe(half);
    EXPECT_NEAR(probe(0, 100.0, 50.0), 0.5, tolerance);
    EXPECT_NEAR(probe(0, 40.0, 50.0), 0.0, tolerance);
    EXPECT_NEAR(probe(0, 100.0, 10.0), 0.0, tolerance);
}

TEST(LayerCoverage, HasItsSoftEdgeByTheLayersHeight) {
    Layer soft = layer();
    soft.arrangers = {place({0.25, 0.2}, {0.75, 0.8})};
    soft.softness = 0.2;  // Of 60 pixels: 6 to either side of the edge.
    const CoverageProbe probe(soft);
    EXPECT_NEAR(probe(0, 50.0, 50.0), 0.5, tolerance);
    EXPECT_EQ(probe(0, 56.1, 50.0), 1.0);
    EXPECT_LT(probe(0, 55.0, 50.0), 1.0);
    EXPECT_EQ(probe(0, 43.9, 50.0), 0.0);
}

TEST(LayerCoverage, IsNothingWhereAnArrangerHasNoPlace) {
    Layer half = layer();
    half.arrangers = {std::make_shared<const RightHalf>()};
    const CoverageProbe probe(half);
    EXPECT_EQ(probe(0, 150.0, 50.0), 1.0);
    EXPECT_EQ(probe(0, 50.0, 50.0), 0.0);
}

// So that a soft edge, half of which lies outside of the layer, has rays to show.
TEST(LayerCoverage, ACameraGoesOnBeyondItsPictureWhereItsArrangersFillIt) {
    Layer inset = layer();
    Camera::Parts parts = std::get<Camera>(inset.content).parts();
    parts.arrangers = {place({0.0, 0.0}, {0.5, 1.0})};
    inset.content = camera(std::move(parts));
    inset.arrangers = {place({0.25, 0.2}, {0.75, 0.8})};
    inset.softness = 0.2;
    const CoverageProbe probe(inset);
    const auto valid = [&probe](double x, double y) {
        return expr::evaluate(std::array{probe.elements()[0].ray->valid}, {x, y, 0.0, {}})[0];
    };
    EXPECT_EQ(valid(46.0, 50.0), 1.0);
    EXPECT_EQ(valid(60.0, 16.0), 1.0);
    EXPECT_EQ(valid(120.0, 50.0), 0.0);
    EXPECT_EQ(valid(154.0, 50.0), 0.0);
}

// There lie the samples of filters that reach beyond it.
TEST(LayerCoverage, IncludesThePicturesBorder) {
    Layer left = layer();
    left.arrangers = {place({0.0, 0.0}, {0.5, 1.0})};
    const CoverageProbe probe(left);
    for (const auto& [x, y] :
         {std::array{0.0, 50.0}, std::array{20.0, 0.0}, std::array{20.0, 100.0}}) {
        EXPECT_EQ(probe(0, x, y), 1.0);
        const Expr valid = probe.elements()[0].ray->valid;
        EXPECT_EQ(expr::evaluate(std::array{valid}, {x, y, 0.0, {}})[0], 1.0);
    }
}

TEST(Frame, IsAsWideAsItsFractionOfTheWholePictureAndInsideTheEdge) {
    Layer framed = layer();
    framed.arrangers = {place({0.25, 0.2}, {0.75, 0.8})};
    framed.frame = Stroke{0.04, {0.25, 0.5, 0.75}};
    const CoverageProbe probe(framed);
    ASSERT_EQ(probe.elements().size(), 2U);
    EXPECT_EQ(probe(1, 49.4, 50.0), 0.0);
    EXPECT_NEAR(probe(1, 50.0, 50.0), 0.5, tolerance);
    EXPECT_EQ(probe(1, 52.0, 50.0), 1.0);
    EXPECT_NEAR(probe(1, 54.0, 50.0), 0.5, tolerance);
    EXPECT_EQ(probe(1, 54.6, 50.0), 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE((*probe.elements()[1].paint)[i].is_constant(0.25 * static_cast<double>(i + 1)));
    }
}

// Squeezed to half in one direction, the layer's picture has its edge at a quarter of the whole.
TEST(Frame, IsAsWideWhereArrangersSqueezeTheLayer) {
    for (const bool across : {true, false}) {
        Layer squeezed = layer();
        squeezed.arrangers = {bend([across](const std::vector<Expr>& p) {
            return across ? std::vector{2.0 * p[0], p[1]} : std::vector{p[0], 2.0 * p[1]};
        })};
        squeezed.frame = Stroke{0.04, {}};
        const CoverageProbe probe(squeezed);
        const auto at = [&](double pixels) {
            return across ? probe(1, 50.0 + pixels, 50.0) : probe(1, 100.0, 25.0 + pixels);
        };
        EXPECT_NEAR(at(0.0), 0.5, tolerance);
        EXPECT_EQ(at(3.0), 1.0);
        EXPECT_NEAR(at(4.0), 0.5, tolerance);
        EXPECT_EQ(at(5.0), 0.0);
    }
}

// From the region (20, 40) .. (40, 60) to an inset in (100, 10) .. (180, 90), two pixels wide.
class LeaderLines : public testing::TestWithParam<bool> {
protected:
    static Layer inset() {
        Layer made = layer();
        made.arrangers = {place({0.5, 0.1}, {0.9, 0.9})};
        // The corners of the region may be given in either order.
        made.leaders = {GetParam() ? Leader{PictureRegion{{0.1, 0.4}, {0.2, 0.6}}, {0.02}}
                                   : Leader{PictureRegion{{0.2, 0.6}, {0.1, 0.4}}, {0.02}}};
        return made;
    }
};

INSTANTIATE_TEST_SUITE_P(EitherOrder, LeaderLines, testing::Bool());

TEST_P(LeaderLines, FrameTheRegionFromOutside) {
    const CoverageProbe probe(inset());
    ASSERT_EQ(probe.elements().size(), 2U);
    EXPECT_TRUE(probe.elements()[0].paint) << "below the layer";
    EXPECT_EQ(probe(0, 30.0, 50.0), 0.0);
    for (const auto& [x, y, by_x, by_y] :
         {std::array{20.0, 50.0, -1.0, 0.0}, std::array{40.0, 50.0, 1.0, 0.0},
          std::array{38.0, 40.0, 0.0, -1.0}, std::array{38.0, 60.0, 0.0, 1.0}}) {
        const auto out = [&](double pixels) {
            return probe(0, x + pixels * by_x, y + pixels * by_y);
        };
        EXPECT_EQ(out(-0.6), 0.0);
        EXPECT_NEAR(out(0.0), 0.5, tolerance);
        EXPECT_EQ(out(1.0), 1.0);
        EXPECT_NEAR(out(2.0), 0.5, tolerance);
        EXPECT_EQ(out(2.6), 0.0);
    }
}

TEST_P(LeaderLines, AreThoseTwoThatCrossNeither) {
    const CoverageProbe probe(inset());
    EXPECT_EQ(probe(0, 60.0, 25.0), 1.0) << "top left to top left";
    EXPECT_EQ(probe(0, 60.0, 75.0), 1.0) << "bottom left to bottom left";
    EXPECT_EQ(probe(0, 70.0, 40.0 - 30.0 * 30.0 / 140.0), 0.0) << "top right to top right";
    EXPECT_EQ(probe(0, 70.0, 60.0 + 30.0 * 30.0 / 140.0), 0.0) << "bottom right to bottom right";
}

TEST_P(LeaderLines, LeaveWhatTheyJoinClear) {
    const CoverageProbe probe(inset());
    // 0.3 pixels inside the region its frame's edge covers a fifth; a line would cover more.
    EXPECT_NEAR(probe(0, 21.0, 40.3), 0.2, tolerance);
    EXPECT_EQ(probe(0, 101.0, 10.4), 0.0);
}

TEST_P(LeaderLines, GoToAnInsetOnTheLeftToo) {
    Layer left = inset();
    left.arrangers = {place({0.1, 0.1}, {0.5, 0.9})};
    left.leaders[0].region->from[0] = GetParam() ? 0.8 : 0.9;
    left.leaders[0].region->to[0] = GetParam() ? 0.9 : 0.8;
    const CoverageProbe probe(left);
    EXPECT_EQ(probe(0, 140.0, 25.0), 1.0) << "top right to top right";
    EXPECT_EQ(probe(0, 140.0, 75.0), 1.0) << "bottom right to bottom right";
}

TEST_P(LeaderLines, EndAtTheRoundCornerOfAnEllipse) {
    Layer round = inset();
    round.clip = stage<ClipShape>(StageKind::clip_shape, "ellipse");
    const CoverageProbe probe(round);
    const double corner = 40.0 * (1.0 - std::sqrt(0.5));  // From the inset's own corner.
    const double slope = (10.0 + corner - 40.0) / (100.0 + corner - 20.0);
    EXPECT_EQ(probe(0, 90.0, 40.0 + 70.0 * slope), 1.0);
    EXPECT_EQ(probe(0, 90.0, 40.0 - 70.0 * 30.0 / 80.0), 0.0);
}

TEST(PictureBounds, HoldForNumbersOfLayers) {
    for (const double outside : {-0.5, 1.5}) {
        Layer transparent = layer();
        transparent.alpha = outside;
        EXPECT_FALSE(picture({transparent}));
        Layer soft = layer();
        soft.softness = outside;
        EXPECT_FALSE(picture({soft}));
        Layer framed = layer();
        framed.frame = Stroke{outside, {}};
        EXPECT_FALSE(picture({framed}));
        Layer led = layer();
        led.leaders = {Leader{PictureRegion{{0.1, 0.4}, {0.2, 0.6}}, {outside}}};
        EXPECT_FALSE(picture({led}));
    }
}

TEST(PictureBounds, HoldForNestingLayersAndSize) {
    EXPECT_TRUE(nested(max_nested_pictures));
    EXPECT_FALSE(nested(max_nested_pictures + 1));

    const auto inner =
        std::make_shared<const Picture>(*picture(std::vector<Layer>(max_layers / 2, layer())));
    EXPECT_FALSE(picture({{"a", inner}, {"b", inner}})) << "1000 layers and the two that hold them";

    for (const std::array<std::size_t, 2> size :
         {std::array{std::size_t{0}, std::size_t{9}}, std::array{std::size_t{9}, std::size_t{0}}}) {
        const auto empty = Picture::make({.name = "p", .layers = {layer()}, .size = size});
        ASSERT_FALSE(empty);
        EXPECT_EQ(empty.diagnostics[0].message, "picture 'p' has no pixels");
    }
}

TEST(Picture, OfACameraHasItsProportion) {
    Camera::Parts parts = std::get<Camera>(layer().content).parts();
    parts.aspect = 2.5;
    EXPECT_EQ(Picture(camera(std::move(parts))).aspect(), 2.5);
}

}  // namespace balcony::camera::picture_elements_test
