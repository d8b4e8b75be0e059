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

/// A value for a camera's parameter from the command line: --set gamma=1/2.
struct Override {
    std::string name;
    std::string expression;
};

/// The declaration of a camera or a picture in a file.
struct Description {
    struct Parameter {
        std::string name;
        std::string default_text;  ///< The source text.
    };

    std::string name;
    std::vector<Parameter> parameters;
    std::string comment;  ///< The comment lines directly above it.
    bool is_picture = false;
    std::vector<std::string> layers;  ///< The names in a picture's layers, from back to front.
};

/// Reads the declarations of a file's cameras and pictures, in the order of the file.
[[nodiscard]] Result<std::vector<Description>> describe(const std::filesystem::path& file);

/// Makes a camera. `file` is a .cam file or the name of a built-in camera; an empty `name` means
/// the file's last camera. Overrides of unknown parameters are errors; of two for the same
/// parameter, the last one applies. Warnings may accompany the camera. In diagnostics, --set is the
/// name of the text of an override.
[[nodiscard]] Result<camera::Camera> load_camera(const std::filesystem::path& file,
                                                 std::string_view name,
                                                 const std::vector<Override>& overrides = {});

/// The same from a text; imports are searched in `folder`.
[[nodiscard]] Result<camera::Camera> make_camera(std::shared_ptr<const SourceText> source,
                                                 std::string_view name,
                                                 const std::vector<Override>& overrides = {},
                                                 const std::filesystem::path& folder = {});

/// Makes a picture; a camera becomes a picture with one layer. An empty `name` means the
/// file's last camera or picture; otherwise like load_camera().
[[nodiscard]] Result<camera::Picture> load_picture(const std::filesystem::path& file,
                                                   std::string_view name,
                                                   const std::vector<Override>& overrides = {});
[[nodiscard]] Result<camera::Picture> make_picture(std::shared_ptr<const SourceText> source,
                                                   std::string_view name,
                                                   const std::vector<Override>& overrides = {},
                                                   const std::filesystem::path& folder = {});

/// Makes all cameras and pictures of a file, in its order; cameras as in load_picture(). A camera
/// that several of them show with the same parameters is shared.
[[nodiscard]] Result<std::vector<camera::Picture>> load_all(
    const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// Makes all cameras and pictures of a file, to find all mistakes in it.
[[nodiscard]] Diagnostics check(const std::filesystem::path& file);

/// A description of a camera or a picture.
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
    std::vector<Step> steps;         ///< The steps of a camera.
    std::vector<Layer> layers;       ///< The layers of a picture, from back to front.
    std::vector<Explanation> shown;  ///< For the whole explanation: the cameras and pictures in its
                                     ///< layers and theirs, once for the same parameters.
};

/// Explains the result of load_picture() for the same arguments.
[[nodiscard]] Result<Explanation> explain(const std::filesystem::path& file, std::string_view name,
                                          const std::vector<Override>& overrides = {});

/// The text of a camera file of at most 1 MB.
[[nodiscard]] Result<std::shared_ptr<const SourceText>> read_text(
    const std::filesystem::path& file);

/// Formats a file's text in the standard layout: the same words and comments in the
/// same order, so that its meaning is unchanged. Idempotent. A text with syntax
/// errors is not formatted.
[[nodiscard]] Result<std::string> format(const std::shared_ptr<const SourceText>& source);

/// The names of the built-in cameras: pinhole, orthographic, ...
[[nodiscard]] const std::vector<std::string>& built_in_cameras();

}  // namespace balcony::lang
