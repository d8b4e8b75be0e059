// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The OSL shaders of all examples, compiled as C++ behind a header that defines OSL's types.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/ray_difference.hpp"
#include "bridge/text/c_like.hpp"
#include "bridge/text/camera_formulas.hpp"
#include "compiled_library.hpp"
#include "examples.hpp"
#include "osl_types.hpp"

namespace balcony::bridge::osl_export_test {
namespace {

using test::Example;

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Numbers with a point or an exponent become floats.
std::string with_float_literals(const std::string& text) {
    std::string made;
    for (std::size_t i = 0; i < text.size();) {
        const bool starts = std::isdigit(static_cast<unsigned char>(text[i])) != 0 &&
                            (i == 0 || !in_name(text[i - 1]));
        if (!starts) {
            made += text[i++];
            continue;
        }
        std::string number;
        while (i < text.size() && (in_name(text[i]) || text[i] == '.' ||
                                   ((text[i] == '-' || text[i] == '+') && number.back() == 'e'))) {
            number += text[i++];
        }
        made += number + (number.find_first_of(".e") != std::string::npos ? "F" : "");
    }
    return made;
}

// The text of a shader as a C++ function: without metadata, and with references as outputs.
std::string as_cpp(std::string text, const std::string& name) {
    for (std::size_t at = text.find(" [["); at != std::string::npos; at = text.find(" [[", at)) {
        text.erase(at, text.find("]]", at) + 2 - at);
    }
    const std::size_t shader = text.find("shader " + name + "(");
    std::string head = text.substr(0, shader);
    std::string body = text.substr(shader);
    const std::size_t end = body.find(")\n{");
    std::string parameters = body.substr(0, end);
    for (const char* type : {"point", "vector", "color"}) {
        parameters =
            replaced(parameters, fmt::format("output {} ", type), fmt::format("{}& ", type));
    }
    for (const char* value : {"& position = 0.0", "& direction = 0.0", "& throughput = 1.0",
                              "& dPdx = 0.0", "& dPdy = 0.0", "& dDdx = 0.0", "& dDdy = 0.0"}) {
        parameters = replaced(parameters, value,
                              std::string(value).substr(0, std::string(value).find(" =")));
    }
    parameters = replaced(parameters, "shader ", "extern \"C\" void ");
    // Defaults of the parameters before the outputs are no defaults of a function in C++.
    for (std::size_t at = parameters.find(" = "); at != std::string::npos;
         at = parameters.find(" = ", at)) {
        parameters.erase(at, std::min(parameters.size(), parameters.find_first_of(",\n", at)) - at);
    }
    return with_float_literals(head + parameters + body.substr(end));
}

std::string text_of(const std::vector<std::pair<std::string, std::string>>& shaders) {
    std::string text = "#include \"" BALCONY_SOURCE_DIR
                       "/tests/bridge/osl_types.hpp\"\n"
                       "namespace osl { Host host; \n";
    for (const auto& [name, shader] : shaders) {
        text += as_cpp(shader, name);
    }
    return text + "}\n";
}

/// A library of shaders.
class Library : public test::CompiledLibrary {
public:
    explicit Library(const std::vector<std::pair<std::string, std::string>>& shaders)
        : CompiledLibrary(text_of(shaders), "-x c++ -w") {}

