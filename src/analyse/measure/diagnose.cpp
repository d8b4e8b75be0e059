// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/diagnose.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include <Imath/ImathBox.h>
#include <fmt/format.h>

#include "analyse/measure/findings.hpp"
#include "analyse/measure/jacobian.hpp"
#include "balcony/median.hpp"
#include "balcony/rays.hpp"

namespace balcony::analyse {

namespace {

constexpr double pixels_per_degree = std::numbers::pi / 180.0;

// The finest grid of whole steps within the limit, at most one sample per pixel.
SampleGrid choose_grid(const DiagnoseSettings& settings) {
    const double maximum = std::max(static_cast<double>(settings.max_samples), 1.0);
    const double step =
        std::max(std::ceil(std::sqrt(settings.width * settings.height / maximum) - 1e-9), 1.0);
    return SampleGrid::over(settings.width, settings.height, step);
}

Imath::Box3d box_of_origins(const std::vector<Ray>& rays) {
    Imath::Box3d box;
    for (const Ray& ray : rays) {
        if (ray.valid) {
            box.extendBy(ray.origin);
        }
    }
    return box;
}

// Where the rays of a lens meet that show the middle of the picture, along the one through the
// middle of the lens. Nothing if they do not, or if only a scene tells where.
std::optional<double> distance_of_focus(const camera::Camera& camera,
                                        const DiagnoseSettings& settings, const Work& work) {
    constexpr double beside = 0.4;  // Of the half side of the square that a lens maps.
    constexpr double parallel = 1e-9;
    if (!camera.parts().lens) {
        return std::nullopt;
    }
    const auto program =
        rays::compile(camera, settings.width, settings.height,
                      {.tiles = false,
                       .points = true,
                       .inputs = {{std::string(camera::lens_input_x), program::Rate::pixel},
                                  {std::string(camera::lens_input_y), program::Rate::pixel}}},
                      work.stop());
    if (!program) {
        return std::nullopt;
    }
    const std::array x{0.5 * settings.width, 0.5 * settings.width};
    const std::array y{0.5 * settings.height, 0.5 * settings.height};
    const std::array<double, 2> lens_x{0.0, beside};
    const std::array<double, 2> lens_y{0.0, 0.0};
    const std::array<std::span<const double>, 2> inputs{lens_x, lens_y};
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run(rays::Points{x, y, settings.time, inputs}, scratch, batch);
    if (!batch.valid(0) || !batch.valid(1)) {
        return std::nullopt;
    }
    const V3d across = batch.direction(0).cross(batch.direction(1));
    const double distance =
        (batch.origin(1) - batch.origin(0)).cross(batch.direction(1)).dot(across) /
        across.length2();
    return across.length() > parallel && distance > 0.0 ? std::optional(distance) : std::nullopt;
}

void measure_origins(const std::vector<Ray>& rays, const DiagnoseSettings& settings,
                     CameraReport& report) {
    const Imath::Box3d box = box_of_origins(rays);
    if (!box.isEmpty()) {
        const double size = std::max(box.min.length(), box.max.length());
        report.origin_extent = box.size().length();
        report.single_viewpoint = report.origin_extent <= 1e-9 * (1.0 + size);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            report.samples[i].origin_distance =
                rays[i].valid ? (rays[i].origin - box.center()).length() : 0.0;
        }
    }
    report.distance = settings.distance;
    if (!report.distance && !report.single_viewpoint) {
        report.distance = 0.25 * report.origin_extent;
    }
}

void measure(const Ray& ray, const std::optional<double>& distance, Sample& sample) {
    sample.valid = ray.valid;
    if (!ray.valid) {
        return;
    }
    const Jacobian map = jacobian(ray, distance);
    sample.singular = !map.regular();
    if (!sample.singular) {
        const double area = map.maximum * std::abs(map.minimum);
        sample.magnification = (distance ? 1.0 : pixels_per_degree) / std::sqrt(area);
        sample.anisotropy = map.maximum / std::abs(map.minimum);
        sample.orientation = map.minimum > 0.0 ? 1 : -1;
    }
}

std::optional<Statistics> statistics(const CameraReport& report, const std::vector<Ray>& rays,
                                     double Sample::*value) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < report.samples.size(); ++i) {
        if (report.samples[i].valid && !report.samples[i].singular) {
            order.push_back(i);
        }
    }
    if (order.empty()) {
        return std::nullopt;
    }
    const auto less = [&](std::size_t a, std::size_t b) {
        return report.samples[a].*value < report.samples[b].*value;
    };
    const auto place = [&](std::size_t i) { return Place{report.grid.at(i), rays[i].parameters}; };
    const auto [minimum, maximum] = std::minmax_element(order.begin(), order.end(), less);
    const std::size_t min_at = *minimum;
    const std::size_t max_at = *maximum;
    std::vector<double> values;
    for (const std::size_t i : order) {
        values.push_back(report.samples[i].*value);
    }
    return Statistics{report.samples[min_at].*value, median(std::move(values)).value_or(0.0),
                      report.samples[max_at].*value, place(min_at), place(max_at)};
}

}  // namespace

