// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/picture_samples.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "render/job/pass_grid.hpp"
#include "render/job/picture_rays.hpp"
#include "render/job/point_blender.hpp"
#include "render/sampling/pass_offset.hpp"

namespace balcony::render {

namespace {

using Element = rays::CompiledPicture::Element;

/// The lenses of a picture whose distances of focus are numbers.
Result<LensFocus> focus_without_scene(const camera::Picture& picture) {
    LensFocus focus;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        const camera::LensPointer& lens = shown.camera.parts().lens;
        focus.any_lens = focus.any_lens || lens;
        if (const auto object = lens ? lens->focus().object() : std::nullopt) {
            return error(fmt::format("the lens is focused on the object '{}', but another renderer "
                                     "does not tell where its objects are",
                                     printable(*object)),
                         shown.camera.parts().lens_span, "focus it at a distance");
        }
    }
    return focus;
}

bool has_depths(const std::vector<Element>& elements) {
    return std::any_of(elements.begin(), elements.end(), [](const Element& element) {
        return element.compositing == camera::Compositing::depth || has_depths(element.group);
    });
}

// Another renderer shows the whole scene in every layer.
Diagnostics check_layers(const rays::CompiledPicture& picture) {
    constexpr std::string_view remedy = "render the picture with 'balcony render'";
    for (const rays::CompiledPicture::CameraLayer& layer : picture.layers()) {
        if (!layer.objects.empty()) {
            return {error(fmt::format("layer '{}' shows some objects of the scene, but another "
                                      "renderer does not tell which object a ray meets",
                                      printable(layer.name)),
                          layer.objects.front().patterns.front().written, std::string(remedy))};
        }
    }
    if (has_depths(picture.elements())) {
        return {
            error("layers are composited by depth, but another renderer does not tell the "
                  "depth of what it shows",
                  {}, std::string(remedy))};
    }
    return {};
}

// Marks the points where some of the layer is visible; returns whether the layer is among the
// elements.
bool mark_covered(const std::vector<Element>& elements, std::size_t layer,
                  const TileCoverages& coverages, Mask& covered) {
    for (const Element& element : elements) {
        const bool has_it =
            element.layer == layer || mark_covered(element.group, layer, coverages, covered);
        if (!has_it) {
            continue;
        }
        for (std::size_t i = 0; i < covered.size(); ++i) {
            if (coverages.coverage(element, i) <= 0.0F) {
                covered[i] = 0;
            }
        }
        return true;
    }
    return false;
}

}  // namespace

struct PictureSamples::State {
    SampleSettings settings;
    const PixelFilter* filter;
    rays::CompiledPicture picture;
    std::vector<ShownObjects> shown = std::vector<ShownObjects>(picture.layers().size());  // All.
    PictureRays rays;
    TileRays found{};  // Kept for its memory.

    State(const SampleSettings& wanted, rays::CompiledPicture compiled, PictureInputs inputs)
        : settings(wanted),
          filter(find_pixel_filter(wanted.filter)),
          picture(std::move(compiled)),
          rays(picture, shown, {}, std::move(inputs)) {}
};

PictureSamples::PictureSamples(std::unique_ptr<State> state) : state_(std::move(state)) {}
PictureSamples::PictureSamples(PictureSamples&&) noexcept = default;
PictureSamples& PictureSamples::operator=(PictureSamples&&) noexcept = default;
PictureSamples::~PictureSamples() = default;

Result<PictureSamples> PictureSamples::make(const camera::Picture& picture,
                                            const SampleSettings& settings) {
    if (find_pixel_filter(settings.filter) == nullptr) {
        return error(
            fmt::format("there is no pixel filter named '{}'", printable(settings.filter)));
    }
    Result<LensFocus> focus = focus_without_scene(picture);
    if (!focus) {
        return std::move(focus.diagnostics);
    }
    PictureInputs inputs{std::move(*focus), parameters_of(picture)};
    Result<rays::CompiledPicture> compiled = rays::compile(
        picture, static_cast<double>(settings.width), static_cast<double>(settings.height),
        {.axes = settings.axes, .footprints = true, .inputs = declared(inputs)});
    if (!compiled) {
        return std::move(compiled.diagnostics);
    }
    if (Diagnostics found = check_layers(*compiled); !found.empty()) {
        return found;
    }
    return PictureSamples(
        std::make_unique<State>(settings, std::move(*compiled), std::move(inputs)));
}

std::size_t PictureSamples::layer_count() const { return state_->picture.layers().size(); }

std::string_view PictureSamples::layer_name(std::size_t layer) const {
    return state_->picture.layers()[layer].name;
}

bool PictureSamples::has_lens(std::size_t layer) const { return state_->rays.has_lens(layer); }

bool PictureSamples::has_times(std::size_t layer) const {
    return state_->picture.layers()[layer].rays.has_times();
}

rays::Tile PictureSamples::places(std::size_t pass, const Region& region) const {
    const SampleSettings& settings = state_->settings;
    return pass_grid(region, pass_offset(*state_->filter, pass), settings.width, settings.height,
                     settings.time);
}

void PictureSamples::find_rays(std::size_t layer, std::size_t pass, const Region& region,
                               rays::RayBatch& rays, std::vector<std::uint8_t>& wanted) {
    const rays::Tile points = places(pass, region);
    wanted.assign(region.size(), 1);
    mark_covered(state_->picture.elements(), layer, state_->rays.coverages(points), wanted);
    std::swap(state_->found.all, rays);
    state_->rays.find_rays_of_pass(layer, points, region, PassNumbers(pass, state_->settings.seed),
                                   state_->found);
    std::swap(state_->found.all, rays);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!traceable(rays, i)) {
            wanted[i] = 0;
        }
    }
}

void PictureSamples::find_rays(std::size_t layer, const rays::Tile& points, rays::RayBatch& rays) {
    std::swap(state_->found.all, rays);
    state_->rays.find_rays(layer, points, state_->found);
    std::swap(state_->found.all, rays);
}

void PictureSamples::prepare(Film& film) const {
    film.picture_layers.clear();
    for (const rays::CompiledPicture::CameraLayer& layer : state_->picture.layers()) {
        film.picture_layers.push_back(layer.name);
    }
    if (film.display.empty() && paints(state_->picture.elements())) {
        film.display.assign(film.window.size(), Color4d(0.0));
    }
}

void PictureSamples::add_pass(std::size_t pass, std::span<const LayerColors> layers, Film& film) {
    std::vector<std::vector<Drawn>> drawn(layers.size());
    const std::vector<std::vector<double>> no_depths;
    for (std::size_t tile = 0; tile < film.tile_count(); ++tile) {
        TileImage image{film.tile(tile), {}};
        const Region& region = image.region;
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            drawn[layer].assign(region.size(), Drawn{});
            for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
                const std::size_t at = film.index(x, y);
                if (layers[layer].seen[at] != 0) {
                    drawn[layer][i] = {layers[layer].light[at], Color4f(0.0F), Color4f(0.0F), 1.0F};
                }
            });
        }
        const TileCoverages coverages = state_->rays.coverages(places(pass, region));
        PointBlender blend(coverages, drawn, no_depths);
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Drawn all = blend(state_->picture.elements(), i);
            image.light.push_back(all.light);
            if (!film.display.empty()) {
                image.display.push_back(all.display);
            }
        }
        render::add_pass(film, tile, image);
    }
}

}  // namespace balcony::render
