// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/check_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

using analyse::CameraReport;
using analyse::Finding;
using analyse::Place;
using analyse::Statistics;
using app::CameraCheck;

std::string pixel_text(const analyse::V2d& point) {
    return fmt::format("({:.4g}, {:.4g})", point.x, point.y);
}

std::string place_text(const Place& place) {
    return fmt::format("{}, u = {:.4g}, v = {:.4g}", pixel_text(place.point), place.parameters.x,
                       place.parameters.y);
}

std::string line(std::string_view name, const std::string& value) {
    return fmt::format("  {:<14} {}\n", name, value);
}

// A finding: its heading on the left, the message, the position and the suggested fix.
std::string finding_text(std::string_view name, const std::string& message,
                         const std::string& where, const std::string& remedy) {
    std::string text = line(name, message);
    if (!where.empty()) {
        text += line("", where);
    }
    return remedy.empty() ? text : text + line("", "help: " + remedy);
}

std::string finding_text(const Finding& finding, bool with_remedy) {
    std::string name(name_of(finding.kind));
    std::replace(name.begin(), name.end(), '_', ' ');
    std::string where;
    if (finding.kind != analyse::FindingKind::mirrored) {
        where = "at " + place_text(finding.place);
        if (finding.other) {
            where += fmt::format("; and at {}", pixel_text(finding.other->point));
        }
    }
    return finding_text(name, finding.message, where, with_remedy ? finding.remedy : "");
}

std::string statistics_text(const Statistics& row, std::string_view unit) {
    return fmt::format("{:.4g} at {}, median {:.4g}, {:.4g} at {}{}", row.minimum,
                       pixel_text(row.min_at.point), row.median, row.maximum,
                       pixel_text(row.max_at.point), unit);
}

std::string origins_text(const CameraReport& report) {
    if (report.valid_share == 0.0) {
        return "none";
    }
    const std::string spread = report.single_viewpoint
                                   ? "all at one point"
                                   : fmt::format("spread over {:.4g} units", report.origin_extent);
    return report.distance
               ? fmt::format("{}; the figures below apply at a distance of {:.4g} units", spread,
                             *report.distance)
               : spread;
}

std::string scale_text(const CameraCheck::InScene::Scale& scale) {
    const auto range = [](const render::SurfaceScale::Range& r) {
        return fmt::format("{:.4g} to {:.4g}, median {:.4g}", r.least, r.most, r.median);
    };
    return fmt::format("{:.4g} {} per pixel; on the surface in x {}, in y {}", scale.nominal,
                       scale.in_millimeters ? "mm" : "units", range(scale.surface.across),
                       range(scale.surface.upwards));
}

std::string scene_text(const CameraCheck::InScene& found) {
    std::string text;
    for (const CameraCheck::InScene::Finding& one : found.findings()) {
        text += finding_text(one.name, printable(one.message),
                             one.at ? "at " + pixel_text(*one.at) : "", one.remedy);
    }
    if (found.scale) {
        text += line("scale", scale_text(*found.scale));
    }
    return text;
}

nlohmann::json place_json(const Place& place) {
    return {{"x", place.point.x},
            {"y", place.point.y},
            {"u", place.parameters.x},
            {"v", place.parameters.y}};
}

nlohmann::json statistics_json(const std::optional<Statistics>& row) {
    if (!row) {
        return nullptr;
    }
    nlohmann::json minimum = place_json(row->min_at);
    nlohmann::json maximum = place_json(row->max_at);
    minimum["value"] = row->minimum;
    maximum["value"] = row->maximum;
    return {{"least", minimum}, {"median", row->median}, {"most", maximum}};
}

nlohmann::json finding_json(const Finding& finding) {
    nlohmann::json entry{{"kind", name_of(finding.kind)}, {"defect", finding.defect},
                         {"message", finding.message},    {"remedy", finding.remedy},
                         {"count", finding.count},        {"share", finding.share},
                         {"length", finding.length},      {"at", place_json(finding.place)}};
    if (finding.other) {
        entry["other"] = place_json(*finding.other);
    }
    return entry;
}

