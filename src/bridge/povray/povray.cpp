// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/povray.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "balcony/picture_samples.hpp"
#include "bridge/povray/camera_mesh.hpp"
#include "bridge/povray/povray_run.hpp"
#include "bridge/povray/scene_axes.hpp"

namespace balcony::bridge {

namespace {

namespace fs = std::filesystem;
using povray::CameraMesh;
using povray::MeshFrame;
using povray::StripMesh;

// POV-Ray looks through the faces of an interpolating mesh one by one, so that a ray costs more,
// the more faces there are: with about 100 000, as much as to read a face of its own.
constexpr std::size_t max_cell_faces_of_run = 100'000;
constexpr std::size_t min_rays_of_cell_face = 12;
// A face of its own for each pixel of 1920 x 1080, which takes POV-Ray 600 MB.
constexpr std::size_t max_single_faces_of_run = std::size_t{1} << 21;
constexpr std::size_t max_pixels_of_run = std::size_t{1} << 25;
constexpr std::size_t max_rows_of_run = 32'000;

class Watch {
public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Some rows of a layer in a pass, which POV-Ray renders as a strip of its picture.
struct Strip {
    std::size_t pass = 0;
    std::size_t layer = 0;
    std::size_t first_row = 0;
    std::size_t rows = 0;
};

/// Renders the strips of all layers and passes and adds the passes to the film.
class StripRenderer {
public:
    StripRenderer(render::PictureSamples samples, const povray::PovrayRun& run,
                  const PovraySettings& settings, render::Film& film,
                  const render::ProgressCallback& progress, std::stop_token stop)
        : samples_(std::move(samples)),
          run_(run),
          settings_(settings),
          film_(film),
          progress_(progress),
          stop_(std::move(stop)) {}

    [[nodiscard]] PovraySummary render() {
        frame_ = povray::mesh_frame(samples_, film_.width, film_.height);
        for (std::size_t pass = 0; pass < settings_.samples && is_fine(); ++pass) {
            for (std::size_t layer = 0; layer < samples_.layer_count() && is_fine(); ++layer) {
                add_layer(pass, layer);
            }
        }
        flush();
        return std::move(summary_);
    }

private:
    [[nodiscard]] bool is_fine() {
        if (has_errors(summary_.diagnostics)) {
            return false;
        }
        summary_.interrupted = summary_.interrupted || stop_.stop_requested();
        return !summary_.interrupted;
    }

    std::vector<render::LayerColors>& colors_of(std::size_t pass) {
        std::vector<render::LayerColors>& layers = colors_[pass];
        layers.resize(samples_.layer_count());
        return layers;
    }

    void add_layer(std::size_t pass, std::size_t layer) {
        std::vector<std::uint8_t>& seen = colors_of(pass)[layer].seen;
        const std::size_t width = film_.width;
        const std::size_t height = film_.height;
        if (!samples_.has_lens(layer) && height <= max_rows_of_run) {
            const Watch watch;
            const std::size_t max_faces =
                std::min(max_cell_faces_of_run, width * height / min_rays_of_cell_face);
            CameraMesh mesh = povray::make_camera_mesh(samples_, layer, pass, width, height, frame_,
                                                       max_faces, seen);
            summary_.camera_seconds += watch.seconds();
            if (mesh.complete) {
                add_strip({pass, layer, 0, height}, std::move(mesh), false);
                return;
            }
        }
        seen.clear();
        const std::size_t rows = std::clamp<std::size_t>(
            max_single_faces_of_run / width, 1,
            std::min(height, max_rows_of_run - povray::first_row_of_single_faces));
        for (std::size_t y = 0; y < height && is_fine(); y += rows) {
            const Watch watch;
            const render::Region region{0, y, width, std::min(rows, height - y)};
            std::vector<std::uint8_t> seen_here;
            CameraMesh mesh =
                povray::make_single_faces(samples_, layer, pass, region, frame_, seen_here);
            seen.insert(seen.end(), seen_here.begin(), seen_here.end());
            summary_.camera_seconds += watch.seconds();
            add_strip({pass, layer, y, region.height}, std::move(mesh), true);
        }
    }

