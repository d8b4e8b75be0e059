// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

#include <cmath>
#include <numbers>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "balcony/motion.hpp"

namespace balcony::render::test {

void on_each_target(const std::function<void()>& check) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (target == HWY_SCALAR || target == HWY_EMU128) {
            continue;
        }
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        check();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

namespace {

using camera::Emitter;
using camera::ObjectPoint;
using camera::ObjectVector;
using camera::ParameterPoint;

class UnitMapper final : public camera::PictureMapper {
public:
    ParameterPoint map(const camera::PicturePoint& picture, Emitter&) const override {
        return {2.0 * picture.point.x / picture.size.width - 1.0,
                1.0 - 2.0 * picture.point.y / picture.size.height};
    }
    // The tests' cameras take films of any aspect.
    bool adapts_to_aspect() const override { return true; }
};

class FormulaObject final : public camera::ObjectGenerator {
public:
    explicit FormulaObject(decltype(RayFormula::origin) formula) : formula_(std::move(formula)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return formula_(p, emit);
    }

private:
    decltype(RayFormula::origin) formula_;
};

class FormulaRule final : public camera::DirectionRule {
public:
    explicit FormulaRule(decltype(RayFormula::direction) formula) : formula_(std::move(formula)) {}
    ObjectVector direction(const camera::PathPoint& eye, const camera::PathPoint*,
                           Emitter& emit) const override {
        return formula_(eye.parameters, emit);
    }

private:
    decltype(RayFormula::direction) formula_;
};

template <class Triple>
Triple affine(const V3d& at, const V3d& right, const V3d& up, const ParameterPoint& p) {
    return {at.x + right.x * p.u + up.x * p.v, at.y + right.y * p.u + up.y * p.v,
            at.z + right.z * p.u + up.z * p.v};
}

template <class Triple>
Triple constant(const V3d& v, Emitter& emit) {
    return {emit(v.x), emit(v.y), emit(v.z)};
}

}  // namespace

camera::Camera make_camera(RayFormula formula, Axes axes) {
    camera::Camera::Parts parts;
    parts.name = "test";
    parts.eye.mapper = std::make_shared<UnitMapper>();
    parts.eye.generator = std::make_shared<FormulaObject>(std::move(formula.origin));
    parts.look = std::make_shared<FormulaRule>(std::move(formula.direction));
    parts.axes = axes;
    Result<camera::Camera> made = camera::Camera::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

View view_down_z(double x, double y, double z) {
    return {{x, y, z}, {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
}

camera::Camera pinhole(const View& view, Axes axes) {
    return make_camera({[view](const ParameterPoint&, Emitter& emit) {
                            return constant<ObjectPoint>(view.eye, emit);
                        },
                        [view](const ParameterPoint& p, Emitter&) {
                            return affine<ObjectVector>(view.forward, view.right, view.up, p);
                        }},
                       axes);
}

camera::Camera orthographic(const View& view, Axes axes) {
    return make_camera({[view](const ParameterPoint& p, Emitter&) {
                            return affine<ObjectPoint>(view.eye, view.right, view.up, p);
                        },
                        [view](const ParameterPoint&, Emitter& emit) {
                            return constant<ObjectVector>(view.forward, emit);
                        }},
                       axes);
}

scene::Mesh parallelogram(V3f corner, V3f right, V3f up) {
    scene::Mesh mesh;
    mesh.positions = {corner, corner + right, corner + right + up, corner + up};
    mesh.texture_coordinates[0] = {{0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}};
    mesh.normals.assign(4, right.cross(up).normalized());
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

std::uint32_t add(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                  const scene::M44d& world_from_mesh) {
    const auto object = static_cast<std::uint32_t>(scene.objects.size());
    mesh.material = scene::MaterialIndex(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({scene::MeshIndex(scene.meshes.size()), world_from_mesh, object});
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back({"object " + std::to_string(object)});
    return object + 1;
}

scene::Mesh wall(float z, float half) {
    return parallelogram({-half, -half, z}, {2.0F * half, 0.0F, 0.0F}, {0.0F, 2.0F * half, 0.0F});
}

scene::Mesh coarse_sphere(float radius, std::uint32_t columns, std::uint32_t rows) {
    constexpr float pi = std::numbers::pi_v<float>;
    scene::Mesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const float latitude = pi * (static_cast<float>(row) / static_cast<float>(rows) - 0.5F);
            const float longitude =
                2.0F * pi * static_cast<float>(column) / static_cast<float>(columns);
            const V3f normal(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                             -std::cos(latitude) * std::sin(longitude));
            mesh.positions.push_back(radius * normal);
            mesh.normals.push_back(normal);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column;
            const std::uint32_t b = a + columns + 1;
            mesh.triangles.push_back({a, a + 1, b});
            mesh.triangles.push_back({b, a + 1, b + 1});
        }
    }
    return mesh;
}

scene::Material white() {
    scene::Material material;
    material.base_color = scene::Color3f(1.0F);
    return material;
}

std::vector<std::uint8_t> encode_png(int width, int height, int channels, const Pixels& pixels) {
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::vector<std::uint8_t> pixel = pixels(x, y);
            samples.insert(samples.end(), pixel.begin(), pixel.end());
        }
    }
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_TRUE(output->set_ioproxy(&memory) && output->open("test.png", spec) &&
                output->write_image(OIIO::TypeDesc::UINT8, samples.data()) && output->close());
    return bytes;
}

scene::TextureIndex add_texture(scene::Scene& scene, std::vector<std::uint8_t> bytes) {
    scene::Texture texture;
    texture.name = "texture " + std::to_string(scene.textures.size());
    texture.bytes = std::move(bytes);
    scene.textures.push_back(std::move(texture));
    return scene::TextureIndex(scene.textures.size() - 1);
}

Request request(std::size_t width, std::size_t height, std::string integrator,
                std::size_t samples) {
    Request made;
    made.layout.width = width;
    made.layout.height = height;
    made.integrator = std::move(integrator);
    made.samples = samples;
    made.ambient = Color3f(0.0F);
    made.path.exact = true;
    return made;
}

Renderer renderer_of(const scene::Scene& scene) {
    Result<Renderer> made = Renderer::make(std::make_shared<const scene::Scene>(scene));
    EXPECT_TRUE(made && made.diagnostics.empty()) << to_text(made.diagnostics);
    return std::move(*made);
}

std::shared_ptr<const scene::Scene> at_time(const scene::Scene& scene, double time) {
    Result<scene::Scene> moved = scene::moved_to(scene, time);
    EXPECT_TRUE(moved.diagnostics.empty()) << to_text(moved.diagnostics);
    return std::make_shared<const scene::Scene>(std::move(*moved));
}

Rendered render(const scene::Scene& scene, const camera::Picture& wanted, const Request& request) {
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    EXPECT_TRUE(renderer && renderer.diagnostics.empty()) << to_text(renderer.diagnostics);
    Result<Film> film = make_film(request.layout);
    EXPECT_TRUE(film) << to_text(film.diagnostics);
    const Result<Summary> summary = render::render(*renderer, wanted, request, *film);
    EXPECT_TRUE(summary && summary.diagnostics.empty()) << to_text(summary.diagnostics);
    return {std::move(*film), *summary};
}

}  // namespace balcony::render::test
