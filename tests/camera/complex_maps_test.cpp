// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <complex>
#include <functional>
#include <numbers>
#include <random>

#include "transform_probe.hpp"

namespace balcony::camera::complex_maps_test {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
// Values of everyday size after some dozen roundings.
constexpr double tolerance = 1e-12;

class Map {
public:
    explicit Map(const char* name, const Given& given = {}) : probe_(warp(name, given)) {}
    Complex operator()(Complex z) const {
        const WarpSample s = probe_(z.real(), z.imag());
        EXPECT_TRUE(s.valid) << z;
        return {s.point[0], s.point[1]};
    }
    [[nodiscard]] WarpSample sample(Complex z) const { return probe_(z.real(), z.imag()); }

private:
    WarpProbe probe_;
};

void expect_near(Complex found, Complex wanted, double within = tolerance) {
    EXPECT_NEAR(found.real(), wanted.real(), within);
    EXPECT_NEAR(found.imag(), wanted.imag(), within);
}

Map power(double re, double im = 0.0) {
    return Map("power", {{"exponent", numbers({re})}, {"imaginary", numbers({im})}});
}

Given coefficients(Complex a, Complex b, Complex c, Complex d) {
    const auto two = [](Complex z) { return numbers({z.real(), z.imag()}); };
    return {{"a", two(a)}, {"b", two(b)}, {"c", two(c)}, {"d", two(d)}};
}

std::vector<Complex> some_points() {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> part(-2.0, 2.0);
    std::vector<Complex> points;
    for (int i = 0; i < 50; ++i) {
        points.emplace_back(part(engine), part(engine));
    }
    return points;
}

}  // namespace

TEST(ComplexMaps, AreTheFunctionsOfTheirNames) {
    for (const Complex z : some_points()) {
        expect_near(Map("exponential")(z), std::exp(z));
        expect_near(Map("logarithm")(z), std::log(z));
        expect_near(power(3.0)(z), z * z * z);
        expect_near(power(0.5)(z), std::sqrt(z));
        expect_near(power(-1.0)(z), 1.0 / z);
        // Relative to a value of up to exp(0.7 pi) 3^0.3.
        expect_near(power(0.3, 0.7)(z), std::pow(z, Complex(0.3, 0.7)), 20.0 * tolerance);
    }
}

// Cauchy and Riemann: d w / d v = i d w / d u.
TEST(ComplexMaps, AreConformal) {
    const std::vector<Map> maps{
        Map("exponential"),
        Map("logarithm"),
        power(3.0),
        power(0.4),
        power(0.3, 0.7),
        Map("moebius", coefficients({1.0, 0.5}, 2.0, {0.3, -1.0}, {-1.0, 3.0})),
        Map("print_gallery"),
        Map("print_gallery", {{"turns", numbers({2.0})}, {"shape", std::string("ellipse")}})};
    for (const Map& map : maps) {
        for (const Complex z : some_points()) {
            const WarpSample s = map.sample(z);
            const double size = std::hypot(s.by_u[0], s.by_u[1]);
            EXPECT_GT(size, 0.0);
            EXPECT_NEAR(s.by_v[0], -s.by_u[1], tolerance * size);
            EXPECT_NEAR(s.by_v[1], s.by_u[0], tolerance * size);
        }
    }
}

TEST(ComplexMaps, InverseFunctionsUndoEachOther) {
    for (const Complex z : some_points()) {
        expect_near(Map("exponential")(Map("logarithm")(z)), z);
        expect_near(power(2.5)(power(0.4)(z)), z);
        expect_near(power(3.0)(power(1.0 / 3.0)(z)), z);
    }
}

TEST(Power, OfAWholeExponentHasNoSeamAndNoHole) {
    const Map cube = power(3.0);
    expect_near(cube(0.0), 0.0);
    expect_near(cube({-1.0, 1e-9}), cube({-1.0, -1e-9}), 1e-8);
}

TEST(Power, OfAComplexExponentIsTheExponentialOfItsLogarithm) {
    const Complex w{2.0, 0.5};
    for (const Complex z : some_points()) {
        expect_near(power(w.real(), w.imag())(z), std::exp(w * std::log(z)), 1e-10);
    }
}

