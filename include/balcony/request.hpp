// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Request: all that a picture is made of, as values. Front ends fill it in, app.hpp renders it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "balcony/checkpoint.hpp"
#include "balcony/denoise.hpp"
#include "balcony/environment.hpp"
#include "balcony/film.hpp"
#include "balcony/layers.hpp"
#include "balcony/names.hpp"
#include "balcony/picture.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"
#include "balcony/shard.hpp"
#include "balcony/shutter.hpp"
#include "balcony/stereo.hpp"

namespace balcony::app {

/// The largest width and height of a picture in pixels.
inline constexpr std::size_t max_side = 1'000'000;

/// A requested picture size: width and height in pixels, one of them, or neither.
struct SizeRequest {
    std::optional<std::size_t> width{};
    std::optional<std::size_t> height{};
    camera::Fit fit = camera::Fit::fit;  ///< What the picture does in a size of another aspect.

    /// Width and height. The default is the picture's own size, if it has one, otherwise about a
    /// million pixels. A missing side follows from the picture's aspect ratio.
    [[nodiscard]] std::pair<std::size_t, std::size_t> resolve(
        double aspect, std::optional<std::array<std::size_t, 2>> own = {}) const;
};

/// A part of a picture at a scale.
struct Crop {
    double scale = 1.0;
    /// Left, top, right and bottom: in pixels before scaling, or as fractions of the picture.
    std::optional<std::array<double, 4>> corners{};
    bool in_pixels = false;

    /// Width and height of a picture after scaling; at least 1.
    [[nodiscard]] std::pair<std::size_t, std::size_t> scaled(std::size_t width,
                                                             std::size_t height) const;
    /// The region of the scaled picture; nothing for all of it. It may reach beyond the picture.
    [[nodiscard]] std::optional<render::Region> region(std::size_t width, std::size_t height) const;
};

/// Light that is not part of the scene.
struct LightRequest {
    /// An equirectangular picture file, a radiance from all directions, or a sky; nothing for what
    /// suits the scene.
    std::variant<std::monostate, std::filesystem::path, Imath::Color3f, render::Sky> environment{};
    double rotation = 0.0;  ///< Of the environment, in radians, as Environment::rotated().
    float strength = 1.0F;  ///< The factor of its radiance.
    std::optional<double> sun_angle{};      ///< As LightSettings::sun_angle.
    std::optional<float> emission_scale{};  ///< As scene::LoadOptions::emission_scale.
    std::vector<scene::Light> lamps{};      ///< They join the scene, in its axes.
    /// A light at the eye in place of the lights of the scene and a sky.
    bool lamp_at_eye = false;
};

/// Frames per second as a fraction, such as 30000/1001.
struct FrameRate {
    double frames = 24.0;
    double seconds = 1.0;

    [[nodiscard]] double frame_time() const { return 1.0 / (frames / seconds); }  ///< In seconds.
    [[nodiscard]] std::string text() const;  ///< "24", "30000/1001".
    bool operator==(const FrameRate&) const = default;
};

/// How long the shutter is open.
struct ShutterRequest {
    double duration = 0.0;    ///< In seconds, or in degrees, of which a frame has 360.
    bool in_degrees = false;  ///< As film cameras have it, whose shutter is a disc.
    render::ShutterShape shape = render::ShutterShape::box;
    FrameRate rate{};  ///< Also that of LayerId::motion.

    [[nodiscard]] render::Shutter shutter() const;
};

/// A stereo picture, or the pictures of both eyes in two files.
struct StereoRequest {
    /// One, or left and right for two files; none for a picture of one eye.
    std::vector<camera::StereoFormat> formats{};
    camera::StereoPair pair{};

    [[nodiscard]] bool is_wanted() const { return !formats.empty(); }
    [[nodiscard]] bool has_two_files() const { return formats.size() > 1; }
    /// Whether the eyes differ in their colours alone.
    [[nodiscard]] bool is_anaglyph() const;
};

/// The file of an eye's picture: film.left.png for film.png.
[[nodiscard]] std::filesystem::path file_of_eye(const std::filesystem::path& file,
                                                camera::StereoFormat eye);

/// Where a program listens that shows pictures while they are rendered, by the messages of tev.
struct DisplayAddress {
    std::string host;  ///< A name or an address.
    std::uint16_t port = 0;

