// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/solving/camera_problem.hpp"
#include "app/solving/drawing_file.hpp"
#include "app/solving/missed_rows.hpp"
#include "app/solving/object_marks.hpp"
#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/output_file.hpp"
#include "balcony/solving.hpp"
#include "camera/catalogue/parameter_text.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

// Angles become numbers of degrees, as files have them.
double as_written(double value, const lang::OpenParameter& parameter) {
    const double rounded = parameter.is_angle ? lang::in_degrees(value) : value;
    return camera::contains(parameter.limits, rounded) ? rounded : value;
}

void add_parameters(const std::vector<lang::OpenParameter>& wanted, SolveReport& report) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const lang::OpenParameter& one = wanted[i];
        double& value = report.solution.values[i];
        value = as_written(value, one);
        report.parameters.push_back(
            {one.name, one.is_angle, report.problem.unknowns[i].value, value,
             report.solution.deviations[i],
             value == one.value ? one.written : lang::literal(value, one.is_angle, one.written)});
    }
}

void add_correlations(SolveReport& report) {
    constexpr double strong = 0.98;
    const std::size_t count = report.parameters.size();
    const std::vector<double>& covariance = report.solution.covariance;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            const double both = report.parameters[i].deviation * report.parameters[j].deviation;
            const double value = covariance[i * count + j] / both;
            if (std::isfinite(both) && both > 0.0 && std::abs(value) > strong) {
                report.correlations.push_back(
                    {report.parameters[i].name, report.parameters[j].name, value});
            }
        }
    }
}

// The expressions that the new file has in place of others.
std::vector<lang::Override> new_values(const SolveReport& report,
                                       const std::vector<lang::OpenParameter>& wanted,
                                       const std::vector<lang::Override>& given) {
    std::vector<lang::Override> values;
    for (const lang::Override& one : given) {
        std::erase_if(values, [&](const lang::Override& other) { return other.name == one.name; });
        values.push_back(one);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const SolvedParameter& solved = report.parameters[i];
        if (solved.value != wanted[i].value) {
            std::erase_if(values,
                          [&](const lang::Override& other) { return other.name == solved.name; });
            values.push_back({solved.name, solved.written});
        }
    }
    return values;
}

// What the file names, it looks for in its folder.
Diagnostics warn_of_other_folder(const fs::path& camera, const fs::path& output,
                                 const std::vector<fs::path>& files) {
    std::error_code failed;
    const fs::path from = fs::weakly_canonical(camera, failed).parent_path();
    const fs::path to = fs::weakly_canonical(output, failed).parent_path();
    if (output.empty() || files.size() < 2 || from == to) {
        return {};
    }
    return {warning(fmt::format("'{}' names other files, which '{}' does not find in its folder",
                                camera.string(), output.string()),
                    {}, "write the output beside the camera file")};
}

Diagnostics check_outputs(const SolveRequest& request) {
    Diagnostics found;
    if (!request.output.empty() && ending_of(request.output) != ".cam") {
        return {error(Kind::usage,
                      fmt::format("the file extension of '{}' is not that of a camera file",
                                  request.output.string()),
                      "use a file name that ends in .cam")};
    }
    if (!request.output.empty()) {
        add(found, OutputFile::check(request.output));
    }
    add(found, check_drawing_of(request));
    add(found, check_uncertainty_of(request));
    return found;
}

// No output may be one of these files, or another input.
Diagnostics check_no_input(const SolveRequest& request, std::vector<fs::path> files) {
    files.push_back(request.marks);
    files.push_back(request.over);
    Diagnostics found;
    for (const auto& [output, option] :
         {std::pair(request.output, "--output"), std::pair(request.drawing, "--drawing"),
          std::pair(request.uncertainty, "--uncertainty")}) {
        if (!output.empty()) {
            add(found, check_overwrites(output, files, option));
        }
    }
    return found;
}

// A camera that is asked for with values for parameters, some of which stay open.
class Subject {
public:
    Subject(const CameraArgument& asked, lang::Workspace& workspace)
        : asked_(asked), workspace_(workspace) {}

