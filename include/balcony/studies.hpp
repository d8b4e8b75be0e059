// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Studies of cameras without a picture: which ones there are, what is wrong with one, where it
// shows points, and how it looks from outside.
//
//     describe_built_in()
//     check(CheckRequest) ─▶ CheckReport        locate(LocateRequest), LocateSession ─▶ Located
//     draw(DrawRequest)   ─▶ a file             draw_film(DrawFilmRequest) ─▶ a film, or files
//
// Cameras are named as in Request::camera, but not those of a scene, unless it says so. A stop ends
// each of these with an error of Kind::interrupted.

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/animation.hpp"
#include "balcony/diagnose.hpp"
#include "balcony/drawing.hpp"
#include "balcony/inputs.hpp"
#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/probe.hpp"
#include "balcony/request.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

class PreparedScene;

// ---------------------------------------------------------------------------------------- list

/// The built-in cameras, by family. What else their files define serves these.
[[nodiscard]] Result<std::vector<lang::Description>> describe_built_in();

// --------------------------------------------------------------------------------------- check

/// A false-colour picture of a camera, and its file: .png, .jpg, .webp or .tif.
struct MapFile {
    analyse::MapKind kind = analyse::MapKind::magnification;
    std::filesystem::path file;
};

struct CheckRequest {
    /// Files, whose cameras are all checked, and single cameras or pictures.
    std::vector<std::string> files{};
    std::vector<std::string> set{};  ///< Values of parameters: "gamma=1/2".
    Placement placement{};           ///< In the scene, if there is one.
    /// The number of a layer of the only picture: 1 is at the back, 3.1 is in the picture of layer
    /// 3. All layers if it is empty.
    std::string layer{};
    SizeRequest size{};   ///< Of whole pictures.
    double time = 0.0;    ///< The value of t in the cameras' formulas, and of the scene.
    std::string scene{};  ///< Without one, nothing is known about objects.
    std::optional<double> meters_per_unit{};  ///< As Request::meters_per_unit.
    /// From the ray origins to where magnification is measured; if empty, it depends on the scene
    /// or, without one, on the camera.
    std::optional<double> distance{};
    std::vector<MapFile> maps{};  ///< Of the only camera.
};

/// What is known of one camera.
struct CameraCheck {
    analyse::CameraReport report;

    /// A layer that shows the camera with these parameters.
    struct Layer {
        std::string picture;
        std::string number;  ///< "2", or "3.1" in the picture of layer 3.
    };
    bool has_lens = false;  ///< The report is about the rays through its centre.
    bool has_bend = false;  ///< The report is about the first straight parts of its rays.
    bool by_itself = true;  ///< Whether it was also asked for on its own.
    std::vector<Layer> layers{};

    struct InScene {
        std::string scene;
        std::vector<std::string> never_seen{};
        std::vector<StartInside> starts_inside{};
        std::optional<MissText> miss{};  ///< If no ray meets anything.
        /// Of a camera with a scale: the length of a pixel, and what it is on the surfaces. In
        /// scene units, or in millimetres if the scene says how long these are.
        struct Scale {
            bool in_millimeters = false;
            double nominal = 0.0;
            render::SurfaceScale surface{};
        };
        std::optional<Scale> scale{};

        /// Something about the rays and the objects of the scene.
        struct Finding {
            std::string_view name;  ///< In some words.
            bool defect = false;
            std::string message;
            std::string remedy;                ///< May be empty.
            std::optional<analyse::V2d> at{};  ///< An example in the picture, in pixels.
        };
        [[nodiscard]] std::vector<Finding> findings() const;
    };
    std::optional<InScene> in_scene{};
    std::vector<std::filesystem::path> maps{};  ///< The files that were written.

    /// Objects that are never visible do not count, unless all are.
    [[nodiscard]] std::size_t defect_count() const;
    /// The camera and the layers that show it: "visitor, layer 2 of poster".
    [[nodiscard]] std::string title() const;
};

/// What is known of one of CheckRequest::files.
struct FileCheck {
    std::string file;
    std::size_t cameras = 0;  ///< That the file has, whether they are checked or not.
    std::size_t pictures = 0;
    bool good = false;  ///< Whether it has no errors.
    std::vector<CameraCheck> checks{};
};

struct CheckReport {
    Diagnostics diagnostics;
    std::vector<FileCheck> files;
};

/// What is told while cameras are checked, in the order in which it is found. May be empty.
struct CheckObserver {
    std::function<void(const Diagnostics&)> tell{};
    std::function<void(const FileCheck&)> file{};  ///< Before its cameras are checked.
    std::function<void(const CameraCheck&)> camera{};
};

/// Checks files and their cameras. Errors of Kind::usage come before anything is checked.
[[nodiscard]] CheckReport check(const CheckRequest& request, const CheckObserver& observer = {},
                                const std::stop_token& stop = {});
