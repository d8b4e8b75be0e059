// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "balcony/dataset.hpp"
#include "balcony/names.hpp"
#include "balcony/output_file.hpp"
#include "balcony/progress.hpp"
#include "base/memory.hpp"
#include "dataset/files.hpp"
#include "dataset/frames/frame_layers.hpp"
#include "dataset/frames/frame_maker.hpp"
#include "dataset/layouts/layout.hpp"
#include "dataset/picture_facts.hpp"
#include "dataset/plan/manifest.hpp"
#include "dataset/plan/planned.hpp"

namespace balcony::dataset {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Makes what a plan says, in a folder.
class Making {
public:
    Making(const DatasetRequest& request, const app::Observer& observer,
           const std::stop_token& stop, DatasetReport& report)
        : request_(request), observer_(observer), stop_(stop), report_(report) {}

    void run() {
        const auto begin = Clock::now();
        // Each scene is a part of what is loaded, and frames need memory as well.
        const double memory =
            request_.only_plan ? 0.0 : request_.scene_memory.value_or(0.25 * physical_memory());
        auto planned = plan_dataset(request_.recipe, memory, observer_, stop_);
        if (fails(planned.diagnostics)) {
            return;
        }
        plan_ = &planned->plan;
        scenes_ = &planned->scenes;
        report_.plan_seconds = seconds_since(begin);
        describe();
        if (request_.only_plan || !begin_folder()) {
            return;
        }
        const auto begin_of_frames = Clock::now();
        make_frames();
        count_warnings();
        report_.seconds = seconds_since(begin_of_frames);
    }

private:
    bool fails(const Diagnostics& found) {
        report_.diagnostics.insert(report_.diagnostics.end(), found.begin(), found.end());
        return has_errors(found);
    }

    // Thousands of frames may have one thing to say, but for its numbers: the first one says it.
    bool fails(const Diagnostics& found, const Frame& frame) {
        for (const Diagnostic& one : found) {
            if (one.severity == Severity::error) {
                report_.diagnostics.push_back(one);
                continue;
            }
            std::string text = one.message;
            std::erase_if(text, [](char c) {
                return std::string_view("0123456789.-").find(c) != std::string_view::npos;
            });
            const auto [told, is_new] =
                told_.try_emplace(text, std::size_t{0}, report_.diagnostics.size());
            if (is_new) {
                report_.diagnostics.push_back(
                    warning(fmt::format("frame '{}': {}", frame.name, one.message), one.span,
                            "the poses of the recipe say where its cameras stand"));
            } else {
                ++told->second.first;
            }
        }
        return has_errors(found);
    }

    void count_warnings() {
        for (const auto& [text, told] : told_) {
            if (told.first > 0) {
                report_.diagnostics[told.second].message +=
                    fmt::format(" (and {} more)", counted(told.first, "frame"));
            }
        }
    }

    [[nodiscard]] bool is_selected(const Frame& frame) const {
        return !request_.shard || frame.index % request_.shard->count == request_.shard->index;
    }

    void describe() {
        report_.is_planned = true;
        report_.frames = plan_->frames.size();
        report_.selected = static_cast<std::size_t>(
            std::count_if(plan_->frames.begin(), plan_->frames.end(),
                          [&](const Frame& frame) { return is_selected(frame); }));
        for (const PlannedCamera& camera : plan_->scenes.front().cameras) {
            report_.cameras.push_back(
                fmt::format("{}: {} x {} pixels, {}", camera.name, camera.size[0], camera.size[1],
                            camera.lens        ? std::string(camera.lens->model)
                            : camera.viewpoint ? "one viewpoint, no model of a lens"
                                               : "several viewpoints"));
        }
    }

    // The manifest is the record of what the folder is of.
    bool begin_folder() {
        const std::string manifest = manifest_of(*plan_);
        const fs::path file = request_.folder / "manifest.json";
        std::error_code failed;
        const bool is_there = fs::exists(file, failed);
        const std::string before = is_there ? text_of(file) : "";
        const std::optional<std::string> changed =
            is_there ? difference(before, manifest) : std::optional<std::string>("");
        if (!request_.overwrite && (!changed || !changed->empty())) {
            return !fails(
                {error(Kind::usage,
                       changed ? fmt::format("'{}' has a data set of another recipe ({})",
                                             request_.folder.string(), *changed)
                               : fmt::format("'{}' is no manifest of a data set", file.string()),
                       "name another folder, or replace what is there with --overwrite")});
        }
        if (request_.overwrite) {
            remove_frames(before, changed && changed->empty());
        }
        if (before == manifest) {
            return write_layouts();
        }
        return write_layouts() && write("manifest.json", manifest);
    }

