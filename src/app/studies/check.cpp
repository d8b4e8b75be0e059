// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/inputs/placement.hpp"
#include "app/inputs/true_scale.hpp"
#include "app/request_check.hpp"
#include "app/studies/check_subjects.hpp"
#include "app/words.hpp"
#include "balcony/display_file.hpp"
#include "balcony/output_file.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/render.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

/// What was made of one of the request's files.
struct Subjects {
    std::string argument;
    std::string file;
    Result<std::vector<CheckSubject>> cameras;
};

bool shows_scale(std::span<const MapFile> maps) {
    return std::any_of(maps.begin(), maps.end(),
                       [](const MapFile& map) { return map.kind == analyse::MapKind::scale; });
}

// Whether two names, which need not exist yet, refer to the same file, like a.png and ./a.png.
bool lead_to_one_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(fs::absolute(a, failed), failed);
    return !failed && place == fs::weakly_canonical(fs::absolute(b, failed), failed);
}

// What is wrong with the maps before anything is read.
Diagnostics check_maps(std::span<const MapFile> maps, bool has_scene) {
    Diagnostics found;
    if (shows_scale(maps) && !has_scene) {
        found.push_back(error(Kind::usage, "--map scale needs a scene, whose surfaces it shows",
                              "add --scene FILE"));
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const fs::path& file = maps[i].file;
        if (render::display_format(file) == nullptr) {
            found.push_back(error(Kind::usage, fmt::format("'{}' cannot be a map", file.string()),
                                  "name a file that ends in .png, .jpg, .webp or .tif"));
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (lead_to_one_file(maps[j].file, file)) {
                found.push_back(error(
                    Kind::usage,
                    fmt::format("two maps cannot be written to the same file '{}'", file.string()),
                    "name a different file for each"));
            }
        }
    }
    return found;
}

// None of the maps may replace what is read.
Diagnostics check_overwrites(std::span<const MapFile> maps, std::span<const fs::path> inputs) {
    for (const MapFile& map : maps) {
        Diagnostics found = app::check_overwrites(map.file, inputs, "--map");
        if (has_errors(found)) {
            return found;
        }
    }
    return {};
}

// A map shows one camera, and that of the scale one which has a scale. Other mistakes are found
// when the cameras are analysed.
Diagnostics check_one_camera(std::span<const Subjects> all, bool wants_scale) {
    const Subjects& first = all.front();
    if (all.size() == 1 && (!first.cameras || first.cameras->size() == 1)) {
        return !first.cameras || !wants_scale || first.cameras->front().camera.parts().sides
                   ? Diagnostics{}
                   : Diagnostics{no_scale("--map scale", first.cameras->front().camera.name())};
    }
    std::vector<std::string> choice;
    for (std::size_t i = 0; first.cameras && i < first.cameras->size(); ++i) {
        const CheckSubject& subject = (*first.cameras)[i];
        for (const CameraCheck::Layer& layer : subject.layers) {
            choice.push_back(fmt::format("{} for {}", layer.number, subject.camera.name()));
        }
    }
    const bool of_picture = all.size() == 1 && first.argument != first.file;
    return {error(Kind::usage, "--map shows one camera, but there are several",
                  of_picture ? fmt::format("choose one with --layer: {}", fmt::join(choice, ", "))
                             : fmt::format("name it: {}:NAME", first.file))};
}

CameraCheck::InScene in_scene(const scene::Scene& scene, const render::Probe& probe) {
    CameraCheck::InScene found{.scene = scene.name, .starts_inside = starts_inside(probe, scene)};
    for (std::size_t i = 0; i < probe.objects.size(); ++i) {
        const render::ObjectSight& sight = probe.objects[i];
        if (sight.has_surface && !sight.seen) {
            found.never_seen.push_back(scene.objects[i].name);
        }
    }
    return found;
}

