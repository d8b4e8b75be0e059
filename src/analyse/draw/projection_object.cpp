// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/projection_object.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace balcony::analyse {

namespace {

// The size of the picture for which the path is compiled. Its objects depend only on its
// aspect ratio.
constexpr double picture_height = 1000.0;

constexpr std::size_t root_count = 9;

program::Program compile(const camera::Path& path, double aspect) {
    expr::Graph graph;
    camera::Emitter emit(graph);
    const camera::PicturePoint picture{
        {graph.picture_x(), graph.picture_y()},
        {graph.constant(picture_height * aspect), graph.constant(picture_height)}};
    const camera::PathPoint p = path.emit(picture, emit);
    const std::array<expr::Expr, root_count> roots = {p.point.x,      p.point.y,      p.point.z,
                                                      p.normal.x,     p.normal.y,     p.normal.z,
                                                      p.parameters.u, p.parameters.v, emit.valid()};
    return program::Program(roots);
}

// What following the lines of all objects of a drawing may cost, in instructions of their programs
// and in points: some seconds. A usual drawing takes a hundredth of it.
constexpr double max_instructions = 2e9;
constexpr double max_points = 2e6;

// Points at which one line is looked at: so many across the picture, in proportion for a shorter
// line, but not less than the minimum, which is enough for a dozen jumps.
constexpr double max_points_across = 16384.0;
constexpr double min_points_of_line = 1024.0;

std::size_t max_points_of(const program::Program& program, double share) {
    std::size_t instructions = 0;
    for (const program::Rate rate : {program::Rate::uniform, program::Rate::column,
                                     program::Rate::row, program::Rate::pixel}) {
        instructions += program.instruction_count(rate);
    }
    const double points =
        max_instructions / static_cast<double>(std::max<std::size_t>(instructions, 1));
    return static_cast<std::size_t>(share * std::min(points, max_points));
}

std::size_t max_points_of_line(const V2d& a, const V2d& b) {
    return static_cast<std::size_t>(
        std::max(min_points_of_line, max_points_across * std::min((b - a).length(), 1.0)));
}

bool is_finite(const V3d& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

V3d unit_or_zero(const V3d& v) {
    return is_finite(v) && v.length2() > 0.0 ? v.normalized() : V3d(0.0);
}

}  // namespace

bool is_near(const V3d& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) <= max_coordinate;
}

ProjectionObject::ProjectionObject(const camera::Path& path, double aspect, Axes axes, double time,
                                   double share, const Work& work)
    : dimension_(path.generator->dimension()),
      axes_(axes),
      aspect_(aspect),
      time_(time),
      work_(work.silent()),
      program_(compile(path, aspect)),
      points_left_(max_points_of(program_, share)),
      bounds_(measure()) {}

std::optional<ProjectionObjectPoint> ProjectionObject::at(const V2d& picture) {
    work_.go_on();
    std::array<double, root_count> values{};
    std::array<double*, root_count> results{};
    for (std::size_t root = 0; root < root_count; ++root) {
        results[root] = &values[root];
    }
    const program::Tile tile{
        picture.x * picture_height * aspect_, picture.y * picture_height, 1.0, 1, 1, time_};
    program::run(program_, tile, scratch_, results);
    const V3d position(values[0], values[1], values[2]);
    const V3d normal(values[3], values[4], values[5]);
    if (values[8] != 1.0 || !is_finite(position)) {
        return std::nullopt;
    }
    if (!is_near(position)) {
        omissions_.far = true;
        return std::nullopt;
    }
    return ProjectionObjectPoint{turned(position, axes_, Axes::z_up),
                                 unit_or_zero(turned(normal, axes_, Axes::z_up)),
                                 {values[6], values[7]}};
}

Box3d ProjectionObject::measure() {
    constexpr int lines = 17;
    Box3d box;
    for (int i = 0; i < lines * lines; ++i) {
        if (const auto p = at(V2d(i % lines, i / lines) / (lines - 1))) {
            box.extendBy(p->position);
        }
    }
    return box;
}

