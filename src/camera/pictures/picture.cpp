// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture arranger: layers become a tree of elements, each with its coverage as a formula.

#include "balcony/picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "camera/arrangers/clip_shapes.hpp"
#include "camera/machine/arrange.hpp"
#include "camera/machine/size_limit.hpp"
#include "camera/pictures/layer_arrangers.hpp"
#include "camera/pictures/strokes.hpp"

namespace balcony::camera {

namespace {

using Element = PictureExpressions::Element;
using NestedPicture = std::shared_ptr<const Picture>;

// ------------------------------------------------------------------------------------- checks

const Picture* nested(const Layer& layer) {
    const auto* picture = std::get_if<NestedPicture>(&layer.content);
    return picture != nullptr ? picture->get() : nullptr;
}

std::optional<std::array<double, 2>> sides_of(const Layer& layer) {
    const Picture* inner = nested(layer);
    return inner != nullptr ? inner->sides() : std::get<Camera>(layer.content).parts().sides;
}

struct Extent {
    std::size_t layers = 0;
    std::size_t depth = 1;
};

Extent extent(const Picture::Parts& parts) {
    Extent all;
    for (const Layer& layer : parts.layers) {
        ++all.layers;
        if (const Picture* inner = nested(layer)) {
            const Extent within = extent(inner->parts());
            all.layers += within.layers;
            all.depth = std::max(all.depth, within.depth + 1);
        }
    }
    return all;
}

// The value of a number if it does not depend on time.
bool known_outside(const Scalar& value, double minimum, double maximum) {
    const auto known = value.constant();
    return known && !(minimum <= *known && *known <= maximum);
}

void check_stroke(const Stroke& stroke, const std::string& layer, Diagnostics& diagnostics) {
    if (known_outside(stroke.width, 0.0, 1.0)) {
        diagnostics.push_back(
            error(fmt::format("the width of a line of layer '{}' is not from 0 to 1", layer), {},
                  "the width is a fraction of the picture's height, such as 0.004"));
    }
}

void check_region(const PictureRegion& region, const std::string& layer, Diagnostics& diagnostics) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const auto first = region.from[i].constant();
        const auto last = region.to[i].constant();
        if (first && last && !(*first < *last)) {
            diagnostics.push_back(
                error(fmt::format("the region that layer '{}' shows has no area", layer), {},
                      "write its top left and its bottom right corner, such as (0.2, 0.1) .. (0.5, "
                      "0.4)"));
            return;
        }
    }
}

void check_layer(const Layer& layer, Diagnostics& diagnostics) {
    if (known_outside(layer.alpha, 0.0, 1.0)) {
        diagnostics.push_back(
            error(fmt::format("the alpha of layer '{}' is not from 0 to 1", layer.name), {},
                  "0 is transparent, 1 is opaque"));
    }
    if (known_outside(layer.softness, 0.0, 1.0)) {
        diagnostics.push_back(error(
            fmt::format("the width of the soft edge of layer '{}' is not from 0 to 1", layer.name),
            {}, "the width is a fraction of the layer's height, such as 0.05"));
    }
    if (layer.show) {
        check_region(*layer.show, layer.name, diagnostics);
    }
    if (layer.frame) {
        check_stroke(*layer.frame, layer.name, diagnostics);
    }
    if (layer.scale_bar && !sides_of(layer)) {
        diagnostics.push_back(error(
            fmt::format("layer '{}' has a scale bar, but what it shows has no scale", layer.name),
            {}, "write the sides of its picture in scene units: aspect (WIDTH, HEIGHT)"));
    }
    for (const Leader& leader : layer.leaders) {
        check_stroke(leader.stroke, layer.name, diagnostics);
    }
}

void check_extent(const Picture::Parts& parts, Diagnostics& diagnostics) {
    const Extent all = extent(parts);
    if (all.layers == 0) {
        diagnostics.push_back(error(fmt::format("picture '{}' has no layers", parts.name), {},
                                    "add one with: layer NAME"));
    }
    if (all.layers > max_layers) {
        diagnostics.push_back(
            error(fmt::format("picture '{}' has {} layers, including those of nested pictures; "
                              "the maximum is {}",
                              parts.name, all.layers, max_layers)));
    }
    if (all.depth > max_nested_pictures) {
        diagnostics.push_back(
            error(fmt::format("picture '{}' nests pictures {} levels deep; the maximum is {}",
                              parts.name, all.depth, max_nested_pictures)));
    }
}

