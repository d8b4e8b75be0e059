// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/display_file.hpp"
#include "balcony/lang.hpp"
#include "balcony/names.hpp"
#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/check_subjects.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/check_report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

/// A requested false-colour picture.
struct Map {
    analyse::MapKind kind;
    fs::path file;
};

struct CheckOptions {
    std::vector<std::string> files;
    SubjectRequest cameras;
    std::string scene;
    std::optional<double> distance;
    std::vector<Map> maps;
    bool strict = false;
    Manner manner;
};

constexpr double largest_check = 1e12;

std::string names_of_maps() {
    return fmt::format("{}", fmt::join(analyse::map_kinds().all(), ", "));
}

Map read_map(const std::string& name, const std::string& file, Diagnostics& diagnostics) {
    const auto kind = analyse::map_kinds().find(name);
    if (!kind) {
        diagnostics.push_back(app::refused(
            "--map", name,
            did_you_mean(name, analyse::map_kinds().all(), "write " + names_of_maps())));
    }
    if (render::display_format(file) == nullptr) {
        diagnostics.push_back(error(Kind::usage, fmt::format("'{}' cannot be a map", file),
                                    "name a file that ends in .png, .jpg, .webp or .tif"));
    }
    return {kind.value_or(analyse::MapKind::magnification), file};
}

// Whether two names, which need not exist yet, refer to the same file, like a.png and ./a.png.
bool lead_to_one_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(fs::absolute(a, failed), failed);
    return !failed && place == fs::weakly_canonical(fs::absolute(b, failed), failed);
}

void check_together(CheckOptions& options, const app::GivenWords&, Diagnostics& diagnostics) {
    if (!options.cameras.layer.empty() && options.files.size() > 1) {
        diagnostics.push_back(error(Kind::usage,
                                    "--layer refers to one picture, but there are several files",
                                    "name the picture"));
    }
    for (std::size_t i = 0; i < options.maps.size(); ++i) {
        const std::string file = options.maps[i].file.string();
        for (std::size_t j = 0; j < i; ++j) {
            if (lead_to_one_file(options.maps[j].file, file)) {
                diagnostics.push_back(
                    error(Kind::usage,
                          fmt::format("two maps cannot be written to the same file '{}'", file),
                          "name a different file for each"));
            }
        }
    }
}

// None of the maps may replace what is read.
Diagnostics check_overwrites(const std::vector<Map>& maps, std::span<const fs::path> inputs) {
    for (const Map& map : maps) {
        Diagnostics found = app::check_overwrites(map.file, inputs, "--map");
        if (has_errors(found)) {
            return found;
        }
    }
    return {};
}

app::Option<CheckOptions> map_option() {
    return app::custom_option<CheckOptions>(
        {.name = "--map",
         .placeholder = "KIND FILE",
         .meaning = "write a false-colour picture; may be repeated. KIND is " + names_of_maps(),
         .repeated = true,
         .words = 2,
         .type = OptionType::choice,
         .choices = app::choices_of(analyse::map_kinds())},
        [](std::span<const std::string> words, CheckOptions& options, Diagnostics& diagnostics) {
            for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
                options.maps.push_back(read_map(words[i], words[i + 1], diagnostics));
            }
        },
        [](const CheckOptions& options) {
            std::vector<std::string> words;
            for (const Map& map : options.maps) {
                words.emplace_back(analyse::map_kinds()[map.kind].name);
                words.push_back(map.file.string());
            }
            return words;
        });
}

std::size_t count_pictures(const std::vector<lang::Description>& all) {
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](const auto& one) { return one.is_picture; }));
}

/// What was made for an argument.
struct Checked {
    std::string argument;
    std::string file;
    Result<std::vector<CheckSubject>> subjects;
};

/// One run of the command. It collects the output for the terminal or for JSON.
class Run {
public:
    Run(const CheckOptions& options, lang::Workspace& workspace)
        : options_(options), workspace_(workspace) {}

    ExitCode operator()(const std::vector<Checked>& all) {
        if (!options_.scene.empty()) {
            read_scene();
        }
        if (!scene_) {
            job_.emplace();
        }
        if (all_.is_done()) {
            for (const Checked& checked : all) {
                if (!stopped_) {
                    check_file(checked);
                }
            }
        }
        if (options_.manner.json) {
            print_json(to_json(all_));
        }
        return exit_code_of(all_.diagnostics);
    }

private:
    // Text is printed at once, JSON at the end.
    void add(const Diagnostics& diagnostics) {
        all_.add(diagnostics);
        stopped_ = stopped_ || kind_of_errors(diagnostics) == Kind::interrupted;
        if (!options_.manner.json) {
            report(diagnostics);
        }
    }

    void print(const std::string& text) const {
        if (!options_.manner.json) {
            print_result(text);
        }
    }

