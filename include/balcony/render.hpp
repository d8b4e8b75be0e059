// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Render: traces the rays of a picture's cameras through a scene onto a film. docs/rendering.md
// says how.
//
//     Renderer::make(scene) ─┐
//     make_film(layout) ─────┴▶ Job::make(renderer, picture, settings, film) ─▶ job.run()
//                                                               write(film, file) ◀─┘
//
// A camera is a picture of one layer. The same scene, picture and settings give the same film bit
// for bit, whatever the number of threads, the regions that the picture is divided into, and where
// a job stops and another goes on.

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
#include "balcony/film.hpp"
#include "balcony/picture.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

// ---------------------------------------------------------------------------------- settings

/// A way to find the light that comes along a ray.
struct IntegratorInfo {
    std::string_view name;     ///< As users write it.
    std::string_view meaning;  ///< A phrase for lists.
};

/// All there are.
[[nodiscard]] std::span<const IntegratorInfo> integrators();

struct Settings {
    std::size_t samples = 16;  ///< Rays a pixel: the number of passes.
    std::string integrator = "direct";
    std::size_t threads = 0;              ///< 0 is all of the machine's.
    double time = 0.0;                    ///< The t of the camera's formulas.
    Color3f ambient{0.1F, 0.1F, 0.1F};    ///< Radiance that comes from everywhere, unshadowed.
    std::optional<Color3f> background{};  ///< Radiance behind the scene; none is transparent.
    std::size_t mirror_depth = 8;         ///< Reflections after which a path ends.
};

// ---------------------------------------------------------------------------------- renderer

/// A scene made ready to trace. Immutable; any number of jobs may use one at once.
class Renderer {
public:
    struct Preparation {
        double build_seconds = 0.0;  ///< Of the acceleration structure.
        double texture_seconds = 0.0;
    };

    /// Builds the acceleration structure and opens the textures. A texture that cannot be read is
    /// a warning, and its material's factor stands alone; so is an object that lies where floats
    /// cannot trace it, which is left out. A scene whose indices lead nowhere is an error.
    [[nodiscard]] static Result<Renderer> make(std::shared_ptr<const scene::Scene> scene);

    [[nodiscard]] const Preparation& preparation() const;

private:
    friend class Job;
    struct State;
    explicit Renderer(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

// --------------------------------------------------------------------------------------- jobs

/// How far a run has come.
struct Progress {
    std::size_t pass = 0;        ///< The current one, from 0.
    std::size_t passes = 0;      ///< After which the last tile is done.
    std::size_t tiles_done = 0;  ///< Over all passes of this run.
    std::size_t tiles = 0;       ///< Over all passes of this run.
    double seconds = 0.0;        ///< Since the first tile began.
};

/// Called after each tile by the thread that did it, one call at a time; must be quick and must
/// not throw.
using ProgressCallback = std::function<void(const Progress&)>;

/// What a run did.
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
    std::uint64_t invalid_pixels = 0;  ///< Pixel centres where nothing is drawn, seen by pass 0.
    std::uint64_t repaired = 0;        ///< Samples whose radiance was no finite number, set to 0.
    std::size_t passes = 0;            ///< Those that all tiles of the film have by now.
    bool interrupted = false;          ///< Stopped before every tile had its passes.
    double seconds = 0.0;              ///< Tracing, by the clock.
    double compile_seconds = 0.0;      ///< The picture, from parts to programs, when the job began.
    double camera_share = 0.0;  ///< Of the threads' time, the part before a tile's rays are traced.
};

/// Adds passes to a film. The film belongs to the caller, who may read it and write it to files
/// between runs, but not during one; it must outlive the job and stay where it is.
///
/// A job has no state besides the film: one that goes on with a film where another stopped adds the
/// passes that are missing, tile by tile.
class Job {
public:
    /// Compiles the picture for the film's size and writes the names of objects and layers into the
    /// film. Settings out of range, an unknown integrator, or a film whose vectors do not have its
    /// size are errors.
    [[nodiscard]] static Result<Job> make(const Renderer& renderer, const camera::Picture& picture,
                                          const Settings& settings, Film& film);

    /// Runs until each tile of the film has all passes of the settings. A tile that is behind the
    /// others catches up first. When stop is asked for, the tiles under way are finished and the
    /// film holds what is done. Textures that fail while they are read are warnings, each once.
    Result<Summary> run(const ProgressCallback& progress = {}, std::stop_token stop = {});

    /// The same until each tile has as many passes as asked for, by tile index: all the same for
    /// progressive display, more where there is more noise for adaptive sampling.
    Result<Summary> run(std::span<const std::uint32_t> passes,
                        const ProgressCallback& progress = {}, std::stop_token stop = {});

private:
    struct State;
    explicit Job(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

/// One job and its one run: all passes of a picture onto a film.
[[nodiscard]] Result<Summary> render(const Renderer& renderer, const camera::Picture& picture,
                                     const Settings& settings, Film& film,
                                     const ProgressCallback& progress = {},
                                     std::stop_token stop = {});

}  // namespace balcony::render
