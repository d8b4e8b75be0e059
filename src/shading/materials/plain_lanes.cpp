// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/materials/plain_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <bit>
#include <numbers>

#include "shading/materials/plain_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::plain_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using Tag = lanes::CappedTag<float, size>;
constexpr Tag tag;
using Mask = lanes::Mask<Tag>;

// A float in each lane. The order of operations is that of Bsdf: sums and products are rounded one
// by one.
struct Number {
    HWY_INLINE Number(lanes::Vec<Tag> vector) : v(vector) {}
    HWY_INLINE Number(float value) : v(lanes::Set(tag, value)) {}
    lanes::Vec<Tag> v;
};

HWY_INLINE Number operator+(Number a, Number b) { return lanes::Add(a.v, b.v); }
HWY_INLINE Number operator-(Number a, Number b) { return lanes::Sub(a.v, b.v); }
HWY_INLINE Number operator*(Number a, Number b) { return lanes::Mul(a.v, b.v); }
HWY_INLINE Number operator/(Number a, Number b) { return lanes::Div(a.v, b.v); }
HWY_INLINE Mask operator>(Number a, Number b) { return lanes::Gt(a.v, b.v); }
HWY_INLINE Mask operator>=(Number a, Number b) { return lanes::Ge(a.v, b.v); }
HWY_INLINE Mask both(Mask a, Mask b) { return lanes::And(a, b); }
HWY_INLINE Number square(Number a) { return a * a; }
HWY_INLINE Number root(Number a) { return lanes::Sqrt(a.v); }
HWY_INLINE Number max(Number a, Number b) { return lanes::Max(a.v, b.v); }
HWY_INLINE Number min(Number a, Number b) { return lanes::Min(a.v, b.v); }
HWY_INLINE Number or_zero(Mask where, Number a) { return lanes::IfThenElseZero(where, a.v); }

struct Vector {
    Number x, y, z;
};

HWY_INLINE Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vector operator*(Number a, const Vector& b) { return {a * b.x, a * b.y, a * b.z}; }
HWY_INLINE Vector operator/(const Vector& a, Number b) { return {a.x / b, a.y / b, a.z / b}; }
HWY_INLINE Number dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Number largest(const Vector& color) { return max(max(color.x, color.y), color.z); }

HWY_INLINE Number load(const Floats& values, std::size_t lane) {
    return lanes::Load(tag, values.data() + lane);
}
HWY_INLINE Vector load(const Vectors& v, std::size_t lane) {
    return {load(v.x, lane), load(v.y, lane), load(v.z, lane)};
}
HWY_INLINE void store(Number value, Floats& values, std::size_t lane) {
    lanes::Store(value.v, tag, values.data() + lane);
}
HWY_INLINE void store(const Vector& v, Vectors& values, std::size_t lane) {
    store(v.x, values.x, lane);
    store(v.y, values.y, lane);
    store(v.z, values.z, lane);
}

// The lanes from `lane` on.
HWY_INLINE Mask mask_of(LaneBits bits, std::size_t lane) {
    const std::uint32_t rest = bits >> lane;
    const std::uint8_t bytes[8]{static_cast<std::uint8_t>(rest),
                                static_cast<std::uint8_t>(rest >> 8U)};
    return lanes::LoadMaskBits(tag, bytes);
}

HWY_INLINE LaneBits bits_of(Mask mask, std::size_t lane) {
    std::uint8_t bytes[8]{};
    lanes::StoreMaskBits(tag, mask, bytes);
    return (std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8U) << lane;
}

// LayerReflectance::albedo() of a layer that nothing covers.
template <class T, class Values>
HWY_INLINE T albedo(const Reflectance<Values>& layer, const Energies& energies, std::size_t lane) {
    return load(energies.single, lane) * load(layer.single, lane) +
           load(energies.single_edge, lane) * load(layer.single_edge, lane) +
           load(layer.all, lane) + load(energies.all_edge, lane) * load(layer.all_edge, lane);
}

// PlainMaterial::below().
HWY_INLINE Number below(const Surfaces& surfaces, const Energies& energies, std::size_t lane) {
    return max(Number(1.0F) - albedo<Number>(surfaces.dielectric, energies, lane), 0.0F);
}

HWY_INLINE Number schlick(Number cosine) {
    const Number c = lanes::Clamp((Number(1.0F) - cosine).v, Number(0.0F).v, Number(1.0F).v);
    return square(square(c)) * c;
}

// Ggx::slant().
HWY_INLINE Number slant(Number squared_alpha, Number cosine) {
    return root(squared_alpha + (Number(1.0F) - squared_alpha) * square(cosine));
}

