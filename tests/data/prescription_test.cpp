// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lenses in tables, in pbrt's .dat and in Zemax's .zmx: what is read, and what is said of what
// cannot be.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include <fmt/format.h>

#include "balcony/data.hpp"

namespace balcony::data::prescription_test {
namespace {

using camera::LensSurface;
using camera::Prescription;

Result<std::shared_ptr<const Prescription>> read(const std::string& text,
                                                 const std::string& name = "lens.dat") {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    return read_prescription(File::in_memory(name, name, bytes));
}

/// Radius of curvature, gap, index, diameter and what else there is of every surface.
std::string shown(const std::string& text, const std::string& name = "lens.dat") {
    const auto lens = read(text, name);
    if (!lens) {
        return to_text(lens.diagnostics);
    }
    std::string all;
    for (const LensSurface& s : (*lens)->surfaces) {
        all += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}{}",
                           s.curvature == 0.0 ? 0.0 : 1.0 / s.curvature, s.gap,
                           s.behind.index(camera::line_d), 2.0 * s.radius, s.stop ? " stop" : "");
        if (s.curvature_x) {
            all +=
                fmt::format(" radius_x={:g}", *s.curvature_x == 0.0 ? 0.0 : 1.0 / *s.curvature_x);
        }
        if (s.conic != 0.0) {
            all += fmt::format(" conic={:g}", s.conic);
        }
        for (std::size_t i = 0; i < s.aspheric.size(); ++i) {
            if (s.aspheric[i] != 0.0) {
                all += fmt::format(" a{}={:.6g}", 2 * i + 4, s.aspheric[i]);
            }
        }
        all += "\n";
    }
    return all;
}

/// Line and message of the first error.
std::string problem(const std::string& text, const std::string& name = "lens.dat") {
    const auto lens = read(text, name);
    if (lens) {
        return "none";
    }
    const Diagnostic& first = lens.diagnostics.front();
    EXPECT_FALSE(first.remedy.empty()) << first.message;
    if (!first.span.source) {
        return first.message;
    }
    return fmt::format("{}: {}", first.span.source->locate(first.span.begin).line, first.message);
}

const std::string two = "stop 1 air 4\n20 3 1.5 8\n";
const std::string last = "-20 30 air 8\n";

/// A biconvex lens behind its stop, as Zemax writes it.
std::string zemax(const std::string& first, const std::string& unit = "MM",
                  const std::string& glass = "GLAS BK7 0 0 1.5 64.2 0 0") {
    return fmt::format(
        "VERS 140124 258 36214\nMODE SEQ\nUNIT {} X W X CM MR CPMM\nSURF 0\n  TYPE STANDARD\n"
        "  CURV 0.0 0 0 0 0\n  DISZ INFINITY\n  DIAM 0 0 0 0 1\nSURF 1\n  TYPE STANDARD\n"
        "  CURV 0.0 0 0\n  DISZ 5\n  DIAM 9 0\nSURF 2\n  STOP\n  TYPE STANDARD\n  CURV 0.0 0\n"
        "  DISZ 1\n  DIAM 2 0 0\nSURF 3\n{}  DISZ 3\n  {}\n  DIAM 4 0\nSURF 4\n"
        "  TYPE STANDARD\n  CURV -0.05\n  DISZ 30\n  DIAM 4\nSURF 5\n  TYPE STANDARD\n  CURV 0\n"
        "  DISZ 0\n  DIAM 0\n",
        unit, first, glass);
}

const std::string sphere = "  TYPE STANDARD\n  CURV 0.05\n";

}  // namespace

TEST(LensTable, IsReadAsPbrtWritesIt) {
    EXPECT_EQ(shown("# a lens\n0\t1\t0\t4\n20\t3\t1.5\t8\n-20 30 1 8\r\n"),
              "0 1 1 4 stop\n20 3 1.5 8\n-20 30 1 8\n");
}

