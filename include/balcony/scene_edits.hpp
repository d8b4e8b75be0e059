// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scene edits: what is changed in a scene that is loaded, or made of arrays.
//
//     Scene scene = *load("room.glb");
//     transform_object(scene, *find_object(scene, "chair"), M44d().translate({0.0, 0.0, 1.0}));
//     set_material(scene, *find_material(scene, "wood"), {{"roughness", {0.4}}});
//
// An edit that fails leaves the scene as it was. A scene that was valid stays so: what an edit
// gives it is within the limits of scene.hpp. Parts are numbered by their vectors in Scene. Each
// edit is true at all times of a scene that moves, and moved_to() keeps it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/names.hpp"
#include "balcony/scene.hpp"

namespace balcony::scene {

// ------------------------------------------------------------------------------ parts by name

/// A part by its name, or by its number if others have the same name, or it has none.
using PartName = std::variant<std::size_t, std::string>;

/// The number of a part. A name that none or several have is an error.
[[nodiscard]] Result<std::size_t> find_object(const Scene& scene, const PartName& name);
[[nodiscard]] Result<std::size_t> find_material(const Scene& scene, const PartName& name);
[[nodiscard]] Result<std::size_t> find_light(const Scene& scene, const PartName& name);

// ---------------------------------------------------------------------------------- properties

enum class PropertyType : std::uint8_t {
    flag,       ///< 0 or 1.
    number,     ///< One number.
    color,      ///< Linear red, green and blue; one number is a grey.
    point,      ///< x, y and z.
    direction,  ///< The same, of any length but 0. It becomes unit.
};

/// A property that front ends show and change by its name, which is that of the member.
struct PropertyInfo {
    std::string_view name;
    std::string_view meaning;  ///< A short description, with the unit.
    PropertyType type = PropertyType::number;
    double least = 0.0;  ///< Of each number.
    double most = 1.0;
};

/// What pictures show of a material, apart from its textures, and of a light, apart from its kind.
[[nodiscard]] std::span<const PropertyInfo> material_properties();
[[nodiscard]] std::span<const PropertyInfo> light_properties();

struct PropertyValue {
    std::string name;
    std::vector<double> numbers;
};

/// The numbers of a property with this name. An unknown one is an error.
[[nodiscard]] Result<std::vector<double>> property_of(const Material& material,
                                                      std::string_view name);
[[nodiscard]] Result<std::vector<double>> property_of(const Light& light, std::string_view name);

/// Sets several properties; if there is an error, none. An opaque material blends if its alpha
/// becomes less than 1, and is a mask if it gets an alpha_cutoff. The inner cone of a light is
/// never wider than the outer one.
[[nodiscard]] Diagnostics set_properties(Material& material, std::span<const PropertyValue> values);
[[nodiscard]] Diagnostics set_properties(Light& light, std::span<const PropertyValue> values);

/// "point", "spot" and "sun".
[[nodiscard]] Names<LightKind> light_kinds();

// ------------------------------------------------------------------------------------- objects

/// Where an object stands: the matrix of its first instance, for row vectors. An object without an
/// instance is an error.
[[nodiscard]] Result<M44d> place_of(const Scene& scene, std::size_t object);

/// The bounds of an object in the world, as it stands. Empty if it has no instance.
[[nodiscard]] Box3f bounds_of(const Scene& scene, std::size_t object);

/// Places an object, whose instances keep their places to each other. It does not move any more,
/// but keeps changing its shape if it does.
[[nodiscard]] Diagnostics place_object(Scene& scene, std::size_t object,
                                       const M44d& world_from_object);

/// Transforms an object in the world: p_after = p_before * change. What moves keeps moving, on a
/// path that is transformed.
[[nodiscard]] Diagnostics transform_object(Scene& scene, std::size_t object, const M44d& change);

/// Removes an object with the meshes that only it has. Those behind it move up by one number.
void remove_object(Scene& scene, std::size_t object);

/// The arrays of a mesh. Those by vertex are empty or have one row per vertex.
struct MeshArrays {
    std::span<const V3d> positions;
    std::span<const std::array<std::int64_t, 3>> triangles;
    std::span<const V3d> normals{};  ///< Of any length but 0. If empty, triangles are flat.
    /// (0, 0) is the top left of a texture, as in glTF.
    std::span<const Imath::V2d> texture_coordinates{};
    /// As Mesh::colors: linear red, green, blue, and alpha in the fourth channel, if there is one.
    std::span<const double> colors{};
    std::size_t color_channels = 3;
};

/// Adds an object that is one mesh with a material, and returns its number. An empty or known name,
/// numbers that are not finite or out of range, and triangles with vertices that are not there are
/// errors; triangles without area are left out with a warning.
[[nodiscard]] Result<std::size_t> add_object(Scene& scene, const std::string& name,
                                             const MeshArrays& arrays, std::size_t material,
                                             const M44d& world_from_object = {});

// ------------------------------------------------------------------------- materials and lights

[[nodiscard]] Diagnostics set_material(Scene& scene, std::size_t material,
                                       std::span<const PropertyValue> values);

/// Adds a material, and returns its number: grey and matt where no value says otherwise. A material
/// with the same name that no mesh has is replaced; another one is an error, as is an empty name.
[[nodiscard]] Result<std::size_t> add_material(Scene& scene, const std::string& name,
                                               std::span<const PropertyValue> values);

/// A light that gets a position or a direction does not move any more.
[[nodiscard]] Diagnostics set_light(Scene& scene, std::size_t light,
                                    std::span<const PropertyValue> values);

/// Adds a light, and returns its number. An empty or known name is an error.
[[nodiscard]] Result<std::size_t> add_light(Scene& scene, const std::string& name, LightKind kind,
                                            std::span<const PropertyValue> values);

/// Those behind it move up by one number.
void remove_light(Scene& scene, std::size_t light);

/// A hash of what edits can change, as it is at the time of the scene: meshes and where they stand,
/// objects, the properties of materials and lights.
[[nodiscard]] std::uint64_t content_hash(const Scene& scene);

}  // namespace balcony::scene
