// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/solving.hpp"

namespace balcony::app {

namespace {

using analyse::Drawing;
using analyse::DrawingColor;
using analyse::DrawingPart;
using solve::V2d;

constexpr DrawingColor mark_color{20, 80, 200};
constexpr DrawingColor miss_color{210, 30, 30};
constexpr DrawingColor tint{255, 150, 0};
constexpr DrawingColor text_color{40, 40, 40};
constexpr DrawingColor plate_color{255, 255, 255};
// In thousandths of the longer side.
constexpr double note_size = 12.0;
constexpr double note_height = 20.0;  // From line to line.

// The largest of 1, 2, 5, 10, ... that is not above a number.
double round_below(double number) {
    const double power = std::pow(10.0, std::floor(std::log10(number)));
    const double digits = number / power;
    return (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0) * power;
}

class MarksDrawing {
public:
    explicit MarksDrawing(const SolveReport& report)
        : report_(report),
          unit_(static_cast<double>(std::max(report.width, report.height)) / 1000.0) {
        made_.name = report.camera;
        made_.width = report.width;
        made_.height = report.height;
    }

    Drawing take() {
        add_uncertainty();
        add_misses();
        add_marks();
        add_outlines();
        add_plate();
        return std::move(made_);
    }

private:
    /// From none for the least uncertain cell to a third for the most uncertain one.
    void add_uncertainty() {
        double least = INFINITY;
        double most = 0.0;
        for (const auto& one : report_.solution.errors) {
            if (one && std::isfinite(*one) && *one > 0.0) {
                least = std::min(least, *one);
                most = std::max(most, *one);
            }
        }
        const solve::ErrorGrid& grid = report_.grid;
        if (!(most > 0.0) || report_.solution.errors.size() != grid.columns * grid.rows) {
            return;
        }
        const double range = std::log(most / least);
        const V2d cell(static_cast<double>(made_.width) / static_cast<double>(grid.columns),
                       static_cast<double>(made_.height) / static_cast<double>(grid.rows));
        for (std::size_t i = 0; i < report_.solution.errors.size(); ++i) {
            const auto& one = report_.solution.errors[i];
            if (!one || !(*one > 0.0)) {
                continue;
            }
            const double part = !std::isfinite(*one) ? 1.0
                                : range > 0.0        ? std::log(*one / least) / range
                                                     : 0.0;
            const V2d corner(cell.x * static_cast<double>(i % grid.columns),
                             cell.y * static_cast<double>(i / grid.columns));
            made_.shapes.push_back(
                {DrawingPart::uncertainty,
                 {corner, corner + V2d(cell.x, 0.0), corner + cell, corner + V2d(0.0, cell.y)},
                 tint,
                 0.0,
                 0.35 * part});
        }
        note(fmt::format("uncertainty {:.2g} to {:.2g} px", least, most));
    }

    /// From where a mark is shown to where it is demanded, lengthened.
    void add_misses() {
        double longest = 0.0;
        for_positions([&](const V2d& seen, const V2d& wanted) {
            longest = std::max(longest, (wanted - seen).length());
        });
        if (!(longest > 0.0)) {
            return;
        }
        const double times = std::max(1.0, round_below(60.0 * unit_ / longest));
        for_positions([&](const V2d& seen, const V2d& wanted) {
            line(DrawingPart::miss, {seen, seen + times * (wanted - seen)}, miss_color, 2.0);
        });
        note(fmt::format("misses x {:g}, the largest {:.2g} px", times, longest));
    }

    void add_marks() {
        constexpr std::size_t most_names = 40;
        for (std::size_t i = 0; i < report_.solution.seen.size(); ++i) {
            const auto& seen = report_.solution.seen[i];
            if (!seen) {
                continue;
            }
            std::vector<V2d> circle;
            constexpr int corners = 24;
            for (int k = 0; k <= corners; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / corners;
                circle.push_back(*seen + 6.0 * unit_ * V2d(std::cos(angle), std::sin(angle)));
            }
            line(DrawingPart::mark, std::move(circle), mark_color, 2.0);
            if (report_.problem.marks.size() <= most_names) {
                made_.labels.push_back({printable(report_.problem.marks[i].name),
                                        *seen + unit_ * V2d(10.0, -8.0), 11.0 * unit_, mark_color});
            }
        }
    }

    void add_outlines() {
        for (std::size_t i = 0; i < report_.solution.outlines.size(); ++i) {
            std::vector<V2d> corners = report_.solution.outlines[i];
            if (corners.empty()) {
                continue;
            }
            corners.push_back(corners.front());
            made_.labels.push_back({printable(report_.problem.outlines[i].name),
                                    corners.front() + unit_ * V2d(10.0, -8.0), 11.0 * unit_,
                                    mark_color});
            line(DrawingPart::mark, std::move(corners), mark_color, 2.0);
        }
    }

    template <class Use>
    void for_positions(const Use& use) const {
        for (const solve::Constraint& one : report_.problem.constraints) {
            const bool is_at = one.kind == solve::ConstraintKind::at;
            if (is_at && report_.solution.seen[one.marks.front()]) {
                use(*report_.solution.seen[one.marks.front()], one.position);
            }
        }
    }

    void line(DrawingPart part, std::vector<V2d> points, const DrawingColor& color, double width) {
        made_.shapes.push_back({part, std::move(points), color, width * unit_});
    }

    void note(std::string text) {
        longest_note_ = std::max(longest_note_, text.size());
        const double above = static_cast<double>(notes_++) * note_height;
        made_.labels.push_back(
            {std::move(text),
             {10.0 * unit_, static_cast<double>(made_.height) - (above + 12.0) * unit_},
             note_size * unit_,
             text_color,
             true});
    }

    /// Behind the notes, over all else.
    void add_plate() {
        if (notes_ == 0) {
            return;
        }
        constexpr double letter = 6.0 / 7.0;  // Of a size, as DrawingLabel has it.
        const V2d foot(0.0, static_cast<double>(made_.height));
        const V2d size = unit_ * V2d(20.0 + static_cast<double>(longest_note_) * letter * note_size,
                                     12.0 + static_cast<double>(notes_) * note_height);
        made_.shapes.push_back(
            {DrawingPart::frame,
             {foot, foot - V2d(0.0, size.y), foot + V2d(size.x, -size.y), foot + V2d(size.x, 0.0)},
             plate_color,
             0.0,
             0.85});
    }

    const SolveReport& report_;
    double unit_;  ///< A thousandth of the longer side.
    Drawing made_;
    std::size_t notes_ = 0;
    std::size_t longest_note_ = 0;  ///< In letters.
};

}  // namespace

Drawing draw_marks(const SolveReport& report) { return MarksDrawing(report).take(); }

Image uncertainty_map(const SolveReport& report) {
    return analyse::paint({.title = "expected uncertainty of projections: deviation in pixels",
                           .width = report.width,
                           .height = report.height,
                           .columns = report.grid.columns,
                           .rows = report.grid.rows,
                           .numbers = report.solution.errors});
}

}  // namespace balcony::app
