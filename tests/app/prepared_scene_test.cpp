// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/prepared_scene.hpp"

#include <algorithm>
#include <fstream>

#include "balcony/layer_values.hpp"
#include "balcony/scene_edits.hpp"
#include "support.hpp"

namespace balcony::app::prepared_scene_test {
namespace {

using scene::M44d;
using scene::PropertyValue;
using Values = std::vector<PropertyValue>;

M44d shifted(double x, double y, double z) { return M44d().translate(scene::V3d(x, y, z)); }
M44d mirrored() { return M44d().scale(scene::V3d(-1, 1, 1)); }

// A floor, a wall of glass, and two leaves that share a mesh.
scene::Scene garden() {
    scene::Scene made;
    const auto material = [&](const char* name, const Values& values) {
        return *add_material(made, name, values);
    };
    const std::vector<scene::V3d> square{{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    const std::vector<std::array<std::int64_t, 3>> faces{{0, 1, 2}, {0, 2, 3}};
    const scene::MeshArrays arrays{.positions = square, .triangles = faces};
    const M44d upright = M44d().rotate(scene::V3d(1.5707963267948966, 0, 0));
    const std::size_t stone = material("stone", {});
    const std::size_t glass = material("glass", {{"transmission", {1}}, {"roughness", {0}}});
    const std::size_t leaf = material("leaf", {{"base_color", {0.1, 0.6, 0.1}}});
    EXPECT_TRUE(add_object(made, "floor", arrays, stone, M44d().scale(scene::V3d(4.0))));
    EXPECT_TRUE(add_object(made, "pane", arrays, glass, upright * shifted(0, 1, 1)));
    EXPECT_TRUE(add_object(made, "leaf 1", arrays, leaf, shifted(1, 0.5, 0)));
    // A mesh is shared by two instances.
    made.objects.push_back({"leaf 2"});
    made.instances.push_back({made.instances.back().mesh, shifted(-1, 0.75, 0), 3});
    EXPECT_TRUE(add_light(made, "lamp", scene::LightKind::point,
                          Values{{"position", {0, 3, 0}}, {"intensity", {20}}}));
    return made;
}

// Looks down at an angle.
const std::string camera = R"(camera down() {
    aspect 1
    map u = 0.8 .. -0.8, v = square
    eye point(0, 0, 0)
    toward plane((1, 0, 0))
    move rotate(y, 40deg), translate((-4, 0, 4))
})";

class Garden : public test::FolderTest {
protected:
    // The colours that a scene shows.
    static std::vector<float> colors_of(PreparedScene& scene,
                                        const std::string& integrator = "path") {
        const lang::CameraSource source{std::make_shared<const SourceText>("down.cam", camera)};
        const auto picture = scene.picture(source, "", {});
        EXPECT_TRUE(picture) << to_text(picture.diagnostics);
        Request request;
        request.size.width = 24;
        request.samples = 4;
        request.settings.integrator = integrator;
        const Report report = scene.render(picture->picture, request);
        EXPECT_TRUE(report.is_traced) << to_text(report.diagnostics);
        return render::color_values(*scene.film()).values;
    }

