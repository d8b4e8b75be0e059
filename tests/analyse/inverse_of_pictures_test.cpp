// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The inverse of pictures of several layers by its law: what a layer shows at a place is found
// there in this layer, what others hide is not.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "balcony/catalogue.hpp"
#include "balcony/inverse.hpp"
#include "support.hpp"

namespace balcony::analyse::inverse_of_pictures_test {
namespace {

using Element = camera::PictureExpressions::Element;

camera::Picture picture_of(const std::string& text) {
    const auto made = lang::make_picture(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// A picture painted by hand, back to front, at one place after another: by the definition of each
// operation, without program or patches.
class Painter {
public:
    struct Layer {
        bool covers = false;  // It has a ray there and covers something.
        bool shows = false;   // And nothing in front covers that wholly.
        V3d origin, direction;
    };

    Painter(const camera::Picture& picture, double width, double height)
        : elements_(picture.emit(graph_, width, height).elements) {
        gather(elements_);
    }

    // The layers at a place, from the back to the front.
    std::vector<Layer> at(const V2d& place) {
        values_ = expr::evaluate(roots_, {place.x, place.y, 0.0, {}});
        next_ = 0;
        layers_.clear();
        paint(elements_, true);
        return layers_;
    }

private:
    void gather(const std::vector<Element>& elements) {
        for (const Element& element : elements) {
            roots_.push_back(element.coverage);
            if (element.ray) {
                const auto& origin = element.ray->origin;
                const auto& direction = element.ray->direction;
                roots_.insert(roots_.end(), {origin.x, origin.y, origin.z, direction.x, direction.y,
                                             direction.z, element.ray->valid});
            }
            gather(element.group);
        }
    }

    double value() { return values_[next_++]; }
    V3d vector() {
        const double x = value();
        const double y = value();
        return {x, y, value()};
    }

    // Whether what is painted lets nothing through.
    bool paint(const std::vector<Element>& elements, bool parents_cover) {
        const std::size_t below = layers_.size();
        bool opaque = false;
        for (const Element& element : elements) {
            const double coverage = value();
            const bool covers = parents_cover && coverage > 0.0;
            const std::size_t mine = layers_.size();
            bool solid = true;
            if (element.ray) {
                Layer layer{false, false, vector(), vector()};
                solid = value() == 1.0;
                layer.covers = layer.shows = covers && solid;
                layers_.push_back(layer);
            } else if (!element.paint) {
                solid = paint(element.group, covers);
            }
            if (solid && coverage >= 1.0 && element.blend == camera::BlendMode::normal) {
                opaque = true;
                for (std::size_t i = below; i < mine; ++i) {
                    layers_[i].shows = false;
                }
            }
        }
        return opaque;
    }

    expr::Graph graph_;
    std::vector<Element> elements_;
    std::vector<expr::Expr> roots_;
    std::vector<double> values_;
    std::size_t next_ = 0;
    std::vector<Layer> layers_;
};

struct Tally {
    std::size_t lost = 0;     // Shown and not found.
    std::size_t uncanny = 0;  // Hidden and found all the same.
    std::size_t shown = 0;
    std::size_t hidden = 0;
    std::set<std::size_t> layers;  // That showed.
};

Tally tally(const camera::Picture& picture, double height, std::size_t places) {
    const double width = std::round(height * picture.aspect());
    Painter painter(picture, width, height);
    std::mt19937_64 random(1953);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    struct Asked {
        std::size_t layer;
        bool shows;
        V2d place;
    };
    std::vector<Asked> asked;
    std::vector<V3d> points;
    for (std::size_t i = 0; i < places; ++i) {
        const V2d place(width * unit(random), height * unit(random));
        const std::vector<Painter::Layer> layers = painter.at(place);
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            if (layers[layer].covers) {
                const double size = std::max(1.0, layers[layer].origin.length());
                const double distance = size * std::pow(10.0, 4.0 * unit(random) - 2.0);
                asked.push_back({layer, layers[layer].shows, place});
                points.push_back(layers[layer].origin + distance * layers[layer].direction);
            }
        }
    }
    const auto locator = Locator::make(picture, width, height);
    EXPECT_TRUE(locator) << to_text(locator.diagnostics);
    std::vector<bool> found(asked.size(), false);
    for (const Sighting& sighting : locator->locate(points)) {
        const Asked& from = asked[sighting.point];
        found[sighting.point] =
            found[sighting.point] ||
            (sighting.layer == from.layer && (sighting.position - from.place).length() < 0.01);
    }
    Tally counts;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        ++(asked[i].shows ? counts.shown : counts.hidden);
        counts.lost += asked[i].shows && !found[i] ? 1 : 0;
        counts.uncanny += !asked[i].shows && found[i] ? 1 : 0;
        if (asked[i].shows) {
            counts.layers.insert(asked[i].layer);
        }
    }
    return counts;
}

void expect_lawful(const Tally& counts, const std::string& what) {
    EXPECT_EQ(counts.lost, 0U) << what << ": of " << counts.shown;
    EXPECT_EQ(counts.uncanny, 0U) << what << ": of " << counts.hidden;
}

}  // namespace

TEST(InverseOfPictures, HoldsForThePoster) {
    const auto poster = lang::make_picture(BALCONY_SOURCE_DIR "/docs/pictures/poster.cam", "");
    ASSERT_TRUE(poster) << to_text(poster.diagnostics);
    const Tally counts = tally(*poster, 600, 4'000);
    expect_lawful(counts, "poster");
    EXPECT_EQ(counts.layers.size(), Locator::make(*poster, 1500, 600)->layers().size());
}

TEST(InverseOfPictures, HoldsForTheExamplesOfTheCatalogue) {
    std::size_t count = 0;
    for (const camera::StageEntry& row : camera::catalogue()) {
        if (row.example.find("picture ") != std::string_view::npos) {
            const Tally counts = tally(picture_of(std::string(row.example)), 200, 500);
            expect_lawful(counts, std::string(row.name));
            EXPECT_GT(counts.shown, 50U) << row.name;
            ++count;
        }
    }
    EXPECT_GE(count, 8U);
}

// Blend modes, alpha, a soft edge, pictures in pictures, bent and turned layers, layers of a few
// pixels, frames and lines.
TEST(InverseOfPictures, HoldsForLayersOfAllKinds) {
    const Tally counts = tally(picture_of(R"(
        picture inner {
            aspect 1
            layer fisheye
            layer pinhole { place (0.3, 0.3) .. (0.9, 0.9) clip ellipse }
        }
        picture wreath {
            aspect 1
            layer fisheye { clip ring(inner = 0.6) }
        }
        picture all {
            aspect 2
            layer panorama
            layer inner   { place (0.05, 0.1) .. (0.45, 0.9) arrange rotate(20deg) }
            layer inner   { place (0.5, 0.1) .. (0.75, 0.5) alpha 0.5 blend multiply }
            layer cylinder {
                place   (0.5, 0.4) .. (0.95, 0.95)
                arrange mirror(x), formula(x, y) = [x, y + 0.1*sin(3*x)]
                clip    star(7, inner = 0.6)
                soft    0.05
            }
            layer hyperbolic {
                place (0.77, 0.05) .. (0.97, 0.35)
                frame(width = 0.03)
                leader (0.1, 0.2) .. (0.3, 0.4)
            }
            layer wreath { place (0.3, 0.3) .. (0.5, 0.7) }
            layer orthographic { place (0.1, 0.6) .. (0.6, 0.8) blend screen }
        }
        )"),
                               300, 3'000);
    expect_lawful(counts, "all kinds");
    EXPECT_EQ(counts.layers.size(), 9U);
    EXPECT_GT(counts.hidden, 1'000U);
}

// A pinhole of 400 x 200 pixels in the right half of the picture: (4, 1, -0.5) is in its own
// picture at (150, 125), as the textbook has it.
TEST(InverseOfPictures, PlacesALayerByTheTextbookFormula) {
    const auto locator = Locator::make(picture_of(R"(
        picture halves {
            aspect 4
            layer orthographic { place (0, 0) .. (0.5, 1) }
            layer pinhole(fov = 90deg) { place (0.5, 0) .. (1, 1) }
        })"),
                                       800, 200);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    EXPECT_TRUE(locator->closed_form());
    EXPECT_EQ(locator->layers(), (std::vector<std::string>{"orthographic", "pinhole"}));
    std::size_t in_pinhole = 0;
    for (const Sighting& sighting : locator->locate(V3d(4, 1, -0.5))) {
        if (sighting.layer == 1) {
            EXPECT_LT((sighting.position - V2d(550, 125)).length(), 1e-6);
            EXPECT_NEAR(sighting.distance, std::sqrt(17.25), 1e-12);
            EXPECT_EQ(sighting.origin, V3d(0.0));
            ++in_pinhole;
        }
    }
    EXPECT_EQ(in_pinhole, 1U);
}

// The fish-eye shows a point in the middle of a picture that something else covers.
TEST(InverseOfPictures, OmitsHiddenPoints) {
    const auto layers_that_see = [](const std::string& in_front, const V3d& point) {
        const auto locator =
            Locator::make(picture_of("camera left { map u = 1 .. -1, v = square eye point(0, 0, 0) "
                                     "toward surface(u, v) = [1, u, v + sqrt(u)/1e9] } "
                                     "picture a { aspect 1 layer fisheye " +
                                     in_front + " }"),
                          200, 200);
        std::vector<std::size_t> layers;
        for (const Sighting& sighting : locator->locate(point)) {
            layers.push_back(sighting.layer);
        }
        std::sort(layers.begin(), layers.end());
        return layers;
    };
    using Layers = std::vector<std::size_t>;
    const V3d ahead(2, 0.1, 0.1);
    const V3d aside(0.5, 2, 0.1);
    const std::string wide = "layer pinhole { ";
    EXPECT_EQ(layers_that_see("", ahead), (Layers{0}));
    EXPECT_EQ(layers_that_see(wide + "}", ahead), (Layers{1}));
    EXPECT_EQ(layers_that_see(wide + "alpha 0.9 }", ahead), (Layers{0, 1}));
    EXPECT_EQ(layers_that_see(wide + "alpha 0 }", ahead), (Layers{0}));
    EXPECT_EQ(layers_that_see(wide + "blend darken }", ahead), (Layers{0, 1}));
    EXPECT_EQ(layers_that_see(wide + "}", aside), (Layers{}));
    EXPECT_EQ(layers_that_see(wide + "clip ring(inner = 0.5) }", ahead), (Layers{0}));
    // The frame alone hides.
    EXPECT_EQ(layers_that_see(wide + "alpha 0 frame(width = 1) }", ahead), (Layers{}));
    // Where a camera in front has no ray one sees through it.
    EXPECT_EQ(layers_that_see("layer left", ahead), (Layers{1}));
    EXPECT_EQ(layers_that_see("layer left", V3d(2, -0.1, 0.1)), (Layers{0}));
}

// Layers that the first look at a picture of a thousand pixels goes past, or sees in a place or
// two.
TEST(InverseOfPictures, FindsALayerOfAFewPixels) {
    const V3d point(1, 1, 0.3);
    const V2d whole = Locator::make(test::standard("fisheye"), 1, 1)->locate(point).at(0).position;
    for (const double size : {2.2, 8.0, 30.0}) {
        const camera::Picture stamp = picture_of(fmt::format(
            "picture stamp {{ aspect 1 layer fisheye {{ place (0.533, 0.271) .. ({}, {}) }} }}",
            0.533 + size / 1000.0, 0.271 + size / 1000.0));
        const auto found = Locator::make(stamp, 1000, 1000)->locate(point);
        ASSERT_EQ(found.size(), 1U) << size;
        const V2d place = V2d(533.0, 271.0) + size * whole;
        EXPECT_LT((found[0].position - place).length(), 1e-6) << size;
    }
}

TEST(InverseOfPictures, TakesPointsInTheGivenAxes) {
    const std::string cameras = R"(
        camera z { map u = 1 .. -1, v = square eye point(0, 0, 0) toward plane((1, 0, 0)) }
        camera y {
            axes y_up
            map u = 1 .. -1, v = square eye point(0, 0, 0) toward plane((1, 0, 0))
        }
        picture one_kind { layer y }
        picture both { aspect 2 layer z { place (0, 0) .. (0.5, 1) } layer y { place (0.5, 0) .. (1, 1) } }
        )";
    const auto mixed = Locator::make(picture_of(cameras), 400, 200);
    ASSERT_FALSE(mixed);
    EXPECT_NE(to_text(mixed.diagnostics).find("different axes"), std::string::npos);
    const auto z_up = Locator::make(picture_of(cameras), 400, 200, 0.0, Axes::z_up);
    const auto y_up = Locator::make(picture_of(cameras), 400, 200, 0.0, Axes::y_up);
    // What is above for the one is, in the other's axes, to the right.
    const auto in_z = z_up->locate(V3d(5, 1, 2));
    const auto in_y = y_up->locate(V3d(5, 2, -1));
    ASSERT_EQ(in_z.size(), 2U);
    ASSERT_EQ(in_y.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(in_z[i].position, in_y[i].position);
    }
    EXPECT_NE(in_z[0].position.x + 200.0, in_z[1].position.x);
    const auto own = Locator::make(
        *lang::make_picture(std::make_shared<const SourceText>("axes.cam", cameras), "one_kind"),
        200, 200);
    EXPECT_EQ(own->axes(), Axes::y_up);
}

}  // namespace balcony::analyse::inverse_of_pictures_test
