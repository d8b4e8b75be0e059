// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a calling program does wrong is an error in every build.

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/bands.hpp"
#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::test::precondition_test {
namespace {

namespace fs = std::filesystem;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Made>
std::optional<Kind> kind_of(const Made& made) {
    EXPECT_FALSE(made);
    return kind_of_errors(made.diagnostics);
}

Film small_film() { return *make_film({.width = 70, .height = 40}); }

camera::Camera some_camera() { return pinhole(view_down_z(0.0, 0.0, 3.0)); }

scene::Scene one_wall() {
    scene::Scene scene;
    add(scene, wall(-2.0F, 1.0F), white());
    return scene;
}

// Vectors of another size than that of the window, one after the other.
std::vector<Film> broken_films() {
    std::vector<Film> films{Film{}};
    const auto broken = [&](const auto& change) { change(films.emplace_back(small_film())); };
    broken([](Film& film) { film.sum.pop_back(); });
    broken([](Film& film) { film.sum.clear(); });
    broken([](Film& film) { film.passes.pop_back(); });
    broken([](Film& film) { film.display.resize(1); });
    broken([](Film& film) { film.mirrored.resize(1); });
    broken([](Film& film) { film.sum_of_squares.resize(1); });
    broken([](Film& film) { film.pixel_passes.resize(1); });
    broken([](Film& film) { film.first_half.resize(1); });
    broken([](Film& film) { film.window.x = std::numeric_limits<std::size_t>::max(); });
    broken([](Film& film) { film.height = 39; });
    return films;
}

TEST(Preconditions, FilmsThatDoNotHoldTogetherAreErrors) {
    const Renderer renderer = renderer_of(one_wall());
    const files::TemporaryFolder folder;
    const fs::path file = folder / "film.exr";
    const std::vector<Film> films = broken_films();
    for (const Film& film : films) {
        SCOPED_TRACE(&film - films.data());
        const auto shared = std::make_shared<Film>(film);
        EXPECT_EQ(kind_of(Job::make(renderer, some_camera(), {}, shared)), Kind::internal);
        EXPECT_EQ(kind_of(encode(film, *display_format("a.png"))), Kind::internal);
        EXPECT_EQ(kind_of_errors(write_exr(film, file)), Kind::internal);
        EXPECT_FALSE(fs::exists(file));
        EXPECT_EQ(automatic_exposure(film), 0.0);
    }
}

TEST(Preconditions, AFilmMayNotBreakBetweenRuns) {
    const Renderer renderer = renderer_of(one_wall());
    const auto film = std::make_shared<Film>(small_film());
    Result<Job> job = Job::make(renderer, some_camera(), {}, film);
    ASSERT_TRUE(job);
    EXPECT_EQ(kind_of(job->run(std::vector<std::uint32_t>{1})), Kind::internal);
    film->layers->normal.pop_back();
    EXPECT_EQ(kind_of(job->run()), Kind::internal);
    film->layers->normal.resize(film->window.size());
    film->sum.pop_back();
    EXPECT_EQ(kind_of(job->run()), Kind::internal);
}

TEST(Preconditions, OutsideTheWindowAFilmIsEmpty) {
    Film film = *make_film({.width = 70, .height = 40, .window = Region{8, 4, 2, 2}});
    film.passes = {3};
    film.sum.assign(4, Color4d(3.0));
    EXPECT_EQ(film.light(8, 4), Color4f(1.0F));
    for (const auto& [x, y] : {std::pair(7, 4), {10, 4}, {8, 3}, {8, 6}, {1 << 30, 1 << 30}}) {
        const auto px = static_cast<std::size_t>(x);
        const auto py = static_cast<std::size_t>(y);
        EXPECT_EQ(film.samples(px, py), 0U);
        EXPECT_EQ(film.pixel(px, py), Color4f(0.0F));
        EXPECT_EQ(film.variance(px, py), Color4d(0.0));
    }
    EXPECT_EQ(film.variance(8, 4), Color4d(0.0));
    EXPECT_EQ(film.tile(1), Region{});
    EXPECT_EQ(Film{}.tile(0), Region{});
}

TEST(Preconditions, AJobIsMadeAgainForItsOwnSceneOnly) {
    const auto film = std::make_shared<Film>(small_film());
    const Renderer renderer = renderer_of(one_wall());
    const Result<Job> job = Job::make(renderer, some_camera(), {}, film);
    ASSERT_TRUE(job);
    EXPECT_TRUE(job->again(renderer, {}, film));
    scene::Scene other = one_wall();
    other.axes = Axes::z_up;
    EXPECT_EQ(kind_of(job->again(renderer_of(other), {}, film)), Kind::usage);
    scene::Scene larger = one_wall();
    add(larger, wall(-3.0F, 1.0F), white());
    EXPECT_EQ(kind_of(job->again(renderer_of(larger), {}, film)), Kind::usage);
}

TEST(Preconditions, IntervalsAreInOrder) {
    const auto scene = std::make_shared<const scene::Scene>(one_wall());
    const Result<Renderer> renderer = Renderer::make(scene);
    ASSERT_TRUE(renderer);
    for (const scene::TimeInterval& interval :
         {scene::TimeInterval{1.0, 0.0}, {0.0, nan}, {nan, 0.0}, {0.0, HUGE_VAL}}) {
        EXPECT_EQ(kind_of(Renderer::make(scene, {.interval = interval})), Kind::usage);
        EXPECT_EQ(kind_of(renderer->moved(scene, interval)), Kind::usage);
    }
}

TEST(Preconditions, NumbersOfSettingsAreInRange) {
    const Renderer renderer = renderer_of(one_wall());
    const auto film = std::make_shared<Film>(small_film());
    const auto refused = [&](const auto& change) {
        Settings settings;
        change(settings);
        return !Job::make(renderer, some_camera(), settings, film);
    };
    EXPECT_FALSE(refused([](Settings&) {}));
    for (const double white : {0.0, -1.0, nan, HUGE_VAL}) {
        EXPECT_TRUE(refused([=](Settings& settings) { settings.sampling.white = white; }));
    }
    for (const float limit : {-1.0F, static_cast<float>(nan)}) {
        EXPECT_TRUE(refused([=](Settings& settings) { settings.path.clamp_indirect = limit; }));
    }
    const FilmLayout layout{.width = 64, .height = 64};
    for (const std::size_t rows : {std::size_t{0}, file_tile_side + 1}) {
        EXPECT_EQ(kind_of(BandedRender::make(renderer, some_camera(), {}, layout, rows)),
                  Kind::internal);
    }
}

TEST(Preconditions, ProbesHaveASizeAndAStep) {
    const Renderer renderer = renderer_of(one_wall());
    for (const ProbeSettings& settings : {ProbeSettings{.width = 0},
                                          {.height = 0},
                                          {.width = std::size_t{1} << 40U},
                                          {.step = 0},
                                          {.time = nan}}) {
        EXPECT_EQ(kind_of(probe(renderer, some_camera(), settings)), Kind::usage);
        EXPECT_EQ(kind_of(explain_miss(renderer, some_camera(), settings)), Kind::usage);
    }
}

}  // namespace
}  // namespace balcony::render::test::precondition_test
