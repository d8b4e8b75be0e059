// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/solve_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/names.hpp"

namespace balcony::cli {

namespace {

using nlohmann::json;

// A number with its unit in few digits.
std::string in_words(double value, bool is_angle) {
    return is_angle ? fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi)
                    : fmt::format("{:.6g}", value);
}

json finite(double value) { return std::isfinite(value) ? json(value) : json(); }

std::string parameters_text(const app::SolveReport& report) {
    std::size_t longest = 9;
    for (const app::SolvedParameter& one : report.parameters) {
        longest = std::max(longest, one.name.size());
    }
    std::string text = fmt::format("{:<{}}  {:>14}  {:>14}  {:>14}\n", "parameter", longest,
                                   "value", "deviation", "first");
    for (const app::SolvedParameter& one : report.parameters) {
        text += fmt::format(
            "{:<{}}  {:>14}  {:>14}  {:>14}\n", printable(one.name), longest,
            in_words(one.value, one.is_angle),
            std::isfinite(one.deviation) ? in_words(one.deviation, one.is_angle) : "not determined",
            in_words(one.first, one.is_angle));
    }
    for (const app::Correlation& one : report.correlations) {
        text += fmt::format("{} and {} are correlated: {:.4f}\n", printable(one.first),
                            printable(one.second), one.value);
    }
    return text;
}

// What a constraint misses: its numbers, of which marks have pixels.
std::string miss_text(const app::SolveReport& report, std::size_t row) {
    for (const std::size_t mark : report.problem.constraints[row].marks) {
        if (!report.solution.seen[mark]) {
            return "not seen";
        }
    }
    const solve::Miss& miss = report.solution.misses[row];
    std::string text;
    for (std::size_t i = 0; i < miss.count; ++i) {
        text += fmt::format("{}{:.4g}", i == 0 ? "" : ", ", miss.by[i]);
    }
    return text;
}

std::string constraints_text(const app::SolveReport& report) {
    constexpr std::size_t most = 40;
    const std::size_t count = report.labels.size();
    std::vector<std::size_t> rows(count);
    if (count > most) {
        rows = app::worst_constraints(report);
        rows.resize(most / 4);
    } else {
        std::iota(rows.begin(), rows.end(), std::size_t{0});
    }
    std::size_t longest = 10;
    for (const std::size_t i : rows) {
        longest = std::max(longest, report.labels[i].size());
    }
    std::string text =
        fmt::format("{:<{}}  {:>20}  {:>10}\n", "constraint", longest, "missed by", "deviations");
    for (const std::size_t i : rows) {
        text += fmt::format("{:<{}}  {:>20}  {:>10.3g}\n", printable(report.labels[i]), longest,
                            miss_text(report, i), report.solution.misses[i].deviations);
    }
    if (count > most) {
        text += fmt::format("... of {} constraints, the ones that are missed most\n", count);
    }
    return text;
}

std::string uncertainty_text(const app::SolveReport& report) {
    const auto errors = app::uncertainty(report);
    if (!errors || !(errors->most > 0.0)) {
        return "";
    }
    const std::string what = "expected uncertainty of projections: ";
    if (!std::isfinite(errors->least)) {
        return what + "not determined\n";
    }
    if (!std::isfinite(errors->most)) {
        return fmt::format("{}from {:.3g} pixels; not determined in parts of the picture\n", what,
                           errors->least);
    }
    return fmt::format("{}{:.3g} to {:.3g} pixels, median {:.3g}\n", what, errors->least,
                       errors->most, errors->median);
}

// Null for products with an unknown that is not determined.
json covariance_json(const solve::Solution& solution) {
    const std::size_t count = solution.values.size();
    json made = json::array();
    for (std::size_t i = 0; i < count; ++i) {
        json row = json::array();
        for (std::size_t j = 0; j < count; ++j) {
            const bool known =
                std::isfinite(solution.deviations[i]) && std::isfinite(solution.deviations[j]);
            row.push_back(known ? json(solution.covariance[i * count + j]) : json());
        }
        made.push_back(std::move(row));
    }
    return made;
}

json pose_json(const solve::Pose& pose) {
    return {{"rotation", {pose.rotation.x, pose.rotation.y, pose.rotation.z}},
            {"translation", {pose.translation.x, pose.translation.y, pose.translation.z}}};
}

}  // namespace

std::string to_text(const app::SolveReport& report) {
    std::string text =
        fmt::format("{}, {} x {} pixels: {} after {}\n\n", printable(report.camera), report.width,
                    report.height, report.solution.converged ? "solved" : "not solved",
                    counted(report.solution.iterations, "iteration"));
    text += parameters_text(report) + "\n" + constraints_text(report) + "\n";
    if (const auto error = app::position_error(report)) {
        text +=
            fmt::format("marks miss their positions by {:.4g} pixels (root mean square)\n", *error);
    }
    return text + uncertainty_text(report);
}

json to_json(const app::SolveReport& report) {
    const solve::Solution& solution = report.solution;
    json document{{"camera", report.camera},
                  {"width", report.width},
                  {"height", report.height},
                  {"converged", solution.converged},
                  {"iterations", solution.iterations},
                  {"cost", solution.cost},
                  {"parameters", json::array()},
                  {"covariance", covariance_json(solution)},
                  {"correlations", json::array()},
                  {"targets", json::array()},
                  {"marks", json::array()},
                  {"outlines", json::array()},
                  {"constraints", json::array()},
                  {"text", report.text}};
    for (const app::SolvedParameter& one : report.parameters) {
        document["parameters"].push_back({{"name", one.name},
                                          {"value", one.value},
                                          {"written", one.written},
                                          {"is_angle", one.is_angle},
                                          {"first", one.first},
                                          {"deviation", finite(one.deviation)}});
    }
    for (const app::Correlation& one : report.correlations) {
        document["correlations"].push_back(
            {{"between", {one.first, one.second}}, {"value", one.value}});
    }
    for (std::size_t i = 0; i < solution.poses.size(); ++i) {
        json target = pose_json(solution.poses[i]);
        target["name"] = report.problem.targets[i].name;
        document["targets"].push_back(std::move(target));
    }
    for (std::size_t i = 0; i < solution.seen.size(); ++i) {
        const auto& seen = solution.seen[i];
        document["marks"].push_back({{"name", report.problem.marks[i].name},
                                     {"seen", seen ? json{seen->x, seen->y} : json()}});
    }
    for (std::size_t i = 0; i < solution.outlines.size(); ++i) {
        json corners = json::array();
        for (const solve::V2d& corner : solution.outlines[i]) {
            corners.push_back({corner.x, corner.y});
        }
        document["outlines"].push_back(
            {{"name", report.problem.outlines[i].name}, {"corners", std::move(corners)}});
    }
    for (std::size_t i = 0; i < solution.misses.size(); ++i) {
        const solve::Miss& miss = solution.misses[i];
        document["constraints"].push_back(
            {{"name", report.labels[i]},
             {"missed_by",
              std::vector<double>(miss.by.begin(),
                                  miss.by.begin() + static_cast<std::ptrdiff_t>(miss.count))},
             {"deviations", miss.deviations}});
    }
    const auto errors = app::uncertainty(report);
    document["uncertainty"] = errors ? json{{"least", finite(errors->least)},
                                            {"median", finite(errors->median)},
                                            {"most", finite(errors->most)}}
                                     : json();
    return document;
}

}  // namespace balcony::cli
