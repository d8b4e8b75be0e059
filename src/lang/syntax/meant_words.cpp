// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/meant_words.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/names.hpp"

namespace balcony::lang {

namespace {

using camera::StageKind;

/// A word of other programs, and the statement that it stands for.
struct MeantStatement {
    std::string_view word;
    std::string_view keyword;
    std::string_view remedy;
};

constexpr std::string_view parameters_of_cameras =
    "parameters stand behind the name of the camera: camera NAME(fov = 60deg) { ... }";

constexpr std::array meant_statements = {
    MeantStatement{"opacity", "alpha", "write alpha 0.5, from 0 (invisible) to 1"},
    MeantStatement{"transparency", "alpha", "write alpha 0.5, from 0 (invisible) to 1"},
    MeantStatement{"border", "frame", "write frame(width = 0.01, color = (1, 1, 1))"},
    MeantStatement{"outline", "frame", "write frame(width = 0.01, color = (1, 1, 1))"},
    MeantStatement{"width", "frame", "write frame(width = 0.01)"},
    MeantStatement{"color", "frame", "write frame(color = (1, 1, 1))"},
    MeantStatement{"mask", "clip", "write clip ellipse, or clip image(\"mask.png\")"},
    MeantStatement{"crop", "show", "write show (0.2, 0.1) .. (0.5, 0.4) for a region"},
    MeantStatement{"region", "show", "write show (0.2, 0.1) .. (0.5, 0.4)"},
    MeantStatement{"position", "place", "write place (0.7, 0.1) .. (0.95, 0.5)"},
    MeantStatement{"contain", "fit", "write fit"},
    MeantStatement{"cover", "fill", "write fill"},
    MeantStatement{"feather", "soft", "write soft 0.02"},
    MeantStatement{"blur", "soft", "write soft 0.02 for a soft edge"},
    MeantStatement{"tint", "channels", "write channels(green = (0, 0, 0)) to leave green out"},
    MeantStatement{"filter", "channels", "write channels(green = (0, 0, 0)) to leave green out"},
    MeantStatement{"mode", "blend", "write blend multiply"},
    MeantStatement{"size", "layer", "write the size behind the name: picture NAME 1920 x 1080"},
    MeantStatement{"background", "layer", "give the background to the command: --background white"},
    MeantStatement{"ratio", "aspect", "write aspect 16/9"},
    MeantStatement{"target", "toward", "write toward plane((1, 0, 0)), with a direction object"},
    MeantStatement{"lookat", "toward", "write toward point(1, 0, 0), with a direction object"},
    MeantStatement{"look_at", "toward", "write toward point(1, 0, 0), with a direction object"},
    MeantStatement{"position", "eye", "write eye point(0, 0, 1.6)"},
    MeantStatement{"origin", "eye", "write eye point(0, 0, 1.6)"},
    MeantStatement{"location", "eye", "write eye point(0, 0, 1.6)"},
    MeantStatement{"transform", "move", "write move rotate(z, 30deg), translate(0, 0, 1)"},
    MeantStatement{"distort", "warp", "write warp with a parameter transformer"},
    MeantStatement{"separation", "stereo", "write stereo(separation = 0.064, side = -1)"},
    MeantStatement{"convergence", "stereo", "write stereo(convergence = 2, side = -1)"},
    MeantStatement{"interocular", "stereo", "write stereo(separation = 0.064, side = -1)"},
    MeantStatement{"aperture", "lens", "write lens(radius = 0.1, focus = 5)"},
    MeantStatement{"focus", "lens", "write lens(radius = 0.1, focus = 5)"},
    MeantStatement{"bokeh", "lens", "write lens(radius = 0.1, blades = 6, focus = 5)"},
    MeantStatement{"shutter", "time", "give the shutter to the command: --shutter 0.02"},
    MeantStatement{"fov", "map",
                   "the field of view is the range of map; for a pinhole camera: map u = "
                   "tan(fov/2) .. -tan(fov/2), v = square"},
    MeantStatement{"param", "let", parameters_of_cameras},
    MeantStatement{"parameter", "let", parameters_of_cameras},
    MeantStatement{"float", "let", "write let width = 4: values have no types"},
    MeantStatement{"var", "let", "write let width = 4"},
    MeantStatement{"set", "let", "write let width = 4"},
    MeantStatement{"extends", "map", "write camera wide = fisheye(fov = 200deg), without a block"},
    MeantStatement{"for", "warp",
                   "loops repeat the layers of a picture; write repeat(n, ...) in warp or move"},
    MeantStatement{"if", "warp", "choose between numbers with if(condition, a, b)"},
};

struct MeantStage {
    StageKind kind;
    std::string_view word;
    std::string_view remedy;
};

constexpr std::string_view fixed =
    "write along(x) for a fixed direction: x forward, y to the left, "
    "z up, or -x, -y, -z";

constexpr std::array meant_stages = {
    MeantStage{StageKind::direction_rule, "left",
               "write along(y) for the left of the scene, or sideways left for that of a curve"},
    MeantStage{StageKind::direction_rule, "right",
               "write along(-y) for the right of the scene, or sideways right for that of a curve"},
    MeantStage{StageKind::direction_rule, "forward",
               "write along(x), or tangent forward along a curve"},
    MeantStage{StageKind::direction_rule, "backward",
               "write along(-x), or tangent backward along a curve"},
    MeantStage{StageKind::direction_rule, "up", "write along(z)"},
    MeantStage{StageKind::direction_rule, "down", "write along(-z)"},
    MeantStage{StageKind::direction_rule, "x", fixed},
    MeantStage{StageKind::direction_rule, "y", fixed},
    MeantStage{StageKind::direction_rule, "z", fixed},
    MeantStage{StageKind::direction_rule, "at",
               "the direction object is written toward point(1, 0, 0)"},
    MeantStage{StageKind::direction_rule, "toward",
               "the direction object is a statement: toward point(1, 0, 0)"},
    MeantStage{StageKind::direction_rule, "inwards", "write normal inward"},
    MeantStage{StageKind::direction_rule, "inside", "write normal inward"},
    MeantStage{StageKind::direction_rule, "outwards", "write normal outward"},
    MeantStage{StageKind::direction_rule, "outside", "write normal outward"},
    MeantStage{StageKind::object_generator, "at", "write point(0, 0, 1.6)"},
    MeantStage{StageKind::object_generator, "ball", "write sphere(1)"},
    MeantStage{StageKind::clip_shape, "circle",
               "write ellipse; in a window of aspect 1 it is a circle"},
    MeantStage{StageKind::clip_shape, "rect", "write rectangle"},
    MeantStage{StageKind::clip_shape, "square", "write rectangle"},
};

/// A word of other languages, and what opens its definition here.
struct MeantItem {
    std::string_view word;
    std::string_view remedy;
};

constexpr std::array meant_items = {
    MeantItem{"include", "write import \"pinhole.cam\""},
    MeantItem{"use", "write import \"pinhole.cam\""},
    MeantItem{"using", "write import \"pinhole.cam\""},
    MeantItem{"require", "write import \"pinhole.cam\""},
    MeantItem{"function", "write let half(x) = x/2"},
    MeantItem{"def", "write let half(x) = x/2"},
    MeantItem{"scene", "a scene is a file of its own: balcony render scene.glb --camera FILE.cam"},
};

bool contains(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string statement_remedy(std::string_view word, Block block,
                             const camera::Catalogue& catalogue) {
    const std::vector<std::string> known = keywords_for(block);
    if ((word == "u" || word == "v") && contains(known, "map")) {
        return "write both ranges in one map, separated by ',': map u = -1 .. 1, v = -1 .. 1";
    }
    for (const MeantStatement& row : meant_statements) {
        if (row.word == word && contains(known, row.keyword)) {
            return std::string(row.remedy);
        }
    }
    std::vector<std::string> with_statement;
    for (const camera::StageEntry& row : catalogue) {
        for (const std::string& statement : statements_for(row.kind)) {
            if (row.name == word && contains(known, statement)) {
                with_statement.push_back(fmt::format("{} {}", statement, word));
            }
        }
    }
    if (!with_statement.empty()) {
        return fmt::format("write {}", one_of(with_statement));
    }
    if (contains(built_in_cameras(), word)) {
        return contains(known, "layer")
                   ? fmt::format("write layer {}", word)
                   : fmt::format(
                         "write camera NAME = {}( ... ), without a block, for a camera with "
                         "other values of its parameters",
                         word);
    }
    const bool of_camera =
        contains(keywords_for(Block::camera), word) || contains(keywords_for(Block::path), word);
    if (of_camera && (contains(known, "layer") || contains(known, "clip"))) {
        return fmt::format("'{}' belongs in a camera; a layer names a camera: layer panorama",
                           word);
    }
    return suggestion(word, known, "the statements are");
}

std::string item_remedy(std::string_view word) {
    const auto row = std::find_if(meant_items.begin(), meant_items.end(),
                                  [word](const MeantItem& one) { return one.word == word; });
    return row != meant_items.end()
               ? std::string(row->remedy)
               : suggestion(word, {"import", "let", "camera", "picture"}, "write");
}

std::optional<std::string> stage_remedy(StageKind kind, std::string_view word) {
    for (const MeantStage& row : meant_stages) {
        if (row.kind == kind && row.word == word) {
            return std::string(row.remedy);
        }
    }
    return std::nullopt;
}

std::string instead_of_formula(StageKind kind, std::string_view numbers, bool depends) {
    const bool is_rule = kind == StageKind::direction_rule;
    if (depends) {
        return fmt::format("write {}surface(u, v) = [{}]{}", is_rule ? "toward " : "", numbers,
                           is_rule ? " and look absolute" : "");
    }
    return is_rule ? fmt::format("write along(({})) for a fixed direction", numbers)
                   : fmt::format("write point({}) for a point", numbers);
}

}  // namespace balcony::lang
