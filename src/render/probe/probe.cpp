// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "balcony/median.hpp"
#include "film/sums/film_arrays.hpp"
#include "render/job/bent_rays.hpp"
#include "render/job/camera_rays.hpp"
#include "render/probe/probed_scene.hpp"

namespace balcony::render {

namespace {

using embree::Hit;
using Imath::V3f;

/// The rays of a part of the picture.
struct RayTile {
    rays::RayBatch rays;
    std::size_t width = 0;
    std::size_t height = 0;
    Imath::V2d corner;
    double step = 1.0;

    [[nodiscard]] std::size_t size() const { return width * height; }
    [[nodiscard]] Imath::V2d at(std::size_t i) const {
        return corner +
               step * Imath::V2d(static_cast<double>(i % width), static_cast<double>(i / width));
    }
};

class Prober {
public:
    Prober(const ProbedScene& probed, const rays::RayProgram& program,
           const ProbeSettings& settings, std::stop_token stop, const PartDone& progress)
        : scene_(probed),
          program_(program),
          settings_(settings),
          stop_(std::move(stop)),
          progress_(progress) {
        const scene::Scene& scene = probed.scene();
        probe_.objects.resize(scene.objects.size());
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            const scene::Instance& instance = scene.instances[i];
            if (probed.shows(i) && !scene.meshes[instance.mesh.value()]->triangles.empty()) {
                probe_.objects[instance.object].has_surface = true;
            }
        }
    }

    Probe run() {
        for_each_tile(settings_.step, [this](const RayTile& tile) {
            look(tile, true);
            look_round(tile);
        });
        if (settings_.searches && settings_.step > 1) {
            for_each_tile(1, [this](const RayTile& tile) {
                if (misses_something()) {
                    look(tile, false);
                }
            });
        }
        if (progress_) {
            progress_(1.0);
        }
        probe_.median_distance = median(std::move(distances_));
        return std::move(probe_);
    }

private:
    template <class Visit>
    void for_each_tile(std::size_t step, const Visit& visit) {
        const std::size_t columns = (settings_.width + step - 1) / step;
        const std::size_t rows = (settings_.height + step - 1) / step;
        const double middle = 0.5 * static_cast<double>(step);
        RayTile tile;
        tile.step = static_cast<double>(step);
        for (std::size_t top = 0; top < rows && !stop_.stop_requested();
             top += program::max_tile_height) {
            report(step, top, rows);
            for (std::size_t left = 0; left < columns && !stop_.stop_requested();
                 left += program::max_tile_width) {
                tile.width = std::min(program::max_tile_width, columns - left);
                tile.height = std::min(program::max_tile_height, rows - top);
                tile.corner = {middle + tile.step * static_cast<double>(left),
                               middle + tile.step * static_cast<double>(top)};
                program_.run({tile.corner.x, tile.corner.y, tile.step, tile.width, tile.height,
                              settings_.time},
                             scratch_, tile.rays);
                visit(tile);
            }
        }
    }

    // The first half is the look at the step.
    void report(std::size_t step, std::size_t row, std::size_t rows) const {
        if (progress_) {
            const double part = 0.5 * static_cast<double>(row) / static_cast<double>(rows);
            progress_(step == settings_.step ? part : 0.5 + part);
        }
    }

    [[nodiscard]] bool misses_something() const {
        return std::any_of(
            probe_.objects.begin(), probe_.objects.end(),
            [](const ObjectSight& sight) { return sight.has_surface && !sight.seen; });
    }

    [[nodiscard]] embree::Ray ray_of(const RayTile& tile, std::size_t i) const {
        return scene_.ray(V3f(tile.rays.origin(i)), V3f(tile.rays.direction(i)));
    }

    // Marks the objects that the rays of a tile hit.
    void look(const RayTile& tile, bool measure) {
        if (tile.rays.part_count() > 1) {
            look_along_bends(tile, measure);
            return;
        }
        for_each_run(tile.width, tile.height, packets_, [&](const Square& first, auto packets) {
            set_packets(tile.rays, first, {}, 0.0F, packets);
            for (embree::Packet& packet : packets) {
                packet.time.fill(scene_.time());
            }
            scene_.shown().intersect(packets);
            for (std::size_t k = 0; k < packets.size(); ++k) {
                for_each_ray(tile.rays, first.beside(k), [&](std::size_t i, std::size_t lane) {
                    if (packets[k].valid[lane] != 0) {
                        look(ray_of(tile, i), packets[k].hit(lane), measure);
                    }
                });
            }
        });
    }

    void look_along_bends(const RayTile& tile, bool measure) {
        for (std::size_t i = 0; i < tile.size(); ++i) {
            if (traceable(tile.rays, i)) {
                const FirstHit first = first_hit(scene_.shown(), tile.rays, i, scene_.time());
                const rays::RayBatch::Part part = tile.rays.part(i, first.part);
                look(scene_.ray(V3f(part.origin), V3f(part.direction)), first.hit, measure,
                     length_before(tile.rays, i, first.part));
            }
        }
    }