    void read_scene() {
        Result<scene::Scene> loaded = app::load_scene(options_.scene, options_.cameras.time);
        add(loaded.diagnostics);
        if (!loaded) {
            return;
        }
        scene_ = std::make_shared<const scene::Scene>(std::move(*loaded));
        auto renderer = render::Renderer::make(scene_, {.textures_on_demand = true});
        add(renderer.diagnostics);
        renderer_ = std::move(renderer.value);
        if (renderer_) {
            add(check_overwrites(options_.maps, scene_->files));
        }
    }

    void check_file(const Checked& checked) {
        add(checked.subjects.diagnostics);
        const auto cameras = workspace_.describe(checked.file);
        const std::size_t pictures = cameras ? count_pictures(*cameras) : 0;
        const std::size_t count = cameras ? cameras->size() - pictures : 0;
        nlohmann::json entry{{"file", checked.file},
                             {"cameras", count},
                             {"pictures", pictures},
                             {"good", static_cast<bool>(checked.subjects)},
                             {"reports", nlohmann::json::array()}};
        if (checked.subjects) {
            print(fmt::format("{}: {}{}, no errors\n", printable(checked.file),
                              counted(count, "camera", "cameras"),
                              pictures > 0 ? ", " + counted(pictures, "picture", "pictures") : ""));
            for (const CheckSubject& subject : *checked.subjects) {
                if (!stopped_) {
                    check_camera(subject, entry["reports"]);
                }
            }
        }
        all_.facts["files"].push_back(std::move(entry));
    }

    void check_camera(const CheckSubject& subject, nlohmann::json& reports) {
        analyse::DiagnoseSettings settings;
        settings.width = subject.width;
        settings.height = subject.height;
        settings.time = options_.cameras.time;
        settings.distance = options_.distance;
        CameraCheck check;
        check.has_lens = subject.camera.parts().lens != nullptr;
        check.by_itself = subject.by_itself;
        check.layers = subject.layers;
        if (renderer_) {
            const Result<render::Probe> probe = look_at(subject);
            if (!probe) {
                add(probe.diagnostics);
                return;
            }
            check.in_scene = in_scene(*scene_, *probe);
            if (!probe->median_distance && probe->rays > 0) {
                explain_empty_view(subject, *check.in_scene);
            }
            scene_distance_ = probe->median_distance;
        }
        if (scene_) {
            job_.emplace();
        }
        const std::stop_token stop = job_->token();
        Result<analyse::Report> report = analyse::diagnose(subject.camera, settings, {}, stop);
        if (report && scene_distance_ && !settings.distance && !report->single_viewpoint) {
            settings.distance = scene_distance_;
            report = analyse::diagnose(subject.camera, settings, {}, stop);
        }
        if (scene_) {
            job_.reset();
        }
        add(report.diagnostics);
        if (!report) {
            return;
        }
        check.report = std::move(*report);
        finish(check, reports);
    }

    // Rays are at most one pixel apart, or further in a very large picture to limit the work.
    [[nodiscard]] Result<render::Probe> look_at(const CheckSubject& subject) const {
        constexpr double max_pixels = 16e6;
        const double scale = std::max(1.0, std::sqrt(subject.width * subject.height / max_pixels));
        const auto scaled = [scale](double side) {
            return static_cast<std::size_t>(std::max(1.0, std::round(side / scale)));
        };
        const std::size_t width = scaled(subject.width);
        const std::size_t height = scaled(subject.height);
        Result<render::Probe> probe =
            render::probe(*renderer_, subject.camera,
                          {.width = width, .height = height, .time = options_.cameras.time});
        if (probe) {
            for (render::ObjectSight& sight : probe->objects) {
                sight.inside_at.x *= subject.width / static_cast<double>(width);
                sight.inside_at.y *= subject.height / static_cast<double>(height);
            }
        }
        return probe;
    }

    void explain_empty_view(const CheckSubject& subject, CameraCheck::InScene& found) const {
        const Result<render::Miss> miss =
            render::explain_miss(*renderer_, subject.camera,
                                 {.width = static_cast<std::size_t>(subject.width),
                                  .height = static_cast<std::size_t>(subject.height),
                                  .time = options_.cameras.time});
        if (miss && found.never_seen.size() == scene_->objects.size()) {
            found.miss = app::miss_text(*miss, subject.camera);
        }
    }

    void finish(const CameraCheck& check, nlohmann::json& reports) {
        reports.push_back(check_json(check));
        print(check_text(check));
        for (const Map& map : options_.maps) {
            write_map(check.report, map);
        }
        if (options_.strict && check.defect_count() > 0) {
            add({error(fmt::format("camera '{}' has {}, but --strict allows none", check.title(),
                                   counted(check.defect_count(), "defect", "defects")))});
        }
    }

