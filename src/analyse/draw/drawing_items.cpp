// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/drawing_items.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace balcony::analyse {

namespace {

// Colours that are distinguishable with any colour vision: Okabe and Ito, "Color Universal
// Design", 2008. Areas are tints of them.
struct ObjectStyle {
    DrawingColor line;
    DrawingColor light, dark;  ///< For areas that face the light, and for others.
    double opacity;
};
constexpr ObjectStyle eye_style{{0, 90, 150}, {226, 241, 251}, {128, 184, 222}, 0.78};
constexpr ObjectStyle toward_style{{0, 140, 105}, {222, 243, 236}, {140, 205, 184}, 0.42};
constexpr DrawingColor ray_color{213, 94, 0};
// Each of several cameras has one of these colours, and tints of it.
constexpr std::array<DrawingColor, 6> camera_colors{{
    {0, 114, 178},
    {213, 94, 0},
    {0, 158, 115},
    {204, 121, 167},
    {230, 159, 0},
    {86, 180, 233},
}};
constexpr DrawingColor frame_color{25, 25, 25};
constexpr DrawingColor axis_color{120, 120, 120};

// Widths in pixels on a page of 960 x 720.
constexpr double grid_width = 0.9;
constexpr double curve_width = 5.0;
constexpr double point_width = 13.0;
constexpr double frame_width = 3.2;
constexpr double corner_width = 13.0;
constexpr double ray_width = 1.5;
constexpr double axis_width = 1.5;

constexpr double cell_count = 336.0;  // 24 x 14.

DrawingColor mix(const DrawingColor& a, const DrawingColor& b, double share) {
    DrawingColor mixed{};
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        mixed[i] = static_cast<std::uint8_t>(std::lround(a[i] + share * (b[i] - a[i])));
    }
    return mixed;
}

struct CameraStyle {
    ObjectStyle eye, toward;
    DrawingColor ray;
};

CameraStyle style_of(std::size_t camera) {
    if (camera == 0) {
        return {eye_style, toward_style, ray_color};
    }
    constexpr DrawingColor black{0, 0, 0};
    constexpr DrawingColor white{255, 255, 255};
    const DrawingColor own = camera_color(camera);
    ObjectStyle object{mix(own, black, 0.2), mix(own, white, 0.86), mix(own, white, 0.45),
                       eye_style.opacity};
    CameraStyle style{object, object, own};
    style.toward.opacity = toward_style.opacity;
    return style;
}

double mean_distance(const DrawingViewer& viewer, const std::vector<V3d>& points) {
    double sum = 0.0;
    for (const V3d& point : points) {
        sum += viewer.distance(point);
    }
    return sum / static_cast<double>(points.size());
}

/// One object with the grid of the picture's lines on it.
class ObjectPainter {
public:
    ObjectPainter(ProjectionObject& object, DrawingPart part, const ObjectStyle& style,
                  double aspect, double extent, const DrawingViewer& viewer)
        : object_(object),
          part_(part),
          style_(style),
          grid_(PictureGrid::of_cells(cell_count, aspect)),
          tolerance_(0.0015 * extent),
          step_(1e-6 * extent),
          viewer_(viewer) {}

    std::vector<DrawingItem> paint(bool with_frame) {
        if (object_.dimension() == 2) {
            paint_cells();
            paint_lines(with_frame);
        } else {
            paint_curve();
        }
        return std::move(items_);
    }

private:
    using Index = std::size_t;

    V2d crossing(Index column, Index row) const {
        return grid_.at(static_cast<double>(column), static_cast<double>(row));
    }

    void paint_cells() {
        cell_distances_.resize(grid_.columns * grid_.rows);
        for (Index row = 0; row < grid_.rows; ++row) {
            for (Index column = 0; column < grid_.columns; ++column) {
                const auto middle = object_.at(
                    grid_.at(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5));
                auto& distance = cell_distances_[row * grid_.columns + column];
                if (middle) {
                    distance = viewer_.distance(middle->position);
                }
                paint_area(crossing(column, row), crossing(column + 1, row + 1), distance, 0);
            }
        }
    }

    // An area between grid lines of the picture. Cells with a gap in the object are omitted.
    void paint_area(const V2d& first, const V2d& last, const std::optional<double>& distance,
                    int depth) {
        const std::array<V2d, 4> corners{first, V2d(last.x, first.y), last, V2d(first.x, last.y)};
        std::vector<V3d> outline;
        bool whole = true;
        for (Index i = 0; i < corners.size() && whole; ++i) {
            const V2d& to = corners[(i + 1) % corners.size()];
            const auto pieces = object_.trace(corners[i], to, tolerance_);
            if (!pieces) {
                return;
            }
            whole = pieces->size() == 1 && object_.at(corners[i]) && object_.at(to);
            if (whole) {
                outline.insert(outline.end(), pieces->front().begin(), pieces->front().end() - 1);
            }
        }
        if (whole) {
            add({part_, outline, shade(outline), 0.0, style_.opacity, false,
                 distance.value_or(mean_distance(viewer_, outline))});
            return;
        }
        constexpr int finest = 3;
        if (depth == finest) {
            return;
        }
        const V2d middle = 0.5 * (first + last);
        paint_area(first, middle, distance, depth + 1);
        paint_area({middle.x, first.y}, {last.x, middle.y}, distance, depth + 1);
        paint_area({first.x, middle.y}, {middle.x, last.y}, distance, depth + 1);
        paint_area(middle, last, distance, depth + 1);
    }