TEST(LensTable, HasWordsGlassesUnitsAndAspheres) {
    const std::string lens =
        "unit cm\nglass G 1.5 60\nradius gap index diameter\nstop, 0.1, air, 0.4\n"
        "2 0.3 G 0.8 conic=-1 a4=0.002  # front\n-2 3 air 0.8\n";
    EXPECT_EQ(shown(lens), "0 1 1 4 stop\n20 3 1.5 8 conic=-1 a4=2e-06\n-20 30 1 8\n");
    EXPECT_EQ(shown("20 3 1.6/50 8 stop\nplane 30 air 8\n"), "20 3 1.6 8 stop\n0 30 1 8\n");
    EXPECT_EQ(shown("20 3 n-bk7 8 stop\n-20 30 air 8\n"), "20 3 1.5168 8 stop\n-20 30 1 8\n");
    const std::string own =
        "glass S sellmeier 1.03961212 0.231792344 1.01046945 0.00600069867 0.0200179144 "
        "103.560653\n20 3 S 8 stop\n-20 30 air 8\n";
    EXPECT_EQ(shown(own), "20 3 1.5168 8 stop\n-20 30 1 8\n");
}

TEST(LensTable, HasToroidsAndCylinders) {
    EXPECT_EQ(shown("unit cm\nstop 0.1 air 0.4\n2 0.3 1.5 0.8 radius_x=2.5\n-2 3 air 0.8 "
                    "radius_x=plane conic=2\n"),
              "0 1 1 4 stop\n20 3 1.5 8 radius_x=25\n-20 30 1 8 radius_x=0 conic=2\n");
    EXPECT_EQ(shown("stop 1 air 4\nplane 3 1.5 8 radius_x=20\n-20 30 air 8\n"),
              "0 1 1 4 stop\n0 3 1.5 8 radius_x=20\n-20 30 1 8\n");
}

TEST(LensTable, NamesTheLineThatIsWrong) {
    EXPECT_EQ(problem(two + "-20 30 air\n"),
              "3: a surface has a radius, a gap, a medium and a diameter");
    EXPECT_EQ(problem(two + "-2O 30 air 8\n"), "3: this is not a number");
    EXPECT_EQ(problem(two + "-20 30 arr 8\n"), "3: there is no glass 'arr'");
    EXPECT_EQ(problem("unit furlong\n" + two + last), "1: there is no unit 'furlong'");
    EXPECT_EQ(problem(two + "unit mm\n" + last), "3: the unit stands behind a surface");
    EXPECT_EQ(problem("glass A 1.5\n" + two + last), "1: this is no glass");
    EXPECT_EQ(problem("glass A 1.5 0\n" + two + last), "1: an Abbe number is above 0");
    EXPECT_EQ(problem(two + "-20 30 1.5/0 8\n"), "3: an Abbe number is above 0");
    EXPECT_EQ(problem(two + "-20 30 air 8 a5=1\n"), "3: a surface has no 'a5=1'");
    EXPECT_EQ(problem(two + "-20 30 1.5 8\n"), "3: the last medium is not air");
    EXPECT_EQ(problem("stop 1 air 0\n20 3 1.5 8\n" + last), "1: this stop lets nothing through");
    EXPECT_EQ(problem("20 3 1.5 8\n" + last), "'lens.dat' has no stop");
    EXPECT_EQ(problem(two + "stop 1 1.5 8\n" + last), "3: 'lens.dat' has 2 stops");
    EXPECT_EQ(problem("stop 1 air 4\n20 0.5 1.5 8\n" + last),
              "3: this surface crosses the one in front of it at the distance 3.25 mm from the "
              "axis");
    EXPECT_EQ(problem("stop 1 air 4\n-20 3 1.5 8\n20 30 air 8\n"),
              "'lens.dat' has no real image of what is far away");
    EXPECT_EQ(problem("stop 1 air 4\nplane 5 1.6 8\n-20 30 air 8 a4=200\n"),
              "3: light of the axis is totally reflected by this surface if it is more than 0.0938 "
              "mm away from it");
    EXPECT_EQ(problem(two + "-20 30 air 8 radius_x=big\n"), "3: this is not a number");
    EXPECT_EQ(problem("stop 1 air 4\n20 3 1.5 8 radius_x=plane\nplane 30 air 8\n"),
              "'lens.dat' has no real image of what is far away in the horizontal plane");
    EXPECT_EQ(problem("# nothing\n"), "'lens.dat' has no surfaces");
}

