// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Materials with their textures at a point: where an image is looked up, the normals that it maps,
// opacity.

#include <gtest/gtest.h>

#include <cmath>

#include "shading/surfaces/surface.hpp"
#include "support.hpp"

namespace balcony::render::material_test {

namespace {

using Imath::Color4f;
using Imath::M44d;
using Imath::V2f;
using Imath::V3f;
using Pixel = std::vector<std::uint8_t>;

constexpr std::size_t side = 16;

// An image without symmetry.
std::vector<std::uint8_t> pattern() {
    return test::encode_png(32, 32, 3, [](int x, int y) {
        return Pixel{static_cast<std::uint8_t>(8 * x), static_cast<std::uint8_t>(7 * y),
                     static_cast<std::uint8_t>(x * y % 256)};
    });
}

// A wall that fills the view of seen().
scene::Scene wall_with(const scene::Material& material, const M44d& world_from_mesh = {}) {
    scene::Scene scene;
    test::add(scene, test::wall(-2.0F, 1.0F), material, world_from_mesh);
    return scene;
}

test::Rendered seen(const scene::Scene& scene, const test::View& view) {
    return render(scene, orthographic(view), test::request(side, side, "preview"));
}

test::Rendered seen(const scene::Scene& scene) {
    return seen(scene, test::view_down_z(0.0, 0.0, 1.0));
}

// The direction that 8 bits of a normal map encode, before and after rounding.
Pixel encoded(const V3f& normal) {
    const auto byte = [](float part) {
        return static_cast<std::uint8_t>(std::lround(255.0F * (part + 1.0F) / 2.0F));
    };
    return {byte(normal.x), byte(normal.y), byte(normal.z)};
}

// The normal that is seen in the middle of a wall whose normal map has one normal.
V3f mapped(const V3f& normal, const std::function<void(scene::Scene&)>& change = {},
           const M44d& placed = {}, const test::View& view = test::view_down_z(0.0, 0.0, 1.0)) {
    scene::Scene scene = wall_with(test::white(), placed);
    scene.materials[0].normal_texture.index = test::add_texture(
        scene, test::encode_png(4, 4, 3, [&](int, int) { return encoded(normal); }));
    if (change) {
        change(scene);
    }
    const test::Rendered picture = seen(scene, view);
    return picture.film.layers->normal[picture.film.index(side / 2, side / 2)];
}

void expect_normal(const V3f& found, const V3f& expected) {
    // Half a step of 8 bits in each component: 1 / 255, and the mean of the samples' normals.
    constexpr float rounding = 0.01F;
    EXPECT_TRUE(found.equalWithAbsError(expected, rounding)) << found << expected;
}

const V3f to_right(0.6F, 0.0F, 0.8F);
const V3f to_top(0.0F, 0.6F, 0.8F);

}  // namespace

// A texture that is transformed shows what transformed coordinates show: exactly, for powers of 2.
TEST(Materials, ATextureTransformEqualsTransformedCoordinates) {
    scene::Scene by_texture = wall_with(test::white());
    scene::TextureUse& use = by_texture.materials[0].base_color_texture;
    use.index = test::add_texture(by_texture, pattern());
    scene::Scene by_mesh = by_texture;
    use.offset = V2f(0.25F, 0.125F);
    use.u_axis = V2f(0.0F, -2.0F);
    use.v_axis = V2f(0.5F, 0.0F);
    for (V2f& at : by_mesh.meshes[0].edit().texture_coordinates[0]) {
        at = use.place(at);
    }
    EXPECT_EQ(seen(by_texture).film.layers->albedo, seen(by_mesh).film.layers->albedo);
    EXPECT_NE(seen(by_texture).film.layers->albedo[0], seen(by_texture).film.layers->albedo[100]);
}

TEST(Materials, TheSecondSetOfCoordinatesIsLikeTheFirst) {
    scene::Scene first = wall_with(test::white());
    first.materials[0].base_color_texture.index = test::add_texture(first, pattern());
    scene::Scene second = first;
    second.materials[0].base_color_texture.coordinates = 1;
    auto& coordinates = second.meshes[0].edit().texture_coordinates;
    coordinates[1] = coordinates[0];
    coordinates[0].assign(4, V2f(0.3F, 0.7F));
    EXPECT_EQ(seen(first).film.layers->albedo, seen(second).film.layers->albedo);
}

// x of a normal map is the right of the image, y its top.
TEST(Materials, NormalMapsTiltTheNormal) {
    expect_normal(mapped({0.0F, 0.0F, 1.0F}), {0.0F, 0.0F, 1.0F});
    expect_normal(mapped(to_right), to_right);
    expect_normal(mapped(to_top), to_top);
    const auto scaled = [](scene::Scene& scene) { scene.materials[0].normal_scale = 0.5F; };
    expect_normal(mapped(to_right, scaled), V3f(0.3F, 0.0F, 0.8F).normalized());
}

TEST(Materials, NormalMapsFollowMirroredAndTurnedImages) {
    const auto mirrored = [](scene::Scene& scene) {
        for (V2f& at : scene.meshes[0].edit().texture_coordinates[0]) {
            at.x = 1.0F - at.x;
        }
    };
    expect_normal(mapped(to_right, mirrored), {-0.6F, 0.0F, 0.8F});
    expect_normal(mapped(to_top, mirrored), to_top);
    // The image turns counter-clockwise by a quarter: its right is up.
    const auto turned = [](scene::Scene& scene) {
        scene::TextureUse& use = scene.materials[0].normal_texture;
        use.u_axis = V2f(0.0F, 1.0F);
        use.v_axis = V2f(-1.0F, 0.0F);
    };
    expect_normal(mapped(to_right, turned), to_top);
}

TEST(Materials, NormalMapsFollowThePlacement) {
    M44d mirror;
    mirror.setScale(V3d(-1.0, 1.0, 1.0));
    expect_normal(mapped(to_right, {}, mirror), {-0.6F, 0.0F, 0.8F});
    expect_normal(mapped(to_top, {}, mirror), to_top);
    M44d turn;
    turn.rotate(V3d(0.0, 0.0, std::acos(-1.0) / 2.0));
    expect_normal(mapped(to_right, {}, turn), to_top);
}

// The other side of a wall has the same bumps, seen from behind.
TEST(Materials, TheNormalOfTheBackIsReversed) {
    const test::View from_behind{V3d(0.0, 0.0, -3.0), V3d(0.0, 0.0, 1.0), V3d(-1.0, 0.0, 0.0),
                                 V3d(0.0, 1.0, 0.0)};
    expect_normal(mapped(to_right, {}, {}, from_behind), -to_right);
}

TEST(Materials, TangentsOfTheFileTakePrecedence) {
    const auto with_tangents = [](const scene::V4f& tangent) {
        return
            [tangent](scene::Scene& scene) { scene.meshes[0].edit().tangents.assign(4, tangent); };
    };
    // Where it is up, the bitangent is to the left, or to the right if it is mirrored.
    expect_normal(mapped(to_right, with_tangents({0.0F, 1.0F, 0.0F, 1.0F})), to_top);
    expect_normal(mapped(to_top, with_tangents({0.0F, 1.0F, 0.0F, 1.0F})), {-0.6F, 0.0F, 0.8F});
    expect_normal(mapped(to_top, with_tangents({0.0F, 1.0F, 0.0F, -1.0F})), to_right);
    expect_normal(mapped(to_right, with_tangents({0.0F, 0.0F, 0.0F, 1.0F})), to_right);
    // A mirroring placement mirrors the bitangent too.
    M44d mirror;
    mirror.setScale(V3d(-1.0, 1.0, 1.0));
    expect_normal(mapped(to_top, with_tangents({1.0F, 0.0F, 0.0F, 1.0F}), mirror), to_top);
}

TEST(Materials, WithoutCoordinatesNothingIsMapped) {
    expect_normal(mapped(to_right,
                         [](scene::Scene& scene) {
                             scene.meshes[0].edit().texture_coordinates[0].assign(4,
                                                                                  V2f(0.5F, 0.5F));
                         }),
                  {0.0F, 0.0F, 1.0F});
    expect_normal(
        mapped(to_right,
               [](scene::Scene& scene) { scene.meshes[0].edit().texture_coordinates[0].clear(); }),
        {0.0F, 0.0F, 1.0F});
}

// However steep the map is, the viewer sees the side that it looks at.
TEST(Materials, AMappedNormalFacesTheViewer) {
    const V3f found = mapped({0.995F, 0.0F, -0.1F});
    EXPECT_GT(found.z, 0.0F);
    EXPECT_NEAR(found.length(), 1.0F, 1e-3F);
}

// The light of a lacquer upon black whose lamp is where the normal `to_right` mirrors the viewer.
float gloss(const std::function<void(scene::Material&, scene::TextureIndex)>& map) {
    scene::Material lacquer = test::white();
    lacquer.base_color = scene::Color3f(0.0F);
    lacquer.specular = 0.0F;
    lacquer.clearcoat = 1.0F;
    lacquer.clearcoat_roughness = 0.2F;
    scene::Scene scene = wall_with(lacquer);
    map(scene.materials[0], test::add_texture(scene, test::encode_png(4, 4, 3, [](int, int) {
                                                  return encoded(to_right);
                                              })));
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.direction = V3d(-0.96, 0.0, -0.28);
    scene.lights.push_back(lamp);
    const test::Rendered picture = render(scene, orthographic(test::view_down_z(0.0, 0.0, 1.0)),
                                          test::request(side, side, "direct"));
    return picture.film.pixel(side / 2, side / 2).g;
}

// KHR_materials_clearcoat: the normal map of the material does not bend the lacquer.
TEST(Materials, AClearcoatHasItsOwnNormalMap) {
    const float own = gloss([](scene::Material& material, scene::TextureIndex bent) {
        material.clearcoat_normal_texture.index = bent;
    });
    const float both = gloss([](scene::Material& material, scene::TextureIndex bent) {
        material.clearcoat_normal_texture.index = material.normal_texture.index = bent;
    });
    const float none = gloss([](scene::Material& material, scene::TextureIndex bent) {
        material.normal_texture.index = bent;
    });
    const float flat = gloss([](scene::Material& material, scene::TextureIndex bent) {
        material.clearcoat_normal_texture.index = bent;
        material.clearcoat_normal_scale = 0.0F;
    });
    EXPECT_GT(own, 0.1F);
    EXPECT_NEAR(both, own, 1e-5F * own);
    EXPECT_LT(none, 0.01F * own);
    EXPECT_LT(flat, 0.01F * own);
}

TEST(Materials, AlphaOfVerticesIsAFactorOfTheOpacity) {
    scene::Material paint = test::white();
    paint.alpha_mode = scene::AlphaMode::blend;
    paint.alpha = 0.5F;
    scene::Scene scene = wall_with(paint);
    scene.meshes[0].edit().colors.assign(4, Color4f(1.0F, 0.25F, 1.0F, 0.5F));
    const test::Rendered picture = seen(scene);
    const Color4f pixel = picture.film.pixel(side / 2, side / 2);
    EXPECT_NEAR(pixel.a, 0.25F, 1e-6F);
    EXPECT_NEAR(pixel.g / pixel.r, 0.25F, 1e-6F);
    scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    scene.materials[0].alpha_cutoff = 0.3F;
    EXPECT_EQ(seen(scene).film.pixel(side / 2, side / 2).a, 0.0F);
    scene.materials[0].alpha_mode = scene::AlphaMode::opaque;
    EXPECT_EQ(seen(scene).film.pixel(side / 2, side / 2).a, 1.0F);
}

// The outer side is the one that sees the triangle counter-clockwise, in the file.
TEST(Materials, RaysEnterAtTheOuterSide) {
    for (const bool is_mirrored : {false, true}) {
        M44d placed;
        placed.setScale(V3d(is_mirrored ? -1.0 : 1.0, 1.0, 1.0));
        const scene::Scene scene = wall_with(test::white(), placed);
        const SurfaceFinder surfaces(scene);
        embree::Hit hit;
        hit.instance = 0;
        hit.triangle = 0;
        hit.u = hit.v = 0.25F;
        const Surface front = surfaces.find(hit, V3f(0.0F, 0.0F, -1.0F));
        const Surface back = surfaces.find(hit, V3f(0.0F, 0.0F, 1.0F));
        EXPECT_TRUE(front.entering) << is_mirrored;
        EXPECT_FALSE(back.entering) << is_mirrored;
        EXPECT_EQ(front.geometric_normal, V3f(0.0F, 0.0F, 1.0F));
        EXPECT_EQ(back.geometric_normal, V3f(0.0F, 0.0F, -1.0F));
    }
}

// Equal normals at the corners are those of a wall only if they are perpendicular to it.
TEST(Materials, EqualNormalsMayBeTilted) {
    scene::Scene scene = wall_with(test::white());
    const V3f straight(0.0F, 0.0F, 1.0F);
    const V3f tilted = V3f(0.3F, 0.0F, 1.0F).normalized();
    embree::Hit hit;
    hit.instance = 0;
    hit.triangle = 0;
    hit.u = hit.v = 0.25F;
    for (const V3f& normal : {straight, tilted, -straight}) {
        scene::Mesh& mesh = scene.meshes[0].edit();
        mesh.normals.assign(mesh.positions.size(), normal);
        const Surface found = SurfaceFinder(scene).find(hit, V3f(0.0F, 0.0F, -1.0F));
        const V3f expected = normal.z < 0.0F ? -normal : normal;
        EXPECT_LT((found.smooth_normal - expected).length(), 1e-6F);
        EXPECT_LT((found.mesh_normal - normal).length(), 1e-6F);
    }
}

}  // namespace balcony::render::material_test
