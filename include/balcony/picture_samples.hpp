// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Picture samples: a picture for a renderer outside of Balcony. They give the rays of each camera
// layer, pass by pass, and compose what the renderer has seen along them onto a film, with all
// clips, blend modes, frames and lines of the picture.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"
#include "balcony/picture.hpp"
#include "balcony/rays.hpp"

namespace balcony::render {

/// Where the samples are.
struct SampleSettings {
    std::size_t width = 1280;  ///< Of the picture, in pixels: 1 to 2^20.
    std::size_t height = 720;
    std::string filter = "box";  ///< The name of a pixel filter, as SamplingSettings::filter.
    std::uint32_t seed = 0;      ///< Of the points of a lens.
    double time = 0.0;           ///< Seconds: the value of t in the camera's formulas.
    Axes axes = Axes::y_up;      ///< The axes of the rays.
};

/// What one camera layer shows in one pass.
struct LayerColors {
    /// Linear light, premultiplied by alpha, row by row.
    std::vector<Color4f> light;
    /// 1 where there is a ray. The light elsewhere does not count.
    std::vector<std::uint8_t> seen;
};

/// Belongs to one thread.
class PictureSamples {
public:
    /// A lens that focuses on an object of a scene is an error, because there is no scene.
    [[nodiscard]] static Result<PictureSamples> make(const camera::Picture& picture,
                                                     const SampleSettings& settings);
    PictureSamples(PictureSamples&&) noexcept;
    PictureSamples& operator=(PictureSamples&&) noexcept;
    ~PictureSamples();

    [[nodiscard]] std::size_t layer_count() const;
    [[nodiscard]] std::string_view layer_name(std::size_t layer) const;
    /// Whether each sample of the layer takes another point of a lens. Otherwise its rays are a
    /// function of the picture point.
    [[nodiscard]] bool has_lens(std::size_t layer) const;
    /// Whether the rays of the layer meet the scene at times of their own.
    [[nodiscard]] bool has_times(std::size_t layer) const;

    /// The places of the samples of a pass in a region, one in each pixel: those of the renderer
    /// with the same filter.
    [[nodiscard]] rays::Tile places(std::size_t pass, const Region& region) const;
    /// The rays of these samples, with footprints, row by row. wanted[i] is 1 if there is a ray
    /// and the layer covers a part of the point.
    void find_rays(std::size_t layer, std::size_t pass, const Region& region, rays::RayBatch& rays,
                   std::vector<std::uint8_t>& wanted);
    /// The rays at other points, through the middle of the lens.
    void find_rays(std::size_t layer, const rays::Tile& points, rays::RayBatch& rays);

    /// Gives the film what it needs for the picture: the names of the layers, and display colours
    /// if there are frames or lines. The film covers the whole picture.
    void prepare(Film& film) const;
    /// Composes what all layers show in a pass and adds it to the film as its next pass.
    void add_pass(std::size_t pass, std::span<const LayerColors> layers, Film& film);

private:
    struct State;
    explicit PictureSamples(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::render
