// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/run.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>

#include <tbb/enumerable_thread_specific.h>

#include "base/parallel_for.hpp"
#include "base/stopwatch.hpp"
#include "render/job/adaptive.hpp"

namespace balcony::render {

namespace {

// All passes over all tiles on a number of threads.
class Run {
public:
    Run(const JobParts& parts, const PictureInputs& inputs, Supersampling& supersampling,
        Film& film, std::span<const std::uint32_t> passes, const ProgressCallback& progress,
        std::stop_token stop)
        : parts_(parts),
          film_(film),
          passes_(passes),
          last_pass_(*std::max_element(passes.begin(), passes.end())),
          tiles_(tiles_missing()),
          workers_([&parts, &inputs, &supersampling, &film] {
              return TileWorker(parts, inputs, supersampling, film);
          }),
          progress_(progress),
          stop_(std::move(stop)) {}

    Summary operator()() {
        bool complete = true;
        for (std::uint32_t pass = fewest_passes(); complete && pass < last_pass_; ++pass) {
            if (is_adaptive() && film_.white == 0.0 &&
                pass >= first_judgement(parts_.settings.sampling)) {
                film_.white = white_of(film_);
            }
            complete = add_pass(pass);
        }
        return summary(complete);
    }

private:
    [[nodiscard]] std::size_t tiles_missing() const {
        std::size_t missing = 0;
        for (std::size_t tile = 0; tile < passes_.size(); ++tile) {
            missing += passes_[tile] - std::min(passes_[tile], film_.passes[tile]);
        }
        return missing;
    }

    [[nodiscard]] bool is_adaptive() const { return !film_.pixel_passes.empty(); }

    [[nodiscard]] std::uint32_t fewest_passes() const {
        return *std::min_element(film_.passes.begin(), film_.passes.end());
    }

    // Adds one pass to the tiles that have this number of passes and need more. Returns whether the
    // pass was completed.
    bool add_pass(std::uint32_t pass) {
        std::vector<std::size_t> tiles;
        for (std::size_t tile = 0; tile < passes_.size(); ++tile) {
            if (film_.passes[tile] == pass && passes_[tile] > pass) {
                tiles.push_back(tile);
            }
        }
        std::atomic<bool> complete = true;
        const auto render_tile = [&](std::size_t i) {
            if (stop_.stop_requested()) {
                complete = false;
            } else {
                const bool sampled = workers_.local().render(tiles[i]);
                report(pass, tiles[i], sampled);
            }
        };
        parallel_for(tiles.size(), render_tile, parts_.settings.threads);
        return complete;
    }

    // A tile that needs no more samples is done with all passes; that alone is no progress. One
    // thread at a time passes on what all have reported, without holding the lock.
    void report(std::size_t pass, std::size_t tile, bool sampled) {
        if (!progress_) {
            return;
        }
        std::unique_lock lock(progress_mutex_);
        tiles_done_ += sampled ? 1 : passes_[tile] - pass;
        if (!sampled) {
            return;
        }
        reported_.push_back({film_.first_pass + pass, film_.first_pass + last_pass_, tiles_done_,
                             tiles_, film_.tile(tile).intersection(film_.window),
                             watch_.seconds()});
        if (passing_on_) {
            return;
        }
        passing_on_ = true;
        while (!reported_.empty()) {
            const Progress next = reported_.front();
            reported_.pop_front();
            lock.unlock();
            progress_(next);
            lock.lock();
        }
        passing_on_ = false;
    }

    [[nodiscard]] Summary summary(bool complete) const {
        WorkCounts counts;
        for (const TileWorker& worker : workers_) {
            counts.add(worker.counts());
        }
        Summary summary;
        counts.layers.resize(parts_.picture.layers().size());
        for (std::size_t i = 0; i < counts.layers.size(); ++i) {
            const RayCounts& layer = counts.layers[i];
            summary.layers.push_back({layer, parts_.picture.layers()[i].name});
            summary.camera_rays += layer.camera_rays;
            summary.invalid_rays += layer.invalid_rays;
        }
        summary.invalid_pixels = counts.invalid_pixels;
        summary.repaired = counts.repaired;
        summary.unknown_motion = counts.motion.unknown;
        summary.ambiguous_motion = counts.motion.ambiguous;
        summary.ambient = *parts_.settings.ambient;
        summary.light = parts_.light;
        summary.substitute = parts_.substitute;
        summary.passes = fewest_passes();
        summary.interrupted = !complete;
        summary.seconds = watch_.seconds();
        summary.compile_seconds = parts_.compile_seconds;
        summary.camera_share = counts.seconds > 0.0 ? counts.camera_seconds / counts.seconds : 0.0;
        return summary;
    }

    const JobParts& parts_;
    Film& film_;
    std::span<const std::uint32_t> passes_;  // The target, by tile.
    std::uint32_t last_pass_;
    std::size_t tiles_;  // The total number, over all passes.
    tbb::enumerable_thread_specific<TileWorker> workers_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    Stopwatch watch_;
    std::mutex progress_mutex_;
    std::size_t tiles_done_ = 0;
    std::deque<Progress> reported_;  // Not yet passed on.
    bool passing_on_ = false;
};

}  // namespace

Summary run(const JobParts& parts, const PictureInputs& inputs, Supersampling& supersampling,
            Film& film, std::span<const std::uint32_t> passes, const ProgressCallback& progress,
            std::stop_token stop) {
    return Run(parts, inputs, supersampling, film, passes, progress, std::move(stop))();
}

}  // namespace balcony::render
