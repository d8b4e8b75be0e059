// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Data sets: scenes times cameras times poses, as pictures with their rays, depths, normals, flow
// and ids, for programs that learn.
//
//     read_recipe(file) ─▶ Recipe ─▶ make_plan() ─▶ Plan ─▶ make_dataset() ─▶ files, manifest.json
//
// docs/datasets.md describes recipes and files. The same recipe gives the same poses and the same
// files, bit for bit, for any number of threads and shards.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/app.hpp"
#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/keyframes.hpp"
#include "balcony/picture.hpp"
#include "balcony/poses.hpp"
#include "balcony/request.hpp"
#include "balcony/shard.hpp"

namespace balcony::dataset {

using Imath::V3d;

// -------------------------------------------------------------------------------------- recipes

struct SceneChoice {
    std::string name;     ///< Of its folder: letters, digits, '.', '_' and '-'.
    std::string written;  ///< The file as the recipe has it.
    std::string file;     ///< Where it is found.
    SourceSpan span{};
};

struct CameraChoice {
    std::string name;     ///< In the names of files, as that of a scene.
    std::string written;  ///< As the recipe has it: FILE, FILE:NAME, a built-in camera, scene:NAME.
    std::string camera;   ///< Where it is found.
    std::vector<std::string> set{};  ///< Values of its parameters: "fov=90deg".
    SourceSpan span{};
};

/// Angles in radians.
struct AngleRange {
    double least = 0.0;
    double most = 0.0;
};

/// Poses at random in the open: no surface is nearer than the clearance, and each place is in sight
/// of where one stands well in the scene, or of a place before it, so that none is inside an object
/// or behind a wall.
struct RandomPoses {
    std::size_t count = 1;
    std::optional<double>
        clearance{};  ///< In scene units; a fiftieth of the scene's width if empty.
    /// Two corners in the axes of the scene; the bounds of all but its surroundings if empty.
    std::optional<std::array<V3d, 2>> box{};
    AngleRange yaw{-3.141592653589793, 3.141592653589793};  ///< Of the line of sight, level.
    AngleRange pitch{};                                     ///< Upwards.
    AngleRange roll{};                                      ///< Clockwise about the line of sight.
};

/// A place on a path, in the axes of the scene, and a point that is looked at there.
struct PathKey {
    V3d at{0.0};
    V3d look_at{0.0};
    double time = 0.0;  ///< Increasing from key to key, in any unit.
};

/// Poses on a path through keys, at equal steps of time; the last one is at the last key, or, if
/// the path is closed, a step before the first key.
struct PathPoses {
    std::size_t count = 2;
    std::vector<PathKey> keys{};  ///< At least two. Of a closed path, the last one is the first.
    camera::Ease ease = camera::Ease::catmull_rom;
    bool closed = false;
};

struct ListedPoses {
    std::string axes = "opencv";  ///< As app::camera_axes().
    std::vector<app::PoseMatrix> matrices{};
};

struct PoseGroup {
    std::variant<RandomPoses, PathPoses, ListedPoses> poses{};
    SourceSpan span{};
};

struct Recipe {
    std::filesystem::path folder{};  ///< Of the recipe; empty for the current one.
    std::vector<SceneChoice> scenes{};
    std::vector<CameraChoice> cameras{};
    std::vector<PoseGroup> groups{};
    std::uint32_t seed = 0;
    std::string axes = "opencv";         ///< Of cameras in the manifest, as app::camera_axes().
    std::vector<std::string> layers{};   ///< By their names, in the order of layers().
    std::vector<std::string> layouts{};  ///< By their names.
    /// Size, samples, light and what else frames have in common. Its scene, camera, placement,
    /// layers and output are not read.
    app::Request picture{};
};

/// Reads a recipe in TOML. All mistakes are reported, with their places. Names of files are
/// relative to the folder of the recipe.
[[nodiscard]] Result<Recipe> read_recipe(const std::filesystem::path& file);
[[nodiscard]] Result<Recipe> read_recipe(const std::shared_ptr<const SourceText>& text,
                                         const std::filesystem::path& folder);

// ---------------------------------------------------------------------------------------- tables

/// A file that each frame can have.
struct LayerInfo {
    std::string_view name;    ///< Of its folder, too.
    std::string_view ending;  ///< ".png" or ".npy".
    std::string_view shape;   ///< Of its numbers: "height x width x 3, float32".
    std::string_view meaning;
    bool by_default = true;
};
[[nodiscard]] std::span<const LayerInfo> layers();

/// Files of a data set as another program reads them.
struct LayoutInfo {
    std::string_view name;
    std::string_view meaning;
};
[[nodiscard]] std::span<const LayoutInfo> layouts();

// ------------------------------------------------------------------------------------------ plans

/// A model of a lens whose numbers give the rays of a camera: from a direction to a point of the
/// picture, in pixels from the top left corner of the first pixel, whose middle is (0.5, 0.5).
struct Lens {
    std::string_view model;  ///< "pinhole", "opencv", "opencv_fisheye" or "omnidirectional".
    std::vector<std::string_view> names;  ///< Of the numbers: "fx", ...
    std::vector<double> numbers;
    camera::Pose in_camera{};  ///< Where it stands, and what is ahead of it.

