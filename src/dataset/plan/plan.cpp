// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "balcony/content_hash.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/progress.hpp"
#include "balcony/ray_maps.hpp"
#include "base/memory.hpp"
#include "dataset/layouts/layout.hpp"
#include "dataset/lenses/lenses.hpp"
#include "dataset/picture_facts.hpp"
#include "dataset/plan/planned.hpp"
#include "dataset/poses/poses.hpp"

namespace balcony::dataset {

namespace {

bool add(Diagnostics& all, const Diagnostics& more) {
    all.insert(all.end(), more.begin(), more.end());
    return has_errors(more);
}

// The rays of a grid all over the picture; none of a picture of several layers.
SampledRays sampled(const camera::Picture& picture, const std::array<std::size_t, 2>& size,
                    double time) {
    SampledRays made;
    const auto grid = bridge::RayGrid::make(
        picture,
        {.width = size[0], .height = size[1], .layer = {}, .axes = Axes::z_up, .time = time});
    if (!grid || grid->has_times()) {
        return made;
    }
    constexpr std::size_t side = 24;
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < side * side; ++i) {
        const auto at = [](std::size_t k) { return (static_cast<double>(k) + 0.5) / side; };
        x.push_back(at(i % side) * static_cast<double>(size[0]));
        y.push_back(at(i / side) * static_cast<double>(size[1]));
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    grid->run_at(x, y, scratch, batch);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (batch.valid(i)) {
            made.points.emplace_back(x[i], y[i]);
            made.origins.push_back(batch.origin(i));
            made.directions.push_back(batch.direction(i));
        }
    }
    return made;
}

/// Plans the scenes of a recipe one after the other.
class Planning {
public:
    Planning(double scene_memory, const app::Observer& observer, const std::stop_token& stop,
             Planned& made)
        : scene_memory_(scene_memory),
          observer_(observer),
          stop_(stop),
          made_(made),
          recipe_(made.plan.recipe) {
        workspace_.stop_with(stop);
    }

    Diagnostics run() {
        for (std::size_t i = 0; i < recipe_.scenes.size(); ++i) {
            make_room(i);
            if (!add_scene(i)) {
                return std::move(found_);
            }
        }
        for (const std::string& name : recipe_.layouts) {
            if (add(found_, layout_of(name).check(made_.plan))) {
                return std::move(found_);
            }
        }
        for (const std::filesystem::path& file : workspace_.files()) {
            files_.insert(file.string());
        }
        if (const auto* const environment =
                std::get_if<std::filesystem::path>(&recipe_.picture.light.environment)) {
            files_.insert(environment->string());
        }
        for (const std::string& file : files_) {
            const auto hash = content_hash(file);
            made_.plan.files.push_back(
                {name_of(file), hash ? fmt::format("{:016x}", *hash) : "unreadable"});
        }
        return std::move(found_);
    }

private:
    // As seen from the folder of the recipe, so that each machine calls it the same.
    [[nodiscard]] std::string name_of(const std::filesystem::path& file) const {
        return recipe_.folder.empty() ? file.generic_string()
                                      : file.lexically_proximate(recipe_.folder).generic_string();
    }

    // Before a scene is loaded, so that there are never two that do not fit.
    void make_room(std::size_t index) {
        if (index > 0 && static_cast<double>(peak_memory()) >= scene_memory_) {
            made_.scenes.erase(index - 1);
        }
    }

    bool add_scene(std::size_t index) {
        const SceneChoice& choice = recipe_.scenes[index];
        auto prepared =
            app::PreparedScene::make(scene_request(recipe_.picture, choice.file), observer_, stop_);
        if (add(found_, prepared.diagnostics)) {
            return false;
        }
        const scene::Scene& scene = *prepared->scene();
        PlannedScene planned{.name = choice.name,
                             .written = choice.written,
                             .file = choice.file,
                             .axes = scene.axes,
                             .meters_per_unit = scene.meters_per_unit};
        for (const scene::Object& object : scene.objects) {
            planned.objects.push_back(object.name);
        }
        for (const scene::Material& material : scene.materials) {
            planned.materials.push_back(material.name);
        }
        for (const std::filesystem::path& file : scene.files) {
            files_.insert(file.string());
        }
        if (!add_poses(index, *prepared, planned) || !add_cameras(scene, planned)) {
            return false;
        }
        for (std::size_t camera = 0; camera < planned.cameras.size(); ++camera) {
            for (std::size_t pose = 0; pose < planned.poses.size(); ++pose) {
                made_.plan.frames.push_back(
                    {.index = made_.plan.frames.size(),
                     .scene = index,
                     .camera = camera,
                     .pose = pose,
                     .name = fmt::format("{}-{:05}", planned.cameras[camera].name, pose)});
            }
        }
        made_.plan.scenes.push_back(std::move(planned));
        made_.scenes.emplace(index, std::move(*prepared.value));
        return true;
    }

    bool add_poses(std::size_t index, const app::PreparedScene& prepared, PlannedScene& planned) {
        for (std::size_t group = 0; group < recipe_.groups.size(); ++group) {
            const auto poses = poses_of(recipe_.groups[group], index, group, prepared);
            Diagnostics found = poses.diagnostics;
            for (Diagnostic& one : found) {
                one.span = recipe_.groups[group].span;
            }
            if (add(found_, found)) {
                return false;
            }
            const auto* const path = std::get_if<PathPoses>(&recipe_.groups[group].poses);
            const std::size_t first = planned.poses.size();
            for (std::size_t i = 0; i < poses->size(); ++i) {
                const bool is_last = i + 1 == poses->size();
                const bool is_loop = path != nullptr && path->closed && poses->size() > 1;
                planned.poses.push_back({.pose = (*poses)[i],
                                         .group = group,
                                         .next = !is_last  ? std::optional(first + i + 1)
                                                 : is_loop ? std::optional(first)
                                                           : std::nullopt});
            }
        }
        return true;
    }

