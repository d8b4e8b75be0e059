// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scene: triangle meshes, instances, materials, textures and lights, as loaded from a file.
//
// Axes and units are the file's own. All colours are linear Rec. 709; textures are decoded to
// linear by the renderer, according to their encoding. A scene is plain data; one that is complete
// does not change any more and may be shared between threads. What moves in it is in motion.hpp,
// which makes another scene for another time.

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/progress.hpp"

namespace balcony::scene {

using Imath::Box3f;
using Imath::Color3f;
using Imath::Color4f;
using Imath::M44d;
using Imath::V2f;
using Imath::V3d;
using Imath::V3f;
using Imath::V4f;

using MeshIndex = StrongIndex<struct MeshTag>;
using MaterialIndex = StrongIndex<struct MaterialTag>;
using TextureIndex = StrongIndex<struct TextureTag>;

/// The limit of coordinates that load() accepts, in scene units. Tracing uses floats: the test of a
/// ray against a triangle multiplies three lengths, which overflows near 1e13.
inline constexpr double max_coordinate = 1e12;
/// Transforms scale lengths by at most this and at least its reciprocal.
inline constexpr double max_scale = 1e9;
/// The maximum of colours, emission and intensities, which are not negative.
inline constexpr double max_quantity = 1e30;
/// The maximum index of refraction, whose reflectance is almost 1.
inline constexpr double max_refraction_index = 1e4;
/// How many sets of texture coordinates a mesh can have.
inline constexpr std::size_t max_coordinate_sets = 2;

/// A large part of a scene, which copies of the scene share until one of them edits it. Reads as a
/// `const T`, by any number of threads.
template <class T>
class Shared {
public:
    Shared() : Shared(T()) {}
    // NOLINTNEXTLINE(google-explicit-constructor)
    Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

    [[nodiscard]] const T& operator*() const { return *value_; }
    [[nodiscard]] const T* operator->() const { return value_.get(); }
    // NOLINTNEXTLINE(google-explicit-constructor)
    [[nodiscard]] operator const T&() const { return *value_; }

    /// For a change that no copy sees.
    [[nodiscard]] T& edit() {
        if (value_.use_count() > 1) {
            value_ = std::make_shared<T>(*value_);
        }
        // What other threads read before they gave up their copies comes before the change.
        std::atomic_thread_fence(std::memory_order_acquire);
        return *value_;
    }

private:
    std::shared_ptr<T> value_;
};

/// Triangles with one material. Normals, tangents, each set of texture coordinates, and colours are
/// empty or one per vertex; load() adds missing normals. All positions are within max_coordinate.
struct Mesh {
    std::string name;
    std::vector<V3f> positions;
    std::vector<V3f> normals;   ///< Unit length.
    std::vector<V4f> tangents;  ///< For the normal map: unit length, or 0 if unknown; w is the
                                ///< sign of the bitangent, which is w times normal × tangent.
    /// The sets that uses of textures number; (0, 0) is top left, as in glTF.
    std::array<std::vector<V2f>, max_coordinate_sets> texture_coordinates;
    std::vector<Color4f> colors;  ///< 0 to 1, multiplied with the base colour and the opacity.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    MaterialIndex material;  ///< Always valid.
};

/// A mesh placed in the world. Normals are transformed by the inverse transpose of world_from_mesh,
/// which is affine and invertible; its scale is within max_scale, and the mesh in the world within
/// max_coordinate. A negative determinant (mirroring) reverses the winding.
struct Instance {
    MeshIndex mesh;
    M44d world_from_mesh;      ///< Imath's convention: row vectors, p_world = p_mesh * M.
    std::uint32_t object = 0;  ///< Index into Scene::objects.
};

/// A node of the file that has geometry, and an id in the object-id layer. The id in
/// pictures is the index plus 1; 0 means that nothing was hit.
struct Object {
    std::string name;
};

enum class Wrap : std::uint8_t { repeat, clamp, mirror };

/// An image: encoded bytes (PNG, JPEG, ...) if embedded, otherwise a file.
struct Texture {
    std::string name;                         ///< For messages.
    std::filesystem::path file;               ///< Empty if embedded.
    Shared<std::vector<std::uint8_t>> bytes;  ///< The encoded image if embedded.
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool interpolated = true;  ///< Where it is magnified; otherwise its texels are rectangles.
};

/// The encoding of an image's red, green and blue; alpha is always linear.
enum class TextureEncoding : std::uint8_t { linear, srgb };

/// A material's use of a texture. At the texture coordinates (u, v) of a set, the image is looked
/// up at offset + u * u_axis + v * v_axis, which is KHR_texture_transform.
struct TextureUse {
    TextureIndex index{};  ///< Invalid if there is no texture.
    TextureEncoding encoding = TextureEncoding::linear;
    std::uint8_t coordinates = 0;  ///< The set, an index into Mesh::texture_coordinates.
    std::uint8_t channel = 0;      ///< Of a texture of single numbers: 0 is red, 3 is alpha.
    V2f offset{0.0F, 0.0F};
    V2f u_axis{1.0F, 0.0F};
    V2f v_axis{0.0F, 1.0F};