    [[nodiscard]] std::string text() const;  ///< "localhost:14158"
    bool operator==(const DisplayAddress&) const = default;
};

/// How long a render runs, and what it leaves on the disk meanwhile. Intervals are in seconds;
/// without one, there is no limit, or nothing is saved.
struct JobRequest {
    std::optional<double> time_limit{};
    std::optional<double> save_every{};
    std::optional<double> checkpoint_every = 60.0;
    bool resume = false;                  ///< Continue from the checkpoint, if there is one.
    std::optional<double> film_memory{};  ///< In bytes; half of the machine's if empty.
    std::optional<render::Shard> shard{};
    std::optional<DisplayAddress> display{};  ///< Which shows the picture so far.

    [[nodiscard]] double film_bytes() const;
};

/// Where a camera of a file stands in a scene.
struct Placement {
    /// Whether the camera is placed by the size of the scene, as its file says; if empty, whether
    /// it is built in.
    std::optional<bool> fit{};
    /// By the size of an object of the scene, if it is not empty. A camera that stands at a point
    /// looks at the object.
    std::string fit_to{};
    /// Where a camera stands that the scene places: at a point in the scene's axes, or where a
    /// camera of the scene does, scene:NAME, and then it looks the same way; if empty, in the open.
    std::optional<std::variant<Imath::V3d, std::string>> from{};

    /// Whether it was asked for in words.
    [[nodiscard]] bool is_demanded() const { return fit.value_or(!fit_to.empty() || from); }
    /// Whether the scene places a camera that is named as in Request::camera.
    [[nodiscard]] bool places(const std::string& camera) const;
};

/// What becomes of rays that start in closed objects, other than a room around all of them.
enum class InsideRule : std::uint8_t {
    report,  ///< They show them from inside. A warning names them, as it does with `pass`.
    pass,    ///< They pass through them.
};
[[nodiscard]] Names<InsideRule> inside_rules();

/// A picture of a scene through a camera.
struct Request {
    std::string scene;                  ///< The name of a scene file.
    std::vector<std::string> added{};   ///< Scene files that join it.
    std::optional<bool> solid_glass{};  ///< As scene::LoadOptions::solid_glass.
    /// The length of the scene's unit in metres; if empty, what its file says.
    std::optional<double> meters_per_unit{};
    /// FILE, FILE:NAME, the name of a built-in camera, or scene:NAME for one of the scene. If
    /// empty, the first camera of the scene, or one that shows it well.
    std::string camera{};
    std::vector<std::string> set{};  ///< Values of the camera's parameters: "gamma=1/2".
    /// A file of marks that other parameters are found by, as solve_camera() does; the scene does
    /// not place the camera then.
    std::filesystem::path solve{};
    Placement placement{};
    InsideRule inside = InsideRule::report;

    SizeRequest size{};
    /// The size of a pixel on the surface for which the camera has a scale, in place of a size.
    std::optional<double> mm_per_pixel{};
    Crop crop{};
    std::optional<std::size_t> samples{};  ///< Per pixel; if empty, it depends on the noise level.
    /// All others; what the members beside it say takes the place of what it says.
    render::Settings settings{};
    LightRequest light{};
    ShutterRequest shutter{};
    StereoRequest stereo{};
    std::size_t texture_memory = render::default_texture_memory;

    std::optional<double> exposure{};  ///< In stops; chosen automatically if empty.
    /// If empty, neutral, but standard for anaglyphs: others mix the channels, so that an eye
    /// would see what belongs to the other one.
    std::optional<render::ViewTransform> view{};
    bool dither = true;
    /// Pixels per inch of the print, which the file names; if empty, those of a print in the size
    /// of the surface, if that is known.
    std::optional<double> dpi{};
    render::LayerSet layers = render::default_layers();  ///< Of an EXR file.
    bool denoise = false;
    render::Denoiser denoiser = render::Denoiser::automatic;

    JobRequest job{};
    std::filesystem::path output{};

    [[nodiscard]] render::ViewTransform view_transform() const;
    /// Millimetres of the surface in a pixel of the scaled picture; nothing if that is not asked.
    [[nodiscard]] std::optional<double> pixel_millimeters() const;
    /// How the picture is shown: with an exposure of 0 if none is asked for, and the resolution of
    /// a print in the size of the surface if the length of a pixel is known.
    [[nodiscard]] render::DisplayOptions display() const;
};

/// The number of samples of a pixel unless a request names it: without and with a noise level.
inline constexpr std::size_t default_samples = 16;
inline constexpr std::size_t default_max_samples = 1024;

/// The settings of a request, without an environment that is a file. A sky out of range is an
/// error.
[[nodiscard]] Result<render::Settings> settings_of(const Request& request);

}  // namespace balcony::app