/// Traces one line by halving its parts until each is straight, or is a jump.
class ProjectionObject::Tracer {
public:
    Tracer(ProjectionObject& object, const V2d& a, const V2d& b, double tolerance)
        : object_(object),
          a_(a),
          b_(b),
          tolerance_(tolerance),
          points_left_(std::min(max_points_of_line(a, b), object.points_left_)) {}

    std::optional<std::vector<Polyline>> trace() {
        const std::size_t points = points_left_;
        // An odd number, so that a curve symmetric about the middle is not mistaken for straight.
        constexpr int parts = 3;
        Mark from = mark(0.0);
        for (int i = 1; i <= parts; ++i) {
            const Mark to = mark(static_cast<double>(i) / parts);
            follow(from, to, 0);
            from = to;
        }
        object_.points_left_ -= points - points_left_;
        if (points_left_ == 0) {
            object_.omissions_.winding = true;
            return std::nullopt;
        }
        std::erase_if(pieces_, [](const Polyline& piece) { return piece.size() < 2; });
        return std::move(pieces_);
    }

private:
    struct Mark {
        double where = 0.0;  ///< From 0 at a to 1 at b.
        std::optional<V3d> point;
    };

    // Number of halvings after which a difference counts as a jump. A root of high degree, as
    // superconics have them at their axes, shrinks slowly.
    static constexpr int deepest = 40;
    // Number of halvings that search for a small gap between two points or a small part between
    // gaps.
    static constexpr int deepest_in_gap = 2;

    Mark mark(double where) {
        if (points_left_ == 0) {
            return {where, std::nullopt};
        }
        --points_left_;
        // This form gives a and b exactly.
        const auto p = object_.at((1.0 - where) * a_ + where * b_);
        return {where, p ? std::optional(p->position) : std::nullopt};
    }

    // Both ends are valid, and the middle is between them, near their chord and not at one end.
    bool is_straight(const V3d& from, const V3d& to, const V3d& middle) const {
        const V3d chord = to - from;
        if (chord.length() <= tolerance_) {
            return (middle - from).length() <= tolerance_;
        }
        const double share = chord.dot(middle - from) / chord.length2();
        constexpr double margin = 0.02;
        return share > margin && share < 1.0 - margin &&
               (from + share * chord - middle).length() <= tolerance_;
    }

    void add(const Mark& from, const Mark& to) {
        if (pieces_.empty() || last_ != from.where) {
            pieces_.push_back({*from.point});
        }
        pieces_.back().push_back(*to.point);
        last_ = to.where;
    }

    void follow(const Mark& from, const Mark& to, int depth) {
        if (points_left_ == 0 || depth > deepest ||
            (!from.point && !to.point && depth > deepest_in_gap)) {
            return;
        }
        const Mark middle = mark(0.5 * (from.where + to.where));
        if (from.point && to.point && middle.point &&
            is_straight(*from.point, *to.point, *middle.point)) {
            add(from, to);
            return;
        }
        follow(from, middle, depth + 1);
        follow(middle, to, depth + 1);
    }

    ProjectionObject& object_;
    V2d a_, b_;
    double tolerance_;
    std::size_t points_left_;
    double last_ = -1.0;  ///< The end of the last piece.
    std::vector<Polyline> pieces_;
};

std::optional<std::vector<Polyline>> ProjectionObject::trace(const V2d& a, const V2d& b,
                                                             double tolerance) {
    return Tracer(*this, a, b, tolerance).trace();
}

bool ProjectionObject::joined(const V2d& a, const V2d& b) {
    const double coarse = bounds_.isEmpty() ? 1.0 : 0.02 * bounds_.size().length();
    const auto pieces = trace(a, b, coarse);
    const auto from = at(a);
    const auto to = at(b);
    return pieces && pieces->size() == 1 && from && to &&
           pieces->front().front() == from->position && pieces->front().back() == to->position;
}

}  // namespace balcony::analyse