    // By the angle between the area and a light above the viewer's left shoulder, for both sides.
    DrawingColor shade(const std::vector<V3d>& outline) const {
        V3d normal(0.0);
        for (Index i = 0; i + 2 < outline.size(); ++i) {
            normal += (outline[i + 1] - outline[0]).cross(outline[i + 2] - outline[0]);
        }
        const V3d light =
            (viewer_.towards() + 0.7 * viewer_.up() - 0.6 * viewer_.right()).normalized();
        const double cosine =
            normal.length2() > 0.0 ? std::abs(normal.normalized().dot(light)) : 1.0;
        return mix(style_.dark, style_.light, cosine);
    }

    // None if the line cannot be followed.
    std::vector<Polyline> pieces_of(const V2d& from, const V2d& to) {
        return object_.trace(from, to, tolerance_).value_or(std::vector<Polyline>());
    }

    void paint_lines(bool with_frame) {
        for (Index row = 0; row <= grid_.rows; ++row) {
            for (Index column = 0; column < grid_.columns; ++column) {
                paint_line(crossing(column, row), crossing(column + 1, row),
                           nearest_cell(column, row, true),
                           with_frame && (row == 0 || row == grid_.rows));
            }
        }
        for (Index column = 0; column <= grid_.columns; ++column) {
            for (Index row = 0; row < grid_.rows; ++row) {
                paint_line(crossing(column, row), crossing(column, row + 1),
                           nearest_cell(column, row, false),
                           with_frame && (column == 0 || column == grid_.columns));
            }
        }
        if (const auto corner = object_.at(crossing(0, 0)); corner && with_frame) {
            add({DrawingPart::frame,
                 {corner->position},
                 frame_color,
                 corner_width,
                 1.0,
                 false,
                 viewer_.distance(corner->position) - 3.0 * step_});
        }
    }

    // Of the two cells that share a line, the nearer one, so that the line is painted after both.
    std::optional<double> nearest_cell(Index column, Index row, bool along_x) const {
        std::optional<double> nearest;
        for (const Index before : {Index{0}, Index{1}}) {
            const Index c = along_x ? column : column - before;
            const Index r = along_x ? row - before : row;
            // A column or row before the first wraps to an index out of range.
            if (c < grid_.columns && r < grid_.rows) {
                if (const auto& distance = cell_distances_[r * grid_.columns + c]) {
                    nearest = std::min(nearest.value_or(*distance), *distance);
                }
            }
        }
        return nearest;
    }

    void paint_line(const V2d& from, const V2d& to, const std::optional<double>& cell,
                    bool is_frame) {
        for (Polyline& piece : pieces_of(from, to)) {
            const double distance = cell.value_or(mean_distance(viewer_, piece));
            add({is_frame ? DrawingPart::frame : part_, std::move(piece),
                 is_frame ? frame_color : style_.line, is_frame ? frame_width : grid_width, 1.0,
                 false, distance - (is_frame ? 2.0 : 1.0) * step_});
        }
    }

    // Along two sides of the picture, which show how the object changes with x and y. Short
    // pieces are sorted separately.
    void paint_curve() {
        const V2d left(crossing(0, 0)), corner(crossing(grid_.columns, 0)),
            bottom(crossing(grid_.columns, grid_.rows));
        for (const auto& [from, to] : {std::pair(left, corner), std::pair(corner, bottom)}) {
            for (const Polyline& piece : pieces_of(from, to)) {
                for (Index i = 0; i + 1 < piece.size(); ++i) {
                    if (object_.dimension() == 1 && piece[i] != piece[i + 1]) {
                        add_marks({piece[i], piece[i + 1]}, curve_width);
                    }
                }
            }
        }
        if (const auto middle = object_.at(V2d(0.5)); middle && object_.dimension() == 0) {
            add_marks({middle->position}, point_width);
        }
    }

    void add_marks(std::vector<V3d> points, double width) {
        const double distance = mean_distance(viewer_, points);
        add({part_, std::move(points), style_.line, width, 1.0, false, distance - step_});
    }

    void add(DrawingItem item) {
        if (!item.points.empty()) {
            items_.push_back(std::move(item));
        }
    }

