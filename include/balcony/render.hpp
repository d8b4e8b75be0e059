// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Render: traces the rays of a picture's cameras through a scene onto a film. docs/rendering.md
// says how.
//
//     Renderer::make(scene) ─▶ renderer.render(picture, settings) ─▶ film ─▶ write(film, file)
//
// A camera is a picture of one layer. The same scene, picture and settings give the same film bit
// for bit, whatever the number of threads.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/picture.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::Color4f;
using Imath::V2f;
using Imath::V3f;

// ---------------------------------------------------------------------------------- settings

enum class Integrator : std::uint8_t {
    preview,  ///< Base colour lit from where the ray comes; no lights, no shadows.
    direct,   ///< The scene's lights with sharp shadows, mirrors, transparency.
};

/// Their names as users write them.
[[nodiscard]] std::string_view name_of(Integrator integrator);
[[nodiscard]] std::optional<Integrator> find_integrator(std::string_view name);

struct Settings {
    std::size_t width = 1280;
    std::size_t height = 720;
    std::size_t samples = 16;  ///< Rays a pixel: the number of passes.
    Integrator integrator = Integrator::direct;
    std::size_t threads = 0;              ///< 0 is all of the machine's.
    double time = 0.0;                    ///< The t of the camera's formulas.
    Color3f ambient{0.1F, 0.1F, 0.1F};    ///< Radiance that comes from everywhere, unshadowed.
    std::optional<Color3f> background{};  ///< Radiance behind the scene; none is transparent.
    std::size_t mirror_depth = 8;         ///< Reflections after which a path ends.
    bool data_layers = true;              ///< Fill Film::layers, at 79 bytes a pixel.
};

// -------------------------------------------------------------------------------------- film

/// What is known of each pixel's centre, unfiltered, row by row from the top left. Where several
/// layers of a picture show, the front one counts that covers at least half of the point. World
/// co-ordinates are the scene's, also where the camera has other axes. Unless said otherwise a
/// value is 0 where there is no ray or nothing was hit.
struct DataLayers {
    std::vector<float> ray_length;      ///< From origin to hit; infinite where nothing was hit.
    std::vector<V3f> position;          ///< Of the hit.
    std::vector<V3f> normal;            ///< Unit shading normal at the hit, towards the ray's side.
    std::vector<Color3f> albedo;        ///< Base colour at the hit.
    std::vector<std::uint32_t> object;  ///< Index into Film::objects plus 1.
    std::vector<V3f> origin;            ///< Of the ray.
    std::vector<V3f> direction;         ///< Of the ray, unit length.
    std::vector<V2f> parameters;        ///< (u, v) of the eye object.
    std::vector<std::uint8_t> valid;    ///< 1 where there is a ray.
    std::vector<std::uint16_t> layer;   ///< Index into Film::picture_layers plus 1.
};

/// A picture in the making: sums over passes, row by row from the top left.
struct Film {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Color4f> sum;            ///< Linear radiance, alpha; colour is premultiplied.
    std::vector<std::uint32_t> samples;  ///< How many are in the sum; 0 where none was yet.
    std::optional<DataLayers> layers;
    std::vector<std::string> objects;         ///< Names, by object id less 1.
    std::vector<std::string> picture_layers;  ///< Names of the picture's camera layers.

    /// The mean of the samples, premultiplied by alpha; nothing where there are none.
    [[nodiscard]] Color4f pixel(std::size_t x, std::size_t y) const;
};

// ---------------------------------------------------------------------------------- renderer

/// How far a render has come.
struct Progress {
    std::size_t pass = 0;  ///< The current one, from 0.
    std::size_t passes = 0;
    std::size_t tiles_done = 0;  ///< Over all passes.
    std::size_t tiles = 0;       ///< Over all passes.
    double seconds = 0.0;        ///< Since the first tile began.
};

/// Called after each tile by the thread that did it, one call at a time; must be quick and must
/// not throw.
using ProgressCallback = std::function<void(const Progress&)>;

struct Summary {
    /// A camera layer of the picture.
    struct Layer {
        std::string name;  ///< Behind the names of the pictures that it is in.
        std::uint64_t camera_rays = 0;
        std::uint64_t invalid_rays = 0;
    };

    std::uint64_t camera_rays = 0;     ///< Points of layers that show, with a ray or not.
    std::uint64_t invalid_rays = 0;    ///< Of these, points where the camera has no ray.
    std::vector<Layer> layers;         ///< The same for each, the back one first.
    std::uint64_t invalid_pixels = 0;  ///< Pixel centres where nothing is drawn.
    std::uint64_t repaired = 0;        ///< Samples whose radiance was no finite number, set to 0.
    std::size_t passes = 0;            ///< Those complete.
    bool interrupted = false;          ///< Stopped before the last pass was complete.
    double seconds = 0.0;              ///< Tracing, by the clock.
    double compile_seconds = 0.0;      ///< The picture, from parts to programs.
    double camera_share = 0.0;  ///< Of the threads' time, the part before a tile's rays are traced.
};

struct Picture {
    Film film;
    Summary summary;
};

/// A scene made ready to trace. Immutable; several renders may use one.
class Renderer {
public:
    struct Preparation {
        double build_seconds = 0.0;  ///< Of the acceleration structure.
        double texture_seconds = 0.0;
    };

    /// Builds the acceleration structure and opens the textures. A texture that cannot be read is
    /// a warning; its material's factor stands alone.
    [[nodiscard]] static Result<Renderer> make(std::shared_ptr<const scene::Scene> scene);

    [[nodiscard]] const Preparation& preparation() const;

    /// Renders. When stop is asked for, the tiles under way are finished and the film holds what is
    /// done, each pixel with its own number of samples. Settings out of range, or a film that would
    /// not fit into memory, are errors; textures that fail while they are read are warnings.
    [[nodiscard]] Result<Picture> render(const camera::Picture& picture, const Settings& settings,
                                         const ProgressCallback& progress = {},
                                         std::stop_token stop = {}) const;

private:
    struct State;
    explicit Renderer(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

// -------------------------------------------------------------------------------------- files

/// All of these write beside the file and then rename, so the file is whole or untouched; what
/// goes wrong is an error. Values that are no number are written as 0.

struct PngOptions {
    double exposure = 0.0;  ///< Stops: colour is multiplied by 2^exposure.
    int bits = 8;           ///< A channel: 8 or 16.
};

/// The exposure, in half stops, that suits a film whose light is far from the range of a screen, as
/// scenes with physical units have it: 0 if the median luminance of what is not transparent is
/// between nearly black (0.004) and a stop above white (2), else what brings it to middle grey
/// (0.18).
[[nodiscard]] double automatic_exposure(const Film& film);

/// sRGB with alpha (not premultiplied); brighter than white is white.
[[nodiscard]] Diagnostics write_png(const Film& film, const std::filesystem::path& file,
                                    const PngOptions& options = {});

/// Linear floats, every layer in one part, names as in docs/rendering.md.
[[nodiscard]] Diagnostics write_exr(const Film& film, const std::filesystem::path& file);

/// By the file's ending, .png or .exr; the options hold for PNG.
[[nodiscard]] Diagnostics write(const Film& film, const std::filesystem::path& file,
                                const PngOptions& options = {});

/// What write() would refuse, known before anything is rendered: an unknown ending, a folder that
/// is not there or cannot be written to.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& file);

}  // namespace balcony::render