bool CameraReport::has_defects() const {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.defect; });
}

namespace {

Result<CameraReport> report_of(const camera::Camera& camera, const DiagnoseSettings& settings,
                               const Work& work) {
    using Derivatives = RayField::Derivatives;
    Result<RayField> with_derivatives = RayField::make(camera, settings.width, settings.height,
                                                       settings.time, Derivatives::with, work);
    Result<RayField> without = RayField::make(camera, settings.width, settings.height,
                                              settings.time, Derivatives::without, work);
    if (!with_derivatives || !without) {
        return with_derivatives ? without.diagnostics : with_derivatives.diagnostics;
    }
    CameraReport report;
    report.camera = camera.name();
    report.grid = choose_grid(settings);
    work.done(0.1);
    const std::vector<Ray> rays = with_derivatives->run(report.grid);
    work.done(0.4);

    report.samples.resize(rays.size());
    measure_origins(rays, settings, report);
    if (!settings.distance && report.distance) {
        report.distance = distance_of_focus(camera, settings, work).value_or(*report.distance);
    }
    std::size_t valid = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        measure(rays[i], report.distance, report.samples[i]);
        valid += rays[i].valid ? 1U : 0U;
    }
    report.valid_share = static_cast<double>(valid) / static_cast<double>(rays.size());
    report.magnification = statistics(report, rays, &Sample::magnification);
    report.anisotropy = statistics(report, rays, &Sample::anisotropy);

    const double unit = report.distance.value_or(0.0) > 0.0 ? *report.distance : 1.0;
    const std::vector<Crossing> crossings = find_crossings(report.grid, rays, *without, unit);
    for (const Crossing& crossing : crossings) {
        report.samples[crossing.sample].seam = true;
        report.samples[crossing.sample + (crossing.along_x ? 1 : report.grid.columns)].seam = true;
    }
    const Repeats repeats =
        find_repeats(report.grid, rays, *without, report.distance, unit, work.part(0.6, 0.9));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        report.samples[i].views = repeats.views[i];
    }
    const Turns turns = count_turns(camera, settings.width, settings.height, settings.time);
    report.findings =
        find_all({camera, settings.time, report, rays, crossings, repeats, turns, *without, work});
    work.done(1.0);
    Diagnostics diagnostics;
    if (!repeats.complete) {
        diagnostics.push_back(warning(fmt::format(
            "the views of camera '{}' differ so much in size, or lie so close together, "
            "that not all of them were compared: some that are repeated may be missed",
            report.camera)));
    }
    return {std::move(report), std::move(diagnostics)};
}

}  // namespace

Result<CameraReport> diagnose(const camera::Camera& camera, const DiagnoseSettings& settings,
                              const PartDone& progress, std::stop_token stop) {
    return unless_stopped(
        [&] { return report_of(camera, settings, Work(progress, std::move(stop))); });
}

}  // namespace balcony::analyse