// position_of_cosine() of the cosines with the normals.
void find_cosines(const Surfaces& surfaces, const Vectors& directions, Cosines& found) {
    constexpr float last = cosine_count - 1;
    const lanes::RebindToSigned<Tag> integers;
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Number cosine = dot(load(surfaces.normal, lane), load(directions, lane));
        const Number position = root(root(max(0.0F, cosine))) * last;
        const Number inside = min(position, last);
        const auto node = lanes::ConvertTo(integers, min(inside, last - 1.0F).v);
        store(cosine, found.cosine, lane);
        lanes::Store(node, integers, found.node.data() + lane);
        store(inside - lanes::ConvertTo(tag, node), found.fraction, lane);
    }
}

// Interpolates.
HWY_INLINE void set_energies(const Cosines& at, Energies& energies) {
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Number fraction = load(at.fraction, lane);
        lanes::Vec<Tag> scale, single, single_edge, all_edge;
        lanes::LoadInterleaved4(tag, &at.lower[lane].scale, scale, single, single_edge, all_edge);
        lanes::Vec<Tag> scale_2, single_2, single_edge_2, all_edge_2;
        lanes::LoadInterleaved4(tag, &at.upper[lane].scale, scale_2, single_2, single_edge_2,
                                all_edge_2);
        const auto mixed = [&](Number a, Number b) { return a + fraction * (b - a); };
        store(mixed(scale, scale_2), energies.scale, lane);
        store(mixed(single, single_2), energies.single, lane);
        store(mixed(single_edge, single_edge_2), energies.single_edge, lane);
        store(mixed(all_edge, all_edge_2), energies.all_edge, lane);
    }
}

void finish_views(const Surfaces& surfaces, const Cosines& cosines, Views& views) {
    views.cosine = cosines.cosine;
    set_energies(cosines, views.energy);
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Number passed = below(surfaces, views.energy, lane);
        const Number specular = largest(albedo<Vector>(surfaces.specular, views.energy, lane));
        const Number diffuse = largest(load(surfaces.diffuse, lane)) * passed;
        store(passed, views.below, lane);
        store(or_zero(specular > 0.0F, specular / (specular + diffuse)), views.specular, lane);
    }
}

// Where the surfaces reflect light, by the cosines with their normals.
HWY_INLINE Mask lit(LaneBits bits, const Surfaces& surfaces, const Views& views,
                    const Vectors& to_light, const Floats& cosines, std::size_t lane) {
    const Number geometric = dot(load(surfaces.geometric_normal, lane), load(to_light, lane));
    const Mask above =
        both(load(cosines, lane) >= min_cosine, load(views.cosine, lane) >= min_cosine);
    return both(mask_of(bits, lane), both(above, geometric > 0.0F));
}

LaneBits lit_lanes(LaneBits bits, const Surfaces& surfaces, const Views& views,
                   const Vectors& to_light, const Floats& cosines) {
    LaneBits found = 0;
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        found |= bits_of(lit(bits, surfaces, views, to_light, cosines, lane), lane);
    }
    return found;
}

void finish_values(LaneBits bits, const Surfaces& surfaces, const Views& views,
                   const Vectors& to_light, const Cosines& cosines, Values& values) {
    constexpr float pi = std::numbers::pi_v<float>;
    alignas(64) Energies energies;
    set_energies(cosines, energies);
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Mask mask = mask_of(bits, lane);
        if (lanes::AllFalse(tag, mask)) {
            store(Vector{0.0F, 0.0F, 0.0F}, values.reflected, lane);
            store(0.0F, values.pdf, lane);
            continue;
        }
        const Number cosine = load(cosines.cosine, lane);
        const Number viewer = load(views.cosine, lane);
        const Number specular = load(views.specular, lane);
        const Number lambert = cosine / pi;
        const Vector diffuse =
            (lambert * load(views.below, lane) * below(surfaces, energies, lane) *
             load(surfaces.per_mean_below, lane)) *
            load(surfaces.diffuse, lane);
        // HalfVector.
        const Vector normal = load(surfaces.normal, lane);
        const Vector sum = load(views.direction, lane) + load(to_light, lane);
        const Number length = root(dot(sum, sum));
        const Vector facet = sum / length;
        const Vector across = cross(normal, facet);
        // Ggx and Microfacets.
        const Number a2 = square(load(surfaces.alpha, lane));
        const Number density =
            a2 / (Number(pi) * square(a2 * square(dot(normal, facet)) + dot(across, across)));
        const Number viewer_slant = slant(a2, viewer);
        const Number masking = Number(0.5F) / (cosine * viewer_slant + viewer * slant(a2, cosine));
        const Number visible = Number(2.0F) / (viewer + viewer_slant);
        const Number edge = schlick(Number(0.5F) * length);
        const Number scale = load(views.energy.scale, lane) * load(energies.scale, lane);
        const Reflectance<Vectors>& layer = surfaces.specular;
        const Vector at_facet = load(layer.single, lane) + edge * load(layer.single_edge, lane) +
                                scale * (load(layer.all, lane) + edge * load(layer.all_edge, lane));
        const Mask rough = both(mask, a2 > 0.0F);
        const Vector glossy = (cosine * (density * masking)) * at_facet;
        const auto added = [&](Number plain, Number facets) {
            return or_zero(mask, plain + or_zero(rough, facets));
        };
        store(Vector{added(diffuse.x, glossy.x), added(diffuse.y, glossy.y),
                     added(diffuse.z, glossy.z)},
              values.reflected, lane);
        store(added((Number(1.0F) - specular) * lambert,
                    specular * (Number(0.25F) * density * visible)),
              values.pdf, lane);
    }
}