    // The scene of a file with all that this one has.
    PreparedScene reloaded(const scene::Scene& made) const {
        Request request;
        request.scene = file("scene.glb");
        const std::vector<std::uint8_t> bytes = to_glb(made);
        std::ofstream(request.scene, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
        auto loaded = PreparedScene::make(request);
        EXPECT_TRUE(loaded) << to_text(loaded.diagnostics);
        return std::move(*loaded);
    }
};

using Edit = std::function<Diagnostics(scene::Scene&)>;

// Each edit as a program asks for it, and what it does to a scene by hand.
struct Case {
    const char* name;
    Edit edit;
    Edit by_hand;
};

Values one(const char* name, std::vector<double> numbers) { return {{name, std::move(numbers)}}; }

std::vector<Case> cases() {
    using scene::Scene;
    return {
        {"a move of a mesh of its own",
         [](Scene& s) { return transform_object(s, 1, shifted(0, 0, -0.5)); },
         [](Scene& s) {
             s.instances[1].world_from_mesh *= shifted(0, 0, -0.5);
             return Diagnostics();
         }},
        {"a move of a shared mesh, mirrored",
         [](Scene& s) { return place_object(s, 3, mirrored() * shifted(0.5, 1, 0)); },
         [](Scene& s) {
             s.instances[3].world_from_mesh = mirrored() * shifted(0.5, 1, 0);
             return Diagnostics();
         }},
        {"a removal that leaves a shared mesh to one",
         [](Scene& s) {
             remove_object(s, 2);
             return Diagnostics();
         },
         [](Scene& s) {
             s.instances.erase(s.instances.begin() + 2);
             s.objects.erase(s.objects.begin() + 2);
             s.instances[2].object = 2;
             return Diagnostics();
         }},
        {"a surface that emits",
         [](Scene& s) {
             return set_material(s, 2, one("emission", {3, 2, 1}));
         },
         [](Scene& s) {
             s.materials[2].emission = {3, 2, 1};
             return Diagnostics();
         }},
        {"leaves that let light pass",
         [](Scene& s) { return set_material(s, 2, one("alpha", {0.25})); },
         [](Scene& s) {
             s.materials[2].alpha = 0.25F;
             s.materials[2].alpha_mode = scene::AlphaMode::blend;
             return Diagnostics();
         }},
        {"glass that becomes opaque",
         [](Scene& s) { return set_material(s, 1, one("transmission", {0})); },
         [](Scene& s) {
             s.materials[1].transmission = 0.0F;
             return Diagnostics();
         }},
        {"a light elsewhere",
         [](Scene& s) {
             return set_light(s, 0, one("position", {1, 2, 1}));
         },
         [](Scene& s) {
             s.lights[0].position = {1, 2, 1};
             return Diagnostics();
         }},
        {"no light",
         [](Scene& s) {
             remove_light(s, 0);
             return Diagnostics();
         },
         [](Scene& s) {
             s.lights.clear();
             return Diagnostics();
         }},
        {"a second light",
         [](Scene& s) {
             return add_light(s, "other", scene::LightKind::point,
                              Values{{"position", {0, 1, 2}}, {"intensity", {5, 1, 1}}})
                 .diagnostics;
         },
         [](Scene& s) {
             s.lights.push_back({.name = "other", .position = {0, 1, 2}, .intensity = {5, 1, 1}});
             return Diagnostics();
         }},
    };
}

TEST_F(Garden, AnEditShowsWhatAFileWithItShows) {
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        PreparedScene edited = reloaded(garden());
        const auto before = colors_of(edited);
        PreparedScene kept = edited.share();
        ASSERT_TRUE(edited.edit(one.edit).empty());
        scene::Scene by_hand = garden();
        ASSERT_TRUE(one.by_hand(by_hand).empty());
        PreparedScene wanted = reloaded(by_hand);
        for (const char* const integrator : {"path", "preview", "direct"}) {
            EXPECT_EQ(colors_of(edited, integrator), colors_of(wanted, integrator)) << integrator;
        }
        EXPECT_NE(colors_of(edited), before);
        EXPECT_EQ(colors_of(kept), before) << "a copy does not see the edit";
    }
}

TEST_F(Garden, EditsAddUpUntilTheyAreShown) {
    PreparedScene edited = reloaded(garden());
    scene::Scene by_hand = garden();
    for (const Case& one : cases()) {
        if (one.name != std::string("a removal that leaves a shared mesh to one") &&
            one.name != std::string("no light")) {
            ASSERT_TRUE(edited.edit(one.edit).empty()) << one.name;
            ASSERT_TRUE(one.by_hand(by_hand).empty());
        }
    }
    PreparedScene wanted = reloaded(by_hand);
    EXPECT_EQ(colors_of(edited), colors_of(wanted));
}

TEST_F(Garden, AnEditThatFailsChangesNothing) {
    PreparedScene scene = reloaded(garden());
    const auto before = scene.scene();
    const Diagnostics found = scene.edit([](scene::Scene& own) {
        remove_object(own, 0);
        return set_material(own, 0, one("roughness", {7.0}));
    });
    EXPECT_TRUE(has_errors(found));
    EXPECT_EQ(scene.scene(), before);
}

TEST_F(Garden, ASceneOfAProgramIsThatOfItsFile) {
    Request request;
    request.light.lamps = {{.name = "extra", .position = {2, 2, 2}, .intensity = {3, 3, 3}}};
    auto made = PreparedScene::make(garden(), request);
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    scene::Scene by_hand = garden();
    by_hand.lights.push_back(request.light.lamps[0]);
    PreparedScene wanted = reloaded(by_hand);
    EXPECT_EQ(colors_of(*made), colors_of(wanted));
}

TEST_F(Garden, AnEmptySceneIsFilledAndEmptiedAgain) {
    scene::Scene nothing;
    nothing.default_light = true;
    auto made = PreparedScene::make(nothing, {});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    const auto empty = colors_of(*made);
    ASSERT_TRUE(made->edit([](scene::Scene& own) {
                        own = garden();
                        return Diagnostics();
                    })
                    .empty());
    PreparedScene wanted = reloaded(garden());
    EXPECT_EQ(colors_of(*made), colors_of(wanted));
    ASSERT_TRUE(made->edit([](scene::Scene& own) {
                        while (!own.objects.empty()) {
                            remove_object(own, 0);
                        }
                        remove_light(own, 0);
                        return Diagnostics();
                    })
                    .empty());
    EXPECT_EQ(colors_of(*made), empty);
}

// Light from all around, but for a place where it is negative: a warning, when the file is read.
void write_light(const std::string& file, double radiance) {
    render::Film film = *render::make_film({.width = 4, .height = 2, .data_layers = false});
    film.sum.assign(film.sum.size(), render::Color4d(radiance, radiance, radiance, 1.0));
    film.sum.front().r = -1.0;
    film.passes.assign(film.tile_count(), 1);
    ASSERT_TRUE(render::write_exr(film, file).empty());
}

TEST_F(Garden, AnEnvironmentIsReadAgainOnlyIfItsFileHasChanged) {
    Request request;
    request.size.width = 24;
    request.settings.integrator = "path";
    request.light.environment = std::filesystem::path(file("light.exr"));
    write_light(file("light.exr"), 1.0);
    auto made = PreparedScene::make(garden(), request);
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
    const lang::CameraSource source{std::make_shared<const SourceText>("down.cam", camera)};
    const auto picture = made->picture(source, "", {});
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto brightest = [&] {
        const std::vector<float> seen = render::color_values(*made->film()).values;
        return *std::max_element(seen.begin(), seen.end());
    };
    EXPECT_TRUE(made->render(picture->picture, request).diagnostics.empty());
    const float before = brightest();
    write_light(file("light.exr"), 10.0);
    EXPECT_EQ(made->render(picture->picture, request).diagnostics.size(), 1U);
    EXPECT_GT(brightest(), 5.0F * before);
    EXPECT_TRUE(made->render(picture->picture, request).diagnostics.empty());
    EXPECT_GT(brightest(), 5.0F * before);
    // One that only pictures have, in turn with that of the scene.
    write_light(file("dusk.exr"), 0.1);
    Request at_dusk = request;
    at_dusk.light.environment = std::filesystem::path(file("dusk.exr"));
    EXPECT_EQ(made->render(picture->picture, at_dusk).diagnostics.size(), 1U);
    const float dusk = brightest();
    EXPECT_LT(dusk, before);
    EXPECT_TRUE(made->render(picture->picture, request).diagnostics.empty());
    EXPECT_GT(brightest(), 5.0F * before);
    EXPECT_TRUE(made->render(picture->picture, at_dusk).diagnostics.empty());
    EXPECT_EQ(brightest(), dusk);
}

}  // namespace
}  // namespace balcony::app::prepared_scene_test
