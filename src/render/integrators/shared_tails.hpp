// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Paths of neighbouring pixels share what they find: Bekaert, Sbert and Halton, "Accelerating Path
// Tracing by Re-Using Paths" (EGWR 2002).
//
// The head of a path ends at the first surface that scatters its light at random. Its ray then
// leads to another surface, where its tail begins. A tail is sound behind any other head that sees
// the point where it begins, so each head receives the light of all tails of its group. The
// direction of a tail y was chosen at one of several heads k, each of which finds it with the
// density, by area,
//
//     q_k = transmittance(k, y) · survival(k, y) · pdf(k, y) · cosine(y) / distance(k, y)²,
//
// where the cosine is that at the tail, and the density is that of directions to bright patches,
// too (bright_patches.hpp). The light of the tail is divided by the sum of q_k over all
// heads of the group: the balance heuristic of multiple importance sampling (Veach 1997), which has
// no bias.
//
// A smooth layer reflects towards each head other directions, so only what lies below it is shared.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/integrators/path_state.hpp"
#include "render/sampling/pixel_groups.hpp"
#include "shading/materials/bsdf.hpp"
#include "shading/materials/plain_lanes.hpp"

namespace balcony::render {

/// The end of a path's head.
struct Head {
    plain_lanes::Surface surface;
    V3f to_viewer;                      ///< Unit.
    V3f start;                          ///< Of the ray to the tail.
    Color3f throughput;                 ///< Of the path up to the surface.
    float time = 0.0F;                  ///< Only heads of the same time
    Bounces bounces;                    ///< and the same numbers of bounces share their tails.
    bool is_clear;                      ///< The surface shows others, in focus, instead of itself.
    const BrightPatches::Place* place;  ///< Null where no path is sent to a bright patch.
};

/// Light that arrives at a tail.
struct ArrivingLight {
    V3f direction{0.0F};      ///< Unit.
    Color3f radiance{0.0F};   ///< Over the density of the direction.
    Color3f reflected{0.0F};  ///< Bsdf::Value::reflected, towards the path's own head.
};

/// The surface where the tail of a path begins, and the light that arrives at it.
struct Tail {
    /// The part of the surface that all heads share.
    plain_lanes::Surface surface;
    V3f flat_normal;  ///< Unit, of the triangle, towards the head.
    V3f position;
    Color3f throughput;      ///< Of the path's own head, and its ray to here.
    float transmittance;     ///< Along that ray, which may cross transparent surfaces by chance.
    bool is_whole;           ///< The surface has no other part.
    bool is_softened;        ///< Here or behind, the path met a surface that is.
    ArrivingLight lamp{};    ///< From a lamp that was chosen.
    ArrivingLight onward{};  ///< Along the ray on which the path goes on.
};

/// The heads and tails of a batch of paths; belongs to one thread.
class SharedTails {
public:
    /// Not with a light at the eye, which is another for each head; and not with low limits for
    /// diffuse or glossy bounces, since a tail counts the bounce at its own head only.
    [[nodiscard]] static bool can_share(const TracedScene& traced, const PathSettings& settings);

    /// The groups are those of the rays.
    void begin(std::span<const CameraRay> rays);

    [[nodiscard]] static bool can_end_head(const BsdfMaterial& material);
    /// Whether a tail may begin at a surface that a viewer sees. It depends on the viewer's side
    /// alone, since elsewhere a surface looks the same from every head.
    [[nodiscard]] static bool can_begin_tail(const BsdfMaterial& material, const Surface& surface,
                                             const V3f& to_viewer);

    void set_head(std::uint32_t path, const Head& head);
    /// After set_head(): of a path at this surface.
    void set_tail(const Path& path, const PlainMaterial& material, const Surface& surface);
    [[nodiscard]] Tail& tail(std::uint32_t path) { return tails_[ends_[path].tail]; }

    /// Adds the light of all tails to the heads of their groups, limited as the rays of these say.
    void add_light(const SceneTracer& tracer, std::span<const CameraRay> rays,
                   std::span<Seen> seen);

private:
    static constexpr std::size_t group_size = PixelGroups::size;
    static constexpr std::size_t tails_at_once = plain_lanes::size / group_size;
    using Indices = std::span<const std::uint32_t>;

    // The heads of one group, once for each tail that is connected with them at the same time.
    struct alignas(64) Lanes {
        LaneBits all = 0;
        plain_lanes::Surfaces surfaces;
        plain_lanes::Views views;
        plain_lanes::Vectors to_viewer, start, throughput;
        plain_lanes::Vectors light;
        plain_lanes::Floats softened;  // The luminance of that part of the light.
    };
    // The tails, and what connects them with the heads.
    struct alignas(64) Connections {
        std::array<const Tail*, tails_at_once> tails{};
        plain_lanes::Surfaces surfaces;
        plain_lanes::Vectors to_tail, to_head;
        plain_lanes::Floats length{}, cosine{}, facing{};
        plain_lanes::Values at_head;
        plain_lanes::Floats per_area{};
        plain_lanes::Floats density{};
        plain_lanes::Views views;
        plain_lanes::Vectors to_light;
        plain_lanes::Values from_lamp, from_onward;
    };

    void limit_tail(std::uint32_t path, float limit, Seen& seen);
    void share(Indices group, const SceneTracer& tracer);
    void gather(Indices group);
    [[nodiscard]] LaneBits like(Indices group, std::size_t own) const;
    void connect(Indices group, LaneBits owners, const SceneTracer& tracer);
    void set_ways();
    [[nodiscard]] LaneBits facing(LaneBits heads);
    void trace(Indices group, LaneBits lanes, LaneBits owners, const SceneTracer& tracer);
    void set_densities(Indices group, LaneBits lanes, const SceneTracer& tracer);
    void reflect(LaneBits lanes);
    void add(LaneBits lanes, LaneBits owners);

    static constexpr std::uint32_t none = 0xffffffffU;
    struct Ends {
        std::uint32_t group = 0;
        std::uint32_t head = none;  // Index into heads_.
        std::uint32_t tail = none;
    };
    [[nodiscard]] const Head& head_of(std::uint32_t path) const { return heads_[ends_[path].head]; }

    std::vector<Ends> ends_;  // By path.
    std::vector<Head> heads_;
    std::vector<Tail> tails_;
    std::vector<std::uint32_t> order_, buffer_;
    Lanes lanes_;
    Connections at_;
};

}  // namespace balcony::render
