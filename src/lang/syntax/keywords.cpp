// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/keywords.hpp"

#include <algorithm>
#include <array>

namespace balcony::lang {

namespace {

constexpr std::uint8_t in_camera = static_cast<std::uint8_t>(Block::camera);
constexpr std::uint8_t in_path = static_cast<std::uint8_t>(Block::path);
constexpr std::uint8_t in_pictures = static_cast<std::uint8_t>(Block::picture);
constexpr std::uint8_t in_layer = static_cast<std::uint8_t>(Block::layer);

constexpr std::array rows = {
    Keyword{StatementKind::let, "let", in_camera | in_pictures},
    Keyword{StatementKind::aspect, "aspect", in_camera | in_pictures},
    Keyword{StatementKind::axes, "axes", in_camera},
    Keyword{StatementKind::map, "map", in_camera | in_path},
    Keyword{StatementKind::eye, "eye", in_camera},
    Keyword{StatementKind::toward, "toward", in_camera},
    Keyword{StatementKind::object, "object", in_path},
    Keyword{StatementKind::warp, "warp", in_camera | in_path},
    Keyword{StatementKind::move, "move", in_camera | in_path},
    Keyword{StatementKind::look, "look", in_camera},
    Keyword{StatementKind::place, "place", in_camera | in_layer},
    Keyword{StatementKind::arrange, "arrange", in_camera | in_layer},
    Keyword{StatementKind::layer, "layer", in_pictures},
    Keyword{StatementKind::clip, "clip", in_layer},
    Keyword{StatementKind::soft, "soft", in_layer,
            "the width of the clip's soft edge, half of it outside the shape, as a fraction of the "
            "layer's height"},
    Keyword{StatementKind::alpha, "alpha", in_layer,
            "the opacity: from 0 (invisible) to 1 (opaque)"},
    Keyword{StatementKind::blend, "blend", in_layer},
    Keyword{StatementKind::frame, "frame", in_layer,
            "a line along the inside of the clip's edge; its width is a fraction of the picture's "
            "height"},
    Keyword{StatementKind::leader, "leader", in_layer,
            "an outline of a region of the picture, and lines from there to the layer"}};

constexpr std::array<std::string_view, 3> file_words = {"import", "camera", "picture"};

const Keyword* row_of(StatementKind kind) {
    const auto* row = std::find_if(rows.begin(), rows.end(),
                                   [kind](const Keyword& one) { return one.kind == kind; });
    return row != rows.end() ? row : nullptr;
}

}  // namespace

std::span<const Keyword> keywords() { return rows; }

const Keyword* find_keyword(const Token& token, bool in_picture) {
    const auto here =
        static_cast<std::uint8_t>(in_picture ? in_pictures | in_layer : in_camera | in_path);
    for (const Keyword& row : rows) {
        if ((row.blocks & here) != 0 && token.is_name(row.text)) {
            return &row;
        }
    }
    return nullptr;
}

bool is_file_keyword(const Token& token) {
    return std::any_of(file_words.begin(), file_words.end(),
                       [&token](std::string_view word) { return token.is_name(word); });
}

std::vector<std::string> keywords_for(Block block) {
    std::vector<std::string> names;
    for (const Keyword& row : rows) {
        if (row.stands_in(block)) {
            names.emplace_back(row.text);
        }
    }
    return names;
}

std::string_view keyword(StatementKind kind) {
    const Keyword* row = row_of(kind);
    return row != nullptr ? row->text : std::string_view();
}

std::string_view meaning_of(StatementKind kind) {
    const Keyword* row = row_of(kind);
    return row != nullptr ? row->meaning : std::string_view();
}

std::vector<std::string> statements_for(camera::StageKind kind) {
    switch (kind) {
        case camera::StageKind::picture_arranger: return {"arrange"};
        case camera::StageKind::picture_mapper: return {"map"};
        case camera::StageKind::parameter_transformer: return {"warp"};
        case camera::StageKind::object_generator: return {"eye", "toward", "object"};
        case camera::StageKind::object_transformer: return {"move"};
        case camera::StageKind::direction_rule: return {"look"};
        case camera::StageKind::clip_shape: return {"clip"};
    }
    return {};
}

}  // namespace balcony::lang
