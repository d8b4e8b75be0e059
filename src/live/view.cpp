// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "app/inputs/file_watch.hpp"
#include "balcony/denoise.hpp"
#include "balcony/display_pixels.hpp"
#include "balcony/live.hpp"
#include "balcony/motion.hpp"
#include "live/followed_picture.hpp"

namespace balcony::live {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<std::filesystem::path> scene_files(const app::Request& request) {
    std::vector<std::filesystem::path> files{request.scene};
    files.insert(files.end(), request.added.begin(), request.added.end());
    return files;
}

// Of the longest animation, in seconds.
double duration_of(const app::PreparedScene& scene) {
    double longest = 0.0;
    if (const auto& motion = scene.scene()->motion) {
        for (const scene::Animation& one : motion->animations) {
            longest = std::max(longest, one.duration);
        }
    }
    return longest;
}

// All changes so far.
struct Wanted : Shown {
    Wanted() = default;
    explicit Wanted(const app::Request& first) {
        size = {960, 540};
        time = first.settings.time;
        if (first.stereo.is_wanted()) {
            stereo = first.stereo.formats.front();
        }
    }

    Clock::time_point since{};
    bool chooses_exposure = false;
    Drag drag;

    void add(Change&& more) {
        ++change;
        since = Clock::now();
        replace(text, std::move(more.text));
        replace(camera, std::move(more.camera));
        replace(values, std::move(more.values));
        replace(size, std::move(more.size));
        replace(drag, std::move(more.drag));
        replace(time, std::move(more.time));
        replace(stereo, std::move(more.stereo));
        size = {std::max<std::size_t>(size[0], 1), std::max<std::size_t>(size[1], 1)};
        chooses_exposure |= more.choose_exposure;
    }

private:
    template <class Member>
    static void replace(Member& member, std::optional<Member>&& by) {
        if (by) {
            member = std::move(*by);
        }
    }
};

}  // namespace

struct View::State {
    State(std::optional<app::PreparedScene> prepared, const app::Request& of, Observer observing,
          const Options& chosen, std::filesystem::path where)
        : scene(std::move(prepared)),
          request(of),
          observer(std::move(observing)),
          options(chosen),
          wanted(of),
          camera(std::move(where)),
          thread([this](const std::stop_token& stop) { work(stop); }) {}

    // Of the thread.
    void work(const std::stop_token& stop);
    [[nodiscard]] bool load(const std::stop_token& stop);
    void share_scene();
    void show(const Wanted& next, const std::stop_token& newer, const std::stop_token& view_ends);
    [[nodiscard]] bool follow(const Wanted& next, const std::stop_token& newer);
    [[nodiscard]] std::vector<Value> dragged(const Wanted& next, const std::stop_token& newer);
    [[nodiscard]] std::size_t coarse_part(const std::array<std::size_t, 2>& size) const;
    void show_preview(const Wanted& next, std::size_t part, const std::stop_token& stop);
    [[nodiscard]] bool is_at_rest(const Wanted& next, const std::stop_token& newer);
    void show_paths(const Wanted& next, const std::stop_token& newer);
    void tell(const Wanted& next, const render::Film& film, Quality quality, std::size_t samples,
              const std::stop_token& stop);
    void tell_camera(const Wanted& next, Diagnostics found);
    [[nodiscard]] std::optional<double> exposure(std::string_view integrator,
                                                 const std::stop_token& newer);

    std::optional<app::PreparedScene> scene;  // Of the thread, once it has begun.
    app::Request request;
    Observer observer;
    Options options;

    std::mutex mutex;  // Guards what follows.
    std::condition_variable_any changed;
    Wanted wanted;
    std::stop_source old;  // Of the work for the last change that the thread has seen.
    std::optional<app::PreparedScene> shared_scene;
    std::optional<Shown> shown;

    // Of the thread.
    std::uint64_t last_change = 0;
    FollowedPicture camera;
    std::optional<double> preview_exposure;
    std::optional<double> path_exposure;
    double seconds_a_pixel = 1e-7;  // Of a preview.

    std::jthread thread;  // The last member, since it uses the others.
};

View::View(std::unique_ptr<State> state) : state_(std::move(state)) {}

std::unique_ptr<View> View::make(app::PreparedScene scene, const app::Request& request,
                                 Observer observer, const Options& options,
                                 std::filesystem::path folder) {
    return std::unique_ptr<View>(new View(std::make_unique<State>(
        std::move(scene), request, std::move(observer), options, std::move(folder))));
}

