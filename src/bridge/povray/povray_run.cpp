// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/povray_run.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "bridge/povray/process.hpp"

namespace balcony::bridge::povray {

PovrayRun::PovrayRun(const PovrayProgram& program, const PovraySettings& settings,
                     const AxesRow& axes, TemporaryFolder folder,
                     std::filesystem::path scene_folder, std::shared_ptr<const SourceText> scene,
                     std::string scene_bytes)
    : program_(program),
      settings_(settings),
      axes_(axes),
      folder_(std::move(folder)),
      scene_bytes_(std::move(scene_bytes)),
      places_{std::move(scene), folder_.path() / "scene.pov", std::move(scene_folder)} {}

std::filesystem::path PovrayRun::picture_file() const {
    return folder_.path() / (settings_.unclipped ? "picture.exr" : "picture.png");
}

// The user's options come after what they may change and before what they must not.
std::vector<std::string> PovrayRun::arguments(std::size_t width, std::size_t height) const {
    std::vector<std::string> words{"-A", "+V"};
    words.insert(words.end(), settings_.options.begin(), settings_.options.end());
    for (const std::string& word :
         {"+I" + places_.copy.string(), "+O" + picture_file().string(),
          std::string(settings_.unclipped ? "+FE" : "+FN16"), std::string("File_Gamma=sRGB"),
          fmt::format("+W{}", width), fmt::format("+H{}", height),
          fmt::format("+K{:.17g}", settings_.time), std::string("Initial_Frame=1"),
          std::string("Final_Frame=1"), std::string("-C"), std::string("-D"), std::string("-P"),
          std::string("All_Console=On"), std::string("Output_to_File=On")}) {
        words.push_back(word);
    }
    return words;
}

Diagnostics PovrayRun::write_scene(const MeshPicture& picture, const MeshFrame& frame) const {
    return povray::write_scene(places_.copy, scene_bytes_, picture, frame, axes_);
}

RunEnd PovrayRun::render(std::size_t width, std::size_t height,
                         const std::function<void(double)>& show,
                         const std::stop_token& stop) const {
    std::string tail;
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result = run_process(
        {program_.file, arguments(width, height), places_.folder},
        [&](std::string_view part) {
            constexpr std::size_t line = 200;
            tail = tail.substr(tail.size() > line ? tail.size() - line : 0) + std::string(part);
            if (const auto done = read_progress(tail)) {
                show(*done);
            }
        },
        stop);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (stop.stop_requested()) {
        return {{}, seconds.count()};
    }
    RunEnd end{read_messages(result.output, places_), seconds.count()};
    if (result.exit_code == 0 || has_errors(end.diagnostics)) {
        return end;
    }
    end.diagnostics.push_back(
        result.exit_code
            ? error(Kind::environment,
                    fmt::format("POV-Ray has ended with exit code {} and without a message",
                                *result.exit_code))
            : error(Kind::environment,
                    fmt::format("'{}' could not be started, or was ended by a signal",
                                program_.file.string()),
                    "the machine may be out of memory: make the picture smaller"));
    return end;
}

Result<LightFile> PovrayRun::open_picture(std::size_t width, std::size_t height) const {
    return LightFile::open(picture_file(), width, height);
}

}  // namespace balcony::bridge::povray
