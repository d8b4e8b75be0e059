// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lang: the camera description language (.cam). docs/language.md has the grammar.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/catalogue.hpp"
#include "balcony/picture.hpp"

namespace balcony::lang {

/// A value for a camera's parameter from the command line: --set gamma=1/2.
struct Override {
    std::string name;
    std::string expression;
};

/// What `fit` statements know of a scene, in axes with z up: where it is and where one stands well
/// in it. By default an arbitrary one.
struct SceneMeasures {
    std::array<double, 3> min{-1.0, -1.0, 0.0}, max{1.0, 1.0, 2.0};  ///< Its bounds.
    /// A point in the open, from which much of it is seen.
    std::array<double, 3> inside{0.0, 0.0, 1.0};
    /// How large the scene appears from there, as an angle; all round by default.
    double angle = 6.283185307179586;
    /// Where a camera that stands there looks, in radians, as the parameters of these names of the
    /// built-in cameras; without it, where its file says.
    struct Look {
        double yaw = 0.0, pitch = 0.0, roll = 0.0;
    };
    std::optional<Look> look{};
    /// Of the vertical cylinder around the centre of the bounds that contains everything.
    double radius = 1.42;
    /// The surface of revolution around the same axis that contains everything: distances from the
    /// axis and heights above the centre, from bottom to top.
    std::vector<std::array<double, 2>> profile{{1.42, -1.0}, {1.42, 1.0}};
    /// The surface of revolution that most of the scene is near, as render::Revolution; if there is
    /// none, an upright one around all of it is known by its names.
    struct Revolution {
        std::array<double, 3> axis{0.0, 0.0, 1.0}, center{};
        double length = 0.0, radius = 0.0, reach = 0.0, arc_middle = 0.0, arc = 0.0;
        std::vector<std::array<double, 2>> profile;
    };
    std::optional<Revolution> revolution{};
};

/// A parameter that a `fit` statement has set, unless an override or a layer gives it another
/// value.
struct FittedParameter {
    std::string camera;
    std::string name;
    std::optional<double> value;  ///< Of a constant number; angles in radians.
    bool is_angle = false;
    bool follows_place = false;  ///< By scene_inside: where one stands decides it.
};

/// The declaration of a camera or a picture in a file.
struct Description {
    struct Parameter {
        std::string name;
        std::string default_text;  ///< The source text.
        camera::Range limits{};    ///< The values that it may have; angles in radians.
        std::string limits_text;   ///< The source text; empty without limits.
    };

    std::string name;
    std::vector<Parameter> parameters;
    /// The comment lines directly above it, without the last paragraph if that has its keywords.
    std::string comment;
    std::string keywords;  ///< By which it is found: "360, vr".
    bool is_picture = false;
    std::vector<std::string> layers;  ///< The names in a picture's layers, from back to front.
};

/// What a camera or a picture does, in words.
struct Explanation {
    struct Parameter {
        std::string name;
        std::string value;
    };
    /// A statement, in the order in which they apply to a picture point.
    struct Step {
        std::string statement;              ///< "map", "eye", ...
        std::string written;                ///< The source text; empty if a block follows.
        std::vector<std::string> meanings;  ///< The meanings of its stages.
        std::size_t depth = 0;              ///< 1 in the block of the previous step.
    };
    struct Layer {
        std::string written;      ///< The source text: closeup(turn = 30deg).
        std::vector<Step> steps;  ///< The statements of its block.
        std::size_t shows = 0;    ///< Index into `shown` of the whole explanation.
    };
    std::string name;
    bool is_picture = false;
    std::string summary;
    std::vector<Parameter> parameters;
    /// The source texts of its lets, and of those of its file that it uses: "half = fov/2".
    std::vector<std::string> definitions;
    std::vector<Step> steps;         ///< The steps of a camera.
    std::vector<Layer> layers;       ///< The layers of a picture, from back to front.
    std::vector<Explanation> shown;  ///< For the whole explanation: the cameras and pictures in its
                                     ///< layers and theirs, once for the same parameters.
};

/// A picture with its explanation.
struct ExplainedPicture {
    camera::Picture picture;
    Explanation explanation;
};

/// A number among a camera's parameters that stays open: an input of its formulas.
struct OpenParameter {
    std::string name;
    std::string written;  ///< The source text of its value.
    double value = 0.0;   ///< In radians if it is an angle.
    bool is_angle = false;
    camera::Range limits{};  ///< The values that it may have. What moves the input keeps to them.
};

/// A number among a camera's parameters that changes with time, such as one with keys.
struct MovingParameter {
    OpenParameter number;      ///< Its value is that at the time 0.
    camera::Scalar over_time;  ///< In the time t alone.

