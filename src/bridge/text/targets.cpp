// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/targets.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "bridge/text/camera_formulas.hpp"
#include "bridge/text/single_precision.hpp"

namespace balcony::bridge {

std::span<const ExportTarget> export_targets() {
    static const std::array targets{osl_target(),   glsl_target(),    c_target(),  numpy_target(),
                                    torch_target(), mitsuba_target(), pov_target()};
    return targets;
}

const ExportTarget* find_export_target(std::string_view name) {
    const std::span<const ExportTarget> all = export_targets();
    const auto found = std::find_if(
        all.begin(), all.end(), [name](const ExportTarget& target) { return target.name == name; });
    return found == all.end() ? nullptr : &*found;
}

Result<ExportedCamera> export_camera(const ExportTarget& target, const ExportSource& source,
                                     const ExportOptions& options) {
    Result<camera::Camera> camera =
        target.adapted != nullptr ? target.adapted(source.camera) : source.camera;
    if (!camera) {
        return std::move(camera.diagnostics);
    }
    const bool is_judged = (options.single || target.always_single) && options.judged_in;
    const bool inverse = options.inverse && target.has_inverse;
    const Axes usual = target.axes.value_or(camera->parts().axes);
    Result<CameraFormulas> formulas =
        formulas_of(*camera, {.target = target.name,
                              .axes = target.only_axes ? usual : options.axes.value_or(usual),
                              .footprints = target.footprints,
                              .measured = is_judged || inverse});
    if (!formulas) {
        return std::move(formulas.diagnostics);
    }
    ExportedCamera made;
    if (is_judged) {
        made.single = measure_single_precision(*formulas, source.parameters, *options.judged_in);
    }
    if (!target.footprints && !inverse) {
        formulas->roots.resize(RayRoots::end_of_ray);
    }
    Result<std::string> text = target.write(source, options, std::move(*formulas));
    Diagnostics found = std::move(camera.diagnostics);
    std::move(text.diagnostics.begin(), text.diagnostics.end(), std::back_inserter(found));
    if (!text) {
        return found;
    }
    made.text = std::move(*text);
    return {std::move(made), std::move(found)};
}

}  // namespace balcony::bridge