    [[nodiscard]] Result<lang::OpenCamera> with_all_open() const {
        return workspace_.make_open_camera(asked_.file, asked_.name, asked_.overrides);
    }

    /// Makes it with these parameters open, and with values for the closed ones.
    [[nodiscard]] solve::CameraMaker maker(const WantedParameters& wanted) const {
        std::vector<std::string> open;
        for (const lang::OpenParameter& one : wanted.open) {
            open.push_back(one.name);
        }
        return [*this, open,
                closed = wanted.closed](std::span<const double> values) -> Result<camera::Camera> {
            std::vector<lang::Override> overrides = asked_.overrides;
            for (std::size_t i = 0; i < closed.size(); ++i) {
                overrides.push_back({closed[i].name, lang::literal(values[i], closed[i].is_angle)});
            }
            Result<lang::OpenCamera> made =
                workspace_.make_open_camera(asked_.file, asked_.name, overrides, open);
            return made ? Result<camera::Camera>(made->camera)
                        : Result<camera::Camera>(std::move(made.diagnostics));
        };
    }

private:
    const CameraArgument& asked_;
    lang::Workspace& workspace_;
};

}  // namespace

Result<SolveReport> solve_camera(const SolveRequest& request, const std::stop_token& stop) {
    Diagnostics found = check_outputs(request);
    const Result<CameraArgument> asked = read_camera(request.camera, request.set);
    if (add(found, asked.diagnostics) || has_errors(found)) {
        return found;
    }
    Result<Marks> marks = read_marks(request.marks);
    if (add(found, marks.diagnostics)) {
        return found;
    }
    const fs::path scene = scene_of(*marks, request.marks.parent_path());
    if (add(found, place_on_objects(*marks, scene, stop)) || add(found, place_directions(*marks))) {
        return found;
    }
    lang::Workspace workspace;
    workspace.stop_with(stop);
    const Subject subject(*asked, workspace);
    const Result<lang::OpenCamera> camera = subject.with_all_open();
    if (add(found, camera.diagnostics)) {
        return found;
    }
    const Result<WantedParameters> wanted = wanted_parameters(*marks, *camera);
    if (add(found, wanted.diagnostics)) {
        return found;
    }
    std::vector<fs::path> files = workspace.files();
    add(found, warn_of_other_folder(asked->file, request.output, files));
    files.push_back(scene);
    if (add(found, check_no_input(request, std::move(files)))) {
        return found;
    }
    Result<solve::Problem> problem = problem_of(*marks, *wanted, camera->camera.parts().axes);
    if (add(found, problem.diagnostics)) {
        return found;
    }
    SolveReport report{.camera = camera->camera.name(),
                       .width = marks->width,
                       .height = marks->height,
                       .problem = std::move(*problem),
                       .labels = marks->labels};
    solve::Options options;
    options.starts = request.starts;
    if (!request.uncertainty.empty()) {
        report.grid = {.columns = 48, .rows = 27};
    }
    options.errors = report.grid;
    const solve::CameraMaker maker = subject.maker(*wanted);
    Result<solve::Solution> solution =
        solve::solve(maker, static_cast<double>(report.width), static_cast<double>(report.height),
                     report.problem, options, stop);
    if (add(found, solution.diagnostics)) {
        return found;
    }
    report.solution = std::move(*solution);
    add_parameters(wanted->all(), report);
    add_correlations(report);
    add(found, warn_of_misses(report, maker, stop));
    Result<std::string> text = workspace.with_values(
        asked->file, report.camera, new_values(report, wanted->all(), asked->overrides));
    if (!text) {
        add(found, text.diagnostics);
        return found;
    }
    report.text = std::move(*text);
    if ((!request.output.empty() && add(found, write_whole(request.output, report.text))) ||
        add(found, write_drawing_of(report, request)) ||
        add(found, write_uncertainty_of(report, request))) {
        return found;
    }
    return {std::move(report), std::move(found)};
}

std::vector<std::string> settings_of(const SolveReport& report) {
    std::vector<std::string> made;
    for (const SolvedParameter& one : report.parameters) {
        made.push_back(fmt::format("{}={}", one.name, one.written));
    }
    return made;
}

}  // namespace balcony::app