TEST(Power, IsUndefinedInItsCentreAlone) {
    EXPECT_FALSE(power(0.5).sample(0.0).valid);
    EXPECT_TRUE(power(0.5).sample(1e-100).valid);
    EXPECT_FALSE(Map("logarithm").sample(0.0).valid);
    EXPECT_FALSE(Map("print_gallery").sample(0.0).valid);
}

TEST(Logarithm, HasItsSeamWhereItIsTold) {
    for (const double cut : {pi, 0.5 * pi, -2.0, 0.0}) {
        const Map log("logarithm", {{"cut", numbers({cut})}});
        for (double angle = cut - 2.0 * pi + 1e-6; angle < cut; angle += 0.1) {
            expect_near(log(std::polar(2.0, angle)), {std::log(2.0), angle});
        }
        EXPECT_NEAR(log(std::polar(2.0, cut - 1e-9)).imag(), cut, 1e-8);
        EXPECT_NEAR(log(std::polar(2.0, cut + 1e-9)).imag(), cut - 2.0 * pi, 1e-8);
    }
}

TEST(Power, IsAboutItsCentre) {
    const Map map("power", {{"exponent", numbers({2.0})}, {"at", numbers({0.5, -0.25})}});
    const Complex at(0.5, -0.25);
    for (const Complex z : some_points()) {
        expect_near(map(z), at + (z - at) * (z - at));
    }
}

TEST(Moebius, CompositionIsTheProductOfMatrices) {
    const std::array<Complex, 4> m{{{1.0, 0.5}, 2.0, {0.3, -1.0}, {-1.0, 3.0}}};
    const std::array<Complex, 4> n{{{0.2, -0.4}, {1.0, 1.0}, 0.7, {0.0, 2.0}}};
    const auto map = [](const std::array<Complex, 4>& k) {
        return Map("moebius", coefficients(k[0], k[1], k[2], k[3]));
    };
    const Map product = map({m[0] * n[0] + m[1] * n[2], m[0] * n[1] + m[1] * n[3],
                             m[2] * n[0] + m[3] * n[2], m[2] * n[1] + m[3] * n[3]});
    for (const Complex z : some_points()) {
        const Complex once = product(z);
        // Near the pole of one of them values are large.
        expect_near(map(m)(map(n)(z)), once, 1e-11 * (1.0 + std::norm(once)));
    }
}

TEST(Moebius, HasNoValueAtItsPole) {
    const Map inversion("moebius", coefficients(0.0, 1.0, 1.0, {-0.5, 0.25}));
    EXPECT_FALSE(inversion.sample({0.5, -0.25}).valid);
    EXPECT_TRUE(inversion.sample({0.5, -0.2499}).valid);
}

TEST(Moebius, WithoutAnInverseIsAnError) {
    const auto made = try_stage(StageKind::parameter_transformer, "moebius",
                                coefficients(1.0, 2.0, {0.0, 2.0}, {0.0, 4.0}));
    ASSERT_FALSE(made);
    EXPECT_NE(made.diagnostics.front().message.find("a d = b c"), std::string::npos);
    // a d and b c differ in one part alone.
    for (const Complex d : {Complex(4.0, 1.0), Complex(5.0, 0.0)}) {
        EXPECT_TRUE(
            try_stage(StageKind::parameter_transformer, "moebius", coefficients(1.0, 2.0, 2.0, d)));
    }
}

// Multiplication by gamma with gamma^alpha = s turns and scales the picture onto itself.
TEST(PrintGallery, RepeatsUnderItsOwnScaling) {
    for (const double turns : {1.0, -1.0, 2.0}) {
        const double s = 20.0;
        const Map map("print_gallery",
                      {{"scale", numbers({s})},
                       {"turns", numbers({std::fabs(turns)})},
                       {"grows", std::string(turns > 0.0 ? "clockwise" : "counter_clockwise")}});
        const Complex alpha(1.0, -turns * std::log(s) / (2.0 * pi));
        const Complex gamma = std::exp(std::log(s) / alpha);
        for (const Complex z : some_points()) {
            expect_near(map(gamma * z), map(z));
        }
    }
}

