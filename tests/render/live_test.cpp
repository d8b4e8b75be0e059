// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameters that move on a job: the picture is that of their values.

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "support.hpp"

namespace balcony::render::test::live_test {
namespace {

constexpr const char* text = R"(
    camera view(width = 1, turn = 0deg, from = 4) {
        aspect 3/2
        map   u = -width .. width, v = -0.6 .. 0.6
        eye   point(0, 0, 0) toward plane((0, 1, 0))
        move  rotate(z, turn), translate(0, -from, 0)
    }
    picture two(share = 1/2, turn = 0deg) {
        aspect 3/2
        layer view
        layer view(turn = turn) {
            alpha share
        }
    })";

lang::CameraSource source() {
    return std::make_shared<const SourceText>("live.cam", std::string(text));
}

scene::Scene ball_before_wall() {
    scene::Scene scene;
    scene.axes = Axes::z_up;
    add(scene, coarse_sphere(1.0F, 48, 24), white());
    add(scene, parallelogram({-2, 3, -9}, {11, 0, 0}, {0, 0, 18}), white());
    return scene;
}

std::vector<camera::KnownInput> inputs(std::initializer_list<camera::KnownInput> values) {
    std::vector<camera::KnownInput> made;
    for (const camera::KnownInput& value : values) {
        made.push_back({lang::parameter_input(value.name), value.value});
    }
    return made;
}

Request request_of(const char* integrator) {
    Request made = request(60, 40, integrator, 2);
    made.ambient = Color3f(0.2F);
    made.path.probes_patches = false;  // They stay those of a job's first values.
    return made;
}

struct Live : testing::TestWithParam<const char*> {
    const Renderer renderer =
        *Renderer::make(std::make_shared<const scene::Scene>(ball_before_wall()));
};
INSTANTIATE_TEST_SUITE_P(Integrators, Live, testing::Values("preview", "direct", "path"));

// Bit for bit that of a job which has had the values from the beginning.
TEST_P(Live, IsTheJobOfItsValues) {
    const auto opened = lang::Workspace().make_open_picture(source(), "view");
    ASSERT_TRUE(opened) << to_text(opened.diagnostics);
    ASSERT_EQ(opened->open.size(), 3U);
    Request settings = request_of(GetParam());
    settings.samples = 24;
    settings.sampling.noise = 0.01;
    const auto shared_film = std::make_shared<Film>(*make_film(settings.layout));
    Film& film = *shared_film;
    Result<Job> job = Job::make(renderer, opened->picture, settings, shared_film);
    ASSERT_TRUE(job) << to_text(job.diagnostics);
    ASSERT_TRUE(job->run());
    ASSERT_GT(film.white, 0.0);
    const std::vector<Color4d> before = film.sum;

    const auto values = inputs({{"width", 0.7}, {"turn", 0.2}});
    ASSERT_TRUE(job->set_inputs(values).empty());
    ASSERT_TRUE(job->run());

    settings.inputs = values;
    const auto shared_other = std::make_shared<Film>(*make_film(settings.layout));
    Film& other = *shared_other;
    const Result<Job> made = Job::make(renderer, opened->picture, settings, shared_other);
    ASSERT_TRUE(made);
    ASSERT_TRUE(Job(*made).run());
    EXPECT_EQ(film.sum, other.sum);
    EXPECT_EQ(film.white, other.white);
    EXPECT_EQ(film.layers->position, other.layers->position);
    EXPECT_NE(film.sum, before);
}

// A formula whose number is known is folded, which rounds otherwise: of a ray, some 1e-16 of its
// length, and less than half a float's step. A ray that this moves across an edge of a facet shows
// another one, in few pixels at most.
TEST_P(Live, IsThePictureThatIsMadeWithItsValues) {
    for (const char* name : {"view", "two"}) {
        const auto opened = lang::Workspace().make_open_picture(source(), name);
        ASSERT_TRUE(opened) << to_text(opened.diagnostics);
        EXPECT_TRUE(opened->closed.empty()) << testing::PrintToString(opened->closed);
        Request settings = request_of(GetParam());
        settings.path.reuse = false;
        const auto shared_film = std::make_shared<Film>(*make_film(settings.layout));
        Film& film = *shared_film;
        Result<Job> job = Job::make(renderer, opened->picture, settings, shared_film);
        ASSERT_TRUE(job) << to_text(job.diagnostics);
        ASSERT_TRUE(job->set_inputs(inputs({{"turn", 0.125}})).empty());
        ASSERT_TRUE(job->run());

        const auto closed = lang::Workspace().make_picture(source(), name, {{"turn", "0.125rad"}});
        ASSERT_TRUE(closed);
        const Rendered made = render(ball_before_wall(), *closed, settings);
        std::size_t others = 0;
        for (std::size_t i = 0; i < film.sum.size(); ++i) {
            const Color4d& a = film.sum[i];
            const Color4d& b = made.film.sum[i];
            others += std::abs(a.r - b.r) > 1e-5 || std::abs(a.a - b.a) > 1e-5 ? 1 : 0;
        }
        EXPECT_LE(others, film.sum.size() / 200) << name;
    }
}

TEST(LiveJob, RefusesAnUnknownInputAndStaysAsItWas) {
    const auto renderer = Renderer::make(std::make_shared<const scene::Scene>(ball_before_wall()));
    const auto opened = lang::Workspace().make_open_picture(source(), "view");
    const Request settings = request_of("preview");
    const auto shared_film = std::make_shared<Film>(*make_film(settings.layout));
    Film& film = *shared_film;
    Result<Job> job = Job::make(*renderer, opened->picture, settings, shared_film);
    ASSERT_TRUE(job);
    ASSERT_TRUE(job->run());
    const std::vector<Color4d> before = film.sum;
    const auto unknown = inputs({{"width", 0.5}, {"wdth", 0.5}});
    EXPECT_NE(to_text(job->set_inputs(unknown)).find("no input 'parameter wdth'"),
              std::string::npos);
    EXPECT_EQ(film.sum, before);
}

}  // namespace
}  // namespace balcony::render::test::live_test
