// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/objects/fractal_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace balcony::camera {

namespace {

constexpr std::size_t period = 8;  // of the lattice, along each axis
constexpr std::size_t lattice_size = period * period * period;
constexpr std::array<std::size_t, 3> stride{period * period, period, 1};

/// Uniform random numbers in [-1, 1) from a counter: the mixing steps of SplitMix64 (Steele, Lea,
/// Flood: "Fast Splittable Pseudorandom Number Generators", 2014).
class Draws {
public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}
    double operator()() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-52 - 1.0;
    }

private:
    std::uint64_t state_;
};

/// Values at the points of a periodic lattice; the last axis varies fastest.
using Lattice = std::vector<double>;

/// The lattice point a number of steps further along an axis.
std::size_t neighbour(std::size_t at, std::size_t axis, std::size_t steps) {
    const std::size_t place = at / stride[axis] % period;
    return at + ((place + steps) % period - place) * stride[axis];
}

/// The variance over space of the cubic B-spline with these control values of mean 0: with the
/// integral of the product of two cubic B-splines that are k steps apart, which is the B-spline of
/// degree 7 at k.
double spline_variance(const Lattice& values) {
    constexpr std::array overlap{151.0 / 315.0, 397.0 / 1680.0, 1.0 / 42.0, 1.0 / 5040.0};
    Lattice smooth = values;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Lattice along(lattice_size);
        for (std::size_t at = 0; at < lattice_size; ++at) {
            along[at] = overlap[0] * smooth[at];
            for (std::size_t k = 1; k < overlap.size(); ++k) {
                along[at] += overlap[k] * (smooth[neighbour(at, axis, k)] +
                                           smooth[neighbour(at, axis, period - k)]);
            }
        }
        smooth = std::move(along);
    }
    return std::inner_product(values.begin(), values.end(), smooth.begin(), 0.0) / lattice_size;
}

/// Normalised so that the spline has mean 0 and variance 1.
Lattice random_lattice(Draws& draw) {
    Lattice values(lattice_size);
    std::generate(values.begin(), values.end(), [&] { return draw(); });
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / lattice_size;
    for (double& value : values) {
        value -= mean;
    }
    const double scale = 1.0 / std::sqrt(spline_variance(values));
    for (double& value : values) {
        value *= scale;
    }
    return values;
}

/// The cubic B-spline with the lattice's values as control values, over one period.
expr::Table spline_table(const Lattice& values) {
    // Row i: the coefficients of four neighbouring control values for power i of the cell position.
    constexpr std::array<std::array<double, 4>, 4> powers{{{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0},
                                                           {-0.5, 0.0, 0.5, 0.0},
                                                           {0.5, -1.0, 0.5, 0.0},
                                                           {-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0}}};
    const auto along = [&](const Lattice& from, std::size_t axis, std::size_t power) {
        Lattice to(lattice_size);
        for (std::size_t at = 0; at < lattice_size; ++at) {
            for (std::size_t k = 0; k < 4; ++k) {
                to[at] += powers[power][k] * from[neighbour(at, axis, k)];
            }
        }
        return to;
    };
    const expr::Table::Axis axis{0.0, static_cast<double>(period), period, 3};
    expr::Table table{{axis, axis, axis}, std::vector<double>(lattice_size * 64)};
    for (std::size_t i = 0; i < 4; ++i) {
        const Lattice by_x = along(values, 0, i);
        for (std::size_t j = 0; j < 4; ++j) {
            const Lattice by_y = along(by_x, 1, j);
            for (std::size_t k = 0; k < 4; ++k) {
                const Lattice by_z = along(by_y, 2, k);
                for (std::size_t cell = 0; cell < lattice_size; ++cell) {
                    table.coefficients[cell * 64 + i * 16 + j * 4 + k] = by_z[cell];
                }
            }
        }
    }
    return table;
}

/// A uniformly distributed rotation: a unit quaternion from a random point of the ball.
std::array<std::array<double, 3>, 3> random_rotation(Draws& draw) {
    double w = 0.0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double squared = 0.0;
    do {
        w = draw();
        x = draw();
        y = draw();
        z = draw();
        squared = w * w + x * x + y * y + z * z;
    } while (squared > 1.0 || squared < 0.01);
    const double s = 2.0 / squared;
    return {{{1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
             {s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)},
             {s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)}}};
}

}  // namespace

FractalNoise::FractalNoise(std::uint64_t seed, std::size_t octaves) {
    Draws draw(seed);
    noise_ = std::make_shared<const expr::Table>(spline_table(random_lattice(draw)));
    for (std::size_t i = 0; i < octaves; ++i) {
        const auto turn = random_rotation(draw);
        octaves_.push_back({turn, {period * draw(), period * draw(), period * draw()}});
    }
}

Expr FractalNoise::emit(const ObjectPoint& p, Expr lacunarity, Expr hurst) const {
    expr::Graph& graph = p.x.graph();
    const Expr gain = pow(lacunarity, -hurst);
    Expr frequency = graph.constant(1.0);
    Expr amplitude = graph.constant(1.0);
    Expr sum = graph.constant(0.0);
    Expr variance = graph.constant(0.0);
    for (const Octave& octave : octaves_) {
        std::array<Expr, 3> at;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& row = octave.turn[k];
            const Expr turned = row[0] * p.x + row[1] * p.y + row[2] * p.z;
            at[k] = mod(frequency * turned + octave.offset[k], graph.constant(period));
        }
        sum = sum + amplitude * graph.lookup(noise_, at);
        variance = variance + amplitude * amplitude;
        frequency = frequency * lacunarity;
        amplitude = amplitude * gain;
    }
    return sum / sqrt(variance);
}

}  // namespace balcony::camera