Diagnostics write_map(const analyse::CameraReport& report, const MapFile& map) {
    // Check before computing a large picture that cannot be written.
    if (Diagnostics refused = OutputFile::check(map.file); has_errors(refused)) {
        return refused;
    }
    const Image image = analyse::false_color(report, map.kind);
    return render::write_samples(image.samples, {image.width, image.height, 3}, map.file);
}

class Check {
public:
    Check(const CheckRequest& request, const CheckObserver& observer, const std::stop_token& stop)
        : request_(request), observer_(observer), stop_(stop) {
        workspace_.stop_with(stop);
    }

    CheckReport operator()() {
        Diagnostics usage = check_size(request_.size);
        app::add(usage, check_unit(request_.meters_per_unit));
        app::add(usage, check_maps(request_.maps, !request_.scene.empty()));
        app::add(usage, check_placement(request_.placement, !request_.scene.empty()));
        if (!request_.layer.empty() && request_.files.size() > 1) {
            usage.push_back(error(Kind::usage,
                                  "--layer refers to one picture, but there are several files",
                                  "name the picture"));
        }
        add(usage);
        if (!is_fine()) {
            return std::move(report_);
        }
        std::vector<Subjects> all;
        for (const std::string& argument : request_.files) {
            all.push_back({argument, camera_file(argument).string(),
                           check_subjects(argument, request_, workspace_)});
        }
        if (!request_.maps.empty()) {
            add(check_one_camera(all, shows_scale(request_.maps)));
            add(check_overwrites(request_.maps, workspace_.files()));
        }
        if (is_fine() && !request_.scene.empty()) {
            read_scene();
            place_cameras(all);
        }
        if (is_fine()) {
            for (std::size_t i = 0; i < all.size() && !is_stopped(); ++i) {
                check_file(all[i]);
            }
        }
        return std::move(report_);
    }

    Result<std::vector<CameraCheck>> operator()(const camera::Picture& picture,
                                                const PreparedScene* scene) {
        if (scene != nullptr) {
            scene_ = scene->scene();
            renderer_ = scene->renderer();
        }
        FileCheck file;
        for (const CheckSubject& subject : check_subjects(picture, request_)) {
            if (is_fine()) {
                check_camera(subject, file);
            }
        }
        return is_fine() ? Result<std::vector<CameraCheck>>(
                               {std::move(file.checks), std::move(report_.diagnostics)})
                         : std::move(report_.diagnostics);
    }

private:
    [[nodiscard]] bool is_fine() const { return !has_errors(report_.diagnostics); }

    // Whether a stop has ended a part of the work.
    [[nodiscard]] bool is_stopped() const {
        return std::any_of(report_.diagnostics.begin(), report_.diagnostics.end(),
                           [](const Diagnostic& one) { return one.kind == Kind::interrupted; });
    }

    void add(const Diagnostics& diagnostics) {
        app::add(report_.diagnostics, diagnostics);
        if (observer_.tell && !diagnostics.empty()) {
            observer_.tell(diagnostics);
        }
    }

    void read_scene() {
        Result<scene::Scene> loaded = load_scene(request_.scene, request_.time, {}, {}, stop_);
        add(loaded.diagnostics);
        if (!loaded) {
            return;
        }
        set_unit(*loaded, request_.meters_per_unit);
        scene_ = std::make_shared<const scene::Scene>(std::move(*loaded));
        add(check_overwrites(request_.maps, scene_->files));
        Result<render::Renderer> renderer =
            render::Renderer::make(scene_, {.textures_on_demand = true}, {}, stop_);
        add(renderer.diagnostics);
        renderer_ = std::move(renderer.value);
    }

