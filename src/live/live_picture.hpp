// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pictures of one camera in their qualities.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "balcony/live.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/render.hpp"
#include "live/pixel_metrics.hpp"

namespace balcony::live {

/// A job that is made when it is first needed, and moved from then on.
class MovingJob {
public:
    /// Makes it for a film, if it is not made for one of this size already or has expired. False if
    /// that fails, as the diagnostics say, or is stopped.
    [[nodiscard]] bool make(const render::Renderer& renderer, const camera::Picture& picture,
                            const render::Settings& settings, const render::FilmLayout& layout,
                            const std::stop_token& stop, Diagnostics& found);
    /// The renderer, the settings or the window are others now.
    void expire() { has_expired_ = true; }
    [[nodiscard]] Diagnostics move(std::span<const camera::KnownInput> inputs);
    /// True if each pixel has these samples; false after a stop, too.
    [[nodiscard]] bool run(std::size_t samples, const std::stop_token& stop, Diagnostics& found);
    [[nodiscard]] const render::Film& film() const { return *job_->film(); }

private:
    [[nodiscard]] bool take(Result<render::Job> made, Diagnostics& found);

    std::optional<render::Job> job_;
    bool has_expired_ = false;
};

/// A camera whose parameters move, in one size.
class LivePicture {
public:
    LivePicture(lang::OpenPicture opened, std::array<std::size_t, 2> size)
        : opened_(std::move(opened)), size_(size) {}

    [[nodiscard]] const lang::OpenPicture& opened() const { return opened_; }
    [[nodiscard]] const std::array<std::size_t, 2>& size() const { return size_; }

    /// Gives the open parameters among these their values, and the others those of the text.
    void move(const std::vector<Value>& values, Diagnostics& found);
    /// The scene is at another time.
    void expire();
    /// Whether a parameter moves without the picture being made anew.
    [[nodiscard]] bool is_open(const std::string& parameter) const;
    /// The values as texts, for a picture in which they are not open.
    [[nodiscard]] std::vector<lang::Override> all_closed(const std::vector<Value>& values) const;

    /// What follows a drag at a time, from these values. `axes` are those of its points.
    [[nodiscard]] Dragged drag(const Drag& drag, const std::vector<Value>& values, double time,
                               Axes axes, const std::stop_token& stop);

    /// A preview of one ray a pixel, in a size that is divided by this. Null if it fails, as the
    /// diagnostics say, or is stopped.
    [[nodiscard]] const render::Film* preview(const app::PreparedScene& scene, std::size_t part,
                                              const std::stop_token& stop, Diagnostics& found);
    /// Path tracing, so far that each pixel has these samples.
    [[nodiscard]] const render::Film* paths(const app::PreparedScene& scene, std::size_t samples,
                                            bool will_denoise, const std::stop_token& stop,
                                            Diagnostics& found);
    /// What the rays through the centres of pixels in a window meet: data layers, and materials.
    [[nodiscard]] const render::Film* data(const app::PreparedScene& scene,
                                           const render::Region& window,
                                           const std::stop_token& stop, Diagnostics& found);
    /// The metric at a distance along the ray through a point, in a layer by its number from the
    /// back; nothing if it is not known.
    [[nodiscard]] std::optional<PixelMetrics::Metric> metric(const app::PreparedScene& scene,
                                                             std::size_t layer,
                                                             const Imath::V2d& point,
                                                             double distance,
                                                             const std::stop_token& stop);

private:
    [[nodiscard]] bool is_angle(const std::string& parameter) const;
    [[nodiscard]] render::Settings with_inputs(render::Settings settings) const;
    [[nodiscard]] render::Settings preview_settings(const app::PreparedScene& scene) const;

    lang::OpenPicture opened_;
    std::array<std::size_t, 2> size_;
    std::vector<camera::KnownInput> inputs_;
    MovingJob coarse_;
    MovingJob preview_;
    MovingJob paths_;
    MovingJob data_;
    std::optional<Dragger> dragger_;  ///< Of the layer and the time that were dragged last.
    std::size_t dragged_layer_ = 0;
    double dragged_time_ = 0.0;
    std::optional<Result<PixelMetrics>> metrics_;
};

}  // namespace balcony::live
