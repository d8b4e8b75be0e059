// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "balcony/povray.hpp"
#include "bridge/povray/light_file.hpp"
#include "bridge/povray/messages.hpp"
#include "bridge/povray/scene_file.hpp"
#include "bridge/povray/temporary_folder.hpp"

namespace balcony::bridge::povray {

/// How a run of POV-Ray ended: with errors unless it was complete or stopped on request.
struct RunEnd {
    Diagnostics diagnostics;
    double seconds = 0.0;
};

/// Runs POV-Ray on one scene, again and again.
class PovrayRun {
public:
    PovrayRun(const PovrayProgram& program, const PovraySettings& settings, const AxesRow& axes,
              TemporaryFolder folder, std::filesystem::path scene_folder,
              std::shared_ptr<const SourceText> scene, std::string scene_bytes);

    /// Writes the copy of the scene with the mesh as its camera.
    [[nodiscard]] Diagnostics write_scene(const MeshPicture& picture, const MeshFrame& frame) const;
    /// Renders it. `show` receives the part that is done, from 0 to 1.
    [[nodiscard]] RunEnd render(std::size_t width, std::size_t height,
                                const std::function<void(double)>& show,
                                const std::stop_token& stop) const;
    /// The picture of the last run.
    [[nodiscard]] Result<LightFile> open_picture(std::size_t width, std::size_t height) const;

private:
    [[nodiscard]] std::vector<std::string> arguments(std::size_t width, std::size_t height) const;
    [[nodiscard]] std::filesystem::path picture_file() const;

    const PovrayProgram& program_;
    const PovraySettings& settings_;
    const AxesRow& axes_;
    TemporaryFolder folder_;
    std::string scene_bytes_;
    ScenePlaces places_;
};

}  // namespace balcony::bridge::povray