    void write_map(const analyse::Report& report, const Map& map) {
        // Check before computing a large picture that cannot be written.
        const Diagnostics refused = OutputFile::check(map.file);
        if (has_errors(refused)) {
            add(refused);
            return;
        }
        const Image image = analyse::false_color(report, map.kind);
        const Diagnostics diagnostics =
            render::write_samples(image.samples, {image.width, image.height, 3}, map.file);
        add(diagnostics);
        if (!has_errors(diagnostics)) {
            print(line_of_map(map));
        }
    }

    static std::string line_of_map(const Map& map) {
        return fmt::format("  {:<14} {}\n", "map", printable(map.file.string()));
    }

    const CheckOptions& options_;
    lang::Workspace& workspace_;
    std::shared_ptr<const scene::Scene> scene_;
    std::optional<render::Renderer> renderer_;
    std::optional<double> scene_distance_;
    std::optional<Job> job_;  ///< Not while rays look at a scene, which cannot be stopped.
    bool stopped_ = false;
    Answer all_{.facts = {{"files", nlohmann::json::array()}}};
};

// A map shows one camera. Other mistakes are found when the cameras are analysed.
void check_one_camera(const std::vector<Checked>& all, Diagnostics& diagnostics) {
    const Checked& first = all.front();
    if (all.size() == 1 && (!first.subjects || first.subjects->size() == 1)) {
        return;
    }
    std::vector<std::string> choice;
    for (std::size_t i = 0; first.subjects && i < first.subjects->size(); ++i) {
        const CheckSubject& subject = (*first.subjects)[i];
        for (const CameraCheck::Layer& layer : subject.layers) {
            choice.push_back(fmt::format("{} for {}", layer.number, subject.camera.name()));
        }
    }
    const bool of_picture = all.size() == 1 && first.argument != first.file;
    diagnostics.push_back(
        error(Kind::usage, "--map shows one camera, but there are several",
              of_picture ? fmt::format("choose one with --layer: {}", fmt::join(choice, ", "))
                         : fmt::format("name it: {}:NAME", first.file)));
}

ExitCode check_command(const CheckOptions& options) {
    lang::Workspace workspace;
    std::vector<Checked> all;
    for (const std::string& argument : options.files) {
        all.push_back({argument, app::camera_file(argument).string(),
                       check_subjects(argument, options.cameras, workspace)});
    }
    Answer refused;
    if (!options.maps.empty()) {
        check_one_camera(all, refused.diagnostics);
        refused.add(check_overwrites(options.maps, workspace.files()));
    }
    return refused.is_done() ? Run(options, workspace)(all) : give(refused, options.manner);
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, CheckOptions& options) {
        app::Options<CheckOptions> all{
            {app::words({.name = "FILE",
                         .meaning = "camera files, cameras or pictures in them (FILE:NAME), or "
                                    "built-in cameras",
                         .required = true,
                         .type = OptionType::camera},
                        &CheckOptions::files)}};
        all.add(&CheckOptions::cameras, {{app::set_option(&SubjectRequest::set),
                                          app::time_option(largest_check, &SubjectRequest::time)}});
        all.rows.push_back(scene_option(
            &CheckOptions::scene,
            "scene file: also report objects that are never visible and rays that start inside an "
            "object"));
        app::Options<SubjectRequest> picture;
        picture.add(&SubjectRequest::size,
                    app::size_options("size of the picture in pixels (default: about a million "
                                      "pixels, with the camera's aspect ratio)"));
        picture.add(&SubjectRequest::size, app::aspect_options());
        picture.rows.push_back(
            option({.name = "--layer",
                    .placeholder = "NUMBER",
                    .meaning = "analyse only this layer of the picture: 1 is at the back, 3.1 is "
                               "in the picture of layer 3"},
                   text(), &SubjectRequest::layer));
        all.add(&CheckOptions::cameras, std::move(picture));
        all.add({{option({.name = "--distance",
                          .placeholder = "UNITS",
                          .meaning = "distance from the ray origins at which magnification is "
                                     "measured; auto depends on the scene or, without one, on the "
                                     "camera"},
                         app::or_word("auto",
                                      app::number(1e-12, largest_check,
                                                  "give auto, or a distance above 0 in scene units",
                                                  "scene units")),
                         &CheckOptions::distance),
                  map_option(),
                  flag({.name = "--strict",
                        .meaning = "exit with code 1 if a camera has a defect: a fold, a seam, a "
                                   "region without rays, ..."},
                       true, &CheckOptions::strict),
                  json_flag(&CheckOptions::manner, "print the report as JSON")},
                 {check_together}});
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony check gallery.cam room.cam\n"
            "  balcony check gallery.cam:closeup --scene gallery.glb --strict\n"
            "  balcony check gallery.cam:poster --layer 2 --map anisotropy inset.png\n"
            "  balcony check superelliptic --set gamma=1/2 --map magnification size.png");
    };
    add_command<CheckOptions>(app, code, "check",
                              "reports mistakes in camera files and defects of their cameras",
                              check_command, describe);
}

}  // namespace balcony::cli
