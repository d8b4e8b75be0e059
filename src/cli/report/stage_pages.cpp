// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/stage_pages.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "camera/catalogue/stage_text.hpp"

namespace balcony::cli {

namespace {

using camera::StageEntry;
using camera::StageKind;

/// The headings of the list of stages: the classes of "Ray Tracing with Extended Cameras", section
/// 3, in its order. A row names its heading, or is under the one of its kind.
struct Heading {
    std::string_view title;
    StageKind kind;
    bool of_kind = true;
};

constexpr std::array headings{
    Heading{"Picture mappers", StageKind::picture_mapper},
    Heading{"Parameter transformers", StageKind::parameter_transformer},
    Heading{"Object transformers", StageKind::object_transformer},
    Heading{"Conics and superconics", StageKind::object_generator, false},
    Heading{"Quadrics and superquadrics", StageKind::object_generator, false},
    Heading{"General curves", StageKind::object_generator, false},
    Heading{"Free-form surfaces", StageKind::object_generator, false},
    Heading{"Sweeps", StageKind::object_generator, false},
    Heading{"Fractal objects", StageKind::object_generator, false},
    Heading{"Objects from formulas", StageKind::object_generator, false},
    Heading{"Points, curves and surfaces of elementary geometry", StageKind::object_generator},
    Heading{"Map projections", StageKind::object_generator, false},
    Heading{"Calibrated cameras", StageKind::object_generator, false},
    Heading{"Direction rules", StageKind::direction_rule},
    Heading{"Stereo views", StageKind::stereo_view},
    Heading{"Lenses", StageKind::lens},
    Heading{"Surfaces of focus", StageKind::focus},
    Heading{"Bends", StageKind::bend},
    Heading{"Picture arrangers", StageKind::picture_arranger},
    Heading{"Clip shapes", StageKind::clip_shape},
};

bool is_under(const StageEntry& row, const Heading& heading) {
    return row.kind == heading.kind &&
           (row.section.empty() ? heading.of_kind : row.section == heading.title);
}

// "object-generator"
std::string hyphenated(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string page_file(StageKind kind) { return hyphenated(camera::plural_of(kind)) + ".md"; }

std::string example_name(const StageEntry& row) {
    return fmt::format("{}-{}", hyphenated(std::string(camera::name_of(row.kind))), row.name);
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
    text += row.shape ? fmt::format("A formula: `{}`.\n", call_text(row))
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
    text += fmt::format("\n```text\n{}\n```\n", stage_formula(row));
    if (const std::string example = example_text(row); !example.empty()) {
        text += fmt::format("\n![{}](pictures/{}.png)\n\n```cam\n{}```\n", row.name,
                            example_name(row), example);
    }
    return text;
}

StagePage page_of(StageKind kind, std::string_view heading) {
    std::string text = fmt::format(
        "# {}\n\n[All stages](README.md). This page is generated from the catalogue of stages by\n"
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
        "same text in the terminal. [Drawing a camera](../drawing.md) explains the pictures.\n\n"
        "Each stage has its formula. A prime marks the result of a transformer: it maps (u, v) to\n"
        "(u′, v′), and p = (x, y, z) to p′. An object gives the point p at the parameters (u,\n"
        "v), a direction rule the direction d, of any length. Indices count the coordinates of a\n"
        "pair or triple, at = (at₁, at₂), or the points of a list. · and × are the products of\n"
        "vectors. Where a formula has no finite value, there is no ray.\n";
    for (const Heading& heading : headings) {
        std::string rows;
        for (const StageEntry& row : camera::catalogue()) {
            if (is_under(row, heading)) {
                rows += fmt::format("| [{0}]({1}#{0}) | {2} |\n", row.name, page_file(row.kind),
                                    in_cell(row.meaning));
            }
        }
        if (!rows.empty()) {
            text += fmt::format("\n## {}\n\n| stage | description |\n|---|---|\n{}", heading.title,
                                rows);
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
            std::string heading = camera::plural_of(row.kind);
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