    /// As it is at a time in seconds.
    [[nodiscard]] OpenParameter at(double time) const;
};

/// The name of the input of an open parameter.
[[nodiscard]] std::string parameter_input(std::string_view parameter);

/// A camera with open parameters.
struct OpenCamera {
    camera::Camera camera;
    std::vector<OpenParameter> open;
    /// The names of those that cannot be open: tuples and lists, and numbers that determine the
    /// structure of a stage, such as its tables.
    std::vector<std::string> closed;
    std::vector<OpenParameter> numbers;  ///< Those of `closed` that are numbers, asked for or not.
};

/// A picture with open parameters.
struct OpenPicture {
    camera::Picture picture;
    std::vector<OpenParameter> open;
    std::vector<std::string> closed;        ///< As OpenCamera::closed: another value makes it anew.
    std::vector<OpenParameter> numbers;     ///< As OpenCamera::numbers.
    std::vector<MovingParameter> moving{};  ///< Those of `closed` that change with time.
};

/// Where cameras are written: a .cam file or the name of a built-in camera, or a text.
class CameraSource {
public:
    CameraSource(std::filesystem::path file) : file_(std::move(file)) {}
    CameraSource(const std::string& file) : file_(file) {}
    CameraSource(const char* file) : file_(file) {}
    /// Imports, tables, images and meshes of the text are looked for in `folder`.
    CameraSource(std::shared_ptr<const SourceText> text, std::filesystem::path folder = {})
        : file_(std::move(folder)), text_(std::move(text)) {}

    /// The file, or the folder of a text.
    [[nodiscard]] const std::filesystem::path& path() const { return file_; }
    /// Null if it is a file.
    [[nodiscard]] const std::shared_ptr<const SourceText>& text() const { return text_; }

private:
    std::filesystem::path file_;
    std::shared_ptr<const SourceText> text_;
};

/// Makes cameras and keeps what it reads: camera files, tables, images and meshes are each read
/// once, however many cameras are made of them, with whatever parameters. What changes on the disk
/// is noticed after reload() only.
///
/// An empty `name` means the file's last camera or picture. Overrides that the camera does not know
/// are errors; of two for one parameter the last counts. Warnings may come with a value; --set is
/// the name of an override's text in diagnostics.
///
/// A workspace belongs to one thread at a time. What it makes is independent of it and may be used
/// anywhere.
class Workspace {
public:
    /// Knows the stages of a catalogue: the built-in ones, and those that a program has added.
    explicit Workspace(camera::Catalogue catalogue = {});
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    ~Workspace();

    /// Makes a camera; an empty name means the last camera, not the last picture.
    [[nodiscard]] Result<camera::Camera> make_camera(const CameraSource& source,
                                                     std::string_view name = "",
                                                     const std::vector<Override>& overrides = {});

    /// The same with parameters that stay open: the named ones, or all of them without a list. An
    /// unknown name is an error.
    [[nodiscard]] Result<OpenCamera> make_open_camera(
        const CameraSource& source, std::string_view name, const std::vector<Override>& overrides,
        const std::optional<std::vector<std::string>>& open = {});

    /// The same for a picture. render::Job::set_inputs() moves them.
    [[nodiscard]] Result<OpenPicture> make_open_picture(
        const CameraSource& source, std::string_view name = "",
        const std::vector<Override>& overrides = {},
        const std::optional<std::vector<std::string>>& open = {});

    /// Makes a picture, or of a camera the picture that shows it alone.
    [[nodiscard]] Result<camera::Picture> make_picture(const CameraSource& source,
                                                       std::string_view name = "",
                                                       const std::vector<Override>& overrides = {});

