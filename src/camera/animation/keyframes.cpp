// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/keyframes.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace balcony::camera {

namespace {

using expr::Expr;
using expr::Graph;

// ----------------------------------------------------------------------------------- eases

struct EaseFormula : Named<Ease> {
    Expr (*of)(Expr s);  ///< Null for a cubic.
};

Expr hold(Expr s) { return 1.0 <= s; }
Expr smooth(Expr s) { return s * s * (3.0 - 2.0 * s); }
Expr smoother(Expr s) { return s * s * s * (10.0 - s * (15.0 - 6.0 * s)); }
Expr ease_in(Expr s) { return s * s; }
Expr ease_out(Expr s) { return s * (2.0 - s); }

Expr ease_in_out(Expr s) {
    const Expr rest = 1.0 - s;
    return select(s < 0.5, 2.0 * s * s, 1.0 - 2.0 * rest * rest);
}

// The constant makes the overshoot a tenth.
Expr overshoot(Expr s) {
    constexpr double c = 1.70158;
    const Expr rest = 1.0 - s;
    return 1.0 - rest * rest * ((c + 1.0) * rest - c);
}

// The last term, at most 1/2048, brings the swing to 1 at the end.
Expr elastic(Expr s) {
    const Expr decay = exp(-10.0 * std::numbers::ln2 * s);
    return 1.0 + decay * sin((10.0 * s - 0.75) * (2.0 * std::numbers::pi / 3.0)) - 0x1p-11 * s;
}

// Parabolas of one acceleration between the contacts at 4/11, 8/11, 10/11 and 1.
Expr bounce(Expr s) {
    constexpr double acceleration = 121.0 / 16.0;
    const auto arc = [s](double middle, double height) {
        const Expr from_middle = s - middle / 11.0;
        return acceleration * from_middle * from_middle + height;
    };
    return select(s < 4.0 / 11.0, arc(0.0, 0.0),
                  select(s < 8.0 / 11.0, arc(6.0, 3.0 / 4.0),
                         select(s < 10.0 / 11.0, arc(9.0, 15.0 / 16.0), arc(10.5, 63.0 / 64.0))));
}

constexpr std::array formulas = {
    EaseFormula{{Ease::linear, "linear", "s"}, [](Expr s) { return s; }},
    EaseFormula{{Ease::hold, "hold", "0 until the next key"}, hold},
    EaseFormula{{Ease::smooth, "smooth", "3s² − 2s³"}, smooth},
    EaseFormula{{Ease::smoother, "smoother", "10s³ − 15s⁴ + 6s⁵"}, smoother},
    EaseFormula{{Ease::ease_in, "ease_in", "s²"}, ease_in},
    EaseFormula{{Ease::ease_out, "ease_out", "1 − (1 − s)²"}, ease_out},
    EaseFormula{{Ease::ease_in_out, "ease_in_out", "2s² up to the middle, then 1 − 2(1 − s)²"},
                ease_in_out},
    EaseFormula{{Ease::overshoot, "overshoot", "1 − (1 − s)² (1 − 2.70158 s)"}, overshoot},
    EaseFormula{{Ease::elastic, "elastic", "1 + 2^(−10s) sin((10s − 3/4) 2π/3) − s/2048"}, elastic},
    EaseFormula{{Ease::bounce, "bounce", "four parabolas: (11s/4)² up to s = 4/11, ..."}, bounce},
    EaseFormula{{Ease::spline, "spline", "a monotone cubic (Fritsch and Butland 1984)"}, nullptr},
    EaseFormula{{Ease::catmull_rom, "catmull_rom", "a cubic (Catmull and Rom 1974)"}, nullptr},
};

constexpr auto ease_names = names_in<Ease>(formulas);

bool is_cubic(Ease ease) { return formulas[static_cast<std::size_t>(ease)].of == nullptr; }

// ------------------------------------------------------------------------------ slopes of cubics

// The formulas of slopes serve numbers and expressions.
double pick(bool condition, double a, double b) { return condition ? a : b; }
Expr pick(Expr condition, Expr a, Expr b) { return select(condition, a, b); }

/// The harmonic mean of the slopes of both chords, weighted by their widths (Fritsch and Butland
/// 1984, as in scipy's PchipInterpolator); 0 at an extremum.
template <class Number>
Number monotone_slope(double width_before, double width_after, Number chord_before,
                      Number chord_after) {
    const double before = width_before + 2.0 * width_after;
    const double after = 2.0 * width_before + width_after;
    const Number product = chord_before * chord_after;
    const Number zero = 0.0 * product;
    return pick(0.0 < product,
                (before + after) * product / (before * chord_after + after * chord_before), zero);
}

/// The slope of the parabola through a key and its neighbours.
template <class Number>
Number catmull_rom_slope(double width_before, double width_after, Number chord_before,
                         Number chord_after) {
    const double both = width_before + width_after;
    return (width_after / both) * chord_before + (width_before / both) * chord_after;
}

/// At rest at both ends, where the value stays or turns back. If it repeats, the last cell precedes
/// the first key.
template <class Number>
std::vector<Number> slopes_at(std::span<const double> times, std::span<const Number> values,
                              Ease ease, BeyondKeys beyond) {
    const auto slope = ease == Ease::spline ? monotone_slope<Number> : catmull_rom_slope<Number>;
    const std::size_t cells = times.size() - 1;
    const auto width = [&](std::size_t cell) { return times[cell + 1] - times[cell]; };
    const auto chord = [&](std::size_t cell) {
        return (values[cell + 1] - values[cell]) / width(cell);
    };
    const auto between = [&](std::size_t before, std::size_t after) {
        return slope(width(before), width(after), chord(before), chord(after));
    };
    const Number end = beyond == BeyondKeys::repeat ? between(cells - 1, 0) : 0.0 * values.front();
    std::vector<Number> made{end};
    for (std::size_t key = 1; key < cells; ++key) {
        made.push_back(between(key - 1, key));
    }
    made.push_back(end);
    return made;
}

/// By cell: the factors of 1 and e(s), or of 1, s, s² and s³.
template <class Number>
std::vector<std::vector<Number>> factors_of(std::span<const double> times,
                                            std::span<const Number> values, Ease ease,
                                            BeyondKeys beyond) {
    std::vector<std::vector<Number>> made;
    const std::vector<Number> slopes =
        is_cubic(ease) ? slopes_at(times, values, ease, beyond) : std::vector<Number>();
    for (std::size_t cell = 0; cell + 1 < times.size(); ++cell) {
        const Number rise = values[cell + 1] - values[cell];
        if (!is_cubic(ease)) {
            made.push_back({values[cell], rise});
            continue;
        }
        const double width = times[cell + 1] - times[cell];
        const Number begin = width * slopes[cell];
        const Number end = width * slopes[cell + 1];
        made.push_back(
            {values[cell], begin, 3.0 * rise - 2.0 * begin - end, begin + end - 2.0 * rise});
    }
    return made;
}

/// What the factors multiply.
std::vector<Expr> basis_at(Expr s, Ease ease) {
    const Expr one = s.graph().constant(1.0);
    return is_cubic(ease) ? std::vector{one, s, s * s, s * s * s}
                          : std::vector{one, formulas[static_cast<std::size_t>(ease)].of(s)};
}

Expr sum_of(std::span<const Expr> factors, std::span<const Expr> basis) {
    Expr sum = factors[0] * basis[0];
    for (std::size_t i = 1; i < factors.size(); ++i) {
        sum = sum + factors[i] * basis[i];
    }
    return sum;
}

// ------------------------------------------------------------------------------------ few keys

/// One formula a cell; comparisons choose among them.
std::vector<Expr> chosen_among_cells(const Keyframes& keys, Expr time) {
    Graph& graph = time.graph();
    const std::size_t cells = keys.times.size() - 1;
    std::vector<std::vector<std::vector<Expr>>> factors;
    std::vector<Expr> made;
    for (const std::vector<Expr>& values : keys.values) {
        factors.push_back(
            factors_of(keys.times, std::span<const Expr>(values), keys.ease, keys.beyond));
        made.push_back(values.back());
    }
    for (std::size_t cell = cells; cell-- > 0;) {
        const double begin = keys.times[cell];
        const Expr s = (time - begin) / (keys.times[cell + 1] - begin);
        const std::vector<Expr> basis = keys.ease == Ease::hold
                                            ? std::vector{graph.constant(1.0), graph.constant(0.0)}
                                            : basis_at(s, keys.ease);
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k] = select(time < keys.times[cell + 1], sum_of(factors[k][cell], basis), made[k]);
        }
    }
    for (std::size_t k = 0; k < made.size(); ++k) {
        made[k] = select(time < keys.times.front(), keys.values[k].front(), made[k]);
    }
    return made;
}

