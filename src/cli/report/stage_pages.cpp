// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/stage_pages.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "cli/report/stage_text.hpp"

namespace balcony::cli {

namespace {

using camera::StageEntry;
using camera::StageKind;

/// The classes of "Ray Tracing with Extended Cameras", section 3, in the paper's order. A stage
/// belongs to the first class of its kind that lists it or lists no names.
struct StageClass {
    std::string_view title;
    StageKind kind;
    std::vector<std::string_view> names{};
};

const std::vector<StageClass>& classes() {
    constexpr auto object = StageKind::object_generator;
    static const std::vector<StageClass> rows{
        {"Picture mappers", StageKind::picture_mapper},
        {"Parameter transformers", StageKind::parameter_transformer},
        {"Object transformers", StageKind::object_transformer},
        {"Conics and superconics",
         object,
         {"ellipse", "hyperbola", "parabola", "superellipse", "superhyperbola", "superparabola"}},
        {"Quadrics and superquadrics",
         object,
         {"product", "ellipsoid", "superellipsoid", "hyperboloid_one", "superhyperboloid_one",
          "hyperboloid_two", "superhyperboloid_two", "toroid", "supertoroid"}},
        {"General curves",
         object,
         {"polyline", "catmull_rom", "natural_spline", "hermite", "bezier", "bspline", "nurbs",
          "arc_length"}},
        {"Free-form surfaces",
         object,
         {"bezier_patch", "bspline_patch", "nurbs_patch", "interpolating_patch", "mesh"}},
        {"Sweeps", object, {"sweep"}},
        {"Fractal objects", object, {"fractal_plane", "fractal_sphere"}},
        {"Objects from formulas", object, {"curve", "surface"}},
        {"Points, curves and surfaces of elementary geometry", object},
        {"Direction rules", StageKind::direction_rule},
        {"Picture arrangers", StageKind::picture_arranger},
        {"Clip shapes", StageKind::clip_shape},
    };
    return rows;
}

const StageClass& class_of(const StageEntry& row) {
    const auto found = std::find_if(classes().begin(), classes().end(), [&](const StageClass& c) {
        return c.kind == row.kind && (c.names.empty() || std::find(c.names.begin(), c.names.end(),
                                                                   row.name) != c.names.end());
    });
    return *found;
}

// "object-generator"
std::string hyphenated(StageKind kind) {
    std::string name(camera::name_of(kind));
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string page_file(StageKind kind) { return hyphenated(kind) + "s.md"; }

std::string example_name(const StageEntry& row) {
    return fmt::format("{}-{}", hyphenated(row.kind), row.name);
}

std::string example_text(const StageEntry& row) {
    const auto begin = row.example.find_first_not_of(" \n");
    if (begin == std::string_view::npos) {
        return {};
    }
    const auto end = row.example.find_last_not_of(" \n");
    std::string text = fmt::format("{}\n", row.example.substr(begin, end + 1 - begin));
    const auto laid_out = lang::format(std::make_shared<const SourceText>("example", text));
    return laid_out ? *laid_out : text;
}

// Escapes a text for a table cell.
std::string in_cell(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '|' ? "\\|" : std::string(1, c);
    }
    return safe;
}

std::string code(const std::string& text) {
    return text.empty() ? "" : fmt::format("`{}`", in_cell(text));
}

std::string section(const StageEntry& row) {
    std::string text = fmt::format("## {}\n\n", row.name);
    text += row.formula ? fmt::format("A formula: `{}`.\n", call_text(row))
                        : fmt::format("`{}`: {}.\n", call_text(row), row.meaning);
    if (!row.parameters.empty()) {
        text += "\n| parameter | type | default | range | meaning |\n|---|---|---|---|---|\n";
        for (const camera::StageParameter& parameter : row.parameters) {
            const std::string standard = default_text(parameter);
            text += fmt::format("| `{}` | {} | {} | {} | {} |\n", parameter.name,
                                in_cell(type_text(parameter)),
                                standard.empty() && parameter.optional ? "nothing" : code(standard),
                                range_text(parameter), in_cell(parameter.meaning));
        }
    }
    if (const std::string example = example_text(row); !example.empty()) {
        text += fmt::format("\n![{}](pictures/{}.png)\n\n```cam\n{}```\n", row.name,
                            example_name(row), example);
    }
    return text;
}

StagePage page_of(StageKind kind, std::string_view heading) {
    std::string text = fmt::format(
        "# {}s\n\n[All stages](README.md). This page is generated from the catalogue of stages by\n"
        "`scripts/pictures`.\n",
        heading);
    for (const StageEntry& row : camera::catalogue()) {
        if (row.kind == kind) {
            text += fmt::format("\n{}", section(row));
        }
    }
    return {page_file(kind), text};
}

std::string index_text() {
    std::string text =
        "# Stages\n\n"
        "All stages of cameras, grouped as in the founding paper. `scripts/pictures` generates\n"
        "these pages and their pictures from the catalogue of stages; `balcony list` prints the\n"
        "same text in the terminal. [Drawing a camera](../drawing.md) explains the pictures.\n";
    for (const StageClass& each : classes()) {
        std::string rows;
        for (const StageEntry& row : camera::catalogue()) {
            if (&class_of(row) == &each) {
                rows += fmt::format("| [{0}]({1}#{0}) | {2} |\n", row.name, page_file(row.kind),
                                    in_cell(row.meaning));
            }
        }
        if (!rows.empty()) {
            text +=
                fmt::format("\n## {}\n\n| stage | description |\n|---|---|\n{}", each.title, rows);
        }
    }
    return text;
}

}  // namespace

std::vector<StagePage> stage_pages() {
    std::vector<StagePage> pages{{"README.md", index_text()}};
    std::vector<StageKind> kinds;
    for (const StageEntry& row : camera::catalogue()) {
        if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end()) {
            kinds.push_back(row.kind);
            std::string heading(camera::name_of(row.kind));
            heading.front() = static_cast<char>(heading.front() - 'a' + 'A');
            pages.push_back(page_of(row.kind, heading));
        }
        if (const std::string example = example_text(row); !example.empty()) {
            pages.push_back({fmt::format("examples/{}.cam", example_name(row)), example});
        }
    }
    return pages;
}

}  // namespace balcony::cli
