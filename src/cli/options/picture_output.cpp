// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/picture_output.hpp"

#include <map>

#include <fmt/format.h>
#include <glob.h>
#include <unistd.h>

#include "balcony/images.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view place_of_scene = "{scene}";

// The files that match a pattern, sorted; the pattern itself if it is a file or matches none.
std::vector<std::string> matches_of(const std::string& pattern) {
    std::error_code ignored;
    if (fs::exists(pattern, ignored) || pattern.find_first_of("*?[") == std::string::npos) {
        return {pattern};
    }
    glob_t found{};
    std::vector<std::string> names;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0) {
        names.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    }
    globfree(&found);
    return names.empty() ? std::vector{pattern} : names;
}

std::string stem_of(const std::string& scene) {
    const std::string stem = fs::path(scene).stem().string();
    return stem.empty() || stem.front() == '.' ? "picture" : stem;
}

fs::path output_for(const std::string& scene, const std::optional<std::string>& written) {
    if (!written) {
        return stem_of(scene) + ".png";
    }
    std::string name = *written;
    for (std::size_t at = name.find(place_of_scene); at != std::string::npos;
         at = name.find(place_of_scene, at)) {
        const std::string stem = stem_of(scene);
        name.replace(at, place_of_scene.size(), stem);
        at += stem.size();
    }
    return name;
}

std::vector<SceneOutput> with_stereo(const std::vector<SceneOutput>& pictures,
                                     const StereoRequest& stereo) {
    std::vector<SceneOutput> made;
    for (const SceneOutput& picture : pictures) {
        const fs::path& file = picture.output.file();
        for (const camera::StereoFormat format : stereo.formats) {
            made.push_back({picture.scene,
                            stereo.has_two_files() ? PictureOutput(app::file_of_eye(file, format))
                                                   : picture.output,
                            format});
        }
    }
    return made;
}

}  // namespace

ExitCode PictureOutput::check(Diagnostics& diagnostics) const {
    if (is_stream()) {
        if (isatty(STDOUT_FILENO) == 0) {
            diagnostics = images::require();
            return diagnostics.empty() ? ExitCode::done : ExitCode::environment;
        }
        diagnostics.push_back(error("a picture cannot be shown on a terminal", {},
                                    "redirect the output: balcony render ... -o - > picture.png"));
        return ExitCode::wrong_usage;
    }
    std::error_code ignored;
    if (fs::is_directory(file_, ignored)) {
        diagnostics.push_back(
            error(fmt::format("'{}' is a folder", file_.string()), {},
                  fmt::format("name a file in it: {}", (file_ / "{scene}.png").string())));
        return ExitCode::wrong_usage;
    }
    const Diagnostics found = render::check_output(file_);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return !has_errors(found)                                          ? ExitCode::done
           : display_format() != nullptr || ending_of(file_) == ".exr" ? ExitCode::environment
                                                                       : ExitCode::wrong_usage;
}

Diagnostics PictureOutput::check_inputs(const std::vector<fs::path>& inputs) const {
    for (const fs::path& input : inputs) {
        std::error_code failed;
        if (fs::equivalent(input, file_, failed) && !failed) {
            return {error(fmt::format("'{}' is part of the scene and would be overwritten", name()),
                          {}, "name another picture with --output")};
        }
    }
    return {};
}

Diagnostics PictureOutput::write(const render::Film& film,
                                 const render::DisplayOptions& options) const {
    if (!is_stream()) {
        return render::write(film, file_, options);
    }
    const auto bytes = render::encode(film, *display_format(), options);
    if (bytes) {
        print_bytes(*bytes);
    }
    return bytes.diagnostics;
}

std::vector<SceneOutput> scene_outputs(const RenderOptions& options,
                                       const std::optional<StereoRequest>& stereo,
                                       Diagnostics& diagnostics) {
    std::vector<SceneOutput> made;
    std::map<fs::path, std::string> scenes;
    for (const std::string& pattern : options.scenes) {
        for (const std::string& scene : matches_of(pattern)) {
            made.push_back({scene, PictureOutput(output_for(scene, options.output))});
            const fs::path& file = made.back().output.file();
            const auto [other, is_new] = scenes.try_emplace(file.lexically_normal(), scene);
            if (!is_new) {
                const bool has_place =
                    !options.output || options.output->find(place_of_scene) != std::string::npos;
                diagnostics.push_back(
                    error(fmt::format("the pictures of '{}' and '{}' would both be '{}'",
                                      other->second, scene, file.string()),
                          {},
                          has_place ? "render scenes of one name in separate runs"
                                    : "write {scene} where the name of the scene belongs: "
                                      "--output 'pictures/{scene}.png'"));
                return {};
            }
        }
    }
    return stereo ? with_stereo(made, *stereo) : made;
}

}  // namespace balcony::cli