// ----------------------------------------------------------------------------------- many keys

Expr look_up(Graph& graph, double first, double last, std::vector<double> values, Expr at) {
    const expr::Table::Axis axis{first, last, values.size(), 0};
    return graph.lookup(std::make_shared<const expr::Table>(expr::Table{{axis}, std::move(values)}),
                        at);
}

double narrowest_cell(std::span<const double> times) {
    double width = times.back() - times.front();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        width = std::min(width, times[i + 1] - times[i]);
    }
    return width;
}

// Twice as many buckets as the narrowest cell needs, so that no rounding puts two keys into one.
double bucket_count(std::span<const double> times) {
    return 2.0 * std::ceil((times.back() - times.front()) / narrowest_cell(times));
}

/// The number of the cell in which a time is, from the key in its bucket.
Expr cell_at(std::span<const double> times, Expr time) {
    const auto buckets = static_cast<std::size_t>(bucket_count(times));
    const double width = (times.back() - times.front()) / static_cast<double>(buckets);
    std::vector<double> keys, before, behind;
    std::size_t cell = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const double end = times.front() + static_cast<double>(bucket + 1) * width;
        before.push_back(static_cast<double>(cell));
        keys.push_back(times[cell + 1]);
        cell += cell + 2 < times.size() && times[cell + 1] < end ? 1 : 0;
        behind.push_back(static_cast<double>(cell));
    }
    Graph& graph = time.graph();
    const auto in_bucket = [&](std::vector<double> values) {
        return look_up(graph, times.front(), times.back(), std::move(values), time);
    };
    return select(time < in_bucket(std::move(keys)), in_bucket(std::move(before)),
                  in_bucket(std::move(behind)));
}

