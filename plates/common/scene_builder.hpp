// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Assembles the scene of a plate: materials, textures, meshes, named objects and lights.

#include <string>
#include <string_view>

#include "balcony/base.hpp"
#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "common/painting.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

using Imath::M44d;

/// An sRGB colour as a style sheet writes it, for a material: linear.
[[nodiscard]] scene::Color3f tint(std::uint32_t rrggbb);

/// Collects the parts of a scene with z up. Errors are kept until finish().
class SceneBuilder {
public:
    SceneBuilder(std::string name, const SceneOptions& options);

    [[nodiscard]] const SceneOptions& options() const { return options_; }

    scene::MaterialIndex material(scene::Material material);
    /// A matt or glossy material of one colour, or of a texture.
    scene::MaterialIndex material(std::string name, const scene::Color3f& color, float roughness,
                                  scene::TextureIndex texture = {});

    /// A texture that a painter computes, in pixels before SceneOptions::texture_scale. Colours are
    /// encoded as sRGB; numbers, such as normal maps and roughness, as they are (linear).
    scene::TextureIndex texture(std::string name, int width, int height, const Painter& painter,
                                scene::Wrap wrap = scene::Wrap::repeat,
                                scene::TextureEncoding encoding = scene::TextureEncoding::srgb,
                                Sampling sampling = Sampling::antialiased);
    /// A picture of plates/pictures, NAME.jpg, which hangs in a gallery.
    scene::TextureIndex hung_picture(std::string_view name);

    scene::MeshIndex mesh(std::string name, scene::Mesh mesh, scene::MaterialIndex material);
    /// An object: a mesh with a name of its own, placed in the world.
    void place(std::string name, scene::MeshIndex mesh, const M44d& world_from_mesh = M44d());
    /// A disc, not visible, that turns counterclockwise about the z axis through a place: a number
    /// of turns from time 0, each in the given seconds. It starts at an angle, in radians.
    scene::NodeIndex turntable(const V3d& place, double seconds, int turns, double start);
    /// An object that turns with it; its mesh has the turntable's place as its origin.
    void place_on(scene::NodeIndex turntable, std::string name, scene::MeshIndex mesh);
    void light(scene::Light light);

    /// The scene, or what was wrong: a picture that is missing, a texture that cannot be encoded.
    [[nodiscard]] Result<scene::Scene> finish() &&;

private:
    SceneOptions options_;
    scene::Scene scene_;
    scene::Motion motion_;
    Diagnostics problems_;
};

}  // namespace balcony::plates
