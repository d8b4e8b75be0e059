// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Solve: the parameters of a camera from what its picture is to show.
//
// The unknowns are inputs of the camera's formulas, such as parameters that lang::make_open_camera
// leaves open, and the places of targets, which are rigid groups of points, for instance a
// chessboard. A point of space appears where the camera's ray meets it: Newton's iteration finds
// that position, and the implicit function theorem gives its derivatives by the unknowns from the
// exact derivatives of the ray. The sum of squares of what the constraints miss, in units of their
// standard deviations, is minimized by the method of Levenberg and Marquardt.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/catalogue.hpp"
#include "balcony/names.hpp"
#include "balcony/picture.hpp"

namespace balcony::solve {

using Imath::V2d;
using Imath::V3d;

/// An input of the camera's formulas that is to be found.
struct Unknown {
    /// Its name in the graph, such as lang::parameter_input("fov"). Without one, it is a number
    /// that a camera is made of anew, whose derivatives are differences.
    std::string input;
    double value = 0.0;     ///< Where the search begins.
    camera::Range range{};  ///< The values that it may have.
    /// How far it may be from `value`: a standard deviation, in deviation_range. Without it,
    /// anywhere in the range.
    std::optional<double> deviation{};
    std::string name{};  ///< What messages call it, if not as its input.
};

/// Where a rigid group of points is: place = rotation * point + translation.
struct Pose {
    V3d rotation{0.0};  ///< The axis, times the angle in radians.
    V3d translation{0.0};

