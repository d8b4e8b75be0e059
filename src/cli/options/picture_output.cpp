// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/picture_output.hpp"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>
#include <unistd.h>

#include "balcony/animation.hpp"

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

}  // namespace

Diagnostics check_output(const fs::path& output) {
    if (output == "-" && isatty(STDOUT_FILENO) != 0) {
        return {error(Kind::usage, "a picture cannot be shown on a terminal",
                      "redirect the output: balcony render ... -o - > picture.png")};
    }
    if (app::names_film(output)) {
        return {error(Kind::usage,
                      fmt::format("'{}' is a film, but this makes a picture", output.string()),
                      fmt::format("balcony animate makes films: {}",
                                  fmt::join(app::film_extensions(), ", ")))};
    }
    return app::check_output(output);
}

std::vector<app::Request> pictures_of(const std::vector<std::string>& scenes,
                                      const std::optional<std::string>& output,
                                      const app::Request& request, Diagnostics& diagnostics) {
    std::vector<app::Request> made;
    std::map<fs::path, std::string> known;
    for (const std::string& pattern : scenes) {
        for (const std::string& scene : matches_of(pattern)) {
            app::Request one = request;
            one.scene = scene;
            one.output = output_for(scene, output);
            const auto [other, is_new] = known.try_emplace(one.output.lexically_normal(), scene);
            if (!is_new) {
                const bool has_place = !output || output->find(place_of_scene) != std::string::npos;
                diagnostics.push_back(
                    error(Kind::usage,
                          fmt::format("the pictures of '{}' and '{}' would both be '{}'",
                                      other->second, scene, one.output.string()),
                          has_place ? "render scenes of one name in separate runs"
                                    : "write {scene} where the name of the scene belongs: "
                                      "--output 'pictures/{scene}.png'"));
                return {};
            }
            const std::vector<app::Request> eyes = app::pictures_of(one);
            made.insert(made.end(), eyes.begin(), eyes.end());
        }
    }
    return made;
}

}  // namespace balcony::cli