std::vector<Expr> looked_up(const Keyframes& keys, Expr time) {
    Graph& graph = time.graph();
    const std::span<const double> times = keys.times;
    const std::size_t cells = times.size() - 1;
    const Expr within = min(max(time, graph.constant(times.front())), graph.constant(times.back()));
    const Expr cell = cell_at(times, within);
    // Of a value by cell; the number of a cell is in the middle of its place in the table.
    const auto of_cell = [&](const auto& value) {
        std::vector<double> values;
        for (std::size_t i = 0; i < cells; ++i) {
            values.push_back(value(i));
        }
        return look_up(graph, -0.5, static_cast<double>(cells) - 0.5, std::move(values), cell);
    };
    const Expr begin = of_cell([&](std::size_t i) { return times[i]; });
    const Expr width = of_cell([&](std::size_t i) { return times[i + 1] - times[i]; });
    const std::vector<Expr> basis = basis_at((within - begin) / width, keys.ease);
    std::vector<Expr> made;
    for (const std::vector<Expr>& values : keys.values) {
        std::vector<double> numbers;
        for (const Expr value : values) {
            numbers.push_back(value.node().value);
        }
        const auto by_cell =
            factors_of(times, std::span<const double>(numbers), keys.ease, keys.beyond);
        std::vector<Expr> factors;
        for (std::size_t j = 0; j < basis.size(); ++j) {
            factors.push_back(of_cell([&](std::size_t i) { return by_cell[i][j]; }));
        }
        made.push_back(sum_of(factors, basis));
    }
    return made;
}

// Tables pay from about so many keys on; one with more buckets would fill the caches.
bool use_tables(const Keyframes& keys) {
    constexpr std::size_t few = 16;
    constexpr double max_buckets = 65536.0;
    const auto all_constant = [](const std::vector<Expr>& values) {
        return std::all_of(values.begin(), values.end(),
                           [](Expr value) { return value.is_constant(); });
    };
    return keys.times.size() > few && bucket_count(keys.times) <= max_buckets &&
           std::all_of(keys.values.begin(), keys.values.end(), all_constant);
}

// The time between the first key and the last one that has the same value.
Expr folded(const Keyframes& keys, Expr time) {
    const double first = keys.times.front();
    const double length = keys.times.back() - first;
    switch (keys.beyond) {
        case BeyondKeys::constant: break;
        case BeyondKeys::repeat: return first + mod(time - first, time.graph().constant(length));
        case BeyondKeys::mirror:
            return keys.times.back() -
                   abs(mod(time - first, time.graph().constant(2.0 * length)) - length);
    }
    return time;
}

constexpr std::array beyond_rows{Named{BeyondKeys::constant, "constant"},
                                 Named{BeyondKeys::repeat, "repeat"},
                                 Named{BeyondKeys::mirror, "mirror"}};

}  // namespace

Names<Ease> eases() { return Names<Ease>(ease_names); }
Names<BeyondKeys> beyond_keys() { return Names<BeyondKeys>(beyond_rows); }

std::vector<Expr> between_keys(const Keyframes& keys, Expr time) {
    assert(!keys.times.empty());
    if (keys.times.size() == 1) {
        std::vector<Expr> made;
        for (const std::vector<Expr>& values : keys.values) {
            made.push_back(values.front());
        }
        return made;
    }
    const Expr at = folded(keys, time);
    return use_tables(keys) ? looked_up(keys, at) : chosen_among_cells(keys, at);
}

}  // namespace balcony::camera
