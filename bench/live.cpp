// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A parameter moves: the time from its new value to the first ray that has been traced, and to
// previews of fewer and fewer pixels, on all cores.

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "balcony/lang.hpp"
#include "balcony/live.hpp"
#include "balcony/median.hpp"
#include "balcony/output_file.hpp"
#include "balcony/render.hpp"
#include "bench_case.hpp"
#include "scenes/catalogue.hpp"

namespace balcony::bench {

namespace {

constexpr int live_runs = 9;
constexpr std::size_t width = 960;
constexpr std::size_t height = 540;

struct LiveRow {
    std::string_view camera;     // In PLATE/camera.cam, or a built-in one.
    std::string_view parameter;  // The one that moves.
};

constexpr std::array live_rows{
    LiveRow{"02-superelliptic", "gamma"},
    LiveRow{"13-circle-and-torus", "tube"},
    LiveRow{"fisheye", "yaw"},
    LiveRow{"fisheye_thoby", "k1"},
    LiveRow{"panini", "d"},
    LiveRow{"omnimax", "tilt"},
    LiveRow{"cylindrical", "pitch"},
    LiveRow{"little_planet", "roll"},
    LiveRow{"caricature", "exaggeration"},
    LiveRow{"look_around", "px"},
};

template <class Value>
Value unwrapped(Result<Value> result) {
    if (!result) {
        throw std::runtime_error(to_text(result.diagnostics));
    }
    return std::move(*result);
}

lang::CameraSource source_of(std::string_view camera) {
    const std::string name(camera);
    return name.find('-') != std::string::npos ? BALCONY_PLATES "/" + name + "/camera.cam" : name;
}

/// The time of the fastest of some runs, in milliseconds.
template <class Show>
double milliseconds(const Show& show) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < live_runs; ++run) {
        const auto start = std::chrono::steady_clock::now();
        show(1e-3 * (1 + run));
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - start;
        least = std::min(least, taken.count());
    }
    return least;
}

/// A preview that follows a parameter: moved if it can be open, otherwise made anew.
class LivePreview {
public:
    LivePreview(const render::Renderer& renderer, const LiveRow& row, lang::Workspace& workspace,
                const lang::OpenPicture& opened, const render::FilmLayout& layout)
        : renderer_(renderer),
          row_(row),
          workspace_(workspace),
          film_(std::make_shared<render::Film>(unwrapped(render::make_film(layout)))),
          job_(unwrapped(render::Job::make(renderer, opened.picture, settings_, film_))) {
        settings_.ambient = film_->ambient;
        const auto found = std::find_if(opened.open.begin(), opened.open.end(),
                                        [&](const auto& one) { return one.name == row.parameter; });
        if (found != opened.open.end()) {
            input_ = {lang::parameter_input(found->name), found->value};
        }
    }

    [[nodiscard]] bool moves() const { return input_.has_value(); }

    void show(double change) {
        if (input_) {
            const camera::KnownInput moved{input_->name, input_->value + change};
            if (const Diagnostics found = job_.set_inputs({&moved, 1}); !found.empty()) {
                throw std::runtime_error(to_text(found));
            }
        } else {
            const camera::Picture picture = unwrapped(workspace_.make_picture(
                source_of(row_.camera), "",
                {{std::string(row_.parameter), std::to_string(0.25 + change)}}));
            film_->passes.assign(film_->passes.size(), 0);
            film_->sum.assign(film_->sum.size(), render::Color4d(0.0));
            job_ = unwrapped(render::Job::make(renderer_, picture, settings_, film_));
        }
        unwrapped(job_.run());
    }

private:
    static render::Settings settings() {
        render::Settings made;
        made.samples = 1;
        made.integrator = "preview";
        return made;
    }

    const render::Renderer& renderer_;
    const LiveRow& row_;
    lang::Workspace& workspace_;
    render::Settings settings_ = settings();
    std::shared_ptr<render::Film> film_;
    render::Job job_;
    std::optional<camera::KnownInput> input_;
};