// on_circle().
HWY_INLINE Vector on_circle(Number part) {
    const lanes::RebindToSigned<Tag> integers;
    const auto quarter = lanes::ConvertTo(integers, (Number(4.0F) * part + 0.5F).v);
    const Number angle = Number(2.0F * std::numbers::pi_v<float>) *
                         (part - Number(0.25F) * lanes::ConvertTo(tag, quarter));
    const Number s = angle * angle;
    const Number sine =
        angle * (Number(1.0F) +
                 s * (Number(-1.0F / 6.0F) +
                      s * (Number(1.0F / 120.0F) + s * (Number(-1.0F / 5040.0F) + s / 362880.0F))));
    const Number cosine =
        Number(1.0F) + s * (Number(-0.5F) + s * (Number(1.0F / 24.0F) +
                                                 s * (Number(-1.0F / 720.0F) + s / 40320.0F)));
    const auto has_bit = [&](auto value, std::int32_t bit) {
        return lanes::RebindMask(tag, lanes::TestBit(value, lanes::Set(integers, bit)));
    };
    const Mask odd = has_bit(quarter, 1);
    const auto signed_by = [&](auto value, Number a) {
        return Number(lanes::IfThenElse(has_bit(value, 2), lanes::Neg(a.v), a.v));
    };
    return {signed_by(lanes::Add(quarter, lanes::Set(integers, 1)),
                      lanes::IfThenElse(odd, sine.v, cosine.v)),
            signed_by(quarter, lanes::IfThenElse(odd, cosine.v, sine.v)), 0.0F};
}

HWY_INLINE Vector unit(const Vector& v) { return v / root(dot(v, v)); }

// As render::Frame.
struct Axes {
    HWY_INLINE explicit Axes(const Vector& normal)
        : x{0.0F, 0.0F, 0.0F}, y{0.0F, 0.0F, 0.0F}, z(normal) {
        const Number sign = lanes::CopySign(Number(1.0F).v, z.z.v);
        const Number a = Number(-1.0F) / (sign + z.z);
        const Number b = z.x * z.y * a;
        x = {Number(1.0F) + sign * z.x * z.x * a, sign * b, Number(0.0F) - sign * z.x};
        y = {b, sign + z.y * z.y * a, Number(0.0F) - z.y};
    }
    HWY_INLINE Vector to_local(const Vector& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    HWY_INLINE Vector to_world(const Vector& v) const { return v.x * x + v.y * y + v.z * z; }

    Vector x, y, z;
};

void sample(const Surfaces& surfaces, const Views& views, const Vectors& random,
            Directions& directions) {
    directions.by_facet = 0;
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Vector numbers = load(random, lane);
        const Vector viewer = load(views.direction, lane);
        const Vector normal = load(surfaces.normal, lane);
        const Axes axes(normal);
        const Mask by_facet = load(views.specular, lane) > numbers.x;
        const Vector around = on_circle(lanes::IfThenElse(by_facet, numbers.y.v, numbers.z.v));
        // Ggx::sample_visible().
        const Number alpha = load(surfaces.alpha, lane);
        const Vector local = axes.to_local(viewer);
        const Vector stretched = unit({alpha * local.x, alpha * local.y, local.z});
        const Number z = (Number(1.0F) - numbers.z) * (Number(1.0F) + stretched.z) - stretched.z;
        const Number radius =
            root(lanes::Clamp((Number(1.0F) - z * z).v, Number(0.0F).v, Number(1.0F).v));
        const Vector cap = Vector{radius * around.x, radius * around.y, z} + stretched;
        const Vector facet = axes.to_world(unit({alpha * cap.x, alpha * cap.y, max(cap.z, 0.0F)}));
        const Vector twice = (Number(2.0F) * dot(viewer, facet)) * facet;
        const Vector mirrored{twice.x - viewer.x, twice.y - viewer.y, twice.z - viewer.z};
        // sample_cosine().
        const Number wide = root(numbers.y);
        const Vector diffuse =
            axes.to_world({wide * around.x, wide * around.y, root(Number(1.0F) - numbers.y)});
        const auto chosen = [&](const Vector& a, const Vector& b) {
            return Vector{lanes::IfThenElse(by_facet, a.x.v, b.x.v),
                          lanes::IfThenElse(by_facet, a.y.v, b.y.v),
                          lanes::IfThenElse(by_facet, a.z.v, b.z.v)};
        };
        store(unit(chosen(mirrored, diffuse)), directions.to_light, lane);
        store(chosen(facet, normal), directions.facet_normal, lane);
        directions.by_facet |= bits_of(by_facet, lane);
    }
}

}  // namespace balcony::render::plain_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::plain_lanes {