    [[nodiscard]] double number(std::string_view name) const;
};

struct PlannedCamera {
    std::string name;
    std::string written;
    std::vector<std::string> set{};
    std::string text;  ///< The file with the camera as it is, its values written into it.
    /// Names and values of its parameters.
    std::vector<std::array<std::string, 2>> parameters{};
    std::array<std::size_t, 2> size{};
    camera::Picture picture;  ///< Where its file has it.
    /// The point from which it sees all; nothing if its rays start at several.
    std::optional<V3d> viewpoint{};
    std::optional<Lens> lens{};  ///< Nothing if no model gives its rays to 1e-6 of a pixel.
};

struct PlannedPose {
    camera::Pose pose{};
    std::size_t group = 0;              ///< Index into Recipe::groups.
    std::optional<std::size_t> next{};  ///< To which its flow goes.
};

struct PlannedScene {
    std::string name;
    std::string written;
    std::string file;
    Axes axes = Axes::y_up;
    double meters_per_unit = 1.0;
    std::vector<std::string> objects{};    ///< By id minus 1.
    std::vector<std::string> materials{};  ///< By id minus 1.
    std::vector<PlannedPose> poses{};
    std::vector<PlannedCamera> cameras{};
};

/// A picture of a data set, with its layers.
struct Frame {
    std::size_t index = 0;
    std::size_t scene = 0;
    std::size_t camera = 0;
    std::size_t pose = 0;
    std::string name;  ///< Of its files, without ending: CAMERA-POSE.
};

struct Plan {
    Recipe recipe;
    std::vector<PlannedScene> scenes{};
    std::vector<Frame> frames{};  ///< Scene by scene, in it camera by camera, pose by pose.
    /// Hashes of the files that the frames depend on, by name.
    std::vector<std::array<std::string, 2>> files{};

    [[nodiscard]] const PlannedPose& pose_of(const Frame& frame) const {
        return scenes[frame.scene].poses[frame.pose];
    }
    [[nodiscard]] const PlannedCamera& camera_of(const Frame& frame) const {
        return scenes[frame.scene].cameras[frame.camera];
    }
};

/// Loads the scenes and the cameras, and finds the poses. A layout that cannot have a camera is an
/// error, which names layouts that can. A stop is an error of Kind::interrupted.
[[nodiscard]] Result<Plan> make_plan(const Recipe& recipe, const app::Observer& observer = {},
                                     const std::stop_token& stop = {});

/// The manifest of a plan, as JSON.
[[nodiscard]] std::string manifest_of(const Plan& plan);

// --------------------------------------------------------------------------------------- making

struct DatasetRequest {
    Recipe recipe;
    std::filesystem::path folder;          ///< Made if it is missing.
    std::optional<render::Shard> shard{};  ///< Every so many frames, as of an animation.
    bool overwrite = false;                ///< Frames that are there are rendered again.
    bool only_plan = false;                ///< Nothing is rendered or written.
    /// While the program has held fewer bytes, scenes stay loaded from the plan to their frames; by
    /// default a quarter of the machine's memory. Others are loaded again.
    std::optional<double> scene_memory{};
};

struct DatasetReport {
    Diagnostics diagnostics;
    bool interrupted = false;
    bool is_planned = false;   ///< Whether what follows is known.
    std::size_t frames = 0;    ///< Of the data set.
    std::size_t selected = 0;  ///< Of the shard.
    std::size_t rendered = 0;
    std::size_t skipped = 0;  ///< Finished before.
    double plan_seconds = 0.0;
    double seconds = 0.0;                ///< Of the frames.
    std::vector<std::string> cameras{};  ///< With the models of their lenses, in words.
};

/// Writes the manifest, the layouts, and the frames that are not finished. Each file is written
/// under a temporary name and renamed. A folder with frames of another recipe is an error of
/// Kind::usage. The same request continues after a stop.
[[nodiscard]] DatasetReport make_dataset(const DatasetRequest& request,
                                         const app::Observer& observer = {},
                                         const std::stop_token& stop = {});

}  // namespace balcony::dataset