// ----------------------------------------------------------------------------------- elements

/// The four corners of a rectangle, with their sides: -1 for left and top, 1 for right and
/// bottom.
struct Corner {
    double side_x, side_y;
};
constexpr std::array corners = {Corner{-1.0, -1.0}, Corner{1.0, -1.0}, Corner{-1.0, 1.0},
                                Corner{1.0, 1.0}};

class PictureEmitter {
public:
    enum class Contents : bool { left_out, emitted };

    PictureEmitter(Graph& graph, Contents contents) : graph_(graph), contents_(contents) {}

    std::vector<Element> elements(const Picture& picture, const PicturePoint& point,
                                  const std::string& path) {
        std::vector<Element> made;
        const Picture::Parts& parts = picture.parts();
        for (std::size_t i = 0; i < parts.layers.size(); ++i) {
            add(parts, i, point, path, made);
        }
        return made;
    }

    // The whole picture, fitted into a picture of another aspect. Nothing is outside of it.
    std::vector<Element> fitted_elements(const Picture& picture, const PicturePoint& whole) {
        Emitter emit(graph_);
        const PictureArrangerPointer fitted = fitting_of(picture);
        const PicturePoint own = fitted ? fitted->arrange(whole, emit) : whole;
        std::vector<Element> made = elements(picture, own, "");
        if (!are_same(own, whole)) {
            for (Element& element : made) {
                element.coverage = select(inside(own), element.coverage, emit(0.0));
            }
        }
        return made;
    }

private:
    void add(const Picture::Parts& parts, std::size_t index, const PicturePoint& whole,
             const std::string& path, std::vector<Element>& made) {
        const Layer& layer = parts.layers[index];
        const LayerArrangers arrangers = arrangers_of(parts, index);
        Emitter emit(graph_);
        const PicturePoint window = arranged(whole, arrangers.window, emit);
        const PicturePoint own = arranged(window, arrangers.content, emit);
        const ClipShapePointer clip = layer.clip ? layer.clip : whole_rectangle();
        const Expr edge = layer.frame || !layer.leaders.empty()
                              ? in_device_pixels(clip->distance(window, emit), window, emit)
                              : Expr();
        for (const Leader& leader : layer.leaders) {
            const Corners region = leader.region
                                       ? corners_of(*leader.region, whole.size, {}, emit)
                                       : corners_of(shown_region(layer), whole.size,
                                                    arrangers_of_source(parts, index), emit);
            made.push_back(
                leader_element(leader.stroke, region, arrangers.window, *clip, edge, whole, emit));
        }

        Element content;
        content.name = path.empty() ? layer.name : path + "/" + layer.name;
        content.coverage =
            emit(layer.alpha) * coverage(layer, *clip, are_same(whole, window), window, own, emit);
        content.channels = layer.channels;
        content.blend = layer.blend;
        if (contents_ == Contents::emitted) {
            add_contents(layer, own, content);
        }
        made.push_back(std::move(content));

        if (layer.frame) {
            const Expr width = emit(layer.frame->width) * whole.size.height;
            const Expr from_middle = abs(edge + 0.5 * width) - 0.5 * width;
            made.push_back(painted(antialiased(from_middle, emit), *layer.frame, emit));
        }
        if (const auto sides = layer.scale_bar ? sides_of(layer) : std::nullopt) {
            made.push_back(scale_bar(*layer.scale_bar, (*sides)[0], own, emit));
        }
    }

    void add_contents(const Layer& layer, const PicturePoint& own, Element& content) {
        if (const Picture* inner = nested(layer)) {
            content.group = elements(*inner, own, content.name);
        } else {
            const Camera& camera = std::get<Camera>(layer.content);
            content.ray = camera.emit(own);
            content.axes = camera.parts().axes;
        }
    }

    static bool are_same(const PicturePoint& a, const PicturePoint& b) {
        return a.point.x.id() == b.point.x.id() && a.point.y.id() == b.point.y.id() &&
               a.size.width.id() == b.size.width.id() && a.size.height.id() == b.size.height.id();
    }

