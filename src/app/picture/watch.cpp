// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/inputs/file_watch.hpp"
#include "app/picture/session.hpp"

namespace balcony::app {

namespace {

// The file of the environment of a request, if it is one.
std::vector<std::filesystem::path> environment_files(const Request& request) {
    const auto* const file = std::get_if<std::filesystem::path>(&request.light.environment);
    return file == nullptr ? std::vector<std::filesystem::path>{} : std::vector{*file};
}

}  // namespace

/// The files of a picture, while it is rendered again and again.
class PictureWatch {
public:
    PictureWatch(Request request, const Observer& observer)
        : request_(std::move(request)),
          observer_(observer),
          environment_(environment_files(request_)) {
        // A picture that is watched is no job to be continued.
        request_.job.checkpoint_every.reset();
    }

    /// The picture as its files are now, or nothing if one of them changes meanwhile.
    [[nodiscard]] std::optional<Report> render(const std::stop_token& stop) {
        start_ = FileWatch::Time::clock::now();
        reads_scene_ = !loaded().renderer;
        cameras_.reset();
        scene_.reset();
        std::stop_source ended;
        const std::stop_callback forward(stop, [&ended] { ended.request_stop(); });
        Observer watching = observer_;
        bool& outdated = session_.state_->is_outdated;
        outdated = false;
        watching.progress = [&](const render::Progress& state) {
            if (observer_.progress) {
                observer_.progress(state);
            }
            if (!outdated && is_time_to_look() && has_changed()) {
                outdated = true;
                ended.request_stop();
            }
        };
        Report report = session_.render(request_, watching, ended.get_token());
        if (outdated && !stop.stop_requested()) {
            return std::nullopt;
        }
        return report;
    }

    /// Waits for a change; false at a stop.
    [[nodiscard]] bool wait(const std::function<void(std::size_t)>& on_wait,
                            const std::stop_token& stop) {
        look();
        if (on_wait) {
            on_wait(cameras_->size() + scene_->size() + environment_.size());
        }
        if (!wait_for_change({*cameras_, *scene_, environment_}, stop)) {
            return false;
        }
        loaded().cameras.reload();
        if (environment_.has_changed()) {
            environment_ = FileWatch(environment_files(request_));
        }
        if (scene_->has_changed()) {
            loaded().renderer.reset();
            loaded().scene.reset();
        }
        return true;
    }

private:
    [[nodiscard]] Loaded& loaded() { return session_.state_->loaded; }

    // Asking for the states of files takes time.
    [[nodiscard]] bool is_time_to_look() {
        const auto now = std::chrono::steady_clock::now();
        if (now < next_) {
            return false;
        }
        next_ = now + std::chrono::milliseconds(100);
        return true;
    }

    // The files are known when the rendering begins.
    void look() {
        if (loaded().scene) {
            scene_files_ = loaded().scene->files;
        }
        if (!cameras_) {
            cameras_.emplace(loaded().cameras.files(), start_);
        }
        if (!scene_) {
            scene_ = reads_scene_ ? FileWatch(scene_files_, start_) : FileWatch(scene_files_);
        }
    }

    [[nodiscard]] bool has_changed() {
        look();
        return cameras_->has_changed() || scene_->has_changed() || environment_.has_changed();
    }

    Request request_;
    const Observer& observer_;
    Session session_;
    std::vector<std::filesystem::path> scene_files_{request_.scene};
    FileWatch environment_;
    std::optional<FileWatch> cameras_;
    std::optional<FileWatch> scene_;
    FileWatch::Time start_{};
    bool reads_scene_ = true;
    std::chrono::steady_clock::time_point next_{};
};

Report watch(const Request& request, const Observer& observer,
             const std::function<void(const Report&)>& on_report,
             const std::function<void(std::size_t)>& on_wait, const std::stop_token& stop) {
    PictureWatch watched(request, observer);
    for (;;) {
        const std::optional<Report> report = watched.render(stop);
        if (report) {
            if (on_report) {
                on_report(*report);
            }
            if (report->interrupted || kind_of_errors(report->diagnostics) == Kind::usage) {
                return *report;
            }
        }
        if (!watched.wait(report ? on_wait : nullptr, stop)) {
            Report ended;
            ended.interrupted = true;
            return ended;
        }
    }
}

}  // namespace balcony::app
