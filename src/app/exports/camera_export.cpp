// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/camera_export.hpp"

#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/picture_shader.hpp"

namespace balcony::app {

std::vector<bridge::ExportParameter> export_parameters(
    const std::vector<lang::OpenParameter>& open) {
    std::vector<bridge::ExportParameter> made;
    for (const lang::OpenParameter& one : open) {
        made.push_back(
            {one.name, lang::parameter_input(one.name), one.written, one.value, one.is_angle});
    }
    return made;
}

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
    Result<bridge::ExportedCamera> exported = bridge::export_camera(
        *request.target,
        {opened.camera, export_parameters(opened.open), request.title, request.comment}, options);
    add(found, exported.diagnostics);
    if (!exported) {
        return found;
    }
    CameraExport made{std::move(exported->text), {}, opened.closed, exported->single};
    for (const lang::OpenParameter& one : opened.open) {
        made.open.push_back(one.name);
    }
    if (made.single) {
        add(found,
            bridge::single_precision_warnings(*made.single, "use a target with double precision"));
    }
    return {std::move(made), std::move(found)};
}

Result<CameraExport> export_camera(const lang::OpenPicture& opened,
                                   const CameraExportRequest& request) {
    const camera::Camera* const camera = opened.picture.only_camera();
    if (camera == nullptr) {
        return error(fmt::format("'{}' is a picture with layers, but one camera is exported",
                                 opened.picture.name()),
                     {}, "choose one of its cameras");
    }
    return export_camera(lang::OpenCamera{*camera, opened.open, opened.closed, opened.numbers},
                         request);
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
