// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inspect: questions about what a view shows, answered beside it.
//
//     view.scene(), view.shown() ─▶ Inspector::show() ─▶ at(), grid(), places_of(), check(),
//     render(), animate()

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera_export.hpp"
#include "balcony/live.hpp"
#include "balcony/prepared_scene.hpp"

namespace balcony::live {

/// The ray of a point of a picture and what stands there, in the axes of the scene.
struct Sight {
    std::string layer{};  ///< The camera layer of the picture, if it has several.
    Imath::V3d origin{0.0};
    Imath::V3d direction{0.0};   ///< Of unit length.
    Imath::V2d parameters{0.0};  ///< (u, v) of the eye object.
    struct Hit {
        std::string object{};
        std::string material{};  ///< Empty if the scene does not name it.
        double distance = 0.0;   ///< From the origin, in scene units.
        Imath::V3d point{0.0};
        Imath::V3d normal{0.0};      ///< Of unit length, towards the ray's side.
        double magnification = 0.0;  ///< As render::DataLayers::magnification.
        /// How long a step of (dx, dy) pixels is there across the ray, in scene units: its square
        /// is xx dx² + 2 xy dx dy + yy dy². By exact derivatives; unknown for rays that bend.
        struct Metric {
            double xx = 0.0, xy = 0.0, yy = 0.0;
        };
        std::optional<Metric> metric{};
    };
    std::optional<Hit> hit{};  ///< Nothing where the ray meets nothing.
};

/// A point of a picture that shows a point of space.
struct Appearance {
    Imath::V2d position{0.0};  ///< In pixels from the top left corner.
    std::string layer{};       ///< The camera layer of the picture, if it has several.
    Imath::V3d origin{0.0};    ///< Of its ray, in the axes of the scene.
    double distance = 0.0;     ///< Along the ray, in scene units.
    /// The object that hides the point from this ray, if one does.
    std::optional<std::string> hidden_by{};
};

/// What app::check() finds about a camera of a picture and its scene.
struct Remark {
    std::string camera{};  ///< As app::CameraCheck::title(); empty if the picture is one camera.
    std::string name{};    ///< What it is, in some words: "no ray".
    bool defect = false;   ///< Otherwise it is worth knowing, but may well be wanted.
    std::string message{};
    std::string remedy{};  ///< May be empty.
    /// Where that is in the picture, in pixels: boxes that do not overlap, and an example. Nothing
    /// if it is about no place, or about a layer, whose camera has a picture of its own.
    std::vector<Imath::Box2d> areas{};
    std::optional<Imath::V2d> example{};
};

/// Belongs to one thread, which need not be that of the view.
class Inspector {
public:
    /// Imports and tables of texts are looked for in the folder.
    explicit Inspector(app::PreparedScene scene, std::filesystem::path folder = {});
    Inspector(Inspector&&) noexcept;
    Inspector& operator=(Inspector&&) noexcept;
    ~Inspector();

    /// What the next questions are about. What is the same as before is not made again. Without a
    /// camera, the diagnostics say why, and there are no answers.
    [[nodiscard]] Diagnostics show(const Shown& shown, const std::stop_token& stop = {});

    /// The name of the camera or picture that is shown; empty without one.
    [[nodiscard]] std::string camera() const;
    /// What the pixel of a point shows, by the ray through its centre; nothing if there is no ray.
    /// A point that is not in the picture is an error of Kind::usage.
    [[nodiscard]] Result<std::optional<Sight>> at(const Imath::V2d& point,
                                                  const std::stop_token& stop = {});
    /// The same for the middles of equal cells of the picture, row by row from the top. The numbers
    /// of columns and rows are at least 1.
    [[nodiscard]] Result<std::vector<std::optional<Sight>>> grid(std::size_t columns,
                                                                 std::size_t rows,
                                                                 const std::stop_token& stop = {});
    /// All points of the picture that a point of the scene's space appears at, hidden or not, from
    /// left to right. As analyse::Locator finds them.
    [[nodiscard]] Result<std::vector<Appearance>> places_of(const Imath::V3d& point,
                                                            const std::stop_token& stop = {});
    /// What is wrong with the cameras of the picture, or worth knowing, defects first.
    [[nodiscard]] Result<std::vector<Remark>> check(const std::stop_token& stop = {});
    /// The camera that is shown, as `balcony export` writes it with its values. Of the request, the
    /// comment and the size are not read, and the title is what comes before the values. A picture
    /// with layers is an error.
    [[nodiscard]] Result<app::CameraExport> export_camera(app::CameraExportRequest request,
                                                          const std::stop_token& stop = {});

    /// Renders what is shown, in its stereo format and in a size and a quality of a request, as
    /// app::PreparedScene::render().
    [[nodiscard]] app::Report render(const app::Request& request,
                                     const app::Observer& observer = {},
                                     const std::stop_token& stop = {});
    /// Renders a film or a sequence of it, as app::PreparedScene::animate(). The time that is shown
    /// stays.
    [[nodiscard]] app::AnimationReport animate(const app::AnimationRequest& animation,
                                               const app::Observer& observer = {},
                                               const std::stop_token& stop = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace balcony::live