    [[nodiscard]] osl::Host& host() const { return *static_cast<osl::Host*>(symbol("host")); }
};

struct Shaded {
    osl::point position = 0.0F;
    osl::vector direction = 0.0F;
    osl::color throughput = 1.0F;
    osl::vector dPdx = 0.0F, dPdy = 0.0F, dDdx = 0.0F, dDdy = 0.0F;
};

// Runs a shader at time 0.
void shade(void* symbol, const std::string& text, int own_focus, Shaded& s) {
    using osl::Triple;
    const bool time = text.find("float camera_time") != std::string::npos;
    const bool focus = text.find("int own_focus") != std::string::npos;
    const auto run = [&](auto... first) {
        using Shader = void (*)(decltype(first)..., Triple&, Triple&, Triple&, Triple&, Triple&,
                                Triple&, Triple&);
        reinterpret_cast<Shader>(symbol)(first..., s.position, s.direction, s.throughput, s.dPdx,
                                         s.dPdy, s.dDdx, s.dDdy);
    };
    if (time && focus) {
        run(0.0F, own_focus);
    } else if (focus) {
        run(own_focus);
    } else if (time) {
        run(0.0F);
    } else {
        run();
    }
}

void set_point(osl::Host& host, const test::PicturePoint& point) {
    host.resolution = {static_cast<float>(test::width), static_cast<float>(test::height), 0.0F};
    host.raster = {static_cast<float>(point.x / test::width),
                   static_cast<float>(1.0 - point.y / test::height), 0.0F};
}

// From Cycles' camera space to the z-up world of a camera's rays.
rays::V3d in_world(const osl::Triple& v) { return {v[2], -v[0], v[1]}; }

rays::Ray ray_of(const Shaded& shaded) {
    rays::Ray ray;
    ray.origin = in_world(shaded.position);
    ray.direction = in_world(shaded.direction);
    ray.valid = shaded.throughput[0] == 1.0F;
    ray.origin_by_x = in_world(shaded.dPdx);
    ray.origin_by_y = -in_world(shaded.dPdy);
    ray.direction_by_x = in_world(shaded.dDdx);
    ray.direction_by_y = -in_world(shaded.dDdy);
    return ray;
}

rays::RayBatch own_rays(const Example& example) {
    const auto program =
        rays::compile(example.camera, test::width, test::height,
                      {.axes = Axes::z_up, .footprints = true, .tiles = false, .points = true});
    std::vector<double> x;
    std::vector<double> y;
    for (const test::PicturePoint& point : test::points()) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run({.x = x, .y = y}, scratch, batch);
    return batch;
}

double relative_difference(const rays::V3d& a, const rays::V3d& b, double scale) {
    return (a - b).length() / (scale + b.length());
}

TEST(OslExport, GivesTheRaysAndTheirFootprints) {
    std::vector<std::pair<std::string, std::string>> shaders;
    for (const Example& example : test::examples()) {
        const auto text = export_camera(*find_export_target("osl"), {example.camera});
        if (text) {
            shaders.emplace_back(example.name, text->text);
        }
    }
    EXPECT_GE(shaders.size() + 3, test::examples().size()) << "only meshes have no formula";
    const Library library(shaders);
    ASSERT_TRUE(library.compiled());
    for (const Example& example : test::examples()) {
        const auto text = std::find_if(shaders.begin(), shaders.end(), [&](const auto& shader) {
            return shader.first == example.name;
        });
        if (text == shaders.end()) {
            continue;
        }
        void* symbol = library.symbol(example.name);
        const rays::RayBatch own = own_rays(example);
        const auto points = test::points();
        for (std::size_t i = 0; i < points.size(); ++i) {
            set_point(library.host(), points[i]);
            Shaded s;
            shade(symbol, text->second, 0, s);
            const rays::Ray exact = own[i];
            const rays::Ray shaded = ray_of(s);
            ASSERT_EQ(shaded.valid, exact.valid) << example.name << " " << i;
            if (!exact.valid) {
                continue;
            }
            EXPECT_LT(rays::pixels_between(exact, shaded, 10.0), 1e-3) << example.name;
            const double size = exact.origin_by_x.length() + exact.origin_by_y.length() +
                                exact.direction_by_x.length() + exact.direction_by_y.length();
            for (const double difference :
                 {relative_difference(shaded.origin_by_x, exact.origin_by_x, size),
                  relative_difference(shaded.origin_by_y, exact.origin_by_y, size),
                  relative_difference(shaded.direction_by_x, exact.direction_by_x, size),
                  relative_difference(shaded.direction_by_y, exact.direction_by_y, size)}) {
                EXPECT_LT(difference, 1e-3) << example.name << " " << i;
            }
        }
    }
}

// Rays through the whole lens meet where Blender's camera is focused, or with own_focus where the
// camera's file says.
TEST(OslExport, FocusesAsBlendersCameraDoes) {
    const char* camera = R"(
        camera portrait {
            map  u = -1 .. 1, v = square
            eye  point(1, 2, 3)
            toward surface(u, v) = [4, u, v]
            lens(0.2, focus = 7)
        })";
    const auto made = lang::make_camera(std::make_shared<const SourceText>("test", camera), "");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    const auto text = export_camera(*find_export_target("osl"), {*made});
    ASSERT_TRUE(text) << to_text(text.diagnostics);
    EXPECT_FALSE(text->single) << "no picture was given";
    const Library library({{"portrait", text->text}});
    ASSERT_TRUE(library.compiled());
    osl::Host& host = library.host();
    set_point(host, {40.0, 30.0});
    host.focal_distance = 5.0F;
    for (const auto& [own_focus, distance] : {std::pair(0, 5.0), {1, 7.0}}) {
        host.aperture = 0.0F;
        Shaded central;
        shade(library.symbol("portrait"), text->text, own_focus, central);
        const rays::Ray middle = ray_of(central);
        const rays::V3d sharp = middle.origin + distance * middle.direction;
        host.aperture = {0.3F, -0.1F, 0.0F};
        Shaded off;
        shade(library.symbol("portrait"), text->text, own_focus, off);
        const rays::Ray ray = ray_of(off);
        EXPECT_NEAR((ray.origin - middle.origin).length(), std::hypot(0.3, 0.1), 1e-6);
        const rays::V3d to_sharp = sharp - ray.origin;
        EXPECT_NEAR((to_sharp % ray.direction).length(), 0.0, 1e-5) << own_focus;
    }
}

// Of a camera with a lens, the rays through its centre are compared, focused as its file says.
TEST(OslExport, IsJudgedByTheFormulasThatItWrites) {
    for (const char* lens : {"", "lens(0.2, focus = 7)"}) {
        const auto made = lang::make_camera(
            std::make_shared<const SourceText>(
                "test", fmt::format("camera c {{ map u = -1 .. 1, v = square  eye point(1e5, 2, 3) "
                                    "toward surface(u, v) = [1e5 + 3, u, v]  {} }}",
                                    lens)),
            "");
        ASSERT_TRUE(made) << to_text(made.diagnostics);
        const auto exported =
            export_camera(*find_export_target("osl"), {*made}, {.judged_in = {{64, 64}}});
        ASSERT_TRUE(exported && exported->single) << to_text(exported.diagnostics);
        EXPECT_EQ(exported->single->rays, 64U * 64U);
        EXPECT_EQ(exported->single->lost, 0U) << lens;
        // Floats have 24 binary digits, so 1e5 is rounded to 1/128 of a unit and the pinhole moves
        // by up to that; the picture is 2 units wide at the distance of 3.
        EXPECT_GT(exported->single->largest, 0.0) << lens;
        EXPECT_LT(exported->single->largest, 1.0) << lens;
    }
}

TEST(OslExport, HasParametersAsSliders) {
    const char* camera = R"(
        // A tower.
        camera tower(radius = 3, turn = 30deg, flat = 0.5) {
            map   u = -1rad .. 1rad, v = -1 .. 1
            eye   superellipsoid(radius, 2, 2, flat, 1/4)
            move  rotate(z, turn)
        })";
    auto opened = lang::Workspace().make_open_camera(
        std::make_shared<const SourceText>("test", camera), "", {});
    ASSERT_TRUE(opened) << to_text(opened.diagnostics);
    ExportSource source{opened->camera};
    for (const lang::OpenParameter& parameter : opened->open) {
        source.parameters.push_back({parameter.name, lang::parameter_input(parameter.name),
                                     parameter.written, parameter.value, parameter.is_angle});
    }
    const auto text = export_camera(*find_export_target("osl"), source);
    ASSERT_TRUE(text) << to_text(text.diagnostics);
    const auto has = [&](const char* part) {
        EXPECT_NE(text->text.find(part), std::string::npos) << part << text->text;
    };
    has("float radius = 3.0 [[ string help = \"radius, 3 in the camera's file\"");
    has("float turn = 30");
    has("string units = \"degrees\"");
    has("radians(turn)");
    has("float flat = 0.5");
    has("float min = 0.0");
}

}  // namespace
}  // namespace balcony::bridge::osl_export_test
