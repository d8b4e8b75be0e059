// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

#include "rays/results.hpp"

namespace balcony::rays {

class PictureCompiler {
public:
    using Expressions = std::vector<camera::PictureExpressions::Element>;

    explicit PictureCompiler(const CompileOptions& options) : options_(options) {}

    Result<CompiledPicture> run(const Expressions& all) {
        made_.elements_ = elements(all);
        if (!roots_.empty()) {
            made_.coverages_ = take(
                program::Program::make(roots_, {program::Sampling::grid, options_.inputs}), found_);
        }
        if (has_errors(found_)) {
            return found_;
        }
        return {std::move(made_), std::move(found_)};
    }

private:
    std::vector<CompiledPicture::Element> elements(const Expressions& all) {
        std::vector<CompiledPicture::Element> made;
        made.reserve(all.size());
        for (const camera::PictureExpressions::Element& one : all) {
            made.push_back(element(one));
        }
        return made;
    }

    CompiledPicture::Element element(const camera::PictureExpressions::Element& one) {
        CompiledPicture::Element made;
        made.channels = one.channels;
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
            made.layer = made_.layers_.size();
            if (auto rays = take(RayProgram::make(*one.ray, one.axes, options_), found_)) {
                made_.layers_.push_back(
                    {one.name, options_.axes.value_or(one.axes), std::move(*rays), one.objects});
            }
        }
        made.group = elements(one.group);
        made.compositing = one.compositing;
        return made;
    }

    const CompileOptions& options_;
    CompiledPicture made_;
    std::vector<expr::Expr> roots_;
    Diagnostics found_;
};

std::size_t CompiledPicture::coverage_count() const {
    return coverages_ ? coverages_->root_count() : 0;
}

void CompiledPicture::run_coverages(const Tile& tile, Scratch& scratch,
                                    std::span<double* const> results) const {
    if (coverages_) {
        program::run(*coverages_, tile, scratch, results);
    }
}

Result<CompiledPicture> compile(const camera::Picture& picture, double width, double height,
                                const CompileOptions& options, const std::stop_token& stop) {
    return within_limits<CompiledPicture>(
        "picture", picture.name(), {width, height}, stop, [&](auto& graph) {
            return PictureCompiler(options).run(picture.emit(graph, width, height).elements);
        });
}

}  // namespace balcony::rays
