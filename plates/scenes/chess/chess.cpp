// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/chess/chess.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;
using scene::MeshIndex;

constexpr double square = 4.0;

enum class Piece : std::uint8_t { pawn, rook, bishop, queen, king };

// The end of a game: pieces of both sides, by column and row from the left and the front.
struct Standing {
    Piece piece;
    bool white;
    int column;
    int row;
};
constexpr std::array position{
    Standing{Piece::king, true, 5, 1},   Standing{Piece::queen, true, 3, 3},
    Standing{Piece::rook, true, 3, 0},   Standing{Piece::bishop, true, 4, 2},
    Standing{Piece::pawn, true, 5, 2},   Standing{Piece::pawn, true, 6, 1},
    Standing{Piece::pawn, true, 7, 2},   Standing{Piece::pawn, true, 0, 2},
    Standing{Piece::pawn, true, 1, 3},   Standing{Piece::king, false, 6, 6},
    Standing{Piece::queen, false, 2, 5}, Standing{Piece::rook, false, 4, 7},
    Standing{Piece::rook, false, 1, 7},  Standing{Piece::bishop, false, 5, 4},
    Standing{Piece::pawn, false, 5, 5},  Standing{Piece::pawn, false, 6, 5},
    Standing{Piece::pawn, false, 7, 5},  Standing{Piece::pawn, false, 0, 5},
    Standing{Piece::pawn, false, 3, 5},
};

// The foot that all pieces share, and a slender stem up to a collar at `collar`.
std::vector<V2d> turned_foot(double width, double collar) {
    std::vector<V2d> profile{{0.0, 0.0},           {width, 0.0},         {width * 1.02, 0.14},
                             {width * 0.98, 0.4},  {width * 0.84, 0.52}, {width * 0.86, 0.66},
                             {width * 0.78, 0.82}, {width * 0.56, 1.05}, {width * 0.42, 1.45},
                             {width * 0.34, 2.1}};
    profile.emplace_back(width * 0.29, collar - 0.5);
    profile.emplace_back(width * 0.31, collar - 0.22);
    profile.emplace_back(width * 0.62, collar - 0.12);
    profile.emplace_back(width * 0.62, collar);
    profile.emplace_back(width * 0.36, collar + 0.1);
    return profile;
}

void add_ball(std::vector<V2d>& profile, double radius, double centre) {
    for (int k = 2; k <= 12; ++k) {
        const double t = std::numbers::pi * (k / 12.0 - 0.5);
        profile.emplace_back(k == 12 ? 0.0 : radius * std::cos(t), centre + radius * std::sin(t));
    }
}

std::vector<V2d> profile_of(Piece piece) {
    switch (piece) {
        case Piece::pawn: {
            auto profile = turned_foot(1.05, 2.7);
            add_ball(profile, 0.72, 3.3);
            return profile;
        }
        case Piece::rook: {
            auto profile = turned_foot(1.25, 3.2);
            profile.insert(profile.end(), {{0.72, 3.5},
                                           {0.78, 4.0},
                                           {1.0, 4.1},
                                           {1.02, 4.85},
                                           {0.74, 4.85},
                                           {0.72, 4.5},
                                           {0.0, 4.45}});
            return profile;
        }
        case Piece::bishop: {
            auto profile = turned_foot(1.2, 3.8);
            profile.insert(
                profile.end(),
                {{0.5, 4.0}, {0.68, 4.35}, {0.72, 4.7}, {0.6, 5.15}, {0.38, 5.5}, {0.14, 5.75}});
            add_ball(profile, 0.2, 5.95);
            return profile;
        }
        case Piece::queen: {
            auto profile = turned_foot(1.4, 4.6);
            profile.insert(profile.end(), {{0.55, 4.8},
                                           {0.62, 5.2},
                                           {0.92, 5.95},
                                           {0.98, 6.1},
                                           {0.82, 6.12},
                                           {0.6, 6.3},
                                           {0.24, 6.5}});
            add_ball(profile, 0.3, 6.75);
            return profile;
        }
        case Piece::king: {
            auto profile = turned_foot(1.45, 5.1);
            profile.insert(profile.end(), {{0.58, 5.3},
                                           {0.66, 5.7},
                                           {0.86, 6.4},
                                           {0.8, 6.55},
                                           {0.5, 6.75},
                                           {0.2, 6.9},
                                           {0.16, 7.0},
                                           {0.0, 7.02}});
            return profile;
        }
    }
    return {};
}