    [[nodiscard]] bool valid() const { return index.valid(); }
    /// The place in the image of a difference of texture coordinates, and of texture coordinates.
    [[nodiscard]] V2f difference(const V2f& uv) const { return uv.x * u_axis + uv.y * v_axis; }
    [[nodiscard]] V2f place(const V2f& uv) const { return offset + difference(uv); }
    /// Whether both look up the same texels; they may use different channels.
    [[nodiscard]] bool shares_texels(const TextureUse& other) const {
        return index == other.index && encoding == other.encoding &&
               coordinates == other.coordinates && offset == other.offset &&
               u_axis == other.u_axis && v_axis == other.v_axis;
    }
};

/// The use of a material's opacity: none, cut-out, or blend.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// glTF 2.0's metallic-roughness material with its extensions. A texture is multiplied with the
/// factor of its name: colours with its red, green and blue, numbers with one channel.
struct Material {
    std::string name;
    Color3f base_color{0.8F, 0.8F, 0.8F};
    TextureUse base_color_texture{.encoding = TextureEncoding::srgb};
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha = 1.0F;  ///< Opacity; 1 if opaque.
    TextureUse opacity_texture;
    float alpha_cutoff = 0.0F;  ///< For a mask: visible where the opacity is at least this.
    float metallic = 0.0F;
    TextureUse metallic_texture;
    float roughness = 1.0F;
    TextureUse roughness_texture;
    Color3f emission{0.0F, 0.0F, 0.0F};
    TextureUse emission_texture{.encoding = TextureEncoding::srgb};
    float normal_scale = 1.0F;  ///< Of the normal map's x and y, which are 2 texel - 1.
    TextureUse normal_texture;
    bool double_sided = true;
    bool unlit = false;  ///< KHR_materials_unlit: shows its base colour, whatever the light.

    float ior = 1.5F;       ///< KHR_materials_ior: the index of refraction, at least 1.
    float specular = 1.0F;  ///< KHR_materials_specular: the strength of a dielectric's reflection.
    TextureUse specular_texture;
    Color3f specular_color{1.0F, 1.0F, 1.0F};  ///< A factor of its reflectance seen from the front.
    TextureUse specular_color_texture{.encoding = TextureEncoding::srgb};

    /// KHR_materials_transmission: the part of a dielectric's light that is transmitted instead of
    /// scattered below the surface.
    float transmission = 0.0F;
    TextureUse transmission_texture;
    /// KHR_materials_volume: false if the mesh bounds a volume, which refracts and absorbs.
    bool thin_walled = true;
    Color3f absorption{0.0F, 0.0F, 0.0F};  ///< In the volume, per scene unit.

    float clearcoat = 0.0F;  ///< KHR_materials_clearcoat: the strength of a layer of lacquer.
    TextureUse clearcoat_texture;
    float clearcoat_roughness = 0.0F;
    TextureUse clearcoat_roughness_texture;
    /// As normal_scale and normal_texture, which do not bend the lacquer's own normal.
    float clearcoat_normal_scale = 1.0F;
    TextureUse clearcoat_normal_texture;

    Color3f sheen_color{0.0F, 0.0F, 0.0F};  ///< KHR_materials_sheen: fibres, as of velvet.
    TextureUse sheen_color_texture{.encoding = TextureEncoding::srgb};
    float sheen_roughness = 0.0F;
    TextureUse sheen_roughness_texture;
};

/// All uses of textures in a material.
inline constexpr std::array texture_uses{&Material::base_color_texture,
                                         &Material::opacity_texture,
                                         &Material::metallic_texture,
                                         &Material::roughness_texture,
                                         &Material::emission_texture,
                                         &Material::normal_texture,
                                         &Material::specular_texture,
                                         &Material::specular_color_texture,
                                         &Material::transmission_texture,
                                         &Material::clearcoat_texture,
                                         &Material::clearcoat_roughness_texture,
                                         &Material::clearcoat_normal_texture,
                                         &Material::sheen_color_texture,
                                         &Material::sheen_roughness_texture};

enum class LightKind : std::uint8_t { point, spot, directional };

/// The mean angular diameter of the sun: 0.533 degrees.
inline constexpr float sun_angle = 9.3e-3F;

/// KHR_lights_punctual. Intensity is in candela (point, spot) or lux (directional), by colour.
struct Light {
    std::string name;
    LightKind kind = LightKind::point;
    V3d position{0.0, 0.0, 0.0};
    V3d direction{0.0, 0.0, -1.0};  ///< The direction of the light; unit length.
    Color3f intensity{1.0F, 1.0F, 1.0F};
    float range = 0.0F;             ///< Scene units; 0 is unlimited.
    float inner_cone = 0.0F;        ///< Radians from the axis, full strength inside.
    float outer_cone = 0.7853982F;  ///< Radians from the axis, dark outside.
    /// Of a directional light: the angular diameter of its disc in radians, that of the sun where
    /// the file does not say. 0 casts sharp shadows.
    float angle = sun_angle;

