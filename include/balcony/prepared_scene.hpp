// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Prepared scene: what many pictures of a scene have in common, for programs that change a camera
// and look at the picture.

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/animation.hpp"
#include "balcony/app.hpp"
#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "balcony/request.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

/// Changes a scene by the functions of scene_edits.hpp, or otherwise. It keeps its textures.
using SceneEdit = std::function<Diagnostics(scene::Scene&)>;

/// A scene that is loaded and lit as a request says, and cameras that are placed in it. Belongs to
/// one thread at a time; what it makes may be used anywhere.
class PreparedScene {
public:
    /// Loads the scene and its environment. The camera of the request is not read. A stop is an
    /// error of Kind::interrupted.
    [[nodiscard]] static Result<PreparedScene> make(const Request& request,
                                                    const Observer& observer = {},
                                                    const std::stop_token& stop = {});
    /// The same for a scene that a program has made; that of the request is not read.
    [[nodiscard]] static Result<PreparedScene> make(scene::Scene scene, const Request& request,
                                                    const Observer& observer = {},
                                                    const std::stop_token& stop = {});
    PreparedScene(PreparedScene&&) noexcept;
    PreparedScene& operator=(PreparedScene&&) noexcept;
    ~PreparedScene();

    /// The same scene for another thread, as it is now: shares all that does not move.
    [[nodiscard]] PreparedScene share() const;

    /// A picture of a camera file with these parameters open, or all that can be without a list,
    /// placed in the scene as the request says. The scene is made ready for the times of its rays.
    [[nodiscard]] Result<lang::OpenPicture> picture(
        const lang::CameraSource& source, std::string_view name,
        const std::vector<lang::Override>& values, const std::stop_token& stop = {},
        const std::optional<std::vector<std::string>>& open = {});

    /// A picture as both eyes of the request's stereo pair see it, in one picture of a format.
    [[nodiscard]] Result<camera::Picture> in_stereo(const camera::Picture& picture,
                                                    camera::StereoFormat format) const;

    /// Moves the scene to a time in seconds, which the settings then have. The renderer follows
    /// with the next picture, or by prepare(). What cannot move is a warning.
    [[nodiscard]] Diagnostics set_time(double time);
    /// Changes what the scene is at all times. After an error of the edit, it stays as it was. The
    /// renderer follows as after set_time(): all edits until then cost it as much as one.
    [[nodiscard]] Diagnostics edit(const SceneEdit& change);
    /// Makes the scene ready for a picture of it that was made before set_time() or edit(), or
    /// without one for cameras that are placed in it.
    [[nodiscard]] Diagnostics prepare(const std::optional<camera::Picture>& picture = {},
                                      const std::stop_token& stop = {});

    /// Renders a picture and writes it, as Session::render() does. Of the request, the scene, its
    /// lamps, the camera and the time are not read.
    [[nodiscard]] Report render(const camera::Picture& picture, const Request& request,
                                const Observer& observer = {}, const std::stop_token& stop = {});
    /// As Session::film(), of the last render().
    [[nodiscard]] std::shared_ptr<const render::Film> film() const;

    /// Renders the frames of a picture, and makes their film, as app::animate() does; the scene is
    /// moved along. Of the request of its frames, what render() does not read is not read here
    /// either. With an identity, frames are continued that were begun with the same one and the
    /// same files, unless they are to be overwritten. Without one, frames that are there are
    /// rendered again, and after a stop, the film is made of the frames that are finished.
    [[nodiscard]] AnimationReport animate(const camera::Picture& picture,
                                          const AnimationRequest& animation,
                                          const Observer& observer = {},
                                          const std::stop_token& stop = {});

    /// The exposure that suits a picture in this integrator's light: that of the request, if it
    /// names one.
    [[nodiscard]] Result<double> exposure(const camera::Picture& picture,
                                          std::string_view integrator,
                                          const std::stop_token& stop = {}) const;

    [[nodiscard]] const std::shared_ptr<const scene::Scene>& scene() const;
    /// Of the scene at its last prepare() or picture.
    [[nodiscard]] const render::Renderer& renderer() const;
    /// Those of the request, with its environment.
    [[nodiscard]] const render::Settings& settings() const;

private:
    struct State;
    explicit PreparedScene(std::unique_ptr<State> state);
    [[nodiscard]] static Result<PreparedScene> make(std::unique_ptr<State> state,
                                                    const Observer& observer,
                                                    const std::stop_token& stop);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::app