    [[nodiscard]] V3d operator*(const V3d& point) const;
};

/// A group of points whose pose is unknown.
struct Target {
    /// Without it, the search begins where rays of the first values at the positions that are
    /// demanded of its marks pass these, as if all began at one point.
    std::optional<Pose> start{};
    std::string name{};  ///< What messages call it, if not by its number.
};

/// What a camera sees, in the axes of the camera.
struct Mark {
    V3d place{0.0};  ///< A point of space or of a target; at infinity, the direction to it.
    bool at_infinity = false;
    std::optional<std::size_t> target{};  ///< The index of the one that it belongs to.
    /// Where in the picture the search for it begins, in pixels; by default where the camera shows
    /// it with the first values of the unknowns.
    std::optional<V2d> near{};
    std::string name{};    ///< What messages call it, if not by its number.
    SourceSpan written{};  ///< Where a file has it, for messages.
};

/// Points of space, such as the vertices of an object, in the axes of the camera. Those that are
/// outermost in the picture make an outline, whatever hides them.
struct Outline {
    std::vector<V3d> points;
    /// Where in the picture the search for them begins, in pixels; by default where the camera
    /// shows one of them with the first values of the unknowns.
    std::optional<V2d> near{};
    std::string name{};    ///< What messages call it, if not by its number.
    SourceSpan written{};  ///< Where a file has it, for messages.
};

/// What a constraint demands. Rows of constraint_kinds() say how many marks each takes, or whether
/// it is about an outline, and what it misses.
enum class ConstraintKind : std::uint8_t {
    at,        ///< A mark appears at a position.
    together,  ///< Two marks appear at one position.
    inside,    ///< A mark is in the picture, at least `value` pixels from its border.
    outside,   ///< A mark is not in the picture.
    straight,  ///< The third mark appears on the line through the first two.
    level,     ///< Two marks appear at one height.
    upright,   ///< Two marks appear one above the other.
    parallel,  ///< The line through the first two marks is parallel to that through the others.
    length,    ///< Two marks appear `value` pixels apart.
    ratio,     ///< The first two marks are `value` times as far apart as the other two.
    magnification,  ///< At a position, `value` pixels per unit at a distance, or per radian.
    isotropic,      ///< At a position, small circles appear as circles.
    unfolded,       ///< At a position, the picture is not mirrored and not compressed to a line.
    left,           ///< An outline begins at `value` pixels from the left side of the picture.
    right,          ///< It ends there.
    top,            ///< It begins at `value` pixels from the upper side.
    bottom,         ///< It ends there.
    wide,           ///< It is `value` pixels wide.
    high,           ///< It is `value` pixels high.
    within,         ///< It is in a box; without one in the picture.
    touches,        ///< It touches a line, on either side.
};

/// The values of standard deviations and tolerances: the squares of what is measured by them are
/// finite numbers.
inline constexpr camera::Range deviation_range{1e-12, 1e12};

/// One demand on the picture.
struct Constraint {
    ConstraintKind kind = ConstraintKind::at;
    std::vector<std::size_t> marks{};  ///< Indices of the problem's marks.
    V2d position{0.0};                 ///< In pixels from the upper left corner.
    double value = 0.0;
    /// Where a magnification or a shape is measured, in scene units; without it at infinity.
    std::optional<double> distance{};
    /// The standard deviation of what it misses, in deviation_range: in pixels for marks; for
    /// magnifications as a part of the value; for shapes as a part of 1.
    double deviation = 1.0;
    /// What it misses beyond so many standard deviations, in deviation_range, counts less and less
    /// (Cauchy's loss).
    std::optional<double> tolerance{};
    SourceSpan written{};  ///< Where a file has it, for messages.
    /// The index of the problem's outline that it is about, of kinds that are about one.
    std::optional<std::size_t> outline{};
    /// The upper left and the lower right corner of a box, or two points of a line.
    std::optional<std::array<V2d, 2>> corners{};
};

/// Whether a constraint has a value of its own.
enum class ValueUse : std::uint8_t { none, may, must };

/// A kind of constraints for documentation and readers of files.
struct ConstraintKindInfo {
    ConstraintKind kind;
    std::string_view name;
    std::string_view meaning;
    std::size_t marks;  ///< How many it takes; 0 if it is about a position or an outline.
    ValueUse value = ValueUse::none;
    bool is_of_outline = false;
    std::string_view corners{};  ///< What its two corners are, "box" or "line"; empty without any.
    bool may_lack_corners = false;
};
[[nodiscard]] const std::vector<ConstraintKindInfo>& constraint_kinds();

/// What is to be solved.
struct Problem {
    std::vector<Unknown> unknowns;
    std::vector<Target> targets;
    std::vector<Mark> marks;
    std::vector<Constraint> constraints;
    std::vector<Outline> outlines{};
};

/// The cells of the picture in whose middles the uncertainty of projections is wanted.
struct ErrorGrid {
    std::size_t columns = 16;
    std::size_t rows = 9;
    std::optional<double> distance{};  ///< Of the points, in scene units; far away without it.
};

struct Options {
    std::size_t iterations = 200;  ///< At most, from each start.
    /// How many starts are tried: the first is that of the problem, the others are spread over the
    /// ranges of the unknowns that have finite ones.
    std::size_t starts = 1;
    std::optional<ErrorGrid> errors{};  ///< Solution::errors are wanted.
};

/// What a constraint misses, in its unit.
struct Miss {
    std::array<double, 4> by{};
    std::size_t count = 1;    ///< How many of these it has.
    double deviations = 0.0;  ///< Their length in standard deviations.
};

/// Values for the unknowns.
struct Solution {
    std::vector<double> values;  ///< By unknown.
    std::vector<Pose> poses;     ///< By target.
    std::vector<Miss> misses;    ///< By constraint.
    /// Where the marks appear, in pixels; nothing for one that no ray meets.
    std::vector<std::optional<V2d>> seen;
    /// The outlines in the picture, as the corners of convex polygons that are traversed from left
    /// to right along their upper sides.
    std::vector<std::vector<V2d>> outlines;
    /// The standard deviations of the unknowns, if each demand misses what its deviation says;
    /// infinite for an unknown that the constraints do not determine.
    std::vector<double> deviations;
    /// The same for products of deviations: covariance[i * n + j] of the unknowns i and j.
    std::vector<double> covariance;
    /// By cell of the grid, row by row: the standard deviation of where the picture shows a point
    /// that it shows in the middle, in pixels and in the direction in which it is largest. The
    /// point is fixed in space or, if there are targets, in the mean of their places, as the
    /// projection uncertainty of mrcal. Infinite where an unknown matters that is not determined,
    /// nothing where the camera has no ray.
    std::vector<std::optional<double>> errors;
    double cost = 0.0;  ///< The sum of squares, with tolerances applied.
    std::size_t iterations = 0;
    bool converged = false;
};

/// Derivatives by the inputs of a solver, point by point. Where a point has no ray, or derivatives
/// that are not finite, all of its numbers are 0.
struct Derivatives {
    std::vector<std::uint8_t> valid;  ///< By point.
    /// values[(i * m + n) * k + j] is that of number n of the m numbers of point i, by input j of
    /// k.
    std::vector<double> values;
};

class InputRays;

/// A layer of a picture that is solved again and again for the same inputs, as while a hand pulls
/// at what it shows: its formulas are compiled once. Immutable, may be shared by threads.
class Solver {
public:
    /// A camera layer of the picture, by its number from the back, in a picture of a size in
    /// pixels, at a time in seconds. The picture has no inputs but these.
    [[nodiscard]] static Result<Solver> make(const camera::Picture& picture, std::size_t layer,
                                             double width, double height,
                                             std::vector<std::string> inputs, double time = 0.0,
                                             const std::stop_token& stop = {});

