// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// App: what a program that renders does besides words.
//
//     Request ─▶ Session::render() ─▶ Report, film, file
//
// It loads the scene and the camera, fits it, finds the light and the exposure, continues from
// checkpoints, renders large pictures in bands, and writes the file. It prints nothing.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/denoise.hpp"
#include "balcony/finish.hpp"
#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// What is done before a picture is traced.
enum class Step : std::uint8_t {
    reading,   ///< The files of a scene.
    building,  ///< What the renderer makes of it: its structure, its textures.
};

/// What is told during a render. All functions may be empty; they must be fast and not throw.
struct Observer {
    /// The part of a step that is done, from 0 to 1. Called by any thread, one at a time.
    std::function<void(Step, double)> step{};
    render::ProgressCallback progress{};  ///< Called by the threads that trace, one at a time.
    /// Warnings that should not wait for the report, as its end may be hours away.
    std::function<void(const Diagnostics&)> tell{};
    /// The picture as a PNG file, if Request::output is "-".
    std::function<void(std::span<const std::uint8_t>)> bytes{};
    /// Of several frames, one begins: its number, its index among them and their count.
    std::function<void(std::size_t, std::size_t, std::size_t)> frame{};
    /// A film is made of pictures: the index of the next one, and their count. Once more at the
    /// end, with an index that is the count.
    std::function<void(std::size_t, std::size_t)> film{};
};

/// The numbers of samples of adaptive sampling.
struct SampleRange {
    std::uint32_t fewest = 0;
    std::uint32_t most = 0;
    double mean = 0.0;
};

/// The facts of a picture, or of a shard of it.
struct Report {
    /// Warnings, and the errors that ended the render.
    Diagnostics diagnostics;
    bool interrupted = false;        ///< Stopped on request.
    std::filesystem::path output{};  ///< The file that was written; empty if none was.
    /// The checkpoint from which this render continues; empty if there is none.
    std::filesystem::path checkpoint{};
    std::optional<render::Shard> shard{};

    bool is_traced = false;  ///< Whether what follows is known.
    std::string camera{};    ///< The name of the picture or camera.
    std::size_t width = 0;   ///< Of what is rendered, in pixels.
    std::size_t height = 0;
    render::Summary summary{};
    std::optional<SampleRange> samples{};
    bool has_samples = true;          ///< Otherwise there was nothing to save.
    double exposure = 0.0;            ///< In stops.
    bool is_exposure_chosen = false;  ///< By a first look at the picture, for the display.
    render::Color3f ambient{0.0F};    ///< As Film::ambient.
    std::optional<render::DenoiseSummary> denoised{};
    double load_seconds = 0.0;    ///< To read the scene.
    float emission_scale = 1.0F;  ///< As Scene::emission_scale.
    render::Renderer::Preparation preparation{};
    std::vector<lang::FittedParameter> fitted{};
    bool in_bands = false;
    double done = 1.0;  ///< The part of the picture that is rendered, in bands.
};

/// Renders pictures one after the other, and keeps the scene and the cameras that it has read.
/// Belongs to one thread at a time.
class Session {
public:
    Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// Renders a picture and writes it, if the request names an output. A stop ends the rendering,
    /// but what is there is written; before that, it is an error of Kind::interrupted. Of two
    /// stereo formats, only the first is rendered.
    [[nodiscard]] Report render(const Request& request, const Observer& observer = {},
                                const std::stop_token& stop = {});

    /// The film of the last picture, unless it was rendered in bands; null if there is none.
    [[nodiscard]] std::shared_ptr<const render::Film> film() const;

private:
    friend class PictureWatch;
    struct State;
    std::unique_ptr<State> state_;
};

using render::Finish;

/// Writes the film, or gives a stream to the observer; errors are of the environment.
[[nodiscard]] Diagnostics write(const Finish& finish, const render::Film& film,
                                const Observer& observer = {});

/// A warning if the film is transparent somewhere, but the format has no alpha and shows black.
[[nodiscard]] Diagnostics warn_of_lost_alpha(const render::Film& film, const Finish& finish);

/// The pictures of a request: one, or one for each eye if they go to two files.
[[nodiscard]] std::vector<Request> pictures_of(const Request& request);

/// Both eyes see a scene with the same exposure and ambient light, those of the first.
void hold_look(const Report& first, Request& second);

/// Renders again whenever a file changes that the picture is made of, until a stop. `on_report`
/// receives the report of each picture that was finished; `on_wait` the number of watched files,
/// whenever they are all at rest, and whether a picture was finished before.
/// The last report is that which ended it: of a stop, or of an error of usage.
[[nodiscard]] Report watch(const Request& request, const Observer& observer,
                           const std::function<void(const Report&)>& on_report,
                           const std::function<void(std::size_t)>& on_wait,
                           const std::stop_token& stop);

/// What is known to be wrong with an output before rendering: its folder, its extension.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& output);

/// What is wrong with a request: values that are out of range, an error of Kind::internal; a fit
/// without a camera.
[[nodiscard]] Diagnostics check_request(const Request& request);

/// A picture of which all shards were joined.
struct MergedPicture {
    Diagnostics diagnostics;
    std::filesystem::path output{};
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t shards = 0;
    double exposure = 0.0;
    std::optional<render::DenoiseSummary> denoised{};
};

/// Joins all shards of a picture, and writes it where the first one says, or to another file if
/// one is named.
[[nodiscard]] MergedPicture merge_picture(const std::vector<std::filesystem::path>& shards,
                                          const std::filesystem::path& other_output = {},
                                          const Observer& observer = {});

/// The same for shards of several frames, each of which is a picture, unless an output is named.
[[nodiscard]] std::vector<MergedPicture> merge_pictures(
    const std::vector<std::filesystem::path>& shards,
    const std::filesystem::path& other_output = {}, const Observer& observer = {});

}  // namespace balcony::app