    void look(const embree::Ray& ray, const Hit& hit, bool measure, double before = 0.0) {
        probe_.rays += measure ? 1 : 0;
        if (measure && hit.any()) {
            distances_.push_back(before + double{(scene_.place(hit) - ray.origin).length()});
        }
        follow(ray, hit);
    }

    void follow(embree::Ray ray, Hit hit) {
        constexpr int max_layers = 64;
        for (int layer = 0; layer < max_layers && hit.any(); ++layer) {
            probe_.objects[scene_.object(hit)].seen = true;
            if (scene_.material(hit).alpha_mode == scene::AlphaMode::opaque) {
                return;
            }
            ray.origin = beyond(ray, hit);
            hit = scene_.nearest(ray, &scene_.shown());
        }
    }

    // Beyond the surface by more than the rounding error.
    [[nodiscard]] V3f beyond(const embree::Ray& ray, const Hit& hit) const {
        constexpr float share = 1e-5F;
        const V3f place = scene_.place(hit);
        const float size = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z),
                                     (place - ray.origin).length()});
        return place + share * size * ray.direction;
    }

    // For the rays of a tile, whether they start inside an object. From inside, a ray
    // hits the back of the surrounding surface, or another object inside it. So both directions
    // along the ray are traced.
    void look_round(const RayTile& tile) {
        std::optional<V3f> last_origin;
        std::optional<std::uint32_t> last_object;
        for (std::size_t i = 0; i < tile.size(); ++i) {
            if (!traceable(tile.rays, i)) {
                continue;
            }
            embree::Ray ray = ray_of(tile, i);
            // Rays from the same origin are tested only once.
            if (last_origin != ray.origin) {
                last_origin = ray.origin;
                last_object = object_round(ray);
                if (!last_object) {
                    ray.direction = -ray.direction;
                    last_object = object_round(ray);
                }
            }
            if (last_object) {
                ObjectSight& sight = probe_.objects[*last_object];
                if (sight.rays_from_inside++ == 0) {
                    sight.inside_at = tile.at(i);
                }
            }
        }
    }

    [[nodiscard]] std::optional<std::uint32_t> object_round(const embree::Ray& ray) {
        const Hit hit = scene_.nearest(ray, &scene_.shown());
        if (!hit.any()) {
            return std::nullopt;
        }
        if (!scene_.from_behind(hit, ray.direction)) {
            return std::nullopt;
        }
        const std::uint32_t object = scene_.object(hit);
        const auto [known, is_new] = encloses_.try_emplace(object, false);
        if (is_new) {
            known->second = scene::encloses_volume(scene_.scene(), object);
        }
        return known->second ? std::optional(object) : std::nullopt;
    }

    const ProbedScene& scene_;
    const rays::RayProgram& program_;
    rays::Scratch scratch_;
    std::array<embree::Packet, 2> packets_;  // Side by side.
    ProbeSettings settings_;
    std::stop_token stop_;
    const PartDone& progress_;
    Probe probe_;
    std::vector<double> distances_;
    std::map<std::uint32_t, bool> encloses_;
};

}  // namespace

Result<ProbedScene> ProbedScene::make(const Renderer& renderer, const ProbeSettings& settings) {
    Result<ShownObjects> shown = shown_by(settings.objects, renderer.state().traced);
    if (!shown) {
        return std::move(shown.diagnostics);
    }
    return ProbedScene(renderer, std::move(*shown));
}

Result<rays::RayProgram> compile(const camera::Camera& camera, const ProbeSettings& settings,
                                 Axes axes, const std::stop_token& stop) {
    if (!is_part({0, 0, settings.width, settings.height}, max_film_side, max_film_side) ||
        settings.step == 0 || !std::isfinite(settings.time)) {
        return error(Kind::usage, "a probe's size, step or time is out of range",
                     fmt::format("give a width and a height from 1 to {}, a step of at least 1, "
                                 "and a finite time",
                                 max_film_side));
    }
    return rays::compile(camera, static_cast<double>(settings.width),
                         static_cast<double>(settings.height), {.axes = axes, .bends = true}, stop);
}

Result<Probe> probe(const Renderer& renderer, const camera::Camera& camera,
                    const ProbeSettings& settings, const PartDone& progress,
                    const std::stop_token& stop) {
    const Result<ProbedScene> scene = ProbedScene::make(renderer, settings);
    if (!scene) {
        return scene.diagnostics;
    }
    const Result<rays::RayProgram> program = compile(camera, settings, scene->scene().axes, stop);
    if (!program) {
        return program.diagnostics;
    }
    Probe found = Prober(*scene, *program, settings, stop, progress).run();
    if (stop.stop_requested()) {
        return stopped();
    }
    return found;
}

}  // namespace balcony::render