    // Where the clip covers the window, and the layer's own picture is there. A layer without clip
    // in the whole picture covers everything; its coverage is the constant 1.
    static Expr coverage(const Layer& layer, const ClipShape& clip, bool covers_whole,
                         const PicturePoint& window, const PicturePoint& own, Emitter& emit) {
        const bool is_cut = !layer.inner_arrangers.empty() || layer.show;
        const Expr there = is_cut ? inside(own) && emit.valid() : emit.valid();
        const Expr shape =
            !layer.clip && covers_whole && layer.softness.constant() == 0.0
                ? emit(1.0)
                : clip.coverage(window, emit(layer.softness) * window.size.height, emit);
        return select(there, shape, emit(0.0));
    }

    /// Two opposite corners of a rectangle in the whole picture, in pixels.
    struct Corners {
        DevicePoint from, to;
    };

    // The arrangers of the layer whose picture has the region that a layer shows.
    static std::vector<PictureArrangerPointer> arrangers_of_source(const Picture::Parts& parts,
                                                                   std::size_t index) {
        const std::optional<std::size_t> source = source_of(parts, index);
        return source ? arrangers_of(parts, *source).all() : std::vector<PictureArrangerPointer>();
    }

    // The smallest upright rectangle around a region of an arranged picture.
    static Corners corners_of(const PictureRegion& region, const PictureSize& whole,
                              const std::vector<PictureArrangerPointer>& arrangers, Emitter& emit) {
        std::optional<Corners> all;
        for (const Corner& corner : corners) {
            const DevicePoint fraction{emit(corner.side_x < 0.0 ? region.from[0] : region.to[0]),
                                       emit(corner.side_y < 0.0 ? region.from[1] : region.to[1])};
            const DevicePoint at =
                arrangers.empty() ? DevicePoint{fraction.x * whole.width, fraction.y * whole.height}
                                  : find_arranged(whole, arrangers, fraction, emit);
            all = all ? Corners{{min(all->from.x, at.x), min(all->from.y, at.y)},
                                {max(all->to.x, at.x), max(all->to.y, at.y)}}
                      : Corners{at, at};
        }
        return *all;
    }

    // The outline of the region and the lines to it, which end at the layer.
    static Element leader_element(const Stroke& stroke, const Corners& target,
                                  const std::vector<PictureArrangerPointer>& window,
                                  const ClipShape& clip, Expr layer_edge, const PicturePoint& whole,
                                  Emitter& emit) {
        const auto& [point, size] = whole;
        const auto& [from, to] = target;
        const Expr half_line = 0.5 * emit(stroke.width) * size.height;
        const Expr region = max(abs(point.x - 0.5 * (from.x + to.x)) - 0.5 * (to.x - from.x),
                                abs(point.y - 0.5 * (from.y + to.y)) - 0.5 * (to.y - from.y));
        Expr drawn = antialiased(abs(region - half_line) - half_line, emit);
        for (const Corner& corner : corners) {
            const DevicePoint end{corner.side_x < 0.0 ? from.x : to.x,
                                  corner.side_y < 0.0 ? from.y : to.y};
            const DevicePoint begin =
                find_arranged(size, window, corner_of(clip, corner, emit), emit);
            // It enters neither rectangle if it leaves both to different sides in x and y.
            const Expr leaves =
                corner.side_x * (end.x - begin.x) * corner.side_y * (end.y - begin.y);
            const Expr line =
                antialiased(segment_distance(point, begin, end, emit) - half_line, emit);
            drawn = max(drawn, select(leaves <= 0.0 && 0.0 <= region && 0.0 <= layer_edge, line,
                                      emit(0.0)));
        }
        return painted(drawn, stroke, emit);
    }

    static DevicePoint corner_of(const ClipShape& clip, const Corner& corner, const Emitter& emit) {
        const double reach = 0.5 * clip.corner_reach();
        return {emit(0.5 + reach * corner.side_x), emit(0.5 + reach * corner.side_y)};
    }

    Graph& graph_;
    Contents contents_;
};

// The number of operations of a picture: those of its layers, counted once, and those of the
// cameras that they show.
std::size_t count_operations(const Picture& picture) {
    Graph graph;
    (void)PictureEmitter(graph, PictureEmitter::Contents::left_out)
        .fitted_elements(picture, whole_picture(graph, 1000.0 * picture.aspect(), 1000.0));
    std::size_t operations = graph.size();
    for (const Layer& layer : picture.parts().layers) {
        const Picture* inner = nested(layer);
        operations += inner != nullptr ? count_operations(*inner)
                                       : std::get<Camera>(layer.content).operations();
    }
    return operations;
}

