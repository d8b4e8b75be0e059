// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A picture in progress: its film, its file, and its checkpoint.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include "balcony/denoise.hpp"
#include "balcony/render.hpp"
#include "cli/checkpoint_file.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/progress_display.hpp"

namespace balcony::cli {

/// What the options ask of every picture.
struct Request {
    render::Settings settings;
    std::optional<double> exposure;  ///< Chosen automatically if empty.
    render::ViewTransform view;
    PictureSize size;
    render::LayerSet layers;
    Crop crop;
    JobRequest job;
    std::size_t texture_memory = render::default_texture_memory;
    std::optional<render::DenoiseOptions> denoise;
    std::optional<StereoRequest> stereo{};
    std::vector<std::string> added{};                       ///< Scenes that join each scene.
    Diagnostics warnings{};                                 ///< Of files that all pictures share.
    FileWatch::Time since = FileWatch::Time::clock::now();  ///< Before the files were read.
};

class PictureRun {
public:
    /// The files are those that the picture is made of. All arguments must outlive the run.
    PictureRun(const RenderOptions& options, const Request& request,
               std::vector<std::filesystem::path> files, const PictureOutput& output,
               render::Film& film);

    [[nodiscard]] CheckpointFile& checkpoint() { return checkpoint_; }

    /// Continues from the checkpoint if that is asked for and there is one.
    [[nodiscard]] Diagnostics resume();

    /// Renders to the end, the time limit or a stop. Saves the picture and the checkpoint at their
    /// intervals, and the checkpoint once more at a stop. A run that is interrupted without a stop
    /// ended because a texture vanished.
    [[nodiscard]] Result<render::Summary> run(render::Job& job,
                                              const render::ProgressCallback& progress,
                                              const std::stop_token& stop);

    /// The requested exposure, or that of the film so far.
    [[nodiscard]] double exposure() const;
    [[nodiscard]] Diagnostics save() const;
    /// Instead, if the request is for a shard.
    [[nodiscard]] Diagnostics save_shard();

private:
    [[nodiscard]] bool writes_checkpoints() const;
    void tell(const Diagnostics& diagnostics);

    const RenderOptions& options_;
    const Request& request_;
    const PictureOutput& output_;
    render::Film& film_;
    ProgressDisplay display_;
    CheckpointFile checkpoint_;
};

}  // namespace balcony::cli