TEST(PrintGallery, GrowsTheWayItSays) {
    for (const char* way : {"clockwise", "counter_clockwise"}) {
        const Map map("print_gallery", {{"frame", numbers({1e3, 1e3})},
                                        {"scale", numbers({1e6})},
                                        {"grows", std::string(way)}});
        // Where a step shows less, things are larger.
        const auto shows = [&](double angle) {
            return std::hypot(map.sample(std::polar(1.0, angle)).by_u[0],
                              map.sample(std::polar(1.0, angle)).by_u[1]);
        };
        EXPECT_EQ(shows(-0.1) < shows(0.1), std::string_view(way) == "clockwise");
    }
}

// The seam of the power lies where one way round has become a whole number of scales.
TEST(PrintGallery, ClosesRoundItsCentre) {
    const Map map("print_gallery", {{"scale", numbers({20.0})}});
    for (const double r : {0.1, 0.37, 1.4}) {
        expect_near(map({-r, 1e-10}), map({-r, -1e-10}), 1e-8);
    }
}

TEST(PrintGallery, StaysInTheRingOfItsFrame) {
    const Map box("print_gallery", {{"scale", numbers({8.0})}, {"frame", numbers({2.0, 1.0})}});
    const Map oval("print_gallery", {{"scale", numbers({8.0})},
                                     {"frame", numbers({2.0, 1.0})},
                                     {"shape", std::string("ellipse")}});
    for (const Complex z : some_points()) {
        const Complex a = box(z);
        const Complex b = oval(z);
        const double in_box = std::max(std::fabs(a.real()) / 2.0, std::fabs(a.imag()));
        const double in_oval = std::hypot(b.real() / 2.0, b.imag());
        for (const double size : {in_box, in_oval}) {
            EXPECT_GT(size, 1.0 / 8.0 - tolerance);
            EXPECT_LE(size, 1.0 + tolerance);
        }
    }
}

// Of the frame, the centre is nearly at the right edge; it would be outside of its ellipse.
TEST(PrintGallery, StaysInTheRingOfAFrameBesideItsCentre) {
    const std::array frame{1.5, 1.0};
    const std::array middle{-1.4, 0.5};
    for (const bool ellipse : {false, true}) {
        const double s = 8.0;
        const double shrunk = ellipse ? 0.3 : 1.0;
        const Map map("print_gallery",
                      {{"scale", numbers({s})},
                       {"frame", numbers({frame[0], frame[1]})},
                       {"offset", numbers({shrunk * middle[0], shrunk * middle[1]})},
                       {"shape", std::string(ellipse ? "ellipse" : "rectangle")}});
        const auto encloses = [&](const Complex& w, double size) {
            const double a = std::fabs(w.real() - size * shrunk * middle[0]) / (size * frame[0]);
            const double b = std::fabs(w.imag() - size * shrunk * middle[1]) / (size * frame[1]);
            return (ellipse ? std::hypot(a, b) : std::max(a, b)) <= 1.0;
        };
        for (const Complex z : some_points()) {
            EXPECT_TRUE(encloses(map(z), 1.0 + tolerance));
            EXPECT_FALSE(encloses(map(z), 1.0 / s - tolerance));
        }
    }
}

TEST(PrintGallery, RejectsACentreOutsideItsFrame) {
    for (const char* shape : {"rectangle", "ellipse"}) {
        const auto made = try_stage(StageKind::parameter_transformer, "print_gallery",
                                    {{"frame", numbers({2.0, 1.0})},
                                     {"offset", numbers({0.0, -1.0})},
                                     {"shape", std::string(shape)}});
        ASSERT_FALSE(made) << shape;
        EXPECT_NE(made.diagnostics.front().message.find("not inside the frame"), std::string::npos);
    }
}

TEST(PrintGallery, WithoutTurnsIsAPictureWithinThePicture) {
    const Map map("print_gallery", {{"scale", numbers({4.0})}, {"turns", numbers({0.0})}});
    expect_near(map({0.7, 0.1}), {0.7, 0.1});
    expect_near(map({0.1, 0.2}), {0.4, 0.8});
    expect_near(map({3.0, -0.5}), {0.75, -0.125});
}

}  // namespace balcony::camera::complex_maps_test
