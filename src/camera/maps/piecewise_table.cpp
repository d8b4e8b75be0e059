// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/piecewise_table.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace balcony::camera::maps {

namespace {

using expr::Table;

constexpr std::size_t table_degree = Table::max_degree;
constexpr std::size_t node_count = table_degree + 1;
constexpr std::size_t most_cells = 128;  // of a piece
using Coefficients = std::array<double, node_count>;

// The zeros of the Chebyshev polynomial of the degree above, from 0 to 1.
std::array<double, node_count> chebyshev_nodes() {
    std::array<double, node_count> nodes{};
    for (std::size_t i = 0; i < node_count; ++i) {
        const double angle =
            std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(node_count);
        nodes[i] = 0.5 - 0.5 * std::cos(angle);
    }
    return nodes;
}

// By powers of r from 0 to 1, through values at the Chebyshev nodes: Newton's divided differences,
// expanded.
Coefficients interpolated(const std::array<double, node_count>& nodes, Coefficients values) {
    for (std::size_t order = 1; order < node_count; ++order) {
        for (std::size_t i = node_count - 1; i >= order; --i) {
            values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - order]);
        }
    }
    Coefficients powers{};
    for (std::size_t k = node_count; k-- > 0;) {
        for (std::size_t i = table_degree; i > 0; --i) {
            powers[i] = powers[i - 1] - nodes[k] * powers[i];
        }
        powers[0] = values[k] - nodes[k] * powers[0];
    }
    return powers;
}

double value_at(const Coefficients& powers, double r) {
    double value = 0.0;
    for (std::size_t i = node_count; i-- > 0;) {
        value = value * r + powers[i];
    }
    return value;
}

/// The polynomials of all pieces with so many cells each, and their largest error.
struct Polynomials {
    std::size_t cells = 0;
    std::vector<double> coefficients;
    double error = 0.0;  ///< Infinite if the function has no value somewhere.
};

Polynomials polynomials(std::span<const double> places, std::size_t cells,
                        const PiecewiseTable::Function& function,
                        const PiecewiseTable::Error& error) {
    static const std::array<double, node_count> nodes = chebyshev_nodes();
    Polynomials made{.cells = cells, .coefficients = {}};
    for (std::size_t piece = 0; piece + 1 < places.size(); ++piece) {
        const double length = (places[piece + 1] - places[piece]) / static_cast<double>(cells);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double first = places[piece] + static_cast<double>(cell) * length;
            Coefficients values{};
            for (std::size_t i = 0; i < node_count; ++i) {
                values[i] = function(piece, first + length * nodes[i]);
            }
            const Coefficients powers = interpolated(nodes, values);
            for (const double r : {0.04, 0.31, 0.5, 0.69, 0.96}) {
                const double off = std::fabs(error(piece, first + length * r, value_at(powers, r)));
                made.error = off <= made.error ? made.error : off;
            }
            if (!std::isfinite(made.error)) {
                made.error = std::numeric_limits<double>::infinity();
                return made;
            }
            made.coefficients.insert(made.coefficients.end(), powers.begin(), powers.end());
        }
    }
    return made;
}

}  // namespace

std::optional<PiecewiseTable> PiecewiseTable::make(std::span<const double> places,
                                                   const Function& function, const Error& error,
                                                   double largest) {
    constexpr double good_enough = 1e-12;
    constexpr double worsened = 10.0;  // more cells make rounding at the ends of the function worse
    Polynomials best{.coefficients = {}, .error = std::numeric_limits<double>::infinity()};
    for (std::size_t cells = 1; cells <= most_cells && best.error > good_enough; cells *= 2) {
        Polynomials next = polynomials(places, cells, function, error);
        if (next.error < best.error) {
            best = std::move(next);
        } else if (best.error <= largest && next.error > worsened * best.error) {
            break;
        }
    }
    if (!(best.error <= largest)) {
        return std::nullopt;
    }
    const std::size_t pieces = places.size() - 1;
    const auto by_piece = [pieces](std::size_t cells, std::size_t power_count,
                                   std::vector<double> coefficients) {
        return std::make_shared<const Table>(
            Table{{{0.0, static_cast<double>(pieces), pieces * cells, power_count - 1}},
                  std::move(coefficients)});
    };
    PiecewiseTable made;
    made.places_.assign(places.begin(), places.end());
    made.values_ = by_piece(best.cells, node_count, std::move(best.coefficients));
    std::vector<double> scales;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        scales.push_back(1.0 / (places[piece + 1] - places[piece]));
    }
    made.starts_ = by_piece(1, 1, {places.begin(), places.end() - 1});
    made.scales_ = by_piece(1, 1, std::move(scales));
    return made;
}

Expr PiecewiseTable::operator()(Expr place, Emitter& emit) const {
    Graph& graph = emit.graph();
    const std::size_t pieces = places_.size() - 1;
    if (pieces == 1) {
        return graph.lookup(values_, (place - places_[0]) / (places_[1] - places_[0]));
    }
    Expr piece = emit(0.0);
    for (std::size_t i = 1; i < pieces; ++i) {
        piece = piece + select(places_[i] <= place, emit(1.0), emit(0.0));
    }
    const Expr start = graph.lookup(starts_, piece + 0.5);
    const Expr scale = graph.lookup(scales_, piece + 0.5);
    return graph.lookup(values_, piece + (place - start) * scale);
}

}  // namespace balcony::camera::maps
