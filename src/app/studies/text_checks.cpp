// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/text_checks.hpp"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "balcony/diagnose.hpp"
#include "balcony/lang.hpp"
#include "balcony/language_service.hpp"

namespace balcony::app {

namespace {

struct Task {
    std::string name;
    std::shared_ptr<const SourceText> text;
    std::filesystem::path folder;
};

// Where a text declares a camera.
SourceSpan place_of(const Task& task, std::string_view camera) {
    for (const lang::DeclaredName& one : lang::EditedText(task.text, task.folder).declared()) {
        if (one.kind == lang::WordKind::camera && one.name == camera) {
            return {task.text, one.name_begin, one.name_end};
        }
    }
    return {};
}

// What `check` finds about one camera. Fewer samples than the command takes are enough to see it.
void look_at(const camera::Camera& camera, const Task& task, const std::stop_token& stop,
             Diagnostics& found) {
    constexpr double width = 640.0;
    constexpr std::size_t max_samples = 16384;
    const SourceSpan place = place_of(task, camera.name());
    const auto report = analyse::diagnose(
        camera,
        {.width = width,
         .height = std::max(1.0, std::round(width / camera.fixed_aspect().value_or(16.0 / 9.0))),
         .max_samples = max_samples,
         .distance = {}},
        {}, stop);
    if (!report || !place.source) {
        return;
    }
    for (const analyse::Finding& one : report->findings) {
        if (one.defect) {
            found.push_back(warning(one.message, place, one.remedy));
        }
    }
}

}  // namespace

class TextChecks::Worker {
public:
    Worker(std::function<void(const TextCheck&)> tell, std::chrono::milliseconds pause)
        : tell_(std::move(tell)),
          pause_(pause),
          thread_([this](const std::stop_token& stop) { work(stop); }) {}

    ~Worker() {
        thread_.request_stop();
        const std::lock_guard lock(mutex_);
        if (current_) {
            current_->second.request_stop();
        }
    }

    void add(Task task) {
        const std::lock_guard lock(mutex_);
        drop(task.name);
        waiting_.push_back(std::move(task));
        last_change_ = std::chrono::steady_clock::now();
        changed_.notify_all();
    }

    void forget(const std::string& name) {
        const std::lock_guard lock(mutex_);
        drop(name);
    }

private:
    // Under the lock.
    void drop(const std::string& name) {
        std::erase_if(waiting_, [&name](const Task& one) { return one.name == name; });
        if (current_ && current_->first == name) {
            current_->second.request_stop();
        }
    }

    void work(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) &&
               !stop.stop_requested()) {
            const auto ready = last_change_ + pause_;
            if (std::chrono::steady_clock::now() < ready) {
                changed_.wait_until(lock, stop, ready, [] { return false; });
                continue;
            }
            const Task task = std::move(waiting_.front());
            waiting_.pop_front();
            std::stop_source source;
            current_.emplace(task.name, source);
            lock.unlock();
            check_text(task, source.get_token());
            lock.lock();
            current_.reset();
        }
    }

    void check_text(const Task& task, const std::stop_token& stop) {
        lang::Workspace workspace;
        workspace.stop_with(stop);
        const auto made = workspace.make_all(lang::CameraSource(task.text, task.folder));
        TextCheck check{task.name, task.text, made.diagnostics, !made};
        tell(check, stop);
        if (!made) {
            return;
        }
        for (const camera::Picture& picture : *made) {
            if (const camera::Camera* camera = picture.only_camera()) {
                look_at(*camera, task, stop, check.found);
            }
        }
        check.is_complete = true;
        tell(check, stop);
    }

    // What is out of date is not told.
    void tell(const TextCheck& check, const std::stop_token& stop) {
        const std::lock_guard lock(mutex_);
        if (!stop.stop_requested()) {
            tell_(check);
        }
    }

    const std::function<void(const TextCheck&)> tell_;
    const std::chrono::milliseconds pause_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Task> waiting_;
    std::chrono::steady_clock::time_point last_change_;
    std::optional<std::pair<std::string, std::stop_source>> current_;
    std::jthread thread_;  // The last member: it uses the others.
};

TextChecks::TextChecks(std::function<void(const TextCheck&)> tell, std::chrono::milliseconds pause)
    : worker_(std::make_unique<Worker>(std::move(tell), pause)) {}

TextChecks::~TextChecks() = default;

void TextChecks::check(const std::string& name, std::shared_ptr<const SourceText> text,
                       std::filesystem::path folder) {
    worker_->add({name, std::move(text), std::move(folder)});
}

void TextChecks::forget(const std::string& name) { worker_->forget(name); }

}  // namespace balcony::app