    // Makes the cameras again that the scene places.
    void place_cameras(std::vector<Subjects>& all) {
        for (Subjects& one : all) {
            if (!renderer_ || !is_fine() || !one.cameras ||
                !request_.placement.places(one.argument)) {
                continue;
            }
            const auto make = [&] {
                one.cameras = check_subjects(one.argument, request_, workspace_);
                std::vector<camera::Camera> made;
                for (std::size_t i = 0; one.cameras && i < one.cameras->size(); ++i) {
                    made.push_back((*one.cameras)[i].camera);
                }
                return made;
            };
            add(fit_cameras(workspace_, request_.placement, *scene_, *renderer_, make, stop_));
            make();
        }
    }

    void check_file(const Subjects& subjects) {
        add(subjects.cameras.diagnostics);
        FileCheck& file = report_.files.emplace_back();
        file.file = subjects.file;
        file.good = static_cast<bool>(subjects.cameras);
        if (const auto known = workspace_.describe(subjects.file)) {
            file.pictures = static_cast<std::size_t>(
                std::count_if(known->begin(), known->end(),
                              [](const lang::Description& one) { return one.is_picture; }));
            file.cameras = known->size() - file.pictures;
        }
        if (observer_.file) {
            observer_.file(file);
        }
        for (std::size_t i = 0; file.good && i < subjects.cameras->size() && !is_stopped(); ++i) {
            check_camera((*subjects.cameras)[i], file);
        }
    }

    void check_camera(const CheckSubject& subject, FileCheck& file) {
        CameraCheck check;
        check.has_lens = subject.camera.parts().lens != nullptr;
        check.has_bend = subject.camera.parts().bend != nullptr;
        check.by_itself = subject.by_itself;
        check.layers = subject.layers;
        if (renderer_ && !look_at_scene(subject, check)) {
            return;
        }
        analyse::DiagnoseSettings settings;
        settings.width = subject.width;
        settings.height = subject.height;
        settings.time = request_.time;
        settings.distance = request_.distance;
        Result<analyse::CameraReport> report =
            analyse::diagnose(subject.camera, settings, {}, stop_);
        if (report && scene_distance_ && !settings.distance && !report->single_viewpoint) {
            settings.distance = scene_distance_;
            report = analyse::diagnose(subject.camera, settings, {}, stop_);
        }
        add(report.diagnostics);
        if (!report) {
            return;
        }
        check.report = std::move(*report);
        Diagnostics of_maps;
        if (shows_scale(request_.maps)) {
            of_maps = measure_scale_errors(subject, check.report);
        }
        for (const MapFile& map : request_.maps) {
            const Diagnostics found = write_map(check.report, map);
            if (!has_errors(found)) {
                check.maps.push_back(map.file);
            }
            app::add(of_maps, found);
        }
        file.checks.push_back(std::move(check));
        if (observer_.camera) {
            observer_.camera(file.checks.back());
        }
        add(of_maps);
    }

    // The length of a pixel by the camera's scale, in scene units.
    static double nominal_scale(const CheckSubject& subject) {
        return (*subject.camera.parts().sides)[0] / subject.width;
    }

    // Adds them to the samples.
    [[nodiscard]] Diagnostics measure_scale_errors(const CheckSubject& subject,
                                                   analyse::CameraReport& report) const {
        const analyse::SampleGrid& grid = report.grid;
        const auto errors = render::scale_errors(
            *renderer_, subject.camera, probe_settings(subject),
            {grid.first().x, grid.first().y, grid.step, grid.columns, grid.rows, request_.time},
            nominal_scale(subject), stop_);
        for (std::size_t i = 0; errors && i < errors->size(); ++i) {
            report.samples[i].scale_error = (*errors)[i];
        }
        return errors.diagnostics;
    }

    [[nodiscard]] render::ProbeSettings probe_settings(const CheckSubject& subject) const {
        return {.width = static_cast<std::size_t>(subject.width),
                .height = static_cast<std::size_t>(subject.height),
                .time = request_.time,
                .objects = subject.objects};
    }

