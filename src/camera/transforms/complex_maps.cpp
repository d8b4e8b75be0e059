// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformers, PCS → PCS: functions of one complex variable, z = u + i v. They preserve
// angles wherever their derivative is not 0.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

constexpr double pi = std::numbers::pi;

struct Complex {
    Expr re, im;
};

Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }

Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Expr squared_size(const Complex& z) { return z.re * z.re + z.im * z.im; }

/// Undefined where b is 0.
Complex quotient(const Complex& a, const Complex& b, Emitter& emit) {
    const Expr size = squared_size(b);
    emit.require(0.0 < size);
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
}

Complex exponential(const Complex& z) {
    const Expr size = exp(z.re);
    return {size * cos(z.im), size * sin(z.im)};
}

/// The branch whose imaginary part lies in (cut - 2 pi, cut]. Undefined at 0.
Complex logarithm(const Complex& z, Expr cut, Emitter& emit) {
    const Expr size = squared_size(z);
    emit.require(0.0 < size);
    const Expr turn = cut - pi;
    const Expr c = cos(turn);
    const Expr s = sin(turn);
    return {0.5 * log(size), atan2(c * z.im - s * z.re, c * z.re + s * z.im) + turn};
}

Complex complex_of(const Pair& t, const Emitter& emit) { return {emit(t[0]), emit(t[1])}; }

Complex offset(const ParameterPoint& p, const Pair& at, const Emitter& emit) {
    return {p.u - emit(at[0]), p.v - emit(at[1])};
}

/// z^w about a point. A positive integer w needs no branch and no logarithm.
class Power final : public ParameterTransformer {
public:
    Power(Pair exponent, Scalar cut, Pair at)
        : exponent_(std::move(exponent)), cut_(std::move(cut)), at_(std::move(at)) {}

    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Complex z = offset(p, at_, emit);
        const int whole = whole_exponent();
        Complex w = z;
        if (whole > 0) {
            for (int i = 1; i < whole; ++i) {
                w = w * z;
            }
        } else {
            w = exponential(complex_of(exponent_, emit) * logarithm(z, emit(cut_), emit));
        }
        return {emit(at_[0]) + w.re, emit(at_[1]) + w.im};
    }

private:
    /// The exponent if it is 1, 2, ..., else 0.
    [[nodiscard]] int whole_exponent() const {
        constexpr double maximum = 16.0;
        const double re = exponent_[0].constant().value_or(0.0);
        const bool whole = 1.0 <= re && re <= maximum && re == std::floor(re);
        return whole && exponent_[1].constant() == 0.0 ? static_cast<int>(re) : 0;
    }

    Pair exponent_;
    Scalar cut_;
    Pair at_;
};

class Exponential final : public ParameterTransformer {
public:
    ParameterPoint transform(const ParameterPoint& p, Emitter&) const override {
        const Complex w = exponential({p.u, p.v});
        return {w.re, w.im};
    }
};

class Logarithm final : public ParameterTransformer {
public:
    explicit Logarithm(Scalar cut) : cut_(std::move(cut)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Complex w = logarithm({p.u, p.v}, emit(cut_), emit);
        return {w.re, w.im};
    }

private:
    Scalar cut_;
};

/// (a z + b) / (c z + d).
class Moebius final : public ParameterTransformer {
public:
    Moebius(Pair a, Pair b, Pair c, Pair d)
        : a_(std::move(a)), b_(std::move(b)), c_(std::move(c)), d_(std::move(d)) {}

    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Complex z{p.u, p.v};
        const Complex w = quotient(complex_of(a_, emit) * z + complex_of(b_, emit),
                                   complex_of(c_, emit) * z + complex_of(d_, emit), emit);
        return {w.re, w.im};
    }

private:
    Pair a_, b_, c_, d_;
};

/// The map of Escher's "Print Gallery" as B. de Smit and H. W. Lenstra found it ("The mathematical
/// structure of Escher's Print Gallery", Notices of the AMS 50, 2003): z^alpha with
/// alpha = (2 pi i + n log s) / (2 pi i) maps one turn around the centre to a scaling by n log s,
/// and a straight picture that contains itself s times smaller is continuous there. It repeats by
/// the reduction to one ring, frame/s < size <= frame, where size is measured by the frame's shape:
/// it is 1 on the frame, and proportional along each ray from the centre.
class PrintGallery final : public ParameterTransformer {
public:
    PrintGallery(Scalar scale, double turns, Pair frame, Pair offset, bool ellipse, Pair at)
        : scale_(std::move(scale)),
          turns_(turns),
          frame_(std::move(frame)),
          offset_(std::move(offset)),
          ellipse_(ellipse),
          at_(std::move(at)) {}

    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Expr log_scale = log(emit(scale_));
        const Complex alpha{emit(1.0), log_scale * (-turns_ / (2.0 * pi))};
        const Complex log_z = logarithm(offset(p, at_, emit), emit(pi), emit);
        const Complex w = exponential(alpha * log_z);
        const Expr log_size = log(ellipse_ ? size_in_ellipse(w, emit) : size_in_rectangle(w, emit));
        const Expr into_ring = exp(log_scale * floor(-log_size / log_scale));
        return {emit(at_[0]) + into_ring * w.re, emit(at_[1]) + into_ring * w.im};
    }

