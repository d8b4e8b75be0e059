// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Live: a picture that follows its camera while it is changed.
//
//     View::change() ─▶ thread of the view ─▶ Observer::frame: coarse, preview, paths, denoised
//
// The newest state wins: what a change makes useless is cancelled, but for the first frame, so that
// a camera in motion is always seen.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/app.hpp"
#include "balcony/base.hpp"
#include "balcony/drag.hpp"
#include "balcony/lang.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/request.hpp"
#include "balcony/stereo.hpp"

namespace balcony::live {

/// What changes in the picture. Members without a value stay as they are.
struct Change {
    std::optional<std::string> text{};                 ///< Of the camera file.
    std::optional<std::string> camera{};               ///< In the text; its last one if empty.
    std::optional<std::vector<Value>> values{};        ///< All of them.
    std::optional<std::array<std::size_t, 2>> size{};  ///< Width and height in pixels.
    std::optional<double> time{};  ///< In seconds, of the camera's formulas and of the scene.
    /// How both eyes of the request's stereo pair are shown in one picture; without a format, it is
    /// the picture of one eye.
    std::optional<std::optional<camera::StereoFormat>> stereo{};
    bool choose_exposure = false;  ///< By this picture, for this and later ones.
    /// What a hand pulls, from `values` as they are without it: until another drag comes, the
    /// picture is shown with the values that follow. One without pulls ends it.
    std::optional<Drag> drag{};
};

/// What is shown once changes are made.
struct Shown {
    std::uint64_t change = 0;  ///< The number of the last one.
    std::string text{};
    std::string camera{};         ///< In the text; its last one if empty.
    std::vector<Value> values{};  ///< With those that follow a drag.
    std::array<std::size_t, 2> size{};
    double time = 0.0;  ///< As Change::time.
    std::optional<camera::StereoFormat> stereo{};
};

/// How a picture is made, from the first answer to the last.
enum class Quality : std::uint8_t {
    coarse,    ///< A preview of fewer pixels.
    preview,   ///< One ray a pixel.
    paths,     ///< Path tracing, with more and more samples.
    denoised,  ///< The same at rest, without its noise.
};

struct Frame {
    std::uint64_t change = 0;  ///< The number of the newest change that it shows.
    Quality quality = Quality::coarse;
    std::size_t width = 0;  ///< In pixels; of a coarse frame, less than those of the picture.
    std::size_t height = 0;
    std::vector<std::uint8_t> pixels{};  ///< As render::display_pixels().
    std::size_t samples = 1;             ///< Of a pixel.
    double seconds = 0.0;                ///< Since the change.
};

/// What became of the camera of a change.
struct CameraState {
    std::uint64_t change = 0;
    /// Errors, after which the frames go on to show the last good camera, or warnings.
    Diagnostics diagnostics{};
    std::string name{};              ///< Of the camera; empty after errors, as the following.
    std::optional<double> aspect{};  ///< Width to height, if it is made for one.
    std::optional<camera::StereoFormat> stereo{};  ///< As Change::stereo.
    double time = 0.0;                             ///< As Change::time.
    std::vector<lang::OpenParameter> open{};    ///< They move without the camera being made anew.
    std::vector<lang::OpenParameter> closed{};  ///< Another value makes the camera anew.
    /// Those that change with time, with their values at the time that is shown. They are open
    /// while a hand pulls.
    std::vector<lang::OpenParameter> moving{};
};

/// The name of the text of a view in the spans of diagnostics.
inline constexpr std::string_view text_name = "camera.cam";

/// What has become of the scene that a view loads.
struct SceneState {
    std::optional<app::Step> step{};  ///< While it is loaded.
    Diagnostics diagnostics{};  ///< When it is loaded: warnings, or errors, after which the view
                                ///< shows nothing.
    double duration = 0.0;      ///< Of the longest of its animations, in seconds.
};

/// What a view tells, from its own thread, one call at a time. Functions may be empty; they must
/// not throw. They may call View::change(), but not destroy the view.
struct Observer {
    std::function<void(const Frame&)> frame{};
    /// Of a view that loads it; while it does, from any thread.
    std::function<void(const SceneState&)> scene{};
    std::function<void(const CameraState&)> camera{};  ///< After each change, before its frames.
    std::function<void(const Dragged&)> drag{};        ///< What follows, before the frames show it.
    /// Nothing is left to do for the newest change, whose number it is.
    std::function<void(std::uint64_t)> rest{};
};

struct Options {
    /// The time that a coarse frame should take. Its pixels follow from the speed of the last ones.
    double coarse_seconds = 0.02;
    /// Paths are traced when no change has come for this time: what they need takes longer to stop
    /// than a coarse frame may take.
    double rest_seconds = 0.1;
    bool traces_paths = true;  ///< Otherwise the preview is the last quality.
    bool denoises = true;
};

/// A picture of a scene that follows its camera. Its functions may be called from any thread and
/// do not wait for a picture.
class View {
public:
    /// The request says all but what changes: scene, light, samples, placement, exposure, the first
    /// time and stereo format. Its camera and size are not read.
    [[nodiscard]] static std::unique_ptr<View> make(app::PreparedScene scene,
                                                    const app::Request& request, Observer observer,
                                                    const Options& options = {},
                                                    std::filesystem::path folder = {});
    /// The same with a scene that the view loads on its thread; changes wait for it. One that fails
    /// is loaded again when its file changes.
    [[nodiscard]] static std::unique_ptr<View> load(const app::Request& request, Observer observer,
                                                    const Options& options = {},
                                                    std::filesystem::path folder = {});
    /// Ends what is in progress.
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Shows something else. Returns the number of the change, from 1. Numbers rise.
    std::uint64_t change(Change change);

    /// What it shows: the newest change that has a camera; nothing before the first one.
    [[nodiscard]] std::optional<Shown> shown() const;
    /// Its scene for another thread; nothing before it is loaded, or if that fails.
    [[nodiscard]] std::optional<app::PreparedScene> scene() const;

private:
    struct State;
    explicit View(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::live
