// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analyse/draw/camera_geometry.hpp"
#include "analyse/draw/drawing_items.hpp"
#include "analyse/draw/drawing_viewer.hpp"

namespace balcony::analyse {

namespace {

// Pixels of a page as large as this one grow and shrink with the page.
constexpr double usual_page_side = 831.0;  // sqrt(960 * 720)

constexpr std::size_t min_side = 16;
constexpr std::size_t max_side = 16384;

/// The strokes of the letters x, y and z in a square from (-1, -1) to (1, 1), y down.
const std::array<std::vector<std::vector<V2d>>, 3>& letters() {
    static const std::array<std::vector<std::vector<V2d>>, 3> strokes{{
        {{{-0.8, -1}, {0.8, 1}}, {{0.8, -1}, {-0.8, 1}}},
        {{{-0.8, -1}, {0, 0.1}}, {{0.8, -1}, {0, 0.1}, {0, 1}}},
        {{{-0.8, -1}, {0.8, -1}, {-0.8, 1}, {0.8, 1}}},
    }};
    return strokes;
}
constexpr DrawingColor letter_color{70, 70, 70};
constexpr double letter_size = 5.5;  // Half of it.
constexpr double letter_width = 1.8;
constexpr double label_size = 11.0;

/// Removes redundant points: those near the previous one, and those near the line
/// between their neighbours.
std::vector<V2d> thinned(const std::vector<V2d>& points) {
    constexpr double visible = 0.1;
    std::vector<V2d> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept.empty()) {
            kept.push_back(points[i]);
            continue;
        }
        const V2d step = points[i] - kept.back();
        if (step.length() < visible) {
            continue;
        }
        if (i + 1 < points.size()) {
            const V2d chord = points[i + 1] - kept.back();
            const double length = chord.length();
            if (length > 0.0 && std::abs(chord % step) < visible * length &&
                chord.dot(step) > 0.0 && step.length() < length) {
                continue;
            }
        }
        kept.push_back(points[i]);
    }
    return kept;
}