private:
    [[nodiscard]] Expr size_in_rectangle(const Complex& w, Emitter& emit) const {
        const auto along = [&](std::size_t axis, const Expr& part) {
            const Expr half = emit(frame_[axis]);
            const Expr middle = emit(offset_[axis]);
            return max(part / (half + middle), part / (middle - half));
        };
        return max(along(0, w.re), along(1, w.im));
    }

    /// The positive m with |p - m q| = m, for w and the offset in units of the frame.
    [[nodiscard]] Expr size_in_ellipse(const Complex& w, Emitter& emit) const {
        const Complex p{w.re / emit(frame_[0]), w.im / emit(frame_[1])};
        const Complex q{emit(offset_[0]) / emit(frame_[0]), emit(offset_[1]) / emit(frame_[1])};
        const Expr pq = p.re * q.re + p.im * q.im;
        const Expr rest = 1.0 - squared_size(q);
        return (sqrt(pq * pq + rest * squared_size(p)) - pq) / rest;
    }

    Scalar scale_;
    double turns_;
    Pair frame_;
    Pair offset_;
    bool ellipse_;
    Pair at_;
};

StageParameter cut_parameter() {
    return angle_parameter("cut", pi, "the direction of the branch cut from the centre");
}

StageParameter complex_parameter(std::string_view name, double value, std::string_view meaning) {
    return pair_parameter(name, {value, 0.0}, meaning);
}

/// Whether a d = b c, if all are constant.
bool is_degenerate(const Arguments& arguments) {
    std::array<double, 8> value{};
    std::size_t i = 0;
    for (const char* name : {"a", "b", "c", "d"}) {
        for (const Scalar& part : arguments.pair(name)) {
            const std::optional<double> known = part.constant();
            if (!known) {
                return false;
            }
            value[i++] = *known;
        }
    }
    const auto& [ar, ai, br, bi, cr, ci, dr, di] = value;
    return ar * dr - ai * di == br * cr - bi * ci && ar * di + ai * dr == br * ci + bi * cr;
}

/// Whether a point is inside a frame about the origin; true if it changes with time.
bool is_inside(const Pair& point, const Pair& frame, bool ellipse) {
    std::array<double, 2> part{};
    for (const std::size_t axis : {0U, 1U}) {
        const std::optional<double> value = point[axis].constant();
        const std::optional<double> half = frame[axis].constant();
        if (!value || !half) {
            return true;
        }
        part[axis] = std::fabs(*value / *half);
    }
    return (ellipse ? std::hypot(part[0], part[1]) : std::max(part[0], part[1])) < 1.0;
}

}  // namespace

