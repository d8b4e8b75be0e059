// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/compiled_picture.hpp"

#include "render/job/camera_rays.hpp"

namespace balcony::render {

namespace {

using ElementExpressions = camera::PictureExpressions::Element;

class Compiler {
public:
    Compiler(Axes scene_axes, bool footprints) : scene_axes_(scene_axes) {
        made_.footprints = footprints;
    }

    CompiledPicture run(const std::vector<ElementExpressions>& all) {
        made_.elements = elements(all);
        if (!roots_.empty()) {
            made_.coverages.emplace(roots_);
        }
        return std::move(made_);
    }

private:
    std::vector<CompiledPicture::Element> elements(const std::vector<ElementExpressions>& all) {
        std::vector<CompiledPicture::Element> made;
        made.reserve(all.size());
        for (const ElementExpressions& one : all) {
            made.push_back(element(one));
        }
        return made;
    }

    CompiledPicture::Element element(const ElementExpressions& one) {
        CompiledPicture::Element made;
        made.blend = one.blend;
        if (!one.coverage.is_constant(1.0)) {
            made.coverage = roots_.size();
            roots_.push_back(one.coverage);
        }
        if (one.paint) {
            made.paint = roots_.size();
            roots_.insert(roots_.end(), one.paint->begin(), one.paint->end());
        }
        if (one.ray) {
            made.layer = made_.layers.size();
            made_.layers.push_back(
                {one.name, compile_rays(*one.ray, one.axes, scene_axes_, made_.footprints)});
        }
        made.group = elements(one.group);
        return made;
    }

    Axes scene_axes_;
    CompiledPicture made_;
    std::vector<expr::Expr> roots_;
};

}  // namespace

CompiledPicture compile_picture(const camera::Picture& picture, Axes scene_axes, std::size_t width,
                                std::size_t height, bool footprints) {
    expr::Graph graph;
    return Compiler(scene_axes, footprints)
        .run(picture.emit(graph, static_cast<double>(width), static_cast<double>(height)).elements);
}

}  // namespace balcony::render
