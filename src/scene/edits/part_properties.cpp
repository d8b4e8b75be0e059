// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The properties of materials and lights as rows.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/scene_edits.hpp"

namespace balcony::scene {

namespace {

using std::numbers::pi;

template <class Owner>
struct Row {
    PropertyInfo info;
    std::variant<bool Owner::*, float Owner::*, Color3f Owner::*, V3d Owner::*> member;
};

constexpr PropertyInfo part(std::string_view name, std::string_view meaning) {
    return {name, meaning, PropertyType::number, 0.0, 1.0};
}
constexpr PropertyInfo flag(std::string_view name, std::string_view meaning) {
    return {name, meaning, PropertyType::flag, 0.0, 1.0};
}
constexpr PropertyInfo color(std::string_view name, std::string_view meaning, double most) {
    return {name, meaning, PropertyType::color, 0.0, most};
}

constexpr std::array material_rows{
    Row<Material>{color("base_color", "linear red, green and blue; a factor of its texture", 1.0),
                  &Material::base_color},
    Row<Material>{part("alpha", "opacity; less than 1 makes an opaque material blend"),
                  &Material::alpha},
    Row<Material>{{"alpha_cutoff",
                   "a mask is visible where its opacity is at least this; makes an opaque "
                   "material a mask",
                   PropertyType::number, 0.0, max_quantity},
                  &Material::alpha_cutoff},
    Row<Material>{part("metallic", "0 for a dielectric, 1 for a metal"), &Material::metallic},
    Row<Material>{part("roughness", "0 for a mirror, 1 for matt"), &Material::roughness},
    Row<Material>{color("emission", "radiance that the surface emits", max_quantity),
                  &Material::emission},
    Row<Material>{{"normal_scale", "strength of the normal map", PropertyType::number,
                   -max_quantity, max_quantity},
                  &Material::normal_scale},
    Row<Material>{flag("unlit", "whether it shows its base colour, whatever the light"),
                  &Material::unlit},
    Row<Material>{{"ior", "index of refraction", PropertyType::number, 1.0, max_refraction_index},
                  &Material::ior},
    Row<Material>{part("specular", "strength of a dielectric's reflection"), &Material::specular},
    Row<Material>{
        color("specular_color", "a factor of the reflectance seen from the front", max_quantity),
        &Material::specular_color},
    Row<Material>{part("transmission", "part of a dielectric's light that passes through"),
                  &Material::transmission},
    Row<Material>{flag("thin_walled", "whether the mesh is a pane; otherwise it bounds a volume"),
                  &Material::thin_walled},
    Row<Material>{color("absorption", "in the volume, per scene unit", max_quantity),
                  &Material::absorption},
    Row<Material>{part("clearcoat", "strength of a layer of lacquer"), &Material::clearcoat},
    Row<Material>{part("clearcoat_roughness", "of the lacquer"), &Material::clearcoat_roughness},
    Row<Material>{{"clearcoat_normal_scale", "strength of the lacquer's normal map",
                   PropertyType::number, -max_quantity, max_quantity},
                  &Material::clearcoat_normal_scale},
    Row<Material>{color("sheen_color", "of fibres, as on velvet", 1.0), &Material::sheen_color},
    Row<Material>{part("sheen_roughness", "of the fibres"), &Material::sheen_roughness},
};

constexpr std::array light_rows{
    Row<Light>{{"position", "in scene units", PropertyType::point, -max_coordinate, max_coordinate},
               &Light::position},
    Row<Light>{{"direction", "in which a spot or a sun shines", PropertyType::direction,
                -max_coordinate, max_coordinate},
               &Light::direction},
    Row<Light>{color("intensity", "linear red, green and blue, in candela; of a sun, in lux",
                     max_quantity),
               &Light::intensity},
    Row<Light>{{"range", "how far it shines, in scene units; 0 is unlimited", PropertyType::number,
                0.0, max_quantity},
               &Light::range},
    Row<Light>{{"inner_cone", "angle from a spot's axis of full strength, in radians",
                PropertyType::number, 0.0, pi / 2},
               &Light::inner_cone},
    Row<Light>{{"outer_cone", "angle from a spot's axis where its light ends, in radians",
                PropertyType::number, 0.0, pi / 2},
               &Light::outer_cone},
    Row<Light>{{"angle", "angular diameter of a sun, in radians", PropertyType::number, 0.0, pi},
               &Light::angle},
};

template <class Owner, std::size_t count>
std::array<PropertyInfo, count> infos_of(const std::array<Row<Owner>, count>& rows) {
    std::array<PropertyInfo, count> infos{};
    std::transform(rows.begin(), rows.end(), infos.begin(),
                   [](const Row<Owner>& row) { return row.info; });
    return infos;
}

template <class Owner, std::size_t count>
Result<const Row<Owner>*> find(const std::array<Row<Owner>, count>& rows, std::string_view name) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [name](const Row<Owner>& one) { return one.info.name == name; });
    if (row != rows.end()) {
        return &*row;
    }
    std::vector<std::string> names;
    for (const Row<Owner>& one : rows) {
        names.emplace_back(one.info.name);
    }
    return error(fmt::format("there is no property '{}'", printable(name)), {},
                 suggestion(name, names, "the properties are"));
}

