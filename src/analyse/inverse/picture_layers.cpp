// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/picture_layers.hpp"

#include <algorithm>

namespace balcony::analyse {

namespace {

using Element = camera::PictureExpressions::Element;
using expr::Expr;

// Goes through elements from the front to the back and gathers what hides those behind.
class LayerFinder {
public:
    std::vector<PictureLayer> run(const std::vector<Element>& elements, expr::Graph& graph) {
        find(elements, graph.constant(0.0), graph.constant(1.0));
        std::reverse(made_.begin(), made_.end());
        return std::move(made_);
    }

private:
    // `hidden` is where elements in front hide these, `shown` where the groups round them cover
    // something. Gives back where these elements and those in front hide what is behind.
    Expr find(const std::vector<Element>& elements, Expr hidden, Expr shown) {
        for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
            const Expr present = contents(*element, hidden, shown && 0.0 < element->coverage);
            if (element->blend == camera::BlendMode::normal) {
                hidden = hidden || (present && 1.0 <= element->coverage);
            }
        }
        return hidden;
    }

    // Where there is anything that could hide: a ray, paint, or a group without a gap.
    Expr contents(const Element& element, Expr hidden, Expr shown) {
        if (!element.group.empty()) {
            return find(element.group, hidden, shown);
        }
        if (!element.ray) {
            return hidden.graph().constant(1.0);
        }
        camera::RayExpressions ray = *element.ray;
        ray.valid = ray.valid && shown;
        made_.push_back({element.name, element.axes, ray, hidden});
        return element.ray->valid;
    }

    std::vector<PictureLayer> made_;
};

}  // namespace

std::vector<PictureLayer> picture_layers(const camera::Picture& picture, expr::Graph& graph,
                                         double width, double height) {
    return LayerFinder().run(picture.emit(graph, width, height).elements, graph);
}

camera::RayExpressions turned(const camera::RayExpressions& ray, Axes from, Axes to) {
    if (from == to) {
        return ray;
    }
    const auto turn = [to](auto v) {
        v = to == Axes::y_up ? decltype(v){v.x, v.z, -v.y} : decltype(v){v.x, -v.z, v.y};
        return v;
    };
    return {turn(ray.origin), turn(ray.direction), ray.valid, ray.parameters};
}

}  // namespace balcony::analyse
