// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Render: traces the rays of a picture's cameras through a scene onto a film. docs/rendering.md
// describes the method.
//
//     Renderer::make(scene) ─┐
//     make_film(layout) ─────┴▶ Job::make(renderer, picture, settings, film) ─▶ job.run()
//                                                               write(film, file) ◀─┘
//
// A camera is a picture of one layer. The same scene, picture and settings give the same film bit
// for bit, for any number of threads, any division of the picture into regions, and any point at
// which a job stops and another continues.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/environment.hpp"
#include "balcony/film.hpp"
#include "balcony/image_points.hpp"
#include "balcony/integrators.hpp"
#include "balcony/picture.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"
#include "balcony/shutter.hpp"

namespace balcony::render {

// ---------------------------------------------------------------------------------- settings

/// The weight of samples around a pixel's centre.
struct PixelFilterInfo {
    std::string_view name;     ///< The name for users.
    std::string_view meaning;  ///< A short description.
};

/// All pixel filters.
[[nodiscard]] std::span<const PixelFilterInfo> pixel_filters();

/// Where samples are, and their random numbers.
struct SamplingSettings {
    std::uint32_t seed = 0;  ///< Another seed gives another noise.
    /// The name of a pixel filter. Samples are distributed by it and all have the same weight.
    std::string filter = "blackman-harris";
    /// Adaptive sampling: the tolerated standard error of a pixel, relative to the root of its
    /// radiance times that of white; Settings::samples is the maximum. 0.01 is hardly visible; 0 is
    /// the same number of samples for all pixels.
    double noise = 0.0;
    std::uint32_t min_samples = 16;  ///< Of adaptive sampling; the next power of two applies.
    /// The radiance shown as white, above 0; by default, it makes the median middle grey.
    std::optional<double> white{};
};

/// What lights a scene that has no light of its own, or only suns.
enum class SubstituteLight : std::uint8_t {
    sky,
    eye,   ///< A light at the eye.
    none,  ///< Nothing beside the suns.
};

/// Light that is not part of the scene, for `path`.
struct LightSettings {
    /// If empty, a scene without any light gets a substitute.
    std::optional<Environment> environment{};
    /// If empty, it is a sky beside suns or where the picture shows surfaces that could see it, and
    /// otherwise a light at the eye. A light at the eye that is asked for takes the place of the
    /// scene's lights, too.
    std::optional<SubstituteLight> substitute{};
    /// A scene that is lit by nothing but directional lights gets a soft sky as well, which gives a
    /// floor a fifth of the illuminance that faces the suns: about that of a clear day.
    bool sky_beside_suns = false;
    /// The environment is the background of the picture, and opaque; not if Settings::background is
    /// a colour.
    bool visible = true;
    /// The angular diameter of directional lights in radians, from 0 to pi; that of the scene's
    /// lights if empty.
    std::optional<double> sun_angle{};
};

/// The frames of an animation before and after the picture, for LayerId::motion.
struct FrameSettings {
    double duration = 1.0 / 24.0;  ///< Seconds from frame to frame, greater than 0.
    /// The inverses of the picture at the times of the previous and the next frame, in the axes of
    /// the scene. A picture that is missing shows nothing.
    std::shared_ptr<const rays::ImagePointFinder> previous{};
    std::shared_ptr<const rays::ImagePointFinder> next{};
};

struct Settings {
    std::size_t samples = 16;  ///< Rays per pixel: the number of passes.
    std::string integrator = "path";
    std::size_t threads = 0;  ///< 0 for all of the machine.
    double time = 0.0;        ///< Seconds: the value of t in the camera's formulas.
    Shutter shutter{};
    FrameSettings frames{};
    /// Values of inputs of the picture, such as open parameters (lang::OpenPicture); the others
    /// have those of Camera::Parts::inputs.
    std::vector<camera::KnownInput> inputs{};
    /// Objects, by index into Scene::objects, that camera rays pass where they meet them from
    /// behind, before anything else: those that they start in.
    std::vector<std::uint32_t> passed_objects{};
    /// Radiance from all directions, without shadows; for `path` it is a constant environment.
    /// If empty, `path` has none, and the other integrators use a tenth of the median brightness of
    /// the places that a coarse grid of the picture's rays meets. The brightness of a place is the
    /// radiance of a white surface there that faces the lights, plus what the place emits. Dark
    /// places do not count; if all are dark, the radiance is 0.3.
    std::optional<Color3f> ambient{};
    /// The colour behind the picture, as the display shows it: neither exposed nor part of the
    /// film's light. Linear, from 0 to 1; transparent if empty.
    std::optional<Color3f> background{};
    LightSettings light{};
    SamplingSettings sampling{};
    PathSettings path{};
    DirectSettings direct{};
};

// ---------------------------------------------------------------------------------- renderer

/// The default limit for the texels of all textures, in bytes, and the least that makes sense.
inline constexpr std::size_t default_texture_memory = std::size_t{1} << 30;
inline constexpr std::size_t min_texture_memory = std::size_t{1} << 26;

struct RendererSettings {
    /// If all textures fit, they are held in memory; otherwise, the smaller ones are, and the
    /// others are in a temporary file, whose parts in use are in memory.
    std::size_t texture_memory = default_texture_memory;
    /// Decodes each texture when a ray first needs it, for jobs of few rays; otherwise all textures
    /// that fit, and all that a picture shows, before the first ray, on all threads.
    bool textures_on_demand = false;
    /// When rays meet the scene, such as the exposure of a shutter; otherwise as it stands. Its
    /// times are finite, and the first one is not later.
    std::optional<scene::TimeInterval> interval{};
};

/// A scene prepared for tracing. Immutable; any number of jobs may use it at the same time.
class Renderer {
public:
    struct Preparation {
        double build_seconds = 0.0;  ///< Build time of the acceleration structure.
        double texture_seconds = 0.0;
        std::size_t texture_bytes = 0;  ///< Of the textures that are held in memory.
    };