    ProjectionObject& object_;
    DrawingPart part_;
    const ObjectStyle& style_;
    PictureGrid grid_;
    double tolerance_;
    double step_;  ///< Offset that determines the painting order of things at the same position.
    const DrawingViewer& viewer_;
    std::vector<std::optional<double>> cell_distances_;
    std::vector<DrawingItem> items_;
};

void append(std::vector<DrawingItem>& to, std::vector<DrawingItem> from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// An arrow: a line in separately sorted parts, and a cone, if it has a head.
std::vector<DrawingItem> arrow_items(const Arrow& arrow, DrawingPart part,
                                     const DrawingColor& color, double width, double head,
                                     const DrawingViewer& viewer) {
    std::vector<DrawingItem> items;
    const V3d along = arrow.to - arrow.from;
    if (along.length2() == 0.0) {
        return items;
    }
    const V3d direction = along.normalized();
    const V3d neck =
        arrow.to - (arrow.has_head ? std::min(head, 0.5 * along.length()) : 0.0) * direction;
    const int parts = arrow.has_head ? 6 : 1;
    for (int i = 0; i < parts; ++i) {
        const V3d a = arrow.from + (neck - arrow.from) * (static_cast<double>(i) / parts);
        const V3d b = arrow.from + (neck - arrow.from) * (static_cast<double>(i + 1) / parts);
        items.push_back({part, {a, b}, color, width, 1.0, false, viewer.distance(0.5 * (a + b))});
    }
    if (!arrow.has_head) {
        return items;
    }
    const V3d aside =
        (std::abs(direction.z) < 0.9 ? V3d(0, 0, 1) : V3d(1, 0, 0)).cross(direction).normalized();
    const V3d across = direction.cross(aside);
    DrawingItem cone{part, {arrow.to}, color, 0.0, 1.0, true, viewer.distance(neck)};
    constexpr int corners = 12;
    const double radius = 0.3 * (arrow.to - neck).length();
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        cone.points.push_back(neck + radius * (std::cos(angle) * aside + std::sin(angle) * across));
    }
    items.push_back(std::move(cone));
    return items;
}

}  // namespace

DrawingColor camera_color(std::size_t camera) {
    return camera_colors[(camera - 1) % camera_colors.size()];
}

std::vector<DrawingItem> drawing_items(const CameraGeometry& geometry, std::size_t camera,
                                       double extent, const Depiction& depiction,
                                       const DrawingViewer& viewer) {
    std::vector<DrawingItem> items;
    const CameraStyle style = style_of(camera);
    const auto paint = [&](ProjectionObject& object, DrawingPart part) {
        const bool with_frame = depiction.frame && &object == geometry.screen();
        const ObjectStyle& own = part == DrawingPart::eye ? style.eye : style.toward;
        append(items,
               ObjectPainter(object, part, own, geometry.aspect, extent, viewer).paint(with_frame));
    };
    if (depiction.eye) {
        paint(*geometry.eye, DrawingPart::eye);
    }
    if (depiction.toward && geometry.toward) {
        paint(*geometry.toward, DrawingPart::toward);
    }
    const double head = 0.024 * extent;
    for (const Arrow& ray : geometry.rays) {
        append(items, arrow_items(ray, DrawingPart::ray, depiction.color.value_or(style.ray),
                                  ray_width, head, viewer));
    }
    for (DrawingItem& item : items) {
        item.camera = camera;
    }
    return items;
}

DrawnAxes drawn_axes(const PictureGeometry& geometry, const DrawingViewer& viewer) {
    const double extent = std::max(geometry.extent(), 1e-300);
    const Box3d& box = geometry.bounds;
    DrawnAxes drawn{V3d(0.0), {}};
    if (box.center().length() > extent) {
        drawn.origin = box.min;
        for (const V3d& corner :
             {V3d(box.max.x, box.min.y, box.min.z), V3d(box.min.x, box.max.y, box.min.z),
              V3d(box.max.x, box.max.y, box.min.z)}) {
            if (viewer.project(corner).x < viewer.project(drawn.origin).x) {
                drawn.origin = corner;
            }
        }
    }
    const double length = 0.22 * extent;
    const std::array<V3d, 3> own{V3d(1, 0, 0), V3d(0, 1, 0), V3d(0, 0, 1)};
    for (std::size_t i = 0; i < own.size(); ++i) {
        drawn.tips[i] = drawn.origin + length * turned(own[i], geometry.axes, Axes::z_up);
    }
    return drawn;
}

std::vector<DrawingItem> drawing_items(const DrawnAxes& axes, const DrawingViewer& viewer) {
    std::vector<DrawingItem> items;
    for (const V3d& tip : axes.tips) {
        append(items, arrow_items({axes.origin, tip}, DrawingPart::axis, axis_color, axis_width,
                                  0.12 * (tip - axes.origin).length(), viewer));
    }
    return items;
}

}  // namespace balcony::analyse