nlohmann::json scene_json(const CameraCheck::InScene& found) {
    nlohmann::json starts = nlohmann::json::array();
    for (const app::StartInside& start : found.starts_inside) {
        starts.push_back({{"object", start.object},
                          {"share", start.share},
                          {"x", start.point.x},
                          {"y", start.point.y}});
    }
    nlohmann::json entry{
        {"scene", found.scene}, {"never_seen", found.never_seen}, {"starts_inside", starts}};
    entry["scale"] = nullptr;
    if (found.scale) {
        const auto range = [](const render::SurfaceScale::Range& r) {
            return nlohmann::json{{"least", r.least}, {"median", r.median}, {"most", r.most}};
        };
        entry["scale"] = {{"unit", found.scale->in_millimeters ? "mm" : "units"},
                          {"nominal", found.scale->nominal},
                          {"x", range(found.scale->surface.across)},
                          {"y", range(found.scale->surface.upwards)}};
    }
    entry["meets_nothing"] = found.miss ? nlohmann::json(found.miss->reason) : nlohmann::json();
    return entry;
}

}  // namespace

std::string check_text(const CameraCheck& check) {
    const CameraReport& report = check.report;
    std::string text =
        fmt::format("\ncamera {}: {:.0f} x {:.0f} pixels, {} samples\n", printable(check.title()),
                    report.grid.picture_width, report.grid.picture_height, report.samples.size());
    text += line("ray origins", origins_text(report));
    if (check.has_lens) {
        text += line("lens", "only the rays through its centre are checked");
    }
    if (check.has_bend) {
        text += line("bend", "only the first straight parts of the rays are checked");
    }
    if (report.magnification) {
        text += line("magnification", statistics_text(*report.magnification,
                                                      report.distance ? "; pixels per unit"
                                                                      : "; pixels per degree"));
        text += line("anisotropy", statistics_text(*report.anisotropy, ""));
    }
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        // The suggested fix is printed once for several findings of a kind.
        const bool last_of_kind = i + 1 == report.findings.size() ||
                                  report.findings[i + 1].kind != report.findings[i].kind;
        text += finding_text(report.findings[i], last_of_kind);
    }
    if (check.in_scene) {
        text += scene_text(*check.in_scene);
    }
    if (check.defect_count() == 0) {
        text += line("no defects", report.findings.empty()
                                       ? "rays everywhere, no folds, no seams, no repeated views"
                                       : "apart from what is said above");
    }
    for (const std::filesystem::path& map : check.maps) {
        text += line("map", printable(map.string()));
    }
    return text;
}

nlohmann::json check_json(const CameraCheck& check) {
    const CameraReport& report = check.report;
    nlohmann::json findings = nlohmann::json::array();
    for (const Finding& finding : report.findings) {
        findings.push_back(finding_json(finding));
    }
    nlohmann::json layers = nlohmann::json::array();
    for (const CameraCheck::Layer& layer : check.layers) {
        layers.push_back({{"picture", layer.picture}, {"layer", layer.number}});
    }
    nlohmann::json entry{{"camera", report.camera},
                         {"layers", layers},
                         {"width", report.grid.picture_width},
                         {"height", report.grid.picture_height},
                         {"samples", report.samples.size()},
                         {"valid_share", report.valid_share},
                         {"single_viewpoint", report.single_viewpoint},
                         {"lens", check.has_lens},
                         {"bend", check.has_bend},
                         {"origin_extent", report.origin_extent},
                         {"distance", nullptr},
                         {"magnification", statistics_json(report.magnification)},
                         {"anisotropy", statistics_json(report.anisotropy)},
                         {"findings", findings},
                         {"defects", check.defect_count()}};
    if (report.distance) {
        entry["distance"] = *report.distance;
    }
    if (check.in_scene) {
        entry["in_scene"] = scene_json(*check.in_scene);
    }
    return entry;
}

}  // namespace balcony::cli