    /// Builds the acceleration structure and opens the textures. A texture that cannot be read is
    /// a warning, and its material uses the constant factor. An object beyond the range that
    /// floats can trace is skipped with a warning. A scene with invalid indices is an error.
    ///
    /// A scene is traced as it stands at its time. With an interval of time, what moves during the
    /// interval is where it stands at the time of each ray: before the interval as at its
    /// beginning, after it as at its end. No scene is an error of Kind::internal, an interval out
    /// of order one of Kind::usage.
    ///
    /// A stop is an error of Kind::interrupted. Progress may be reported by any thread.
    [[nodiscard]] static Result<Renderer> make(std::shared_ptr<const scene::Scene> scene,
                                               const RendererSettings& settings = {},
                                               const PartDone& progress = {},
                                               const std::stop_token& stop = {});

    /// The scene at other times, as scene::moved_to() gives it, or edited, also with other parts.
    /// Shares textures and meshes that are the same; other textures are an error of Kind::usage.
    [[nodiscard]] Result<Renderer> moved(std::shared_ptr<const scene::Scene> scene,
                                         const scene::TimeInterval& interval,
                                         const PartDone& progress = {},
                                         const std::stop_token& stop = {}) const;

    [[nodiscard]] const Preparation& preparation() const;

    struct State;
    /// For the functions of this layer.
    [[nodiscard]] const State& state() const { return *state_; }

private:
    friend class Job;
    explicit Renderer(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

// --------------------------------------------------------------------------------------- jobs

/// The progress of a run.
struct Progress {
    std::size_t pass = 0;        ///< The current one, from 0.
    std::size_t passes = 0;      ///< The number of passes of the last tile.
    std::size_t tiles_done = 0;  ///< Over all passes of this run.
    std::size_t tiles = 0;       ///< Over all passes of this run.
    Region region{};             ///< The part of the film's window that the last tile changed.
    double seconds = 0.0;        ///< Since the first tile began.
};

/// Called after each tile, one call at a time, by one of the threads that render and without a
/// lock; the others go on meanwhile. Must not throw.
using ProgressCallback = std::function<void(const Progress&)>;

/// What the rays of a camera layer found.
struct RayCounts {
    std::uint64_t camera_rays = 0;   ///< Visible points of the layer, with a ray or not.
    std::uint64_t invalid_rays = 0;  ///< Of these, points where the camera has no ray.
    std::uint64_t blocked_rays = 0;  ///< Not of those: points where a lens lets no light through.
    std::uint64_t hits = 0;          ///< Rays that meet a surface.
    double light = 0.0;              ///< The sum of their luminances.
    double softened_light = 0.0;     ///< Of that, what PathSettings::exact would show sharp.
    double light_left_out = 0.0;     ///< Not of that: what limits of indirect light have cost.
    double emitted_light = 0.0;      ///< Of the light, what comes from its source directly.
    /// The throughputs of paths that end at a surface by BounceLimits.
    double bounces_cut = 0.0;

    void add(const RayCounts& other) {
        camera_rays += other.camera_rays;
        invalid_rays += other.invalid_rays;
        blocked_rays += other.blocked_rays;
        hits += other.hits;
        light += other.light;
        softened_light += other.softened_light;
        light_left_out += other.light_left_out;
        emitted_light += other.emitted_light;
        bounces_cut += other.bounces_cut;
    }
    /// Points with a ray that is traced.
    [[nodiscard]] std::uint64_t traced_rays() const {
        return camera_rays - invalid_rays - blocked_rays;
    }
    /// The part of the light that mirrors and glass have softened.
    [[nodiscard]] double softened_share() const {
        return light > 0.0 ? softened_light / light : 0.0;
    }
    /// The part of all light that was found that limits have left out.
    [[nodiscard]] double share_left_out() const {
        return light_left_out > 0.0 ? light_left_out / (light + light_left_out) : 0.0;
    }
    /// An estimate of the part of all light that BounceLimits cut off. Where a limit ends a path, a
    /// surface is taken to reflect as much as those that the camera sees do on average, what is cut
    /// off included: they reflect r = found / hits + r cut / hits.
    [[nodiscard]] double share_cut_off() const {
        const double part = hits > 0 ? std::min(bounces_cut / static_cast<double>(hits), 1.0) : 0.0;
        const double lost = part * (light - emitted_light);
        return lost > 0.0 ? lost / ((1.0 - part) * light + lost) : 0.0;
    }
};

/// The results of a run.
struct Summary {
    /// A camera layer of the picture.
    struct Layer : RayCounts {
        std::string name;  ///< Prefixed by the names of the enclosing pictures.
    };

    std::uint64_t camera_rays = 0;     ///< Visible points of layers, with a ray or not.
    std::uint64_t invalid_rays = 0;    ///< Of these, points where the camera has no ray.
    std::vector<Layer> layers;         ///< The same per layer, from back to front.
    std::uint64_t invalid_pixels = 0;  ///< Pixel centres where nothing is drawn, counted in pass 0.
    std::uint64_t repaired = 0;        ///< Samples whose radiance was not finite, replaced by 0.
    /// Pixels that show a surface which neither the previous nor the next frame shows; their motion
    /// is 0. If one of the frames shows it, the other one continues its motion.
    std::uint64_t unknown_motion = 0;
    /// Pixels that show a surface which one of the frames shows at several places, of which the
    /// nearest counts.
    std::uint64_t ambiguous_motion = 0;
    std::string light;  ///< What lights the scene of `path`: "2 lamps, ...".
    /// Of `path`, if the scene has no light, or only suns and LightSettings::sky_beside_suns.
    std::optional<SubstituteLight> substitute{};
    Color3f ambient{0.0F};         ///< The ambient radiance, from the settings or chosen.
    std::size_t passes = 0;        ///< The number of passes that all tiles of the film have.
    bool interrupted = false;      ///< Stopped before all tiles had all passes.
    double seconds = 0.0;          ///< Elapsed time of tracing.
    double compile_seconds = 0.0;  ///< Time to compile the picture when the job was made.
    double camera_share =
        0.0;  ///< Fraction of the threads' time spent before a tile's rays are traced.
};

/// Adds passes to a film, which it shares with its caller. Between runs, but not during one, the
/// film may be read, written to files and changed.
///
/// A job has no state besides the film: a job that continues the film of another one adds the
/// missing passes, tile by tile.
class Job {
public:
    /// Compiles the picture for the film's size and writes the names of objects and layers, the
    /// background and the ambient light into the film, to which it adds the sums that the picture
    /// needs. Settings out of range and an unknown integrator are errors; no film and one whose
    /// vectors do not have its size are errors of Kind::internal, a stop is one of
    /// Kind::interrupted.
    [[nodiscard]] static Result<Job> make(const Renderer& renderer, const camera::Picture& picture,
                                          const Settings& settings, std::shared_ptr<Film> film,
                                          const std::stop_token& stop = {});

    /// The same picture with other settings, such as another time, on another film. A film of the
    /// same size takes over the compiled picture. A renderer of another scene is an error of
    /// Kind::usage.
    [[nodiscard]] Result<Job> again(const Renderer& renderer, const Settings& settings,
                                    std::shared_ptr<Film> film,
                                    const std::stop_token& stop = {}) const;

    /// Never null.
    [[nodiscard]] const std::shared_ptr<Film>& film() const;

    /// Moves the picture: other values for some of its inputs, on the same film, which becomes
    /// empty; not during a run. Compiles nothing, and the light stays as it was chosen, so the
    /// first ray is traced at once. Only the distances of objects in focus are measured anew. An
    /// unknown input is an error and leaves the job as it was.
    [[nodiscard]] Diagnostics set_inputs(std::span<const camera::KnownInput> inputs);

    /// What lights the picture, as Summary::light.
    [[nodiscard]] const std::string& light() const;
    /// What lights it in place of the scene's own lights or beside suns, as Summary::substitute.
    [[nodiscard]] std::optional<SubstituteLight> substitute() const;

    /// Runs until each tile of the film has all passes of the settings. A tile that is behind the
    /// others catches up first. When a stop is requested, tiles in progress are completed and the
    /// film contains what is done. Textures that fail while they are read are warnings, each once.
    Result<Summary> run(const ProgressCallback& progress = {}, std::stop_token stop = {});

    /// The same until each tile has the requested number of passes, by tile index: equal numbers
    /// for progressive display, larger numbers in noisy tiles for adaptive sampling. Another number
    /// of tiles is an error of Kind::internal.
    Result<Summary> run(std::span<const std::uint32_t> passes,
                        const ProgressCallback& progress = {}, std::stop_token stop = {});

private:
    struct State;
    explicit Job(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    [[nodiscard]] static Result<Job> make(const Renderer& renderer, const camera::Picture& picture,
                                          const Settings& settings, std::shared_ptr<Film> film,
                                          const State* previous, const std::stop_token& stop);
    std::shared_ptr<const State> state_;
};

/// Makes a job and runs it: all passes of a picture onto a film.
[[nodiscard]] Result<Summary> render(const Renderer& renderer, const camera::Picture& picture,
                                     const Settings& settings, Film& film,
                                     const ProgressCallback& progress = {},
                                     std::stop_token stop = {});

}  // namespace balcony::render
