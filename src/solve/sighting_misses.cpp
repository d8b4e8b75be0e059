// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/sighting_misses.hpp"

#include <cassert>
#include <cmath>

#include "solve/outlines.hpp"

namespace balcony::solve {

namespace {

struct Sight {
    const Constraint& constraint;
    std::span<const DualPoint> at;
    V2d size;
};

DualPoint operator-(const DualPoint& a, const DualPoint& b) { return {a.x - b.x, a.y - b.y}; }
Dual cross(const DualPoint& a, const DualPoint& b) { return a.x * b.y - a.y * b.x; }
Dual length(const DualPoint& a) { return sqrt(a.x * a.x + a.y * a.y); }

// How far a position is from the border of the picture, positive inside.
Dual within(const Sight& sight) {
    const auto nearest = [](const Dual& a, const Dual& b) { return b.value < a.value ? b : a; };
    const auto [x, y] = sight.at[0];
    return nearest(nearest(x, sight.size.x - x), nearest(y, sight.size.y - y));
}

std::vector<Dual> misses_at(const Sight& sight) {
    const auto [x, y] = sight.at[0];
    return {x - sight.constraint.position.x, y - sight.constraint.position.y};
}
std::vector<Dual> misses_together(const Sight& sight) {
    const auto [x, y] = sight.at[1] - sight.at[0];
    return {x, y};
}
std::vector<Dual> misses_inside(const Sight& sight) {
    return {max(sight.constraint.value - within(sight), 0.0)};
}
std::vector<Dual> misses_outside(const Sight& sight) { return {max(within(sight), 0.0)}; }
std::vector<Dual> misses_straight(const Sight& sight) {
    const DualPoint line = sight.at[1] - sight.at[0];
    return {cross(line, sight.at[2] - sight.at[0]) / length(line)};
}
std::vector<Dual> misses_level(const Sight& sight) { return {sight.at[1].y - sight.at[0].y}; }
std::vector<Dual> misses_upright(const Sight& sight) { return {sight.at[1].x - sight.at[0].x}; }
// By how many pixels the end of the first line is beside a parallel to the other through its start.
std::vector<Dual> misses_parallel(const Sight& sight) {
    const DualPoint other = sight.at[3] - sight.at[2];
    return {cross(other, sight.at[1] - sight.at[0]) / length(other)};
}
std::vector<Dual> misses_length(const Sight& sight) {
    return {length(sight.at[1] - sight.at[0]) - sight.constraint.value};
}
std::vector<Dual> misses_ratio(const Sight& sight) {
    return {length(sight.at[1] - sight.at[0]) -
            sight.constraint.value * length(sight.at[3] - sight.at[2])};
}

// Of an outline, `at` are the outermost positions.
enum Outermost : std::size_t { leftmost, rightmost, uppermost, lowermost };

std::vector<Dual> misses_left(const Sight& sight) {
    return {sight.at[leftmost].x - sight.constraint.value};
}
std::vector<Dual> misses_right(const Sight& sight) {
    return {sight.at[rightmost].x - sight.constraint.value};
}
std::vector<Dual> misses_top(const Sight& sight) {
    return {sight.at[uppermost].y - sight.constraint.value};
}
std::vector<Dual> misses_bottom(const Sight& sight) {
    return {sight.at[lowermost].y - sight.constraint.value};
}
std::vector<Dual> misses_wide(const Sight& sight) {
    return {sight.at[rightmost].x - sight.at[leftmost].x - sight.constraint.value};
}
std::vector<Dual> misses_high(const Sight& sight) {
    return {sight.at[lowermost].y - sight.at[uppermost].y - sight.constraint.value};
}
std::vector<Dual> misses_within(const Sight& sight) {
    const auto [first, last] = sight.constraint.corners.value_or(std::array{V2d(0.0), sight.size});
    return {max(first.x - sight.at[leftmost].x, 0.0), max(sight.at[rightmost].x - last.x, 0.0),
            max(first.y - sight.at[uppermost].y, 0.0), max(sight.at[lowermost].y - last.y, 0.0)};
}
// From the side of the line on which it needs less to touch: the square is continuous.
std::vector<Dual> misses_touches(const Sight& sight) {
    const auto distance = [&](const DualPoint& p) {
        return distance_from(*sight.constraint.corners, p.x, p.y);
    };
    const Dual least = distance(sight.at[0]);
    const Dual greatest = distance(sight.at[1]);
    return {std::abs(least.value) < std::abs(greatest.value) ? least : greatest};
}

struct Row {
    ConstraintKindInfo info;
    std::vector<Dual> (*misses)(const Sight&);  // Null for shapes.
};

ConstraintKindInfo of_outline(ConstraintKind kind, std::string_view name,
                              std::string_view meaning) {
    return {kind, name, meaning, 0, ValueUse::must, true};
}

// In the order of ConstraintKind.
const std::vector<Row>& rows() {
    using enum ConstraintKind;
    static const std::vector<Row> all{
        {{at, "at", "a mark appears at a position", 1}, misses_at},
        {{together, "together", "two marks appear at one position", 2}, misses_together},
        {{inside, "inside", "a mark is in the picture, so many pixels from its border", 1,
          ValueUse::may},
         misses_inside},
        {{outside, "outside", "a mark is not in the picture", 1}, misses_outside},
        {{straight, "straight", "the third mark appears on the line through the first two", 3},
         misses_straight},
        {{level, "level", "two marks appear at one height", 2}, misses_level},
        {{upright, "upright", "two marks appear one above the other", 2}, misses_upright},
        {{parallel, "parallel",
          "the line through the first two marks is parallel to that through the other two", 4},
         misses_parallel},
        {{length, "length", "two marks appear so many pixels apart", 2, ValueUse::must},
         misses_length},
        {{ratio, "ratio", "the first two marks are so many times as far apart as the other two", 4,
          ValueUse::must},
         misses_ratio},
        {{magnification, "magnification",
          "there are so many pixels per unit at a distance, or per radian", 0, ValueUse::must},
         nullptr},
        {{isotropic, "isotropic", "small circles appear as circles", 0}, nullptr},
        {{unfolded, "unfolded",
          "the picture is not mirrored, and its rows and columns meet at an angle of at least this "
          "sine",
          0, ValueUse::may},
         nullptr},
        {of_outline(left, "left", "an outline begins so many pixels from the left side"),
         misses_left},
        {of_outline(right, "right", "an outline ends so many pixels from the left side"),
         misses_right},
        {of_outline(top, "top", "an outline begins so many pixels from the upper side"),
         misses_top},
        {of_outline(bottom, "bottom", "an outline ends so many pixels from the upper side"),
         misses_bottom},
        {of_outline(wide, "wide", "an outline is so many pixels wide"), misses_wide},
        {of_outline(high, "high", "an outline is so many pixels high"), misses_high},
        {{within, "within", "an outline is in a box or, without one, in the picture", 0,
          ValueUse::none, true, "box", true},
         misses_within},
        {{touches, "touches", "an outline touches the line through two positions", 0,
          ValueUse::none, true, "line"},
         misses_touches},
    };
    return all;
}

}  // namespace

const std::vector<ConstraintKindInfo>& constraint_kinds() {
    static const std::vector<ConstraintKindInfo> infos = [] {
        std::vector<ConstraintKindInfo> made;
        for (const Row& row : rows()) {
            made.push_back(row.info);
        }
        return made;
    }();
    return infos;
}

std::vector<Dual> sighting_misses(const Constraint& constraint, std::span<const DualPoint> at,
                                  const V2d& size) {
    const Row& row = rows()[static_cast<std::size_t>(constraint.kind)];
    assert(row.misses != nullptr && (row.info.is_of_outline || at.size() == row.info.marks));
    return row.misses({constraint, at, size});
}

}  // namespace balcony::solve