    /// The axes of the marks.
    [[nodiscard]] Axes axes() const { return axes_; }
    /// As solve() below, with constraints on marks or outlines only. The unknowns have the inputs
    /// that it was made for, in their order; one that is known has a range of one number.
    [[nodiscard]] Result<Solution> solve(const Problem& problem, const Options& options = {},
                                         const std::stop_token& stop = {}) const;

    /// How the rays at points of the picture, in pixels, change with the inputs, which have these
    /// values, in their order: six numbers for each, those of the origin and the direction.
    [[nodiscard]] Derivatives ray_derivatives(std::span<const V2d> points,
                                              std::span<const double> values) const;
    /// How the positions change at which the picture shows points of space, by the implicit
    /// function theorem: two numbers for each, x and y in pixels. seen[i] is where it shows
    /// points[i], in its axes.
    [[nodiscard]] Derivatives position_derivatives(std::span<const V3d> points,
                                                   std::span<const V2d> seen,
                                                   std::span<const double> values) const;

private:
    Solver(std::shared_ptr<const InputRays> rays, Axes axes, double width, double height,
           std::vector<std::string> inputs);
    std::shared_ptr<const InputRays> rays_;
    Axes axes_;
    double width_, height_;
    std::vector<std::string> inputs_;
};

/// Makes a camera of the values of the unknowns without an input, in their order.
using CameraMaker = std::function<Result<camera::Camera>(std::span<const double>)>;

/// Finds values for the unknowns with which a picture of a size in pixels misses as little of the
/// constraints as it can. It is an error if there are no unknowns or constraints, if an index, a
/// number or an input is not known, if no ray meets a mark that must be seen, if a target has
/// neither a start nor the marks for one, and, of Kind::interrupted, if it is stopped. There
/// are warnings for unknowns that the constraints do not determine, which change no more than these
/// ask for, for constraints that are fewer equations than there are unknowns, and for marks that
/// the found camera does not show.
[[nodiscard]] Result<Solution> solve(const CameraMaker& make, double width, double height,
                                     const Problem& problem, const Options& options = {},
                                     const std::stop_token& stop = {});
/// The same of unknowns that all have inputs of a camera.
[[nodiscard]] Result<Solution> solve(const camera::Camera& camera, double width, double height,
                                     const Problem& problem, const Options& options = {},
                                     const std::stop_token& stop = {});

}  // namespace balcony::solve