    // Adds a strip to the next run, after the run of those that it does not fit with.
    void add_strip(const Strip& strip, CameraMesh mesh, bool single_faces) {
        const std::size_t rows = rows_ + strip.rows;
        const bool full = rows > max_rows_of_run || rows * film_.width > max_pixels_of_run ||
                          faces_ + mesh.faces.size() >
                              (single_faces ? max_single_faces_of_run : max_cell_faces_of_run);
        if (!strips_.empty() && (full || single_faces != single_faces_)) {
            flush();
        }
        if (strips_.empty()) {
            single_faces_ = single_faces;
            rows_ = single_faces ? povray::first_row_of_single_faces : 0;
        }
        summary_.camera_rays += mesh.rays;
        summary_.single_rays += mesh.single_rays;
        summary_.faces += mesh.faces.size();
        summary_.largest_error = std::max(summary_.largest_error, mesh.largest_error);
        rays_ += mesh.rays;
        faces_ += mesh.faces.size();
        strips_.push_back(strip);
        meshes_.push_back({rows_, std::move(mesh)});
        rows_ += strip.rows;
    }

    // Renders the strips that wait.
    void flush() {
        if (is_fine() && !strips_.empty()) {
            // Nothing is to be seen if there is no ray.
            if (rays_ > 0) {
                run();
            }
            if (is_fine()) {
                read();
            }
            done_strips_ += static_cast<double>(rows_) / static_cast<double>(film_.height);
        }
        strips_.clear();
        meshes_.clear();
        rows_ = 0;
        faces_ = 0;
        rays_ = 0;
    }

    void run() {
        Diagnostics failed = run_.write_scene({film_.width, rows_, meshes_, single_faces_}, frame_);
        // Their memory is POV-Ray's now.
        for (StripMesh& strip : meshes_) {
            strip.mesh = {};
        }
        if (!failed.empty()) {
            fail(failed);
            return;
        }
        finish_run(run_.render(
            film_.width, rows_, [&](double part) { show_progress(part); }, stop_));
    }

    void finish_run(povray::RunEnd end) {
        summary_.povray_seconds += end.seconds;
        // POV-Ray repeats its warnings in each run.
        if (summary_.runs == 0 || has_errors(end.diagnostics)) {
            summary_.diagnostics.insert(summary_.diagnostics.end(), end.diagnostics.begin(),
                                        end.diagnostics.end());
        }
        ++summary_.runs;
    }

    // Reads POV-Ray's picture, and adds the passes that are complete.
    void read() {
        std::optional<povray::LightFile> file;
        if (rays_ > 0) {
            Result<povray::LightFile> opened = run_.open_picture(film_.width, rows_);
            if (!opened) {
                fail(opened.diagnostics);
                return;
            }
            file = std::move(*opened.value);
        }
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            const Strip& strip = strips_[i];
            std::vector<render::LayerColors>& layers = colors_of(strip.pass);
            std::vector<Imath::Color4f>& light = layers[strip.layer].light;
            light.resize(film_.width * film_.height, Imath::Color4f(0.0F));
            if (file) {
                const std::span<Imath::Color4f> rows(&light[strip.first_row * film_.width],
                                                     strip.rows * film_.width);
                if (Diagnostics failed = file->read_rows(meshes_[i].first_row, rows);
                    !failed.empty()) {
                    fail(failed);
                    return;
                }
            }
            const bool last_rows = strip.first_row + strip.rows == film_.height;
            if (last_rows && strip.layer + 1 == samples_.layer_count()) {
                samples_.add_pass(strip.pass, layers, film_);
                colors_.erase(strip.pass);
            }
        }
    }

    void fail(const Diagnostics& diagnostics) {
        summary_.diagnostics.insert(summary_.diagnostics.end(), diagnostics.begin(),
                                    diagnostics.end());
    }