bool is_too_large(const Picture& picture) {
    try {
        return count_operations(picture) > max_operations_of_picture;
    } catch (const expr::GraphTooLarge&) {
        return true;  // It did not even fit into a graph.
    }
}

}  // namespace

Result<Picture> Picture::make(Parts parts) {
    Diagnostics diagnostics;
    check_extent(parts, diagnostics);
    for (const Layer& layer : parts.layers) {
        check_layer(layer, diagnostics);
    }
    if (parts.size && ((*parts.size)[0] == 0 || (*parts.size)[1] == 0)) {
        diagnostics.push_back(error(fmt::format("picture '{}' has no pixels", parts.name), {},
                                    "write its width and height, such as 1920 x 1080"));
    } else if (parts.size) {
        parts.aspect =
            static_cast<double>((*parts.size)[0]) / static_cast<double>((*parts.size)[1]);
    }
    if (parts.aspect && !(*parts.aspect > 0.0 && std::isfinite(*parts.aspect))) {
        diagnostics.push_back(
            error(fmt::format("picture '{}' has the aspect {}, which is not a positive number",
                              parts.name, *parts.aspect),
                  {}, "write the width of the picture divided by its height, such as 16/9"));
    }
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    Picture made(std::move(parts));
    if (is_too_large(made)) {
        diagnostics.push_back(too_large("picture", made.name(), max_operations_of_picture));
        return diagnostics;
    }
    return {std::move(made), std::move(diagnostics)};
}

const Camera* Picture::only_camera() const {
    return of_layers_ ? nullptr : std::get_if<Camera>(&parts_->layers.front().content);
}

Picture::Picture(Camera camera) : of_layers_(false) {
    Parts parts;
    parts.name = camera.name();
    parts.aspect = camera.parts().aspect;
    parts.sides = camera.parts().sides;
    Layer layer{camera.name(), std::move(camera)};
    parts.layers.push_back(std::move(layer));
    parts_ = std::make_shared<const Parts>(std::move(parts));
}

std::optional<std::array<double, 2>> Picture::sides() const {
    const Layer& back = parts_->layers.front();
    const bool is_whole = back.arrangers.empty() && back.inner_arrangers.empty() && !back.show;
    return parts_->sides                 ? parts_->sides
           : !parts_->aspect && is_whole ? sides_of(back)
                                         : std::nullopt;
}

std::optional<double> Picture::fixed_aspect() const {
    const Camera* camera = only_camera();
    return camera != nullptr ? camera->fixed_aspect() : parts_->aspect;
}

Picture Picture::with_fit(Fit fit) const {
    Parts parts = *parts_;
    parts.fit = fit;
    if (!of_layers_) {
        parts.layers.front().fit = fit;
    }
    Picture made(std::move(parts));
    made.of_layers_ = of_layers_;
    return made;
}

Picture Picture::with_size(const std::array<std::size_t, 2>& size) const {
    Parts parts = *parts_;
    parts.size = size;
    Picture made(std::move(parts));
    made.of_layers_ = of_layers_;
    return made;
}

Picture Picture::with_turn(const Turn& turn) const {
    TurnedCameras cameras;
    return with_turn(turn, cameras);
}

// Layers that share a camera still do afterwards.
Picture Picture::with_turn(const Turn& turn, TurnedCameras& cameras) const {
    Parts parts = *parts_;
    for (Layer& layer : parts.layers) {
        if (const Picture* const inner = nested(layer)) {
            layer.content = std::make_shared<const Picture>(inner->with_turn(turn, cameras));
            continue;
        }
        const auto own = std::get<Camera>(layer.content);
        const auto known = cameras.find(&own.parts());
        const Camera turned = known != cameras.end() ? known->second : own.with_turn(turn);
        cameras.try_emplace(&own.parts(), turned);
        layer.content = turned;
    }
    Picture made(std::move(parts));
    made.of_layers_ = of_layers_;
    return made;
}

PictureExpressions Picture::emit(Graph& graph, double width, double height) const {
    return {PictureEmitter(graph, PictureEmitter::Contents::emitted)
                .fitted_elements(*this, whole_picture(graph, width, height))};
}

}  // namespace balcony::camera