    /// Makes every camera and picture, in the order of the file; cameras as in make_picture(). What
    /// several of them show with the same parameters is one camera. With a `name`, the overrides
    /// are for the camera of that name; if it is imported, it comes last.
    [[nodiscard]] Result<std::vector<camera::Picture>> make_all(
        const CameraSource& source, const std::vector<Override>& overrides = {},
        std::string_view name = "");

    /// The text of a file in which a camera or a picture has these expressions as the values of its
    /// parameters; the rest is as it was written, comments and layout among it. The values of what
    /// is made of another one stand in its own call. What is imported stays as it is: one of the
    /// same name that is made of it is added, which is all of the text for a built-in camera.
    [[nodiscard]] Result<std::string> with_values(const CameraSource& source, std::string_view name,
                                                  const std::vector<Override>& values);

    /// The same as make_picture(), explained.
    [[nodiscard]] Result<ExplainedPicture> explain(const CameraSource& source,
                                                   std::string_view name = "",
                                                   const std::vector<Override>& overrides = {});

    /// What cameras and pictures a file has, in its order, without making them.
    [[nodiscard]] Result<std::vector<Description>> describe(const CameraSource& source);

    /// Cameras and pictures that are made from now on are fitted to a scene: their `fit` statements
    /// replace the defaults of parameters. Without a scene, they are made as they are written.
    void fit_to(std::optional<SceneMeasures> scene);
    /// The parameters with `fit` statements in the last make_picture(), with the values they have.
    [[nodiscard]] const std::vector<FittedParameter>& fitted() const;

    /// A stop ends the making of a camera, which is an error of Kind::interrupted.
    void stop_with(std::stop_token stop);

    /// The files on the disk that were read or looked for since the last reload(): camera files,
    /// tables, images and meshes. To notice a change, watch these.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

    /// Forgets what was read, so that files are read anew.
    void reload();

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// For a program that makes one camera: the same by a workspace of its own.
[[nodiscard]] Result<camera::Camera> make_camera(const CameraSource& source, std::string_view name,
                                                 const std::vector<Override>& overrides = {});
[[nodiscard]] Result<camera::Picture> make_picture(const CameraSource& source,
                                                   std::string_view name,
                                                   const std::vector<Override>& overrides = {});

/// The text of a camera file of at most 1 MB.
[[nodiscard]] Result<std::shared_ptr<const SourceText>> read_text(
    const std::filesystem::path& file);

/// Formats a file's text in the standard layout: the same words and comments in the
/// same order, so that its meaning is unchanged. Idempotent. A text with syntax
/// errors is not formatted.
[[nodiscard]] Result<std::string> format(const std::shared_ptr<const SourceText>& source);

/// A finite number as an expression in the shortest digits that the language reads as this value
/// bit for bit. An angle has the unit of the expression that it replaces, otherwise degrees, or
/// radians if no number of degrees has its value.
[[nodiscard]] std::string literal(double value, bool is_angle, std::string_view instead_of = {});
/// The angle nearest to one in radians that is a number of degrees.
[[nodiscard]] double in_degrees(double radians);

/// The names of the built-in cameras by family: fisheye, panorama, ...
[[nodiscard]] const std::vector<std::string>& built_in_cameras();
/// A built-in camera that words lead to.
struct CameraMatch {
    std::string name;
    bool is_named = false;  ///< All words are in its name, its keywords or its family.
};
/// The built-in cameras that contain the most of some words, such as "flatten a room": in their
/// names, the keywords of their files, their families and their descriptions. The best come first,
/// and map projections last.
[[nodiscard]] std::vector<CameraMatch> search_built_in_cameras(std::string_view words);
/// The remedy for a name that no built-in camera has: those that it leads to, or a similar name.
[[nodiscard]] std::string instead_of_camera(std::string_view name);
/// The family of a built-in camera, which is its folder in cameras/; empty if there is none.
[[nodiscard]] std::string_view family_of(std::string_view built_in_camera);

}  // namespace balcony::lang