    // Of another recipe all, of this one those that are to be rendered.
    void remove_frames(const std::string& before, bool is_same) {
        std::error_code ignored;
        if (!is_same) {
            for (const std::string& file : files_in(before)) {
                fs::remove(request_.folder / file, ignored);
            }
        }
        for (const Frame& frame : plan_->frames) {
            for (const fs::path& file : files_of(*plan_, frame)) {
                if (is_selected(frame) || !is_same) {
                    fs::remove(request_.folder / file, ignored);
                }
            }
        }
    }

    bool write_layouts() {
        for (const std::string& name : plan_->recipe.layouts) {
            for (const LayoutFile& one : layout_of(name).files(*plan_)) {
                if (!write(one.file, one.bytes)) {
                    return false;
                }
            }
        }
        return true;
    }

    bool write(const fs::path& name, const std::string& bytes) {
        const fs::path file = request_.folder / name;
        std::error_code failed;
        fs::create_directories(file.parent_path(), failed);
        if (failed) {
            return !fails({error(Kind::environment,
                                 fmt::format("the folder '{}' cannot be made: {}",
                                             file.parent_path().string(), failed.message()))});
        }
        return !fails(write_whole(file, bytes));
    }

    [[nodiscard]] bool is_finished(const Frame& frame) const {
        const std::vector<fs::path> files = files_of(*plan_, frame);
        return std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
            std::error_code failed;
            return fs::file_size(request_.folder / file, failed) > 0 && !failed;
        });
    }

    void make_frames() {
        std::vector<const Frame*> missing;
        for (const Frame& frame : plan_->frames) {
            if (is_selected(frame)) {
                is_finished(frame) ? ++report_.skipped : (missing.push_back(&frame), 0U);
            }
        }
        // The scenes that are loaded come first, and the others do not meet them in memory.
        std::stable_partition(missing.begin(), missing.end(),
                              [&](const Frame* frame) { return scenes_->contains(frame->scene); });
        for (std::size_t i = 0; i < missing.size(); ++i) {
            if (stop_.stop_requested()) {
                report_.interrupted = true;
                return;
            }
            if (observer_.frame) {
                observer_.frame(missing[i]->index, i, missing.size());
            }
            if (!load(missing[i]->scene) || !make(*missing[i])) {
                return;
            }
            ++report_.rendered;
        }
    }

    bool load(std::size_t scene) {
        if (maker_ && maker_->scene() == scene) {
            return true;
        }
        maker_.reset();
        if (auto loaded = scenes_->extract(scene)) {
            maker_.emplace(*plan_, scene, std::move(loaded.mapped()));
            return true;
        }
        scenes_->clear();
        auto prepared = app::PreparedScene::make(
            scene_request(plan_->recipe.picture, plan_->scenes[scene].file), observer_, stop_);
        if (fails(prepared.diagnostics)) {
            return false;
        }
        maker_.emplace(*plan_, scene, std::move(*prepared.value));
        return true;
    }

    // The layers come last of all, so that a frame that has them is complete.
    bool make(const Frame& frame) {
        const auto data = maker_->make(frame, observer_, stop_);
        if (fails(data.diagnostics, frame)) {
            return false;
        }
        for (const std::string& name : plan_->recipe.layouts) {
            const std::vector<std::string> files = layout_of(name).frame_files(*plan_, frame);
            const auto bytes = layout_of(name).frame_bytes(*data);
            if (fails(bytes.diagnostics)) {
                return false;
            }
            for (std::size_t i = 0; i < files.size(); ++i) {
                if (!write(files[i], (*bytes)[i])) {
                    return false;
                }
            }
        }
        for (const std::string& layer : plan_->recipe.layers) {
            const auto bytes = frame_layer(layer).bytes(*data);
            if (fails(bytes.diagnostics) || !write(layer_file(*plan_, frame, layer), *bytes)) {
                return false;
            }
        }
        return true;
    }

    const DatasetRequest& request_;
    const app::Observer& observer_;
    std::stop_token stop_;
    DatasetReport& report_;
    const Plan* plan_ = nullptr;
    std::map<std::size_t, app::PreparedScene>* scenes_ = nullptr;  // That are loaded.
    std::optional<FrameMaker> maker_;
    // How many frames more have a warning, and its index.
    std::map<std::string, std::pair<std::size_t, std::size_t>> told_;
};

}  // namespace

DatasetReport make_dataset(const DatasetRequest& request, const app::Observer& observer,
                           const std::stop_token& stop) {
    DatasetReport report;
    try {
        Making(request, observer, stop, report).run();
    } catch (const std::bad_alloc&) {
        report.diagnostics.push_back(error(Kind::environment, "there is not enough memory",
                                           "make the pictures smaller, or free some memory"));
    }
    report.interrupted |= kind_of_errors(report.diagnostics) == Kind::interrupted;
    std::erase_if(report.diagnostics, [](const Diagnostic& one) {
        return one.kind == Kind::interrupted && one.severity == Severity::error;
    });
    return report;
}

}  // namespace balcony::dataset
