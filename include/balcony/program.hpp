// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Program: expressions compiled to a tape that runs over many picture points at a time.
//
// A Program is immutable and may be shared by threads; a Scratch belongs to one thread; the caller
// owns the results. Compiled for grids, it runs over tiles, and each node has a rate, which follows
// from the rates of its inputs: uniform nodes run once per tile, others once per
// column, row or point. Branches that no point of a tile takes are left out. Compiled for points,
// it runs over lists of arbitrary points, and all nodes that are not uniform run once per point.
//
// Inputs are x, y and time, which a Tile and Points always have, and any number of further ones,
// which an Interface declares.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::program {

/// The values of the further inputs, in the order of the Interface: each has
/// one value if it is uniform; over a tile, one for each column or row or, row by row, one for each
/// point; over points, one for each point. They must exist while the program runs.
using InputValues = std::span<const std::span<const double>>;

/// A grid of picture points: point (i, j) is (x + i*step, y + j*step), i < width, j < height. What
/// lies beyond the limits is clamped to them.
struct Tile {
    double x = 0.5;
    double y = 0.5;
    double step = 1.0;
    std::size_t width = 0;
    std::size_t height = 0;
    double time = 0.0;

    struct Limits {
        double minimum = -std::numeric_limits<double>::infinity();
        double maximum = std::numeric_limits<double>::infinity();
    };
    Limits x_limits{};
    Limits y_limits{};
    InputValues inputs{};

    [[nodiscard]] double column(std::size_t i) const { return within(x, i, x_limits); }
    [[nodiscard]] double row(std::size_t j) const { return within(y, j, y_limits); }

private:
    [[nodiscard]] double within(double first, std::size_t steps, const Limits& limits) const {
        return std::clamp(first + static_cast<double>(steps) * step, limits.minimum,
                          limits.maximum);
    }
};

/// The largest tile that runs in one go; run() cuts larger ones into such parts.
inline constexpr std::size_t max_tile_width = 64;
inline constexpr std::size_t max_tile_height = 64;

/// Arbitrary picture points: point i is (x[i], y[i]). There are as many x as y.
struct Points {
    std::span<const double> x;
    std::span<const double> y;
    double time = 0.0;
    InputValues inputs{};
};

/// The longest list of points that runs in one go.
inline constexpr std::size_t max_points = 64;

/// The domain for which a program is compiled: a Tile or Points.
enum class Sampling : std::uint8_t { grid, points };

using expr::Rate;

/// A further input of a program: the name that formulas know it by, and how often it changes. Over
/// points, what is not uniform changes from point to point.
struct Input {
    std::string name;
    Rate rate = Rate::uniform;
};

/// What a program is given to run with.
struct Interface {
    Sampling sampling = Sampling::grid;
    std::vector<Input> inputs{};  ///< Beside x, y and t. Those that no root depends on are ignored.
    /// Whether the roots are simplified first, which takes longer than the rest of compiling, and
    /// branches are left out over tiles: of use unless the program runs at few points. Values
    /// change by rounding only.
    bool is_simplified = true;
};

struct Tape;  // src/program/tape.hpp

class Program {
public:
    /// Compiles the roots, which must be in one graph; they are simplified first unless the
    /// interface says otherwise. Fails if a root depends on an input that is not declared or on a
    /// free variable, if an input is declared twice or has the name x, y or t, and if
    /// simplification makes the graph too large. A stop of the graph is an error of
    /// Kind::interrupted.
    [[nodiscard]] static Result<Program> make(std::span<const expr::Expr> roots,
                                              const Interface& interface = {});
    /// The same for roots that depend on x, y and t alone; throws expr::GraphTooLarge.
    explicit Program(std::span<const expr::Expr> roots, Sampling sampling = Sampling::grid);

    [[nodiscard]] Sampling sampling() const;
    /// The declared further inputs.
    [[nodiscard]] std::span<const Input> inputs() const;
    [[nodiscard]] std::size_t root_count() const;
    /// Uniform or pixel in a program for points.
    [[nodiscard]] Rate rate(std::size_t root) const;
    /// The number of instructions of a rate, which determines the cost. A tile may need fewer.
    [[nodiscard]] std::size_t instruction_count(Rate rate) const;
    [[nodiscard]] const Tape& tape() const { return *tape_; }

private:
    explicit Program(std::shared_ptr<const Tape> tape);

    std::shared_ptr<const Tape> tape_;
};

/// The working memory of one thread; grows to the needs of the largest program run with it.
class Scratch {
public:
    [[nodiscard]] double* reserve(std::size_t doubles);  ///< Aligned to 64 bytes.

private:
    struct Free {
        void operator()(double* memory) const;
    };
    std::unique_ptr<double[], Free> memory_;
    std::size_t size_ = 0;
};

/// Memory for the results of runs, one array for each root, grown when needed. The arrays start at
/// multiples of 64 bytes, and at different places of a page, so that they do not compete for the
/// same lines of a cache.
class ResultArrays {
public:
    /// Arrays for `roots` roots of `size` doubles each; their values are undefined.
    std::span<double* const> reserve(std::size_t roots, std::size_t size);
    [[nodiscard]] const double* operator[](std::size_t root) const { return arrays_[root]; }

private:
    Scratch memory_;
    std::vector<double*> arrays_;
};

/// Runs a program over a tile of any size on the widest instruction set of this machine. Here and
/// below, the sampling, the inputs and the number of results are those of the program. results[r]
/// receives root r, row by row, width*height doubles without padding.
void run(const Program& program, const Tile& tile, Scratch& scratch,
         std::span<double* const> results);

/// Runs a program for points. results[r] receives root r, one double a point. The values are those
/// of a program for grids at the same points, bit for bit.
void run(const Program& program, const Points& points, Scratch& scratch,
         std::span<double* const> results);

/// The same by the scalar definition of each operation, point by point: the reference that
/// the runners are tested against.
void run_reference(const Program& program, const Tile& tile, std::span<double* const> results);
void run_reference(const Program& program, const Points& points, std::span<double* const> results);

/// An instruction set that run() can use.
struct InstructionSet {
    std::string_view name;  ///< "avx512", "avx2", "sse4", "neon", "scalar"
    std::size_t lanes;      ///< Doubles in a register.
};

/// The compiled instruction sets that this machine supports, widest first. Never empty.
[[nodiscard]] std::span<const InstructionSet> instruction_sets();

/// Runs on instruction_sets()[set]: a tile or list of points that runs in one go.
void run_on(std::size_t set, const Program& program, const Tile& tile, Scratch& scratch,
            std::span<double* const> results);
void run_on(std::size_t set, const Program& program, const Points& points, Scratch& scratch,
            std::span<double* const> results);

}  // namespace balcony::program