/// The convex hull, by Andrew's monotone chain.
std::vector<V2d> hull_of(std::vector<V2d> points) {
    const auto turn = [](const V2d& a, const V2d& b, const V2d& c) { return (b - a) % (c - a); };
    std::sort(points.begin(), points.end(),
              [](const V2d& a, const V2d& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<V2d> hull;
    const auto add_chain = [&](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= base + 2 &&
                   turn(hull[hull.size() - 2], hull.back(), *point) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(*point);
        }
        hull.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return hull;
}

/// The points that belong on the page: those not far outside the measured bounds, as points
/// near a pole of a formula are.
Box2d seen(const std::vector<DrawingItem>& items, const Box3d& bounds,
           const DrawingViewer& viewer) {
    const V3d margin(0.1 * bounds.size().length());
    const Box3d wide(bounds.min - margin, bounds.max + margin);
    Box2d box;
    for (const DrawingItem& item : items) {
        for (const V3d& point : item.points) {
            if (item.part == DrawingPart::axis || wide.intersects(point)) {
                box.extendBy(viewer.project(point));
            }
        }
    }
    return box;
}

class Composer {
public:
    Composer(Drawing& drawing, const DrawingViewer& viewer, const Page& page, double unit)
        : drawing_(drawing), viewer_(viewer), page_(page), unit_(unit) {}

    void add(const DrawingItem& item) {
        std::vector<V2d> points;
        for (const V3d& point : item.points) {
            points.push_back(page_(viewer_.project(point)));
        }
        points = item.hull ? hull_of(std::move(points)) : thinned(points);
        const bool is_area = item.line_width == 0.0;
        // Omits lines that degenerate to a dot in this view, unless they are dots.
        const bool is_nothing =
            is_area ? points.size() < 3 : points.size() < 2 && item.points.size() > 1;
        if (!is_nothing) {
            drawing_.shapes.push_back({item.part, std::move(points), item.color,
                                       item.line_width * unit_, item.opacity, item.camera});
        }
    }

    // From the top left, in the order of the layers, the front layer first.
    void add_labels(const PictureGeometry& geometry) {
        const std::size_t count = geometry.cameras.size();
        for (std::size_t i = 0; i < count; ++i) {
            const V2d position(label_size, label_size * (2.0 + 2.0 * static_cast<double>(i)));
            const std::size_t camera = count - i;
            drawing_.labels.push_back({geometry.cameras[camera - 1].title, unit_ * position,
                                       unit_ * label_size, camera_color(camera)});
        }
    }

    void add_letter(std::size_t axis, const DrawnAxes& axes) {
        const V2d origin = page_(viewer_.project(axes.origin));
        const V2d tip = page_(viewer_.project(axes.tips[axis]));
        const V2d away = (tip - origin).length() > 1e-6 ? (tip - origin).normalized() : V2d(0, -1);
        const V2d middle = tip + 2.0 * letter_size * unit_ * away;
        for (const std::vector<V2d>& stroke : letters()[axis]) {
            std::vector<V2d> points;
            for (const V2d& point : stroke) {
                points.push_back(middle + letter_size * unit_ * point);
            }
            drawing_.shapes.push_back(
                {DrawingPart::axis, std::move(points), letter_color, letter_width * unit_, 1.0});
        }
    }

private:
    Drawing& drawing_;
    const DrawingViewer& viewer_;
    const Page& page_;
    double unit_;
};

std::optional<Diagnostic> refusal(const DrawingView& view) {
    if (std::min(view.width, view.height) < min_side ||
        std::max(view.width, view.height) > max_side) {
        return error(
            fmt::format("a drawing of {} x {} pixels is not supported", view.width, view.height),
            {}, fmt::format("give each side from {} to {} pixels", min_side, max_side));
    }
    if (!std::isfinite(view.azimuth) || !std::isfinite(view.elevation)) {
        return error("a drawing cannot be seen from an angle that is not a number");
    }
    return std::nullopt;
}

}  // namespace

std::string_view name_of(DrawingPart part) {
    switch (part) {
        case DrawingPart::eye: return "eye";
        case DrawingPart::toward: return "toward";
        case DrawingPart::frame: return "frame";
        case DrawingPart::ray: return "ray";
        case DrawingPart::axis: return "axis";
        case DrawingPart::mark: return "mark";
        case DrawingPart::miss: return "miss";
        case DrawingPart::uncertainty: return "uncertainty";
    }
    return {};
}

namespace {

/// What there is to draw, the farthest first.
std::vector<DrawingItem> items_of(const PictureGeometry& geometry, const Depiction& depiction,
                                  const DrawingViewer& viewer, const Work& work) {
    std::vector<DrawingItem> items;
    const auto append = [&items](const std::vector<DrawingItem>& more) {
        items.insert(items.end(), more.begin(), more.end());
    };
    const std::size_t count = geometry.cameras.size();
    for (std::size_t i = 0; i < count; ++i) {
        work.done(static_cast<double>(i) / static_cast<double>(count));
        const bool several = !geometry.cameras[i].title.empty();
        append(drawing_items(geometry.cameras[i].geometry, several ? i + 1 : 0, geometry.extent(),
                             depiction, viewer));
    }
    if (depiction.axes) {
        append(drawing_items(drawn_axes(geometry, viewer), viewer));
    }
    std::stable_sort(items.begin(), items.end(), [](const DrawingItem& a, const DrawingItem& b) {
        return a.distance > b.distance;
    });
    return items;
}

/// The lines of a text at the right of a page: how large they can be, and where they stand.
class Notes {
public:
    Notes(const DrawingView& view, double margin, double largest) : view_(view), margin_(margin) {
        const auto width = static_cast<double>(view.width);
        const auto height = static_cast<double>(view.height);
        std::size_t longest = 1;
        for (const std::string& line : view.notes) {
            longest = std::max(longest, line.size());
        }
        const double letters = letter * static_cast<double>(longest);
        size_ = std::min(
            {largest, share * width / letters,
             (height - 2.0 * margin) / (line_height * static_cast<double>(view.notes.size()))});
        left_ = width - margin - letters * size_;
    }

    /// The part of the page that they leave to the figure.
    [[nodiscard]] DrawingView figure() const {
        DrawingView figure = view_;
        if (!view_.notes.empty()) {
            figure.width = static_cast<std::size_t>(std::max(left_, 2.0 * margin_ + 1.0));
        }
        return figure;
    }

    void add_to(Drawing& drawing) const {
        double bottom = margin_;
        for (const std::string& line : view_.notes) {
            bottom += line_height * size_;
            drawing.labels.push_back({line, {left_, bottom}, size_, letter_color, true});
        }
    }

private:
    static constexpr double letter = 6.0 / 7.0;  // Of a size, as DrawingLabel has it.
    static constexpr double line_height = 1.8;   // In sizes.
    static constexpr double share = 0.55;        // Of the page, at most.

    const DrawingView& view_;
    double margin_;
    double size_ = 0.0;
    double left_ = 0.0;
};

Result<Drawing> drawing_of(const camera::Picture& picture, const Depiction& depiction,
                           const DrawingView& view, const Work& work) {
    if (const auto refused = refusal(view)) {
        return *refused;
    }
    auto geometry = measure_geometry(picture, depiction, work.part(0.0, 0.2));
    if (!geometry) {
        return geometry.diagnostics;
    }
    const std::vector<PictureGeometry> film = measure_film(picture, depiction, work.part(0.2, 0.4));
    Box3d bounds = film.empty() ? geometry->bounds : film.front().bounds;
    geometry->bounds = bounds;
    if (bounds.size().length() == 0.0) {
        bounds = Box3d(bounds.min - V3d(1.0), bounds.max + V3d(1.0));
    }
    const DrawingViewer viewer(view, bounds);
    const std::vector<DrawingItem> items =
        items_of(*geometry, depiction, viewer, work.part(0.4, 0.7));
    Box2d box = film.empty() ? seen(items, bounds, viewer) : Box2d();
    for (const PictureGeometry& then : film) {
        box.extendBy(seen(items_of(then, depiction, viewer, work.silent()), bounds, viewer));
    }

    const double unit =
        std::sqrt(static_cast<double>(view.width) * static_cast<double>(view.height)) /
        usual_page_side;
    const double margin = 26.0 * unit;
    const Notes notes(view, margin, label_size * unit);
    const Page page(notes.figure(), box, margin);
    Drawing drawing{picture.name(), view.width, view.height, {}};
    Composer composer(drawing, viewer, page, unit);
    for (const DrawingItem& item : items) {
        work.go_on();
        composer.add(item);
    }
    const DrawnAxes axes = drawn_axes(*geometry, viewer);
    for (std::size_t axis = 0; depiction.axes && axis < axes.tips.size(); ++axis) {
        composer.add_letter(axis, axes);
    }
    if (picture.only_camera() == nullptr) {
        composer.add_labels(*geometry);
    }
    notes.add_to(drawing);
    Diagnostics diagnostics = geometry.diagnostics;
    const Diagnostics left_out = omissions(*geometry);
    diagnostics.insert(diagnostics.end(), left_out.begin(), left_out.end());
    work.done(1.0);
    return {std::move(drawing), std::move(diagnostics)};
}

}  // namespace

Result<Drawing> draw(const camera::Picture& picture, const Depiction& depiction,
                     const DrawingView& view, const PartDone& progress, std::stop_token stop) {
    return unless_stopped(
        [&] { return drawing_of(picture, depiction, view, Work(progress, std::move(stop))); });
}

}  // namespace balcony::analyse