HWY_EXPORT(find_cosines);
HWY_EXPORT(finish_views);
HWY_EXPORT(lit_lanes);
HWY_EXPORT(finish_values);
HWY_EXPORT(sample);

namespace {

// The entries of the table around the cosines, lane by lane.
void look_up(LaneBits bits, const Surfaces& surfaces, Cosines& at) {
    for_each_lane(bits, [&](std::size_t lane) {
        const LayerEnergies& energies = *surfaces.energies[lane];
        if (const EnergyEntry* const row = energies.row()) {
            at.lower[lane] = row[at.node[lane]];
            at.upper[lane] = row[at.node[lane] + 1];
        } else {
            const LayerEnergy energy = energies.at(at.cosine[lane]);
            at.lower[lane] =
                at.upper[lane] = {energy.scale, energy.single, energy.single_edge, energy.all_edge};
        }
    });
}

// Calls set(array, number) for each number of a material.
template <class Set>
void put(const PlainMaterial& material, Surfaces& all, const Set& set) {
    const auto set_vector = [&set](Vectors& values, const V3f& value) {
        set(values.x, value.x);
        set(values.y, value.y);
        set(values.z, value.z);
    };
    set_vector(all.specular.single, material.specular.single);
    set_vector(all.specular.single_edge, material.specular.single_edge);
    set_vector(all.specular.all, material.specular.all);
    set_vector(all.specular.all_edge, material.specular.all_edge);
    set(all.dielectric.single, material.dielectric.single);
    set(all.dielectric.single_edge, material.dielectric.single_edge);
    set(all.dielectric.all, material.dielectric.all);
    set(all.dielectric.all_edge, material.dielectric.all_edge);
    set_vector(all.diffuse, material.diffuse);
    set(all.per_mean_below, material.per_mean_below);
    set(all.alpha, material.facets.alpha());
}

}  // namespace

void Surfaces::set_material(std::size_t lane, const PlainMaterial& material) {
    put(material, *this, [lane](Floats& values, float value) { values[lane] = value; });
    energies[lane] = &material.energies;
}

void Surfaces::set(std::size_t lane, const Surface& surface) {
    set_material(lane, surface.material);
    normal.set(lane, surface.normal);
    geometric_normal.set(lane, surface.geometric_normal);
}

void Surfaces::fill(std::size_t first, std::size_t count, const Surface& surface) {
    put(surface.material, *this,
        [=](Floats& values, float value) { std::fill_n(values.begin() + first, count, value); });
    std::fill_n(energies.begin() + first, count, &surface.material.energies);
    normal.fill(first, count, surface.normal);
    geometric_normal.fill(first, count, surface.geometric_normal);
}

void set_views(LaneBits lanes, const Surfaces& surfaces, const Vectors& to_viewer, Views& views) {
    Cosines cosines;
    views.direction = to_viewer;
    HWY_DYNAMIC_DISPATCH(find_cosines)(surfaces, to_viewer, cosines);
    look_up(lanes, surfaces, cosines);
    HWY_DYNAMIC_DISPATCH(finish_views)(surfaces, cosines, views);
}

void evaluate(LaneBits lanes, const Surfaces& surfaces, const Views& views, const Vectors& to_light,
              Values& values) {
    Cosines cosines;
    HWY_DYNAMIC_DISPATCH(find_cosines)(surfaces, to_light, cosines);
    const LaneBits lit =
        HWY_DYNAMIC_DISPATCH(lit_lanes)(lanes, surfaces, views, to_light, cosines.cosine);
    look_up(lit, surfaces, cosines);
    HWY_DYNAMIC_DISPATCH(finish_values)(lit, surfaces, views, to_light, cosines, values);
}

void sample(const Surfaces& surfaces, const Views& views, const Vectors& random,
            Directions& directions) {
    HWY_DYNAMIC_DISPATCH(sample)(surfaces, views, random, directions);
}

}  // namespace balcony::render::plain_lanes

#endif