    void show_progress(double part_of_run) const {
        if (!progress_) {
            return;
        }
        constexpr double steps = 10'000.0;
        const double strips = static_cast<double>(settings_.samples * samples_.layer_count());
        const double here = static_cast<double>(rows_) / static_cast<double>(film_.height);
        const double done = (done_strips_ + part_of_run * here) / strips;
        render::Progress progress;
        progress.passes = settings_.samples;
        progress.pass = std::min<std::size_t>(
            static_cast<std::size_t>(done * static_cast<double>(settings_.samples)),
            settings_.samples - 1);
        progress.tiles = static_cast<std::size_t>(steps);
        progress.tiles_done = static_cast<std::size_t>(std::min(done, 1.0) * steps);
        progress.seconds = watch_.seconds();
        progress_(progress);
    }

    render::PictureSamples samples_;
    const povray::PovrayRun& run_;
    const PovraySettings& settings_;
    render::Film& film_;
    const render::ProgressCallback& progress_;
    std::stop_token stop_;
    PovraySummary summary_;
    MeshFrame frame_;
    Watch watch_;

    // The strips that wait, with their meshes one below the other.
    std::vector<Strip> strips_;
    std::vector<StripMesh> meshes_;
    bool single_faces_ = false;
    std::size_t rows_ = 0;
    std::size_t faces_ = 0;
    std::uint64_t rays_ = 0;
    double done_strips_ = 0.0;
    std::map<std::size_t, std::vector<render::LayerColors>> colors_;  // By pass in progress.
};

}  // namespace

PovraySummary render_with_povray(const PovrayProgram& program, const fs::path& scene,
                                 const camera::Picture& picture, const PovraySettings& settings,
                                 render::Film& film, const render::ProgressCallback& progress,
                                 std::stop_token stop) {
    const povray::AxesRow* const axes = povray::find_axes(settings.axes);
    if (axes == nullptr) {
        return {.diagnostics = {error(fmt::format("POV-Ray's scenes cannot have axes '{}'",
                                                  printable(settings.axes)))}};
    }
    std::error_code failed;
    if (auto fault = not_a_file(scene, fmt::format("'{}'", scene.string()))) {
        fault->remedy = "name a scene file of POV-Ray, such as scene.pov";
        return {.diagnostics = {*std::move(fault)}};
    }
    std::ifstream in(scene, std::ios::binary);
    if (!in) {
        return {.diagnostics = {error(fmt::format("the scene '{}' cannot be read", scene.string()),
                                      {}, "check its read permission")}};
    }
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    Result<render::PictureSamples> samples = render::PictureSamples::make(
        picture,
        {.width = film.width, .height = film.height, .seed = settings.seed, .time = settings.time});
    if (!samples) {
        return {.diagnostics = std::move(samples.diagnostics)};
    }
    samples->prepare(film);
    std::optional<povray::TemporaryFolder> folder = povray::TemporaryFolder::make();
    if (!folder) {
        return {.diagnostics = {error(Kind::environment, "a temporary folder cannot be made",
                                      "set TMPDIR to a folder that can be written to")}};
    }
    Diagnostics warnings;
    for (std::size_t layer = 0; layer < samples->layer_count(); ++layer) {
        if (samples->has_times(layer)) {
            warnings.push_back(warning(
                fmt::format("the rays of '{}' meet the scene at times of their own, but POV-Ray "
                            "renders the scene as it stands at one time",
                            printable(samples->layer_name(layer))),
                {}, "--time sets that time"));
        }
    }
    const auto source = std::make_shared<const SourceText>(scene.string(), bytes);
    const povray::PovrayRun run(program, settings, *axes, std::move(*folder),
                                fs::absolute(scene, failed).parent_path(), source,
                                std::move(bytes));
    PovraySummary summary =
        StripRenderer(std::move(*samples), run, settings, film, progress, std::move(stop)).render();
    summary.diagnostics.insert(summary.diagnostics.begin(), warnings.begin(), warnings.end());
    return summary;
}

}  // namespace balcony::bridge
