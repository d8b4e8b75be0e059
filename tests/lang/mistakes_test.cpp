// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What people type who know other programs: each mistake is one error, with what is meant.

#include <gtest/gtest.h>

#include <algorithm>

#include "support.hpp"

namespace balcony::lang::mistakes_test {

namespace {

struct Mistake {
    std::string_view text;
    std::string_view remedy;
};

const std::vector<Mistake> mistakes = {
    Mistake{"camera my camera { map u = -1 .. 1, v = square eye sphere(1) }",
            "write camera my_camera { ... }"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look left }",
            "write along(y) for the left of the scene, or sideways left for that of a curve"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look inwards }",
            "write normal inward"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look outwards }",
            "write normal outward"},
    Mistake{"picture p 800 x 600px { layer pinhole }",
            "write the size of a picture as 1920 x 1080; positions and widths in a picture are "
            "fractions, such as 0.5 for its middle"},
    Mistake{"picture p 800px x 600px { layer pinhole }",
            "write the size of a picture as 1920 x 1080; positions and widths in a picture are "
            "fractions, such as 0.5 for its middle"},
    Mistake{"picture p 800, 600 { layer pinhole }", "for example 1920 x 1080"},
    Mistake{"picture p (800, 600) { layer pinhole }",
            "names consist of letters, digits and _, and start with a letter"},
    Mistake{"picture p { size 800 x 600 layer pinhole }",
            "write the size behind the name: picture NAME 1920 x 1080"},
    Mistake{"picture p { layer panorama { opacity 0.5 } }",
            "write alpha 0.5, from 0 (invisible) to 1"},
    Mistake{"picture p { layer panorama { alpha 50% } }", "write a fraction, 0.5 for 50 %"},
    Mistake{"picture p { layer panorama { place (10%, 10%) .. (50%, 50%) } }",
            "write a fraction, 0.5 for 50 %"},
    Mistake{"picture p { layer panorama { place (10px, 10px) .. (50px, 50px) } }",
            "write the size of a picture as 1920 x 1080; positions and widths in a picture are "
            "fractions, such as 0.5 for its middle"},
    Mistake{"picture p { camera panorama }", "write layer panorama to show it"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) focus 5 }",
            "write lens(radius = 0.1, focus = 5)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) shutter 0.02 }",
            "give the shutter to the command: --shutter 0.02"},
    Mistake{"camera a { fov 60deg map u = -1 .. 1, v = square eye sphere(1) }",
            "the field of view is the range of map; for a pinhole camera: map u = tan(fov/2) .. "
            "-tan(fov/2), v = square"},
    Mistake{"camera a { map u = -1 .. 1 v = square eye sphere(1) }",
            "write map u = -1 .. 1, v = -1 .. 1"},
    Mistake{"camera a { map u = -1 to 1, v = square eye sphere(1) }", "a range is written -1 .. 1"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye = sphere(1) }", "remove the '='"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere 1 }",
            "write arguments in parentheses: sphere(1)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(radius: 1) }",
            "write name = value, for example radius = 1"},
    Mistake{"camera a { map u = -180° .. 180°, v = -90° .. 90° eye sphere(1) }", "write 180deg"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look toward (0, 0, 1) }",
            "the direction object is a statement: toward point(1, 0, 0)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye at (0, 0, 1) }", "write point(0, 0, 1.6)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye (0, 0, 1) }",
            "write point(0, 0, 1) for a point"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye point(0, 0, 1) lookat (1, 0, 0) }",
            "write toward point(1, 0, 0), with a direction object"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye point(0, 0, 1) target plane((1, 0, 0)) }",
            "write toward plane((1, 0, 0)), with a direction object"},
    Mistake{"Camera a { map u = -1 .. 1, v = square eye sphere(1) }", "did you mean 'camera'?"},
    Mistake{"def f(x): x\ncamera a { map u = -1 .. 1, v = square eye sphere(1) }",
            "write let half(x) = x/2"},
    Mistake{"include \"pinhole.cam\"\ncamera a { map u = -1 .. 1, v = square eye sphere(1) }",
            "write import \"pinhole.cam\""},
    Mistake{"import pinhole\ncamera a { map u = -1 .. 1, v = square eye sphere(1) }",
            "for example import \"pinhole.cam\""},
    Mistake{"camera a(fov: 60deg) { map u = -fov .. fov, v = square eye sphere(1) }",
            "write fov = ..."},
    Mistake{"camera a(float fov = 60deg) { map u = -fov .. fov, v = square eye sphere(1) }",
            "parameters have no types: write fov = ..."},
    Mistake{"camera a { param fov = 60deg map u = -fov .. fov, v = square eye sphere(1) }",
            "parameters stand behind the name of the camera: camera NAME(fov = 60deg) { ... }"},
    Mistake{"camera a { let fov = 60 deg map u = -fov .. fov, v = square eye sphere(1) }",
            "append the unit to its number: 30deg, 0.5rad"},
    Mistake{"picture p { pinhole }", "write layer pinhole"},
    Mistake{"picture p { layer \"pinhole.cam\" }", "remove the quotation marks: pinhole"},
    Mistake{
        "camera a { fisheye(fov = 200deg) }",
        "write camera NAME = fisheye( ... ), without a block, for a camera with other values of "
        "its parameters"},
    Mistake{"camera a { extends fisheye }",
            "write camera wide = fisheye(fov = 200deg), without a block"},
    Mistake{"function f(x) = x/2\ncamera a { map u = -1 .. f(2), v = square eye sphere(1) }",
            "write 'let' instead of 'function'"},
    Mistake{"fov = 60deg\ncamera a { map u = -fov .. fov, v = square eye sphere(1) }",
            "write 'let' before 'fov'"},
    Mistake{"var fov = 60deg\ncamera a { map u = -fov .. fov, v = square eye sphere(1) }",
            "write 'let' instead of 'var'"},
    Mistake{"import lengths.cam\ncamera a { map u = -1 .. 1, v = square eye sphere(1) }",
            "write \"vase.obj\", in quotation marks, for a file name; 0.5 for a number"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) for i in 0 .. 3 { move rotate(z, "
            "i*10deg) } }",
            "loops repeat the layers of a picture; write repeat(n, ...) in warp or move"},
    Mistake{
        "camera a { map u = -1 .. 1, v = square eye sphere(1) if t > 1 { move rotate(z, 10deg) } }",
        "choose between numbers with if(condition, a, b)"},
    Mistake{"picture p { layer pinhole { clip circle } }",
            "write ellipse; in a window of aspect 1 it is a circle"},
    Mistake{"picture p { layer pinhole { frame width 0.01 } }", "write frame(width = 0.01)"},
    Mistake{"picture p { layer pinhole { border } }",
            "write frame(width = 0.01, color = (1, 1, 1))"},
    Mistake{"picture p { layer pinhole { map u = -1 .. 1, v = square } }",
            "'map' belongs in a camera; a layer names a camera: layer panorama"},
    Mistake{"picture p { background white layer pinhole }",
            "give the background to the command: --background white"},
    Mistake{"picture p { layer pinhole { contain } }", "write fit"},
    Mistake{"camera a { aspect 16:9 map u = -1 .. 1, v = square eye sphere(1) }",
            "write a ratio as a quotient: aspect 16/9"},
    Mistake{"camera a { aspect 16x9 map u = -1 .. 1, v = square eye sphere(1) }",
            "write a ratio as a quotient: aspect 16/9"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look z }",
            "write along(x) for a fixed direction: x forward, y to the left, z up, or -x, -y, -z"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look (0, 0, 1) }",
            "write along((0, 0, 1)) for a fixed direction"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look forward }",
            "write along(x), or tangent forward along a curve"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look down }", "write along(-z)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(1) look at the wall }",
            "the direction object is written toward point(1, 0, 0)"},
    Mistake{"camera a { map u = -1 .. 1, v = square eye sphere(5px) }",
            "write the size of a picture as 1920 x 1080; positions and widths in a picture are "
            "fractions, such as 0.5 for its middle"},
    Mistake{"camera a { map u = -1 .. 1, v = square warp zoom 2 eye sphere(1) }",
            "write arguments in parentheses: zoom(2)"},
    Mistake{"camera a { map u = 0 .. 2pi, v = square eye sphere(1) }",
            "angles are written 30deg or 0.5rad, lengths 2, in units of the scene, products 2*pi"},
};

}  // namespace

TEST(Mistakes, AreOneErrorEachWithWhatIsMeant) {
    for (const Mistake& mistake : mistakes) {
        const auto source =
            std::make_shared<const SourceText>("test.cam", std::string(mistake.text));
        const Diagnostics found = Workspace().make_all(source).diagnostics;
        ASSERT_EQ(found.size(), 1U) << mistake.text << '\n' << to_text(found);
        EXPECT_EQ(found[0].remedy, mistake.remedy) << mistake.text;
    }
}

// The size of a picture is understood as it is often written.
TEST(Mistakes, AreNoneInASizeWithoutSpaces) {
    const auto source =
        std::make_shared<const SourceText>("test.cam", "picture p 800x600 { layer pinhole }");
    const auto made = make_picture(source, "");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ((*made->parts().size)[1], 600U);
}

}  // namespace balcony::lang::mistakes_test
