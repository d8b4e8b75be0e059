// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/thumbnails.hpp"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "balcony/display_pixels.hpp"
#include "balcony/progress.hpp"
#include "balcony/render.hpp"

namespace balcony::live {

namespace {

using Size = std::array<std::size_t, 2>;

constexpr std::size_t samples = 4;

// Of an aspect, as large as there is room for.
Size fitted(const Size& room, double aspect) {
    const auto width = static_cast<double>(room[0]);
    const auto height = static_cast<double>(room[1]);
    const auto side = [](double length) {
        return static_cast<std::size_t>(std::max(std::round(length), 1.0));
    };
    return {side(std::min(width, height * aspect)), side(std::min(height, width / aspect))};
}

struct Task {
    std::string camera;
    Size room{};
};

Thumbnail thumbnail_of(const Task& task, app::PreparedScene& scene, const app::Request& request,
                       const std::stop_token& stop) {
    Thumbnail made{.camera = task.camera, .room = task.room};
    const std::vector<std::string> none;
    Result<lang::OpenPicture> opened = scene.picture(task.camera, "", {}, stop, none);
    if (!opened) {
        made.diagnostics = std::move(opened.diagnostics);
        return made;
    }
    const Size size = fitted(task.room, opened->picture.aspect());
    Result<render::Film> film =
        render::make_film({.width = size[0], .height = size[1], .data_layers = false});
    if (!film) {
        made.diagnostics = std::move(film.diagnostics);
        return made;
    }
    render::Settings settings = scene.settings();
    settings.integrator = "preview";
    settings.samples = samples;
    settings.sampling.noise = 0.0;
    settings.threads = 1;
    const Result<render::Summary> summary =
        render::render(scene.renderer(), opened->picture, settings, *film, {}, stop);
    if (!summary || summary->interrupted) {
        made.diagnostics = summary ? Diagnostics{stopped()} : summary.diagnostics;
        return made;
    }
    made.width = size[0];
    made.height = size[1];
    made.pixels = render::display_pixels(
        *film, {.exposure = request.exposure.value_or(render::automatic_exposure(*film)),
                .view = request.view_transform(),
                .dither = request.dither});
    return made;
}

}  // namespace

struct Thumbnails::State {
    State(const app::Request& of, Made told) : request(of), made(std::move(told)) {}

    void work(app::PreparedScene scene, std::size_t number, const std::stop_token& stop);

    app::Request request;
    Made made;
    std::mutex telling;

    std::mutex mutex;  // Guards what follows.
    std::condition_variable_any changed;
    std::deque<Task> waiting;
    /// What a thread does, if it does something.
    struct Work {
        Task task;
        std::stop_source stop;
    };
    std::vector<std::optional<Work>> in_progress;

    std::vector<std::jthread> threads;  // The last member, since they use the others.
};

Thumbnails::Thumbnails(const app::PreparedScene& scene, const app::Request& request, Made made)
    : state_(std::make_unique<State>(request, std::move(made))) {
    const std::size_t count = std::max(std::thread::hardware_concurrency(), 1U);
    state_->in_progress.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        state_->threads.emplace_back(
            [state = state_.get(), i, own = scene.share()](const std::stop_token& stop) mutable {
                state->work(std::move(own), i, stop);
            });
    }
}

Thumbnails::~Thumbnails() {
    show({}, {});
    for (std::jthread& thread : state_->threads) {
        thread.request_stop();
    }
}

void Thumbnails::show(const std::vector<std::string>& cameras, const Size& size) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->waiting.clear();
        for (const std::string& camera : cameras) {
            state_->waiting.push_back({camera, size});
        }
        for (std::optional<State::Work>& work : state_->in_progress) {
            const auto is_done = [&](const Task& task) {
                return work && work->task.camera == task.camera && work->task.room == task.room;
            };
            if (std::erase_if(state_->waiting, is_done) == 0 && work) {
                work->stop.request_stop();
            }
        }
    }
    state_->changed.notify_all();
}

void Thumbnails::State::work(app::PreparedScene scene, std::size_t number,
                             const std::stop_token& stop) {
    for (;;) {
        Work next;
        {
            std::unique_lock lock(mutex);
            changed.wait(lock, stop, [this] { return !waiting.empty(); });
            if (stop.stop_requested()) {
                return;
            }
            next.task = std::move(waiting.front());
            waiting.pop_front();
            in_progress[number] = next;
        }
        const Thumbnail done = thumbnail_of(next.task, scene, request, next.stop.get_token());
        const std::lock_guard order(telling);
        {
            // What is asked for from now on is made again.
            const std::lock_guard lock(mutex);
            in_progress[number].reset();
        }
        if (!next.stop.stop_requested()) {
            made(done);
        }
    }
}

}  // namespace balcony::live