    // False if that is not possible.
    bool look_at_scene(const CheckSubject& subject, CameraCheck& check) {
        const Result<render::Probe> probe = probe_scene(subject);
        if (!probe) {
            add(probe.diagnostics);
            return false;
        }
        check.in_scene = in_scene(*scene_, *probe);
        if (subject.camera.parts().sides) {
            check.in_scene->scale = scale_of(subject);
        }
        if (!probe->median_distance && probe->rays > 0) {
            explain_empty_view(subject, *probe, *check.in_scene);
        }
        scene_distance_ = probe->median_distance;
        return true;
    }

    // Nothing if it cannot be measured.
    [[nodiscard]] std::optional<CameraCheck::InScene::Scale> scale_of(
        const CheckSubject& subject) const {
        const auto measured =
            render::measure_scale(*renderer_, subject.camera, probe_settings(subject), stop_);
        if (!measured || !*measured) {
            return std::nullopt;
        }
        const double unit = scene_->has_unit ? 1000.0 * scene_->meters_per_unit : 1.0;
        CameraCheck::InScene::Scale scale{scene_->has_unit, unit * nominal_scale(subject),
                                          **measured};
        for (render::SurfaceScale::Range* range : {&scale.surface.across, &scale.surface.upwards}) {
            range->least *= unit;
            range->median *= unit;
            range->most *= unit;
        }
        return scale;
    }

    // Rays are at most one pixel apart, or further in a very large picture to limit the work.
    [[nodiscard]] Result<render::Probe> probe_scene(const CheckSubject& subject) const {
        constexpr double max_pixels = 16e6;
        const double scale = std::max(1.0, std::sqrt(subject.width * subject.height / max_pixels));
        const auto scaled = [scale](double side) {
            return static_cast<std::size_t>(std::max(1.0, std::round(side / scale)));
        };
        const std::size_t width = scaled(subject.width);
        const std::size_t height = scaled(subject.height);
        Result<render::Probe> probe = render::probe(
            *renderer_, subject.camera,
            {.width = width, .height = height, .time = request_.time, .objects = subject.objects},
            {}, stop_);
        if (probe) {
            for (render::ObjectSight& sight : probe->objects) {
                sight.inside_at.x *= subject.width / static_cast<double>(width);
                sight.inside_at.y *= subject.height / static_cast<double>(height);
            }
        }
        return probe;
    }

    void explain_empty_view(const CheckSubject& subject, const render::Probe& probe,
                            CameraCheck::InScene& found) const {
        const bool is_empty =
            std::none_of(probe.objects.begin(), probe.objects.end(),
                         [](const render::ObjectSight& sight) { return sight.seen; });
        const Result<render::Miss> miss =
            render::explain_miss(*renderer_, subject.camera, probe_settings(subject), stop_);
        if (miss && is_empty) {
            found.miss = miss_text(*miss, subject.camera);
        }
    }

    const CheckRequest& request_;
    const CheckObserver& observer_;
    const std::stop_token& stop_;
    lang::Workspace workspace_;
    std::shared_ptr<const scene::Scene> scene_;
    std::optional<render::Renderer> renderer_;
    std::optional<double> scene_distance_;
    CheckReport report_;
};

}  // namespace

CheckReport check(const CheckRequest& request, const CheckObserver& observer,
                  const std::stop_token& stop) {
    return Check(request, observer, stop)();
}

Result<std::vector<CameraCheck>> check(const camera::Picture& picture,
                                       const std::array<std::size_t, 2>& size,
                                       const std::stop_token& stop) {
    CheckRequest request;
    request.size = {.width = size[0], .height = size[1]};
    return Check(request, {}, stop)(picture, nullptr);
}

Result<std::vector<CameraCheck>> check(const camera::Picture& picture, const PreparedScene& scene,
                                       const std::array<std::size_t, 2>& size,
                                       const std::stop_token& stop) {
    CheckRequest request;
    request.size = {.width = size[0], .height = size[1]};
    request.time = scene.settings().time;
    return Check(request, {}, stop)(picture, &scene);
}

}  // namespace balcony::app