    bool operator==(const Light&) const = default;
};

enum class Projection : std::uint8_t { perspective, orthographic };

/// A camera of the file. `right`, `up` and `forward` are orthogonal unit vectors.
struct Camera {
    std::string name;
    Projection projection = Projection::perspective;
    V3d position{0.0, 0.0, 0.0};
    V3d right{1.0, 0.0, 0.0};
    V3d up{0.0, 1.0, 0.0};
    V3d forward{0.0, 0.0, -1.0};
    /// Half of the picture's height: at distance 1 in a perspective picture, otherwise in scene
    /// units.
    double half_height = 0.5;
    double aspect = 16.0 / 9.0;  ///< Width divided by height.
    double near = 0.0;           ///< Scene units along `forward`: what is nearer is not visible.
};

struct Motion;

struct Scene {
    std::string name;    ///< The file it came from, for messages.
    std::string format;  ///< "glTF 2.0 binary", "Wavefront OBJ", ...
    /// The factor of load() for the emission of materials: see LoadOptions.
    float emission_scale = 1.0F;
    Axes axes = Axes::y_up;
    double meters_per_unit = 1.0;  ///< According to the format; 1 if unspecified.
    bool has_unit = false;         ///< Whether the format specifies it.
    std::vector<Shared<Mesh>> meshes;
    std::vector<Instance> instances;
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<std::filesystem::path> files;  ///< That load() read or looked for.
    double time = 0.0;                         ///< In seconds, when instances, lights and cameras
                                               ///< stand where they do.
    std::shared_ptr<const Motion> motion;      ///< What moves; null if nothing does.
    bool default_light = false;  ///< The file has no light: use a light at the ray origin.

    [[nodiscard]] std::size_t triangle_count() const;  ///< Counts each instance.
    /// Of all instances, in the world: exact, unless instances have so many vertices in all (2^28)
    /// that the bounding boxes of their meshes replace them.
    [[nodiscard]] Box3f bounds() const;
};

/// The extensions of the files that load() reads: ".glb", ...
[[nodiscard]] std::span<const std::string_view> file_extensions();

struct LoadOptions {
    /// The file joins another scene, so lights or cameras alone are enough.
    bool is_addition = false;
    /// The factor for the emission of materials, from 0 to max_quantity; 1 is as written. If empty,
    /// it is 683 in a glTF file with lights and emission that Blender 3.4 or later has exported,
    /// and 1 in others: its exporter multiplies lights by 683 lm/W, but not emission.
    std::optional<float> emission_scale{};
    /// Whether closed, curved objects whose glass has no volume are solid: as Blender's exporter
    /// writes glass. If empty, they are thin as written, and a warning names them in a file of
    /// Blender's.
    std::optional<bool> solid_glass{};
};

/// Reads a scene file (.glb, .gltf, .obj, .ply, .stl). A part that cannot be used (a missing
/// texture, a vertex that is not finite) is skipped or replaced with a warning that names it; an
/// error means that there is nothing to render. A stop is an error of Kind::interrupted.
[[nodiscard]] Result<Scene> load(const std::filesystem::path& file, const PartDone& progress = {},
                                 const std::stop_token& stop = {}, const LoadOptions& options = {});
/// The same from the bytes of a file; its name determines the format, and the folder of other files
/// that it names.
[[nodiscard]] Result<Scene> load(const std::filesystem::path& name,
                                 std::span<const std::uint8_t> bytes, const PartDone& progress = {},
                                 const std::stop_token& stop = {});

/// An error of Kind::internal for a scene that a program has made and that is not consistent:
/// indices are in range, and what is said to be empty or one per vertex is. Renderers check it.
[[nodiscard]] Diagnostics check(const Scene& scene);

/// Whether the triangles of an object, including all instances, enclose a volume that they face
/// away from: every edge is traversed once in each direction. Points at the same position are
/// merged.
[[nodiscard]] bool encloses_volume(const Scene& scene, std::uint32_t object);

/// Adds all that another scene has, with its motion, turned to the axes of the first. Objects keep
/// their names, which may then be the same. The emission scale is that of the scene, unless that is
/// 1.
void add_scene(Scene& scene, Scene added);

/// The bytes of a binary glTF 2.0 file (GLB) with the scene: one node per instance (named
/// after its object) or light, one glTF mesh with a single primitive per mesh, embedded PNG and
/// JPEG images. Meshes are shared by their instances. A z_up scene is rotated to glTF's y up: (x,
/// y, z) becomes (x, z, -y), in positions, normals, placements and lights alike. What moves
/// with a node of the motion keeps moving; lights, cameras and meshes that change their shape are
/// written as they stand.
///
/// The scene is consistent, as check() says, and its textures are embedded as PNG or JPEG. The same
/// scene always gives the same bytes.
[[nodiscard]] std::vector<std::uint8_t> to_glb(const Scene& scene);

}  // namespace balcony::scene