/// Checks the cameras of a picture of a size in pixels. Nothing is known about objects.
[[nodiscard]] Result<std::vector<CameraCheck>> check(const camera::Picture& picture,
                                                     const std::array<std::size_t, 2>& size,
                                                     const std::stop_token& stop = {});
/// The same in a scene, at the time of its settings.
[[nodiscard]] Result<std::vector<CameraCheck>> check(const camera::Picture& picture,
                                                     const PreparedScene& scene,
                                                     const std::array<std::size_t, 2>& size,
                                                     const std::stop_token& stop = {});

// -------------------------------------------------------------------------------------- locate

struct LocateRequest {
    std::string camera;              ///< With a scene also scene:NAME.
    std::vector<std::string> set{};  ///< Values of parameters: "gamma=1/2".
    Placement placement{};           ///< In the scene, if there is one.
    SizeRequest size{};
    double time = 0.0;
    std::optional<Axes> axes{};  ///< Of the points; if empty, those of the scene or the camera.
    std::string scene{};         ///< Without one, nothing is known about obstacles.
    std::vector<analyse::V3d> points{};
};

/// What decided on the axes of points.
enum class AxesSource : std::uint8_t { request, scene, camera };

/// Points, and where a picture shows them.
struct Located {
    std::string camera;
    std::vector<std::string> layers;   ///< Names of the picture's layers; one for a camera.
    std::vector<std::string> numbers;  ///< Of these layers: "2", or "3.1".
    std::size_t width = 0;
    std::size_t height = 0;
    bool closed_form = false;
    Axes axes = Axes::z_up;  ///< Of the points.
    AxesSource axes_from = AxesSource::camera;
    std::vector<analyse::V3d> points;  ///< As given.
    std::vector<analyse::Sighting> sightings;
    /// With a scene: the obstacle that hides each sighting, if there is one.
    std::optional<std::vector<std::optional<render::Obstacle>>> obstacles;
    std::vector<scene::Object> objects;  ///< Of the scene.
};

[[nodiscard]] Result<Located> locate(const LocateRequest& request,
                                     const std::stop_token& stop = {});

/// The warning that not all places were searched at which a picture may show some points, so many.
[[nodiscard]] Diagnostic searched_in_part(std::size_t points);

/// A picture, with its scene, that is asked for points in batches. One thread at a time.
class LocateSession {
public:
    /// The points of the request are not used.
    [[nodiscard]] static Result<LocateSession> make(const LocateRequest& request,
                                                    const std::stop_token& stop = {});
    /// A picture of a size in pixels in a scene. Points are in the axes of the scene. `inverse` is
    /// that of the picture in this size and at the time of the scene, if it is known already.
    [[nodiscard]] static Result<LocateSession> make(
        const camera::Picture& picture, const PreparedScene& scene,
        const std::array<std::size_t, 2>& size, const std::stop_token& stop = {},
        const std::optional<analyse::Locator>& inverse = {});
    LocateSession(LocateSession&&) noexcept;
    LocateSession& operator=(LocateSession&&) noexcept;
    ~LocateSession();

    [[nodiscard]] Result<Located> locate(std::vector<analyse::V3d> points,
                                         const std::stop_token& stop = {});
    /// The files of the camera and the scene that were read.
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const;
    /// Warnings about all points so far.
    [[nodiscard]] Diagnostics finish(const std::stop_token& stop = {}) const;

private:
    struct State;
    explicit LocateSession(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// ---------------------------------------------------------------------------------------- draw

struct DrawRequest {
    std::string camera;
    std::vector<std::string> set{};  ///< Values of parameters: "gamma=1/2".
    analyse::Depiction depiction{};
    analyse::DrawingView view{};
    /// A picture (.svg, .png, .jpg, .webp, .tif), or a scene (.glb), which has no view.
    std::filesystem::path output{};
};

/// Draws a camera, or the cameras of a picture, to a file, which is complete or unchanged.
[[nodiscard]] Diagnostics draw(const DrawRequest& request, const std::stop_token& stop = {});

/// Drawings of a camera at the times of the frames of a film.
struct DrawFilmRequest {
    /// Of each frame, but for its output. Its time is that of frame 1. Without Depiction::film, the
    /// frame of reference is that of the times of all frames.
    DrawRequest drawing{};
    FrameNumbers frames{};  ///< At least one.
    FrameRate rate{};
    FrameOutput output{};
};

/// Draws all frames, and makes the film of them. Files that are there are replaced, but not the
/// frames of a film that animate() has begun.
[[nodiscard]] Diagnostics draw_film(const DrawFilmRequest& request, const Observer& observer = {},
                                    const std::stop_token& stop = {});

}  // namespace balcony::app