// Light and dark squares in one picture of the whole board, with the grain of wood.
Color board(const Sample& sample) {
    static const Gradient maple({0xb98a55, 0xd0a56e, 0xdcb985});
    static const Gradient walnut({0x2a160c, 0x3b2114, 0x50301e});
    const V2d at = (sample.point + V2d(1.0)) * 4.0;
    const int column = static_cast<int>(std::floor(at.x));
    const int row = static_cast<int>(std::floor(at.y));
    const bool dark = (column + row) % 2 == 0;
    const V2d in(at.x * 1.2 + 11.0 * lattice_noise(column, row, 8), at.y * 14.0);
    const double grain = 0.5 + 0.45 * fractal_noise(in, 4, 9);
    return dark ? walnut(grain) : maple(grain);
}

class Game {
public:
    Game(SceneBuilder& builder, const M44d& placed) : builder_(builder), placed_(placed) {}

    void add() {
        add_board();
        add_pieces();
    }

private:
    void place(std::string name, MeshIndex mesh, const M44d& on_board = M44d()) {
        builder_.place(std::move(name), mesh, on_board * placed_);
    }

    MaterialIndex polished(const char* name, const Color3f& color, float roughness,
                           scene::TextureIndex texture = {}) {
        Material material;
        material.name = name;
        material.base_color = color;
        material.base_color_texture.index = texture;
        material.roughness = roughness;
        material.clearcoat = 0.7F;
        material.clearcoat_roughness = 0.12F;
        return builder_.material(material);
    }

    void add_board() {
        const auto wood = builder_.texture("board", 1024, 1024, board, scene::Wrap::clamp);
        place("board", builder_.mesh("board", rectangle(8 * square, 8 * square),
                                     polished("squares", Color3f(1.0F), 0.4F, wood)));
        const M44d flat = M44d().setScale(V3d(8 * square + 3.0, 8 * square + 3.0, 1.18)) *
                          M44d().setTranslation(V3d(0, 0, -0.6));
        place(
            "rim",
            builder_.mesh("rim", chamfered_cube(1.0, 0.02), polished("rim", tint(0x3d2012), 0.4F)),
            flat);
    }

    void add_pieces() {
        const std::array sides{polished("ebony", tint(0x1d1512), 0.3F),
                               polished("boxwood", tint(0xe2bd83), 0.35F)};
        std::map<std::pair<Piece, bool>, MeshIndex> meshes;
        const MeshIndex bar = builder_.mesh("bar", chamfered_cube(1.0, 0.08), sides[0]);
        const MeshIndex white_bar = builder_.mesh("bar", chamfered_cube(1.0, 0.08), sides[1]);
        int number = 0;
        for (const Standing& standing : position) {
            const auto [mesh, first] = meshes.try_emplace({standing.piece, standing.white});
            if (first) {
                mesh->second = builder_.mesh("piece", lathe(profile_of(standing.piece)),
                                             sides[standing.white ? 1 : 0]);
            }
            const V3d at((standing.column - 3.5) * square, (standing.row - 3.5) * square, 0.0);
            place(fmt::format("piece {}", ++number), mesh->second, M44d().setTranslation(at));
            if (standing.piece == Piece::king) {
                const MeshIndex cross = standing.white ? white_bar : bar;
                const auto add = [&](const char* part, const V3d& size, double up) {
                    place(fmt::format("{} of piece {}", part, number), cross,
                          M44d().setScale(size) * M44d().setTranslation(at + V3d(0, 0, up)));
                };
                add("upright", V3d(0.24, 0.2, 0.95), 7.4);
                add("bar", V3d(0.7, 0.2, 0.24), 7.5);
            }
        }
    }

    SceneBuilder& builder_;
    M44d placed_;
};

void add_room(SceneBuilder& builder) {
    builder.place("table",
                  builder.mesh("table", rectangle(600, 600),
                               builder.material("green cloth", tint(0x17493a), 0.95F)),
                  M44d().setTranslation(V3d(0, 0, -1.2)));
    Material window;
    window.name = "window";
    window.base_color = Color3f(0.0F);
    window.emission = Color3f(15.0F, 12.5F, 9.5F);
    builder.place(
        "window", builder.mesh("window", rectangle(24, 24), builder.material(window)),
        M44d().setEulerAngles(V3d(-0.45, 2.3, 0.0)) * M44d().setTranslation(V3d(-34, 12, 32)));
}

}  // namespace

void add_game_of_chess(SceneBuilder& builder, const M44d& placed) { Game(builder, placed).add(); }

Result<scene::Scene> make_chess(const SceneOptions& options) {
    SceneBuilder builder("chess", options);
    add_room(builder);
    add_game_of_chess(builder, M44d());
    return std::move(builder).finish();
}

}  // namespace balcony::plates
