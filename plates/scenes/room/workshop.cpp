// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/room/workshop.hpp"

#include <fmt/format.h>

#include "common/meshes.hpp"

namespace balcony::plates::room {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;

M44d stand(const V3d& at, double turn) {
    return M44d().setAxisAngle(V3d(0, 0, 1), turn * degrees) * M44d().setTranslation(at);
}

M44d hang(const V3d& at, double turn) {
    return M44d(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1) * stand(at, turn);
}

MaterialIndex Workshop::plain(const std::string& name, std::uint32_t color, float roughness) {
    return builder.material(name, tint(color), roughness);
}

MaterialIndex Workshop::metal(const char* name, std::uint32_t color, float roughness) {
    Material made;
    made.name = name;
    made.base_color = tint(color);
    made.metallic = 1.0F;
    made.roughness = roughness;
    return builder.material(made);
}

MaterialIndex Workshop::glowing(const char* name, const Color3f& emission) {
    Material made;
    made.name = name;
    made.base_color = Color3f(0.6F);
    made.emission = emission;
    return builder.material(made);
}

MaterialIndex Workshop::painted(const char* name, int width, int height, const Painter& painter,
                                float roughness) {
    return builder.material(name, Color3f(1.0F), roughness,
                            builder.texture(name, width, height, painter, scene::Wrap::clamp));
}

MaterialIndex Workshop::drawn(const char* name, int width, int height, const Drawing& drawing) {
    constexpr float paper = 0.6F;
    return painted(
        name, width, height,
        [&](const Sample& sample) {
            const double scale = drawing.height() / 2.0;
            return drawing.at(V2d(drawing.length() / 2.0, scale) + sample.point * scale);
        },
        paper);
}

MaterialIndex Workshop::tiled(const char* name, int pixels, const Painter& painter, double size,
                              float roughness) {
    Material made;
    made.name = name;
    made.base_color = Color3f(1.0F);
    made.roughness = roughness;
    made.base_color_texture.index = builder.texture(name, pixels, pixels, painter);
    const auto per_unit = static_cast<float>(1.0 / size);
    made.base_color_texture.u_axis = scene::V2f(per_unit, 0.0F);
    made.base_color_texture.v_axis = scene::V2f(0.0F, per_unit);
    return builder.material(made);
}

void Workshop::put(const std::string& name, scene::Mesh mesh, MaterialIndex material,
                   const M44d& placed) {
    builder.place(name, builder.mesh(name, std::move(mesh), material), placed);
}

void Workshop::put(const std::string& name, const MeshBuilder& built, MaterialIndex material,
                   const M44d& placed) {
    put(name, built.mesh(), material, placed);
}

void Workshop::hang_picture(const char* picture, const V3d& middle, double turn, const V2d& size,
                            MaterialIndex moulding) {
    const M44d placed = hang(middle, turn);
    const std::string name = fmt::format("picture of {}", picture);
    put(name, rectangle(size.x, size.y),
        builder.material(name, Color3f(1.0F), 0.6F, builder.hung_picture(picture)),
        M44d().setTranslation(V3d(0, 0, 0.012)) * placed);
    put_frame(fmt::format("frame of {}", picture), size, 0.05, moulding, placed);
}

void Workshop::put_frame(const std::string& name, const V2d& size, double moulding_width,
                         MaterialIndex moulding, const M44d& placed) {
    scene::Mesh frame = picture_frame(size.x, size.y, moulding_width);
    for (scene::V3f& position : frame.positions) {
        position.z = 0.02F + 0.06F * position.z;
    }
    put(name, std::move(frame), moulding, placed);
}

}  // namespace balcony::plates::room
