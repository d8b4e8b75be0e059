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
#include "camera/pictures/picture_checks.hpp"
#include "camera/pictures/strokes.hpp"

namespace balcony::camera {

namespace {

using Element = PictureExpressions::Element;

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
                                  const std::string& path, const ObjectFilter& objects) {
        std::vector<Element> made;
        const Picture::Parts& parts = picture.parts();
        const Around around{point, path, objects};
        for (std::size_t i = 0; i < parts.layers.size();) {
            const std::size_t first = i++;
            const auto goes_on_by = [&](Compositing compositing) {
                return i < parts.layers.size() && parts.layers[i].compositing == compositing;
            };
            if (parts.layers[first].compositing == Compositing::weight) {
                for (; goes_on_by(Compositing::weight); ++i) {
                }
                add_by_weight(parts, first, i, around, made);
                continue;
            }
            for (; goes_on_by(Compositing::depth); ++i) {
            }
            if (i - first == 1) {
                add(parts, first, around, made);
            } else {
                add_by_depth(parts, first, i, around, made);
            }
        }
        return made;
    }

    // The whole picture, fitted into a picture of another aspect. Nothing is outside of it.
    std::vector<Element> fitted_elements(const Picture& picture, const PicturePoint& whole) {
        Emitter emit(graph_);
        const PictureArrangerPointer fitted = fitting_of(picture);
        const PicturePoint own = fitted ? fitted->arrange(whole, emit) : whole;
        std::vector<Element> made = elements(picture, own, "", {});
        if (!are_same(own, whole)) {
            for (Element& element : made) {
                element.coverage = select(inside(own), element.coverage, emit(0.0));
            }
        }
        return made;
    }

private:
    /// What is around the layers of a picture.
    struct Around {
        const PicturePoint& whole;
        const std::string& path;
        const ObjectFilter& objects;
    };

    // Lines of layers that are composited by depth are drawn behind and in front of all of these.
    void add_by_depth(const Picture::Parts& parts, std::size_t first, std::size_t last,
                      const Around& around, std::vector<Element>& made) {
        Element all;
        all.coverage = graph_.constant(1.0);
        all.blend = parts.layers[first].blend;
        all.compositing = Compositing::depth;
        std::vector<Element> in_front;
        for (std::size_t i = first; i < last; ++i) {
            std::vector<Element> one;
            add(parts, i, around, one);
            const auto content =
                std::find_if(one.begin(), one.end(), [](const Element& e) { return !e.paint; });
            made.insert(made.end(), one.begin(), content);
            in_front.insert(in_front.end(), std::next(content), one.end());
            all.group.push_back(std::move(*content));
            all.group.back().blend = BlendMode::normal;
        }
        made.push_back(std::move(all));
        made.insert(made.end(), in_front.begin(), in_front.end());
    }

    // Over those behind it, each covers its part of the sum of the weights so far, so that in the
    // end each has its part of the sum of all.
    void add_by_weight(const Picture::Parts& parts, std::size_t first, std::size_t last,
                       const Around& around, std::vector<Element>& made) {
        const auto& [point, size] = around.whole;
        const Expr zero = graph_.constant(0.0);
        Expr sum = zero;
        for (std::size_t i = first; i < last; ++i) {
            const Expr given =
                parts.layers[i]
                    .weight->emit(graph_, std::array{point.x / size.width, point.y / size.height})
                    .front();
            const Expr weight = select(is_finite(given), max(given, zero), zero);
            sum = sum + weight;
            const std::size_t begin = made.size();
            add(parts, i, around, made);
            const auto content =
                std::find_if(made.begin() + static_cast<std::ptrdiff_t>(begin), made.end(),
                             [](const Element& e) { return !e.paint; });
            content->coverage = content->coverage * select(0.0 < sum, weight / sum, zero);
        }
    }

    void add(const Picture::Parts& parts, std::size_t index, const Around& around,
             std::vector<Element>& made) {
        const auto& [whole, path, objects] = around;
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
        content.objects = objects;
        content.objects.insert(content.objects.end(), layer.objects.begin(), layer.objects.end());
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
            content.group = elements(*inner, own, content.name, content.objects);
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
    Diagnostics diagnostics = check_layers(parts);
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

// Layers that share a camera still do afterwards.
template <class Move>
Picture Picture::moved(const Move& move, MovedCameras& cameras) const {
    Parts parts = *parts_;
    for (Layer& layer : parts.layers) {
        if (const Picture* const inner = nested(layer)) {
            layer.content = std::make_shared<const Picture>(inner->moved(move, cameras));
            continue;
        }
        const auto own = std::get<Camera>(layer.content);
        const auto known = cameras.find(&own.parts());
        const Camera made = known != cameras.end() ? known->second : move(own);
        cameras.try_emplace(&own.parts(), made);
        layer.content = made;
    }
    Picture made(std::move(parts));
    made.of_layers_ = of_layers_;
    return made;
}

Picture Picture::with_pose(const Pose& pose) const {
    MovedCameras cameras;
    return moved([&](const Camera& camera) { return camera.with_pose(pose); }, cameras);
}

Picture Picture::with_turn(const Turn& turn) const {
    MovedCameras cameras;
    return moved([&](const Camera& camera) { return camera.with_turn(turn); }, cameras);
}

PictureExpressions Picture::emit(Graph& graph, double width, double height) const {
    return {PictureEmitter(graph, PictureEmitter::Contents::emitted)
                .fitted_elements(*this, whole_picture(graph, width, height))};
}

}  // namespace balcony::camera