void print_live_of(std::string_view scene_name) {
    const auto scene = std::make_shared<const scene::Scene>(
        unwrapped(plates::make_scene(scene_name, {.texture_scale = 0.5})));
    const render::Renderer renderer = unwrapped(render::Renderer::make(scene));
    lang::Workspace workspace;
    for (const LiveRow& row : live_rows) {
        const lang::OpenPicture opened =
            unwrapped(workspace.make_open_picture(source_of(row.camera)));
        fmt::print("{:<10}{:<22}{:<14}", scene_name, row.camera, row.parameter);
        bool moves = false;
        const auto print = [&](std::size_t part, std::optional<render::Region> window) {
            LivePreview preview(renderer, row, workspace, opened,
                                {.width = width / part,
                                 .height = height / part,
                                 .window = window,
                                 .data_layers = false});
            moves = preview.moves();
            fmt::print("{:>10.2f}", milliseconds([&](double change) { preview.show(change); }));
        };
        print(1, render::Region{width / 2, height / 2, 1, 1});
        print(1, {});
        print(2, {});
        print(4, {});
        fmt::print("{}\n", moves ? "" : "  (made anew)");
    }
}

/// The seconds from changes of a parameter to their first frames.
std::vector<double> first_frames(const app::Request& request, const LiveRow& row) {
    std::mutex mutex;
    std::condition_variable told;
    std::uint64_t seen = 0;
    std::vector<double> seconds;
    const auto frame = [&](const live::Frame& shown) {
        const std::lock_guard lock(mutex);
        if (shown.change > seen) {
            seen = shown.change;
            seconds.push_back(shown.seconds);
            told.notify_all();
        }
    };
    const auto view =
        live::View::make(unwrapped(app::PreparedScene::make(request)), request, {.frame = frame});
    const auto text = unwrapped(lang::read_text(source_of(row.camera).path()));
    const auto show = [&](live::Change change) {
        const std::uint64_t number = view->change(std::move(change));
        std::unique_lock lock(mutex);
        told.wait(lock, [&] { return seen >= number; });
    };
    // The first frames find the exposure and the size of the next ones.
    show({.text = std::string(text->text()), .size = {{width, height}}});
    show({.values = {{{std::string(row.parameter), 0.25}}}});
    seconds.clear();
    for (int run = 1; run <= 21; ++run) {
        show({.values = {{{std::string(row.parameter), 0.25 + 1e-3 * run}}}});
    }
    return seconds;
}

void print_views() {
    fmt::print(
        "\nthe same in a live::View in the gallery: median of the milliseconds to a coarse frame "
        "in sRGB,\nright after that of the change before\n\n");
    const auto file = std::filesystem::temp_directory_path() / "balcony_bench_gallery.glb";
    const scene::Scene gallery = unwrapped(plates::make_scene("gallery", {.texture_scale = 0.5}));
    if (const Diagnostics found = write_whole(file, scene::to_glb(gallery)); !found.empty()) {
        throw std::runtime_error(to_text(found));
    }
    const app::Request request{.scene = file.string()};
    for (const LiveRow& row : {live_rows[0], live_rows[1]}) {
        fmt::print("{:<22}{:<14}{:>10.2f}\n", row.camera, row.parameter,
                   1e3 * median(first_frames(request, row)).value_or(0.0));
    }
    std::filesystem::remove(file);
}

}  // namespace

void print_live() {
    fmt::print(
        "\na parameter moves: milliseconds to the first traced ray, and to a finished preview of\n"
        "{} x {}, with all, a quarter and a sixteenth of the pixels, on all cores\n\n",
        width, height);
    fmt::print("{:<10}{:<22}{:<14}{:>10}{:>10}{:>10}{:>10}\n", "scene", "camera", "parameter",
               "first ray", "all", "quarter", "16th");
    for (const std::string_view scene : {"gallery", "street"}) {
        print_live_of(scene);
    }
    print_views();
}

}  // namespace balcony::bench