// What is wrong with numbers for a property; empty if they are right.
std::string fault_of(const PropertyInfo& info, std::span<const double> numbers) {
    const bool is_triple = info.type != PropertyType::number && info.type != PropertyType::flag;
    const bool may_be_grey = info.type == PropertyType::color && numbers.size() == 1;
    if (numbers.size() != (is_triple ? 3 : 1) && !may_be_grey) {
        return fmt::format("{} needed", !is_triple ? "one number is"
                                        : info.type == PropertyType::color
                                            ? "one or three numbers are"
                                            : "three numbers are");
    }
    for (const double number : numbers) {
        if (!(number >= info.least && number <= info.most)) {
            return fmt::format("{:g} is not from {:g} to {:g}", number, info.least, info.most);
        }
    }
    if (info.type == PropertyType::direction &&
        !(V3d(numbers[0], numbers[1], numbers[2]).length() > 0.0)) {
        return "it has no length";
    }
    return {};
}

template <class Owner>
void assign(const Row<Owner>& row, std::span<const double> numbers, Owner& owner) {
    const auto at = [&](std::size_t i) { return numbers[numbers.size() == 1 ? 0 : i]; };
    if (const auto* const is = std::get_if<bool Owner::*>(&row.member)) {
        owner.** is = at(0) != 0.0;
    } else if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
        owner.** number = static_cast<float>(at(0));
    } else if (const auto* const color_of = std::get_if<Color3f Owner::*>(&row.member)) {
        owner.** color_of = {static_cast<float>(at(0)), static_cast<float>(at(1)),
                             static_cast<float>(at(2))};
    } else {
        const V3d vector(at(0), at(1), at(2));
        owner.*std::get<V3d Owner::*>(row.member) =
            row.info.type == PropertyType::direction ? vector.normalized() : vector;
    }
}

template <class Owner>
std::vector<double> numbers_of(const Row<Owner>& row, const Owner& owner) {
    if (const auto* const is = std::get_if<bool Owner::*>(&row.member)) {
        return {owner.**is ? 1.0 : 0.0};
    }
    if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
        return {double{owner.**number}};
    }
    if (const auto* const color_of = std::get_if<Color3f Owner::*>(&row.member)) {
        const Color3f& c = owner.**color_of;
        return {double{c.x}, double{c.y}, double{c.z}};
    }
    const V3d& v = owner.*std::get<V3d Owner::*>(row.member);
    return {v.x, v.y, v.z};
}

template <class Owner, std::size_t count>
Diagnostics set(const std::array<Row<Owner>, count>& rows, std::span<const PropertyValue> values,
                Owner& owner) {
    for (const PropertyValue& value : values) {
        const Result<const Row<Owner>*> row = find(rows, value.name);
        if (!row) {
            return row.diagnostics;
        }
        const PropertyInfo& info = (*row)->info;
        if (const std::string fault = fault_of(info, value.numbers); !fault.empty()) {
            return {error(fmt::format("'{}' cannot be set: {}", info.name, fault), {},
                          fmt::format("it is: {}", info.meaning))};
        }
        assign(**row, value.numbers, owner);
    }
    return {};
}

bool names(std::span<const PropertyValue> values, std::string_view property) {
    return std::any_of(values.begin(), values.end(),
                       [&](const PropertyValue& value) { return value.name == property; });
}

}  // namespace

std::span<const PropertyInfo> material_properties() {
    static const auto infos = infos_of(material_rows);
    return infos;
}

std::span<const PropertyInfo> light_properties() {
    static const auto infos = infos_of(light_rows);
    return infos;
}

Result<std::vector<double>> property_of(const Material& material, std::string_view name) {
    const auto row = find(material_rows, name);
    return row ? Result(numbers_of(**row, material)) : row.diagnostics;
}

Result<std::vector<double>> property_of(const Light& light, std::string_view name) {
    const auto row = find(light_rows, name);
    return row ? Result(numbers_of(**row, light)) : row.diagnostics;
}

Diagnostics set_properties(Material& material, std::span<const PropertyValue> values) {
    Material changed = material;
    Diagnostics found = set(material_rows, values, changed);
    if (!found.empty()) {
        return found;
    }
    if (changed.alpha_mode == AlphaMode::opaque && names(values, "alpha_cutoff")) {
        changed.alpha_mode = AlphaMode::mask;
    } else if (changed.alpha_mode == AlphaMode::opaque && changed.alpha < 1.0F) {
        changed.alpha_mode = AlphaMode::blend;
    }
    material = std::move(changed);
    return {};
}

Diagnostics set_properties(Light& light, std::span<const PropertyValue> values) {
    Light changed = light;
    Diagnostics found = set(light_rows, values, changed);
    if (!found.empty()) {
        return found;
    }
    if (changed.inner_cone > changed.outer_cone && names(values, "inner_cone")) {
        return {
            error(fmt::format("'inner_cone' cannot be set: {:g} is more than the outer_cone, "
                              "which is {:g}",
                              changed.inner_cone, changed.outer_cone))};
    }
    changed.inner_cone = std::min(changed.inner_cone, changed.outer_cone);
    light = std::move(changed);
    return {};
}

Names<LightKind> light_kinds() {
    static constexpr std::array kinds{
        Named{LightKind::point, "point", "shines from a point in all directions"},
        Named{LightKind::spot, "spot", "shines from a point in a cone"},
        Named{LightKind::directional, "sun", "shines from infinitely far away"},
    };
    return Names<LightKind>(kinds);
}

}  // namespace balcony::scene
