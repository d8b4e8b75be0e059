// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lang: the camera description language (.cam). docs/language.md has the grammar.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/picture.hpp"

namespace balcony::lang {

/// A value for a camera's parameter from outside: --set gamma=1/2.
struct Override {
    std::string name;
    std::string expression;
};

/// What a file says of a camera or a picture without making it.
struct Description {
    struct Parameter {
        std::string name;
        std::string default_text;  ///< As written.
    };

    std::string name;
    std::vector<Parameter> parameters;
    std::string comment;  ///< The comment lines directly above it.
    bool is_picture = false;
    std::vector<std::string> layers;  ///< Of a picture, what it names, from the back to the front.
};

/// Reads what cameras and pictures a file has, in the order of the file.
[[nodiscard]] Result<std::vector<Description>> describe(const std::filesystem::path& file);

/// Makes a camera. `file` is a .cam file or the name of a built-in camera; an empty `name` means
/// the file's last camera. Overrides that the camera does not know are errors; of two for one
/// parameter the last counts. Warnings may come with the camera; --set names the text of an
/// override in what is said of it.
[[nodiscard]] Result<camera::Camera> load_camera(const std::filesystem::path& file,
                                                 std::string_view name,
                                                 const std::vector<Override>& overrides = {});

/// The same from a text; imports are looked for in `folder`.
[[nodiscard]] Result<camera::Camera> make_camera(std::shared_ptr<const SourceText> source,
                                                 std::string_view name,
                                                 const std::vector<Override>& overrides = {},
                                                 const std::filesystem::path& folder = {});

/// Makes a picture, or of a camera the picture that shows it alone. An empty `name` means the
/// file's last camera or picture; else as load_camera().
[[nodiscard]] Result<camera::Picture> load_picture(const std::filesystem::path& file,
                                                   std::string_view name,
                                                   const std::vector<Override>& overrides = {});
[[nodiscard]] Result<camera::Picture> make_picture(std::shared_ptr<const SourceText> source,
                                                   std::string_view name,
                                                   const std::vector<Override>& overrides = {},
                                                   const std::filesystem::path& folder = {});

/// Makes every camera and picture of a file, in its order; cameras as in load_picture(). What
/// several of them show with the same parameters is one camera.
[[nodiscard]] Result<std::vector<camera::Picture>> load_all(
    const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// Makes every camera and picture of a file, to find all that is wrong with it.
[[nodiscard]] Diagnostics check(const std::filesystem::path& file);

/// What a camera or a picture does, in words.
struct Explanation {
    struct Parameter {
        std::string name;
        std::string value;
    };
    /// A statement, in the order in which a picture point goes through them.
    struct Step {
        std::string statement;              ///< "map", "eye", ...
        std::string written;                ///< As in the file; empty if a block follows.
        std::vector<std::string> meanings;  ///< What each stage in it does.
        std::size_t depth = 0;              ///< 1 in the block of the step before.
    };
    struct Layer {
        std::string written;      ///< As in the file: closeup(turn = 30deg).
        std::vector<Step> steps;  ///< What its block says.
        std::size_t shows = 0;    ///< In `shown` of what was asked for.
    };
    std::string name;
    bool is_picture = false;
    std::string summary;
    std::vector<Parameter> parameters;
    std::vector<Step> steps;         ///< Of a camera.
    std::vector<Layer> layers;       ///< Of a picture, from the back to the front.
    std::vector<Explanation> shown;  ///< Of what was asked for: the cameras and pictures in its
                                     ///< layers and theirs, once for the same parameters.
};

/// Explains what load_picture() makes of the same arguments.
[[nodiscard]] Result<Explanation> explain(const std::filesystem::path& file, std::string_view name,
                                          const std::vector<Override>& overrides = {});

/// The text of a camera file of at most 1 MB.
[[nodiscard]] Result<std::shared_ptr<const SourceText>> read_text(
    const std::filesystem::path& file);

/// A file's text in the one layout that all camera files have: the same words and comments in the
/// same order, so that it means the same; laid out again it stays as it is. A text with syntax
/// errors is not laid out.
[[nodiscard]] Result<std::string> format(const std::shared_ptr<const SourceText>& source);

/// The cameras that come with Balcony, by name: pinhole, orthographic, ...
[[nodiscard]] const std::vector<std::string>& built_in_cameras();

}  // namespace balcony::lang
