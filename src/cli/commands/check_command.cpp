// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "balcony/studies.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/check_report.hpp"

namespace balcony::cli {

namespace {

using app::CameraCheck;
using app::CheckRequest;
using app::MapFile;

struct CheckOptions {
    CheckRequest request;
    bool strict = false;
    Manner manner;
};

constexpr double largest_check = 1e12;

std::string names_of_maps() {
    return fmt::format("{}", fmt::join(analyse::map_kinds().all(), ", "));
}

MapFile read_map(const std::string& name, const std::string& file, Diagnostics& diagnostics) {
    const auto kind = analyse::map_kinds().find(name);
    if (!kind) {
        diagnostics.push_back(app::refused(
            "--map", name,
            did_you_mean(name, analyse::map_kinds().all(), "write " + names_of_maps())));
    }
    return {kind.value_or(analyse::MapKind::magnification), file};
}

app::Option<CheckRequest> map_option() {
    return app::custom_option<CheckRequest>(
        {.name = "--map",
         .placeholder = "KIND FILE",
         .meaning = "write a false-colour picture; may be repeated. KIND is " + names_of_maps(),
         .repeated = true,
         .words = 2,
         .type = OptionType::choice,
         .choices = app::choices_of(analyse::map_kinds())},
        [](std::span<const std::string> words, CheckRequest& request, Diagnostics& diagnostics) {
            for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
                request.maps.push_back(read_map(words[i], words[i + 1], diagnostics));
            }
        },
        [](const CheckRequest& request) {
            std::vector<std::string> words;
            for (const MapFile& map : request.maps) {
                words.emplace_back(analyse::map_kinds()[map.kind].name);
                words.push_back(map.file.string());
            }
            return words;
        });
}

std::string text_of(const app::FileCheck& file) {
    return fmt::format("{}: {}{}, no errors\n", printable(file.file),
                       counted(file.cameras, "camera"),
                       file.pictures > 0 ? ", " + counted(file.pictures, "picture") : "");
}

nlohmann::json json_of(const app::FileCheck& file) {
    nlohmann::json reports = nlohmann::json::array();
    for (const CameraCheck& check : file.checks) {
        reports.push_back(check_json(check));
    }
    return {{"file", file.file},
            {"cameras", file.cameras},
            {"pictures", file.pictures},
            {"good", file.good},
            {"reports", std::move(reports)}};
}

Diagnostics check_strictly(const CameraCheck& check) {
    if (check.defect_count() == 0) {
        return {};
    }
    return {error(fmt::format("camera '{}' has {}, but --strict allows none", check.title(),
                              counted(check.defect_count(), "defect")))};
}

// Text is printed at once, JSON at the end.
ExitCode check_command(const CheckOptions& options) {
    Answer answer;
    const auto tell = [&](const Diagnostics& found) {
        answer.add(found);
        if (!options.manner.json) {
            report(found);
        }
    };
    const bool prints = !options.manner.json && !options.manner.quiet;
    app::CheckObserver observer{.tell = tell};
    observer.file = [&](const app::FileCheck& file) {
        if (file.good && prints) {
            print_result(text_of(file));
        }
    };
    observer.camera = [&](const CameraCheck& check) {
        if (prints) {
            print_result(check_text(check));
        }
        if (options.strict) {
            tell(check_strictly(check));
        }
    };
    const Interruptible work;
    const app::CheckReport found = app::check(options.request, observer, work.token());
    if (options.manner.json) {
        answer.facts["files"] = nlohmann::json::array();
        for (const app::FileCheck& file : found.files) {
            answer.facts["files"].push_back(json_of(file));
        }
        print_json(to_json(answer));
    }
    return exit_code_of(answer.diagnostics);
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, CheckOptions& options) {
        app::Options<CheckRequest> request{
            {app::words({.name = "FILE",
                         .meaning = "camera files, cameras or pictures in them (FILE:NAME), or "
                                    "built-in cameras",
                         .required = true,
                         .type = OptionType::camera},
                        &CheckRequest::files),
             app::set_option(&CheckRequest::set),
             app::time_option(largest_check, &CheckRequest::time),
             scene_option(&CheckRequest::scene,
                          "scene file: also report objects that are never visible and rays that "
                          "start inside an object"),
             app::unit_option(&CheckRequest::meters_per_unit)}};
        request.add(&CheckRequest::placement, app::placement_options());
        request.add(&CheckRequest::size,
                    app::size_options("size of the picture in pixels (default: about a million "
                                      "pixels, with the camera's aspect ratio)"));
        request.add(&CheckRequest::size, app::aspect_options());
        request.add(
            {{option({.name = "--layer",
                      .placeholder = "NUMBER",
                      .meaning = "analyse only this layer of the picture: 1 is at the back, 3.1 "
                                 "is in the picture of layer 3"},
                     text(), &CheckRequest::layer),
              option({.name = "--distance",
                      .placeholder = "UNITS",
                      .meaning = "distance from the ray origins at which magnification is "
                                 "measured; auto depends on the scene or, without one, on the "
                                 "camera"},
                     app::or_word("auto",
                                  app::number(1e-12, largest_check,
                                              "give auto, or a distance above 0 in scene units",
                                              "scene units")),
                     &CheckRequest::distance),
              map_option()}});
        app::Options<CheckOptions> all;
        all.add(&CheckOptions::request, std::move(request));
        all.add({{flag({.name = "--strict",
                        .meaning = "exit with code 1 if a camera has a defect: a fold, a seam, a "
                                   "region without rays, ..."},
                       true, &CheckOptions::strict)}});
        all.add(manner_options(&CheckOptions::manner, "print the report as JSON"));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony check my.cam\n"
            "  balcony check my.cam:closeup --scene room.glb --fit --strict\n"
            "  balcony check my.cam:poster --layer 2 --map anisotropy inset.png\n"
            "  balcony check superelliptic --set gamma=1/2 --map magnification size.png");
    };
    add_command<CheckOptions>(app, code, "check",
                              "reports mistakes in camera files and defects of their cameras",
                              check_command, describe);
}

}  // namespace balcony::cli
