// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/statement_rows.hpp"

#include <algorithm>
#include <array>

namespace balcony::lang {

namespace {

using camera::StageKind;

constexpr std::uint8_t in_camera = static_cast<std::uint8_t>(Block::camera);
constexpr std::uint8_t in_path = static_cast<std::uint8_t>(Block::path);
constexpr std::uint8_t in_pictures = static_cast<std::uint8_t>(Block::picture);
constexpr std::uint8_t in_layer = static_cast<std::uint8_t>(Block::layer);
constexpr std::uint8_t in_loop = static_cast<std::uint8_t>(Block::loop);

constexpr std::array rows = {
    StatementRow{.kind = StatementKind::let,
                 .keyword = "let",
                 .blocks = in_camera | in_pictures | in_loop,
                 .shape = Shape::let,
                 .once = false},
    StatementRow{.kind = StatementKind::aspect,
                 .keyword = "aspect",
                 .blocks = in_camera | in_pictures,
                 .shape = Shape::value},
    StatementRow{.kind = StatementKind::axes,
                 .keyword = "axes",
                 .blocks = in_camera,
                 .shape = Shape::word,
                 .expected = "'z_up' or 'y_up' after 'axes'"},
    StatementRow{.kind = StatementKind::map,
                 .keyword = "map",
                 .blocks = in_camera | in_path,
                 .shape = Shape::ranges,
                 .phase = 1,
                 .stage_kind = StageKind::picture_mapper},
    StatementRow{.kind = StatementKind::eye,
                 .keyword = "eye",
                 .blocks = in_camera,
                 .shape = Shape::path,
                 .phase = 4,
                 .stage_kind = StageKind::object_generator,
                 .expected = "an object, such as sphere(1)"},
    StatementRow{.kind = StatementKind::toward,
                 .keyword = "toward",
                 .blocks = in_camera,
                 .shape = Shape::path,
                 .phase = 5,
                 .stage_kind = StageKind::object_generator,
                 .expected = "an object, such as sphere(1)"},
    StatementRow{.kind = StatementKind::morph,
                 .keyword = "morph",
                 .blocks = in_camera,
                 .shape = Shape::morph,
                 .phase = 3,
                 .expected = "the name of a camera, such as pinhole",
                 .meaning =
                     "a camera between two others: between their parameters if they are calls "
                     "of one camera, otherwise between their rays"},
    StatementRow{.kind = StatementKind::object,
                 .keyword = "object",
                 .blocks = in_path,
                 .shape = Shape::stage,
                 .phase = 3,
                 .stage_kind = StageKind::object_generator,
                 .expected = "an object, such as sphere(1)"},
    StatementRow{.kind = StatementKind::warp,
                 .keyword = "warp",
                 .blocks = in_camera | in_path,
                 .shape = Shape::stages,
                 .once = false,
                 .phase = 2,
                 .stage_kind = StageKind::parameter_transformer,
                 .expected = "a parameter transformer, such as rotate(10deg)"},
    StatementRow{.kind = StatementKind::move,
                 .keyword = "move",
                 .blocks = in_camera | in_path,
                 .shape = Shape::stages,
                 .once = false,
                 .phase = 6,
                 .stage_kind = StageKind::object_transformer,
                 .expected = "an object transformer, such as translate(0, 0, 1)"},
    StatementRow{.kind = StatementKind::look,
                 .keyword = "look",
                 .blocks = in_camera,
                 .shape = Shape::rule,
                 .phase = 7,
                 .stage_kind = StageKind::direction_rule,
                 .expected = "a direction rule, such as normal"},
    StatementRow{.kind = StatementKind::stereo,
                 .keyword = "stereo",
                 .blocks = in_camera | in_layer,
                 .shape = Shape::call,
                 .phase = 8,
                 .stage_kind = StageKind::stereo_view,
                 .expected = "a stereo view, such as stereo(side = -1)"},
    StatementRow{
        .kind = StatementKind::lens,
        .keyword = "lens",
        .blocks = in_camera,
        .shape = Shape::call,
        .phase = 9,
        .stage_kind = StageKind::lens,
        .expected = "a lens, such as lens(radius = 0.1, focus = 5) or table(\"lens.dat\")"},
    StatementRow{.kind = StatementKind::bend,
                 .keyword = "bend",
                 .blocks = in_camera,
                 .shape = Shape::stage,
                 .phase = 10,
                 .stage_kind = StageKind::bend,
                 .expected = "a bend, such as field(at(x, y, z) = [0, 0, -0.1], length = 10)"},
    StatementRow{.kind = StatementKind::time,
                 .keyword = "time",
                 .blocks = in_camera,
                 .shape = Shape::equation,
                 .phase = 11,
                 .meaning = "when each ray meets the scene, and t in the other formulas of the "
                            "camera; x and y are the point of the picture as fractions from its "
                            "top left corner"},
    StatementRow{.kind = StatementKind::fitted,
                 .keyword = "fit",
                 .blocks = in_camera | in_pictures,
                 .shape = Shape::assignments,
                 .once = false,
                 .meaning = "what parameters are where a scene places the camera"},
    StatementRow{.kind = StatementKind::place,
                 .keyword = "place",
                 .blocks = in_camera | in_layer,
                 .shape = Shape::placements,
                 .once = false,
                 .phase = 0,
                 .stage_kind = StageKind::picture_arranger,
                 .expected = "corners or a picture arranger after ','"},
    StatementRow{.kind = StatementKind::arrange,
                 .keyword = "arrange",
                 .blocks = in_camera | in_layer,
                 .shape = Shape::stages,
                 .once = false,
                 .phase = 0,
                 .stage_kind = StageKind::picture_arranger,
                 .expected = "a picture arranger, such as rotate(8deg)"},
    StatementRow{.kind = StatementKind::layer,
                 .keyword = "layer",
                 .blocks = in_pictures | in_loop,
                 .shape = Shape::layer,
                 .once = false,
                 .expected = "the name of a camera or a picture"},
    StatementRow{.kind = StatementKind::loop,
                 .keyword = "for",
                 .blocks = in_pictures | in_loop,
                 .shape = Shape::loop,
                 .once = false},
    StatementRow{.kind = StatementKind::fit,
                 .keyword = "fit",
                 .blocks = in_layer,
                 .shape = Shape::nothing,
                 .phase = 1,
                 .meaning = "unstretched, as large as the place permits, in its middle"},
    StatementRow{.kind = StatementKind::fill,
                 .keyword = "fill",
                 .blocks = in_layer,
                 .shape = Shape::nothing,
                 .phase = 1,
                 .meaning = "unstretched, as small as covers the place; the rest is cut off"},
    StatementRow{.kind = StatementKind::stretch,
                 .keyword = "stretch",
                 .blocks = in_layer,
                 .shape = Shape::nothing,
                 .phase = 1,
                 .meaning = "stretched to the place"},
    StatementRow{.kind = StatementKind::show,
                 .keyword = "show",
                 .blocks = in_layer,
                 .shape = Shape::shown,
                 .once = false,
                 .phase = 2,
                 .expected = "objects(\"vase*\"), with names of objects of the scene",
                 .meaning = "the region of the layer's own picture that is shown, or the objects "
                            "of the scene that its rays meet first"},
    StatementRow{.kind = StatementKind::hide,
                 .keyword = "hide",
                 .blocks = in_layer,
                 .shape = Shape::objects,
                 .once = false,
                 .phase = 2,
                 .expected = "objects(\"vase*\"), with names of objects of the scene",
                 .meaning = "the objects of the scene that its rays pass at first"},
    StatementRow{.kind = StatementKind::clip,
                 .keyword = "clip",
                 .blocks = in_layer,
                 .shape = Shape::stage,
                 .phase = 9,
                 .stage_kind = StageKind::clip_shape,
                 .expected = "a clip shape, such as ellipse"},
    StatementRow{.kind = StatementKind::soft,
                 .keyword = "soft",
                 .blocks = in_layer,
                 .shape = Shape::value,
                 .phase = 10,
                 .meaning = "the width of the clip's soft edge, half of it outside the shape, as a "
                            "fraction of the layer's height"},
    StatementRow{.kind = StatementKind::alpha,
                 .keyword = "alpha",
                 .blocks = in_layer,
                 .shape = Shape::value,
                 .phase = 12,
                 .meaning = "the opacity: from 0 (invisible) to 1 (opaque)"},
    StatementRow{.kind = StatementKind::channels,
                 .keyword = "channels",
                 .blocks = in_layer,
                 .shape = Shape::call,
                 .phase = 11,
                 .expected = "channels(red = (1, 0, 0))",
                 .meaning = "red, green and blue of the layer, each as weights of the red, green "
                            "and blue that it shows, in linear light"},
    StatementRow{.kind = StatementKind::blend,
                 .keyword = "blend",
                 .blocks = in_layer,
                 .shape = Shape::blend,
                 .phase = 13,
                 .expected = "a blend mode, such as multiply, or by depth, or by weight(1 - x)"},
    StatementRow{.kind = StatementKind::frame,
                 .keyword = "frame",
                 .blocks = in_layer,
                 .shape = Shape::call,
                 .phase = 14,
                 .expected = "a frame",
                 .meaning = "a line along the inside of the clip's edge; its width is a fraction "
                            "of the picture's height"},
    StatementRow{.kind = StatementKind::scale_bar,
                 .keyword = "scale_bar",
                 .blocks = in_layer,
                 .shape = Shape::call,
                 .phase = 16,
                 .expected = "scale_bar(0.1), with a length in scene units",
                 .meaning = "a bar of a length in scene units, on a layer with a scale"},
    StatementRow{
        .kind = StatementKind::leader,
        .keyword = "leader",
        .blocks = in_layer,
        .shape = Shape::optional_corners,
        .once = false,
        .phase = 15,
        .meaning = "an outline of a region of the picture, and lines from there to the layer"},
};

constexpr std::array<std::string_view, 3> file_words = {"import", "camera", "picture"};

}  // namespace

std::span<const StatementRow> statement_rows() { return rows; }

const StatementRow* row_of(StatementKind kind) {
    const auto* row = std::find_if(rows.begin(), rows.end(),
                                   [kind](const StatementRow& one) { return one.kind == kind; });
    return row != rows.end() ? row : nullptr;
}

const StatementRow* find_statement(const Token& token, Block block) {
    const bool in_camera_or_path = block == Block::camera || block == Block::path;
    const std::uint8_t around = in_camera_or_path ? in_camera | in_path : in_pictures | in_layer;
    const StatementRow* found = nullptr;
    for (const StatementRow& row : rows) {
        if ((row.blocks & around) == 0 || !token.is_name(row.keyword)) {
            continue;
        }
        if (row.stands_in(block)) {
            return &row;
        }
        found = found != nullptr ? found : &row;
    }
    return found;
}

bool is_file_keyword(const Token& token) {
    return std::any_of(file_words.begin(), file_words.end(),
                       [&token](std::string_view word) { return token.is_name(word); });
}

std::vector<std::string> keywords_for(Block block) {
    std::vector<std::string> names;
    for (const StatementRow& row : rows) {
        if (row.stands_in(block)) {
            names.emplace_back(row.keyword);
        }
    }
    return names;
}

std::string_view keyword(StatementKind kind) {
    const StatementRow* row = row_of(kind);
    return row != nullptr ? row->keyword : std::string_view();
}

std::vector<std::string> statements_for(camera::StageKind kind) {
    std::vector<std::string> keywords;
    for (const StatementRow& row : rows) {
        if (row.stage_kind == kind) {
            keywords.emplace_back(row.keyword);
        }
    }
    return keywords;
}

}  // namespace balcony::lang
