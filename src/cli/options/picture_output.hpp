// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "balcony/display_file.hpp"
#include "balcony/film.hpp"
#include "cli/exit_code.hpp"
#include "cli/options/render_options.hpp"

namespace balcony::cli {

/// Where the picture of a scene goes: a file, or standard output.
class PictureOutput {
public:
    explicit PictureOutput(std::filesystem::path file) : file_(std::move(file)) {}

    [[nodiscard]] bool is_stream() const { return file_ == "-"; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// For messages.
    [[nodiscard]] std::string name() const {
        return is_stream() ? "standard output" : file_.string();
    }
    /// Null for EXR. Standard output is PNG.
    [[nodiscard]] const render::DisplayFormat* display_format() const {
        return render::display_format(is_stream() ? "picture.png" : file_);
    }

    /// Rejects what cannot be written, before rendering.
    [[nodiscard]] ExitCode check(Diagnostics& diagnostics) const;
    /// Rejects a file that is also an input, even under another name or through a link.
    [[nodiscard]] Diagnostics check_inputs(const std::vector<std::filesystem::path>& inputs) const;
    [[nodiscard]] Diagnostics write(const render::Film& film,
                                    const render::DisplayOptions& options) const;

private:
    std::filesystem::path file_;
};

/// The scenes of a command line with the outputs of their pictures.
struct SceneOutput {
    std::string scene;
    PictureOutput output;
    std::optional<camera::StereoFormat> stereo{};
};

/// Expands patterns of scenes such as '*.glb' that the shell has left, and "{scene}" in the name of
/// the output. Without a name, a picture is in this folder and named after its scene. Several
/// scenes need several outputs, and so do eyes.
[[nodiscard]] std::vector<SceneOutput> scene_outputs(const RenderOptions& options,
                                                     const std::optional<StereoRequest>& stereo,
                                                     Diagnostics& diagnostics);

}  // namespace balcony::cli