std::vector<StageEntry> complex_maps() {
    const StageParameter center = pair_parameter("at", {0.0, 0.0}, "the centre");
    return {
        {.name = "power",
         .meaning = "z^w of z = u + i v; a whole w from 1 to 16 has no branch cut",
         .formula = R"(
u′ + i v′ = at + z^w = at + exp(w log z)
z = (u − at₁) + i (v − at₂),   w = exponent + i imaginary
log z = log |z| + i arg z with cut − 360° < arg z ≤ cut
)",
         .parameters = {number_parameter("exponent", 2.0, "the real part of w"),
                        number_parameter("imaginary", 0.0, "the imaginary part of w"),
                        cut_parameter(), center},
         .make =
             [](const Arguments& a) {
                 return made<Power>(Pair{a.number("exponent"), a.number("imaginary")},
                                    a.number("cut"), a.pair("at"));
             },
         .example = R"(camera power {
    map    u = 1.2 .. -1.2, v = square
    warp   power(2)
    eye    point
    toward plane((1, 0, 0))
})"},
        {.name = "exponential",
         .meaning = "e^z of z = u + i v: columns become circles, rows become rays from (0, 0)",
         .formula = R"(
u′ + i v′ = exp(u + i v) = exp(u) (cos v + i sin v)
)",
         .make = [](const Arguments&) { return made<Exponential>(); },
         .example = R"(camera exponential {
    map    u = 180deg .. -180deg, v = square
    warp   exponential
    eye    point
    toward plane((1, 0, 0))
})"},
        {.name = "logarithm",
         .meaning = "log z of z = u + i v: unrolls the surroundings of (0, 0): u becomes the "
                    "logarithm of the "
                    "distance and v the angle",
         .formula = R"(
u′ + i v′ = log z = log |z| + i arg z      z = u + i v ≠ 0
cut − 360° < arg z ≤ cut
)",
         .parameters = {cut_parameter()},
         .make = maker<Logarithm>("cut"),
         .example = R"(camera logarithm {
    map  u = 3 .. -3, v = square
    warp logarithm, rotate(90deg)
    eye  sphere(1)
})"},
        {.name = "moebius",
         .meaning =
             "(a z + b) / (c z + d) of z = u + i v: circles and lines become circles and lines",
         .formula = R"(
u′ + i v′ = (a z + b)/(c z + d)      z = u + i v
no ray where c z + d = 0
)",
         .parameters = {complex_parameter("a", 1.0, "(real part, imaginary part)"),
                        complex_parameter("b", 0.0, "(real part, imaginary part)"),
                        complex_parameter("c", 0.0, "(real part, imaginary part)"),
                        complex_parameter("d", 1.0,
                                          "(real part, imaginary part); a d must differ from b c")},
         .make = [](const Arguments& a) -> StageResult {
             if (is_degenerate(a)) {
                 return error("a d = b c maps all of parameter space to one point", {},
                              "change one of a, b, c and d");
             }
             return made<Moebius>(a.pair("a"), a.pair("b"), a.pair("c"), a.pair("d"));
         },
         .example = R"(camera moebius {
    map    u = 1.2 .. -1.2, v = square
    warp   moebius(a = (1, 0), b = (0.3, 0), c = (0.4, 0.4), d = (1, 0))
    eye    point
    toward plane((1, 0, 0))
})"},
        {.name = "print_gallery",
         .meaning = "Escher's Print Gallery: along one turn around the centre, everything grows "
                    "`scale` times and joins itself",
         .formula = R"(
u′ + i v′ = at + scale^k z^α      z = (u − at₁) + i (v − at₂)
α = 1 − i turns log(scale)/2π for grows = clockwise, 1 + i … for the other
z^α = exp(α log z) with −180° < arg z ≤ 180°
k   the whole number with 1/scale < scale^k m ≤ 1, where for z^α = a + i b
    m = the smallest number for which m offset ± m frame encloses (a, b):
    without an offset, max(|a|/frame₁, |b|/frame₂) for rectangle and
    √((a/frame₁)² + (b/frame₂)²) for ellipse
(B. de Smit and H. W. Lenstra, "The Mathematical Structure of Escher's Print
Gallery", 2003: theirs is turns = 1, scale = 256.)
)",
         .parameters =
             {number_parameter("scale", 256.0, "size of a picture relative to the one inside it",
                               {.minimum = 1.0, .excludes_minimum = true}),
              {.name = "turns",
               .type =
                   CountParameter{.default_value = 1.0, .range = {.minimum = 0.0, .maximum = 16.0}},
               .meaning =
                   "number of scale factors per turn; 0 is the picture within the picture, without "
                   "rotation"},
              choice_parameter("grows", {"clockwise", "counter_clockwise"},
                               "sense in which things become larger, for u to the right and v up; "
                               "if u runs to the left, it is reversed"),
              {.name = "frame",
               .type = PairParameter{.unit = Unit::either,
                                     .default_value = std::array{1.0, 1.0},
                                     .range = {.minimum = 0.0, .excludes_minimum = true},
                                     .one_for_both = true},
               .meaning =
                   "half the width and height of the picture that repeats; its edge is the seam"},
              {.name = "offset",
               .type = PairParameter{.unit = Unit::either, .default_value = std::array{0.0, 0.0}},
               .meaning =
                   "the middle of the frame, from the centre, which must be inside the frame"},
              choice_parameter("shape", {"rectangle", "ellipse"}, "shape of the frame"),
              center},
         .make = [](const Arguments& a) -> StageResult {
             const bool ellipse = a.choice("shape") == "ellipse";
             if (!is_inside(a.pair("offset"), a.pair("frame"), ellipse)) {
                 return error("the centre of the repetition is not inside the frame", {},
                              "make the offset smaller, or the frame larger");
             }
             const double sense = a.choice("grows") == "clockwise" ? 1.0 : -1.0;
             return made<PrintGallery>(a.number("scale"), sense * a.constant("turns"),
                                       a.pair("frame"), a.pair("offset"), ellipse, a.pair("at"));
         },
         .example =
             R"(// Clockwise in the picture, as in Escher's lithograph, because u runs to the left.
camera print_gallery {
    map    u = 1 .. -1, v = square
    warp   print_gallery(scale = 16, grows = counter_clockwise)
    eye    point
    toward plane((1, 0, 0))
})"},
    };
}

}  // namespace balcony::camera