TEST(Zemax, IsReadInTextOfBothKinds) {
    const std::string text = zemax(sphere);
    const std::string wanted = "0 1 1 4 stop\n20 3 1.5 8\n-20 30 1 8\n";
    EXPECT_EQ(shown(text, "lens.ZMX"), wanted);
    std::string wide = "\xFF\xFE";
    for (const char c : text) {
        wide += c;
        wide += '\0';
    }
    EXPECT_EQ(shown(wide, "lens.zmx"), wanted);
    EXPECT_EQ(shown(zemax("  TYPE EVENASPH\n  CURV 0.05\n  CONI -1\n  PARM 1 0\n  PARM 2 2e-6\n"),
                    "lens.zmx"),
              "0 1 1 4 stop\n20 3 1.5 8 conic=-1 a4=2e-06\n-20 30 1 8\n");
    EXPECT_EQ(shown(zemax(sphere, "CM"), "lens.zmx"),
              "0 10 1 40 stop\n200 30 1.5 80\n-200 300 1 80\n");
    EXPECT_EQ(shown(zemax(sphere, "MM", "GLAS N-BK7 0 0 1 1"), "lens.zmx"),
              "0 1 1 4 stop\n20 3 1.5168 8\n-20 30 1 8\n");
}

// The curve is in the vertical plane, as the parameters of h² to h¹⁴ are; the first one is the
// radius of its rotation, and 0 a cylinder.
TEST(Zemax, HasToroids) {
    EXPECT_EQ(shown(zemax("  TYPE TOROIDAL\n  CURV 0.05\n  CONI -1\n  PARM 1 25\n  PARM 2 0\n"
                          "  PARM 3 0.002\n",
                          "CM"),
                    "lens.zmx"),
              "0 10 1 40 stop\n200 30 1.5 80 radius_x=250 conic=-1 a4=2e-06\n-200 300 1 80\n");
    EXPECT_EQ(shown(zemax("  TYPE TOROIDAL\n  CURV 0.05\n"), "lens.zmx"),
              "0 1 1 4 stop\n20 3 1.5 8 radius_x=0\n-20 30 1 8\n");
    EXPECT_EQ(problem(zemax("  TYPE TOROIDAL\n  CURV 0.05\n  PARM 2 0.1\n"), "lens.zmx"),
              "23: of an aspheric surface, only a4 to a12 are supported");
}

TEST(Zemax, NamesWhatIsNotSupported) {
    EXPECT_EQ(problem(zemax("  TYPE COORDBRK\n"), "lens.zmx"),
              "21: surfaces of the type 'COORDBRK' are not supported");
    EXPECT_EQ(problem(zemax("  TYPE EVENASPH\n  CURV 0.05\n  PARM 1 0.1\n"), "lens.zmx"),
              "23: of an aspheric surface, only a4 to a12 are supported");
    EXPECT_EQ(problem(zemax(sphere, "FT"), "lens.zmx"), "3: there is no unit 'FT'");
    EXPECT_EQ(problem(zemax(sphere, "MM", "GLAS MIRROR"), "lens.zmx"),
              "24: mirrors are not supported");
    EXPECT_EQ(problem(zemax(sphere, "MM", "GLAS UNOBTAINIUM"), "lens.zmx"),
              "24: there is no glass 'UNOBTAINIUM'");
    EXPECT_EQ(problem(zemax(sphere + "  SQAP 1 1\n"), "lens.zmx"),
              "23: holes other than round ones are not supported");
    EXPECT_EQ(problem("MODE NSC\n", "lens.zmx"), "1: this is no sequential lens");
    EXPECT_EQ(problem("SURF 0\nSURF 1\n", "lens.zmx"), "1: this file has no surfaces of a lens");
}

// No text, however broken, makes the readers do more than say so.
TEST(Prescriptions, SurviveMutations) {
    std::mt19937 random(3);
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{"lens.dat", "unit cm\nglass G 1.5 60\n" + two + last},
          {"lens.zmx", zemax("  TYPE EVENASPH\n  CURV 0.05\n  PARM 2 2e-6\n")}}) {
        for (int i = 0; i < 3000; ++i) {
            std::string broken = text;
            for (int k = 0; k < 3; ++k) {
                const std::size_t at = random() % broken.size();
                if (k == 0 && i % 2 == 0) {
                    broken.erase(at, 1 + random() % 4);
                } else {
                    broken[at] = static_cast<char>(random() % 128);
                }
            }
            const auto lens = read(broken, name);
            EXPECT_EQ(lens.value.has_value(), !has_errors(lens.diagnostics));
            EXPECT_TRUE(!lens || camera::check(**lens).empty());
        }
    }
}

}  // namespace balcony::data::prescription_test
