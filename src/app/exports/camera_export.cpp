// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/camera_export.hpp"

#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"

namespace balcony::app {

namespace {

constexpr double visible = 0.1;  // Pixels.

void judge(const bridge::SinglePrecision& found, Diagnostics& diagnostics) {
    if (found.largest > visible) {
        diagnostics.push_back(warning(
            fmt::format("in single precision, rays move by up to {:.2g} pixels (at x = {}, y = {}; "
                        "99 % move by less than {:.2g})",
                        found.largest, found.x, found.y, found.usual),
            {},
            "move the camera's world closer to the origin, or use a target with double "
            "precision"));
    }
    if (found.lost > 0) {
        diagnostics.push_back(warning(fmt::format(
            "in single precision, {} of {} rays are there that are not in double precision, or the "
            "other way round",
            found.lost, found.rays)));
    }
}

bridge::ExportSource source_of(const lang::OpenCamera& opened, const CameraExportRequest& request) {
    bridge::ExportSource source{opened.camera, {}, request.title, request.comment};
    for (const lang::OpenParameter& one : opened.open) {
        source.parameters.push_back(
            {one.name, lang::parameter_input(one.name), one.written, one.value, one.is_angle});
    }
    return source;
}

}  // namespace

std::optional<std::vector<std::string>> parameters_for(const bridge::ExportTarget& target) {
    return target.opens_parameters ? std::nullopt : std::optional(std::vector<std::string>());
}

Result<CameraExport> export_camera(const lang::OpenCamera& opened,
                                   const CameraExportRequest& request) {
    Diagnostics found;
    if (opened.camera.parts().time) {
        found.push_back(
            warning(fmt::format("the rays of the camera '{}' have times of their own, which other "
                                "programs do not know",
                                opened.camera.name()),
                    {}, "all of a picture is seen at the time of that program"));
    }
    bridge::ExportOptions options{.axes = request.axes,
                                  .single = request.single || request.target->always_single,
                                  .inverse = request.inverse};
    if (options.single) {
        options.judged_in = request.size;
    }
    Result<bridge::ExportedCamera> exported =
        bridge::export_camera(*request.target, source_of(opened, request), options);
    add(found, exported.diagnostics);
    if (!exported) {
        return found;
    }
    CameraExport made{std::move(exported->text), {}, opened.closed, exported->single};
    for (const lang::OpenParameter& one : opened.open) {
        made.open.push_back(one.name);
    }
    if (made.single) {
        judge(*made.single, found);
    }
    return {std::move(made), std::move(found)};
}

std::string comment_of(lang::Workspace& workspace, const lang::CameraSource& source,
                       const std::string& camera) {
    if (const auto described = workspace.describe(source)) {
        for (const lang::Description& one : *described) {
            if (one.name == camera) {
                return one.comment;
            }
        }
    }
    return {};
}

}  // namespace balcony::app