std::unique_ptr<View> View::load(const app::Request& request, Observer observer,
                                 const Options& options, std::filesystem::path folder) {
    return std::unique_ptr<View>(new View(std::make_unique<State>(
        std::nullopt, request, std::move(observer), options, std::move(folder))));
}

View::~View() {
    state_->thread.request_stop();
    const std::lock_guard lock(state_->mutex);
    state_->old.request_stop();
}

std::uint64_t View::change(Change change) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(state_->mutex);
        state_->wanted.add(std::move(change));
        number = state_->wanted.change;
        state_->old.request_stop();
    }
    state_->changed.notify_one();
    return number;
}

std::optional<app::PreparedScene> View::scene() const {
    const std::lock_guard lock(state_->mutex);
    return state_->shared_scene ? std::optional(state_->shared_scene->share()) : std::nullopt;
}

std::optional<Shown> View::shown() const {
    const std::lock_guard lock(state_->mutex);
    return state_->shown;
}

// False if there is no scene.
bool View::State::load(const std::stop_token& stop) {
    const auto tell = [this](const SceneState& state) {
        if (observer.scene) {
            observer.scene(state);
        }
    };
    std::optional<app::Step> told;
    const auto begins = [&](app::Step step, double) {
        if (step != told) {
            told = step;
            tell({.step = step});
        }
    };
    Result<app::PreparedScene> made = app::PreparedScene::make(request, {.step = begins}, stop);
    if (stop.stop_requested()) {
        return false;
    }
    scene = std::move(made.value);
    if (scene) {
        share_scene();
    }
    tell({.diagnostics = std::move(made.diagnostics),
          .duration = scene ? duration_of(*scene) : 0.0});
    return scene.has_value();
}

// Before it is told that the scene is there.
void View::State::share_scene() {
    const std::lock_guard lock(mutex);
    shared_scene = scene->share();
}

void View::State::work(const std::stop_token& stop) {
    if (scene) {
        share_scene();
    }
    while (!scene) {
        const app::FileWatch watch(scene_files(request));
        if (!load(stop) && !app::wait_for_change({watch}, stop)) {
            return;
        }
    }
    for (;;) {
        Wanted next;
        std::stop_token newer;
        {
            std::unique_lock lock(mutex);
            changed.wait(lock, stop, [this] { return wanted.change != last_change; });
            if (stop.stop_requested()) {
                return;
            }
            next = wanted;
            wanted.chooses_exposure = false;
            old = std::stop_source();
            newer = old.get_token();
        }
        show(next, newer, stop);
        last_change = next.change;
        if (!newer.stop_requested() && observer.rest) {
            observer.rest(last_change);
        }
    }
}

void View::State::show(const Wanted& next, const std::stop_token& newer,
                       const std::stop_token& view_ends) {
    if (next.chooses_exposure) {
        preview_exposure.reset();
        path_exposure.reset();
    }
    if (!follow(next, newer)) {
        return;
    }
    // Not even a newer change stops the first frame: of a camera in motion, nothing would be seen.
    const std::size_t part = coarse_part(next.size);
    show_preview(next, part, view_ends);
    if (part > 1) {
        show_preview(next, 1, newer);
    }
    if (options.traces_paths && is_at_rest(next, newer)) {
        show_paths(next, newer);
    }
}

// Waits; false if a newer change comes.
bool View::State::is_at_rest(const Wanted& next, const std::stop_token& newer) {
    const std::chrono::duration<double> rest(options.rest_seconds);
    std::unique_lock lock(mutex);
    changed.wait_until(lock, newer, next.since + std::chrono::duration_cast<Clock::duration>(rest),
                       [] { return false; });
    return !newer.stop_requested();
}

// Moves the camera, or makes it anew. False if there is none, or if a newer change has come.
bool View::State::follow(const Wanted& next, const std::stop_token& newer) {
    Diagnostics found;
    const bool holds = !next.drag.pulls.empty() && !next.stereo;
    if (!camera.follow(*scene, next, holds, newer, found)) {
        if (kind_of_errors(found) != Kind::interrupted) {
            tell_camera(next, std::move(found));
        }
        return false;
    }
    Shown now = next;
    now.values = dragged(next, newer);
    camera.picture().move(now.values, found);
    {
        const std::lock_guard lock(mutex);
        shown = std::move(now);
    }
    tell_camera(next, std::move(found));
    return true;
}