    [[nodiscard]] Result<std::vector<camera::Pose>> poses_of(
        const PoseGroup& group, std::size_t scene, std::size_t number,
        const app::PreparedScene& prepared) const {
        const Axes axes = prepared.scene()->axes;
        if (const auto* const random = std::get_if<RandomPoses>(&group.poses)) {
            const std::size_t stream = scene * recipe_.groups.size() + number;
            return random_poses(*random, *prepared.scene(), prepared.renderer(), recipe_.seed,
                                static_cast<std::uint32_t>(stream), stop_);
        }
        if (const auto* const path = std::get_if<PathPoses>(&group.poses)) {
            return path_poses(*path, axes);
        }
        const auto& listed = std::get<ListedPoses>(group.poses);
        std::vector<camera::Pose> made;
        for (const app::PoseMatrix& matrix : listed.matrices) {
            const auto pose = app::pose_of(matrix, listed.axes, axes);
            if (!pose) {
                return pose.diagnostics;
            }
            made.push_back(*pose);
        }
        return made;
    }

    bool add_cameras(const scene::Scene& scene, PlannedScene& planned) {
        for (std::size_t i = 0; i < recipe_.cameras.size(); ++i) {
            const CameraChoice& choice = recipe_.cameras[i];
            const bool is_of_scene = app::is_of_scene(choice.camera);
            auto known = cameras_.find(i);
            if (known == cameras_.end() || is_of_scene) {
                const auto made = is_of_scene ? scene_camera(choice, scene) : file_camera(choice);
                Diagnostics found = made.diagnostics;
                for (Diagnostic& one : found) {
                    if (!one.span.source) {
                        one.span = choice.span;
                    }
                }
                if (add(found_, found)) {
                    return false;
                }
                known = cameras_.insert_or_assign(i, measured(choice, *made)).first;
                if (add(found_, misfits(known->second, choice.span))) {
                    return false;
                }
            }
            planned.cameras.push_back(known->second);
        }
        return true;
    }

    struct MadeCamera {
        camera::Picture picture;
        std::string text{};
        std::vector<std::array<std::string, 2>> parameters{};
    };

    Result<MadeCamera> file_camera(const CameraChoice& choice) {
        const auto wanted = app::read_camera(choice.camera, choice.set);
        if (!wanted) {
            return wanted.diagnostics;
        }
        workspace_.fit_to({});
        const auto explained = workspace_.explain(wanted->file, wanted->name, wanted->overrides);
        if (!explained) {
            return explained.diagnostics;
        }
        const auto text = workspace_.with_values(wanted->file, wanted->name, wanted->overrides);
        MadeCamera made{explained->picture, text ? *text : "", {}};
        for (const auto& one : explained->explanation.parameters) {
            made.parameters.push_back({one.name, one.value});
        }
        return {std::move(made), explained.diagnostics};
    }

    [[nodiscard]] Result<MadeCamera> scene_camera(const CameraChoice& choice,
                                                  const scene::Scene& scene) const {
        const auto picture = app::load_picture(choice.camera, choice.set, scene, stop_);
        return picture ? Result<MadeCamera>(MadeCamera{*picture}, picture.diagnostics)
                       : Result<MadeCamera>(picture.diagnostics);
    }

    [[nodiscard]] PlannedCamera measured(const CameraChoice& choice, const MadeCamera& made) const {
        const app::SizeRequest& size = recipe_.picture.size;
        const auto [width, height] = size.resolve(made.picture.aspect(), made.picture.parts().size);
        PlannedCamera planned{.name = choice.name,
                              .written = choice.written,
                              .set = choice.set,
                              .text = made.text,
                              .parameters = made.parameters,
                              .size = {width, height},
                              .picture = made.picture.with_fit(size.fit).with_pose({})};
        const SampledRays rays =
            sampled(planned.picture, planned.size, recipe_.picture.settings.time);
        planned.viewpoint = viewpoint_of(rays);
        planned.lens = lens_of(rays);
        return planned;
    }

    [[nodiscard]] Diagnostics misfits(const PlannedCamera& camera, const SourceSpan& span) const {
        Diagnostics found;
        for (const std::string& name : recipe_.layouts) {
            for (Diagnostic& one : check_layout(layout_of(name), camera)) {
                one.span = span;
                found.push_back(std::move(one));
            }
        }
        return found;
    }

    double scene_memory_;
    const app::Observer& observer_;
    std::stop_token stop_;
    lang::Workspace workspace_;
    Planned& made_;
    const Recipe& recipe_;
    Diagnostics found_;
    std::set<std::string> files_;
    std::map<std::size_t, PlannedCamera> cameras_;  // By the number of the choice.
};

}  // namespace

Result<Planned> plan_dataset(const Recipe& recipe, double scene_memory,
                             const app::Observer& observer, const std::stop_token& stop) {
    Result<Planned> made;
    made.value.emplace(Planned{.plan = {.recipe = recipe}});
    made.diagnostics = Planning(scene_memory, observer, stop, *made).run();
    if (has_errors(made.diagnostics)) {
        made.value.reset();
    }
    return made;
}

Result<Plan> make_plan(const Recipe& recipe, const app::Observer& observer,
                       const std::stop_token& stop) {
    auto planned = plan_dataset(recipe, 0.0, observer, stop);
    return planned ? Result<Plan>(std::move(planned->plan), std::move(planned.diagnostics))
                   : Result<Plan>(std::move(planned.diagnostics));
}

}  // namespace balcony::dataset