// Of both eyes' pictures, a point has two places.
Dragged not_dragged(const Wanted& next) {
    Dragged none;
    none.points.resize(next.drag.pulls.size());
    none.diagnostics = {
        error("a hand pulls at the picture of one eye", {}, "leave the stereo view")};
    return none;
}

// The values of a change, or what follows its drag.
std::vector<Value> View::State::dragged(const Wanted& next, const std::stop_token& newer) {
    std::vector<Value> values = next.values;
    if (next.drag.pulls.empty()) {
        return values;
    }
    Dragged made = next.stereo ? not_dragged(next)
                               : camera.picture().drag(next.drag, values, next.time,
                                                       scene->scene()->axes, newer);
    made.change = next.change;
    for (const Value& one : made.values) {
        std::erase_if(values, [&](const Value& given) { return given.parameter == one.parameter; });
        values.push_back(one);
    }
    if (observer.drag && !newer.stop_requested()) {
        observer.drag(made);
    }
    return values;
}

void View::State::tell_camera(const Wanted& next, Diagnostics found) {
    if (!observer.camera) {
        return;
    }
    CameraState state{next.change, std::move(found)};
    if (!has_errors(state.diagnostics)) {
        const lang::OpenPicture& opened = camera.picture().opened();
        state.name = opened.picture.parts().name;
        state.aspect = opened.picture.parts().aspect;
        state.stereo = next.stereo;
        state.time = next.time;
        state.open = opened.open;
        state.closed = opened.numbers;
        for (const lang::MovingParameter& one : opened.moving) {
            state.moving.push_back(one.at(next.time));
        }
    }
    observer.camera(state);
}

// By how much the sides of a picture are divided for a frame in time; 1 if it is fast enough.
std::size_t View::State::coarse_part(const std::array<std::size_t, 2>& size) const {
    constexpr double coarsest = 16.0;
    const double seconds = seconds_a_pixel * static_cast<double>(size[0] * size[1]);
    return static_cast<std::size_t>(
        std::ceil(std::clamp(std::sqrt(seconds / options.coarse_seconds), 1.0, coarsest)));
}

void View::State::show_preview(const Wanted& next, std::size_t part, const std::stop_token& stop) {
    Diagnostics found;
    const auto begin = Clock::now();
    if (const render::Film* const film = camera.picture().preview(*scene, part, stop, found)) {
        seconds_a_pixel = seconds_since(begin) / static_cast<double>(film->window.size());
        tell(next, *film, part > 1 ? Quality::coarse : Quality::preview, 1, stop);
    }
}

// Twice as many samples from frame to frame.
void View::State::show_paths(const Wanted& next, const std::stop_token& newer) {
    Diagnostics found;
    const std::size_t most = scene->settings().samples;
    const render::Film* film = nullptr;
    for (std::size_t samples = 1; samples < 2 * most; samples *= 2) {
        film =
            camera.picture().paths(*scene, std::min(samples, most), options.denoises, newer, found);
        if (film == nullptr) {
            return;
        }
        tell(next, *film, Quality::paths, std::min(samples, most), newer);
    }
    if (!options.denoises || film == nullptr || newer.stop_requested()) {
        return;
    }
    render::Film copy = *film;
    if (render::denoise(copy)) {
        tell(next, copy, Quality::denoised, most, newer);
    }
}

void View::State::tell(const Wanted& next, const render::Film& film, Quality quality,
                       std::size_t samples, const std::stop_token& newer) {
    const bool is_preview = quality == Quality::coarse || quality == Quality::preview;
    const std::optional<double> exposed =
        exposure(is_preview ? "preview" : scene->settings().integrator, newer);
    if (!exposed || newer.stop_requested() || !observer.frame) {
        return;
    }
    const auto pixels =
        render::display_pixels(film, {.exposure = *exposed,
                                      .view = with_stereo_of(request, next).view_transform(),
                                      .dither = request.dither});
    observer.frame({next.change, quality, film.width, film.height, pixels, samples,
                    seconds_since(next.since)});
}

// Chosen by the first picture, and held: a picture in motion does not flicker.
std::optional<double> View::State::exposure(std::string_view integrator,
                                            const std::stop_token& newer) {
    std::optional<double>& held = integrator == "preview" ? preview_exposure : path_exposure;
    if (!held) {
        const Result<double> chosen =
            scene->exposure(camera.picture().opened().picture, integrator, newer);
        held = chosen ? std::optional(*chosen) : std::nullopt;
    }
    return held;
}

}  // namespace balcony::live
