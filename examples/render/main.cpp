// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A picture of a scene through a built-in camera, where it shows a point, a turn around the scene
// in three frames, parameters that move while nothing is compiled, and a camera that is edited.

#include <cstdint>
#include <cstdio>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "balcony/animation.hpp"
#include "balcony/app.hpp"
#include "balcony/inputs.hpp"
#include "balcony/live.hpp"
#include "balcony/rays.hpp"
#include "balcony/render.hpp"
#include "balcony/studies.hpp"

using namespace balcony;

int fail(const Diagnostics& diagnostics) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
}

// The rays of a camera for several values of a parameter.
int move_rays() {
    const std::string input = lang::parameter_input("fov");
    const auto lens = lang::Workspace().make_open_camera("fisheye", "", {}, {{"fov"}});
    if (!lens) {
        return fail(lens.diagnostics);
    }
    const auto program = rays::compile(lens->camera, 64, 64, {.inputs = {{input}}});
    if (!program) {
        return fail(program.diagnostics);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (const double fov : {1.0, 2.0}) {
        const std::span value(&fov, 1);
        program->run({.width = 64, .height = 64, .inputs = {&value, 1}}, scratch, batch);
        std::printf("fov %g: %g forward at the left\n", fov, batch.direction(64 * 32).x);
    }
    return 0;
}

// A live view: the picture turns, and each frame is on the film as soon as it is traced.
int move_picture(const std::string& name) {
    auto scene = app::load_scene(name);
    if (!scene) {
        return fail(scene.diagnostics);
    }
    const auto renderer =
        render::Renderer::make(std::make_shared<const scene::Scene>(std::move(*scene)));
    if (!renderer) {
        return fail(renderer.diagnostics);
    }
    const auto turned = lang::Workspace().make_open_picture("panorama", "", {}, {{"yaw"}});
    if (!turned) {
        return fail(turned.diagnostics);
    }
    const auto film = std::make_shared<render::Film>(
        *render::make_film({.width = 64, .height = 32, .data_layers = false}));
    auto job = render::Job::make(*renderer, turned->picture,
                                 {.samples = 1, .integrator = "preview"}, film);
    if (!job) {
        return fail(job.diagnostics);
    }
    for (const double yaw : {0.0, 0.5, 1.0}) {
        const camera::KnownInput moved{lang::parameter_input("yaw"), yaw};
        if (const Diagnostics found = job->set_inputs({&moved, 1}); !found.empty()) {
            return fail(found);
        }
        if (const auto summary = job->run()) {
            std::printf("yaw %g: %g in the middle\n", yaw, film->pixel(32, 16).g);
        }
    }
    return 0;
}

// A camera that is edited: each frame is better than the one before.
int follow_camera(const app::Request& request) {
    auto prepared = app::PreparedScene::make(request);
    if (!prepared) {
        return fail(prepared.diagnostics);
    }
    std::promise<void> rests;
    const auto show = [](const live::Frame& frame) {
        std::printf("%zu x %zu, %zu samples\n", frame.width, frame.height, frame.samples);
    };
    const auto rest = [&rests](std::uint64_t change) {
        if (change == 2) {
            rests.set_value();
        }
    };
    const auto view =
        live::View::make(std::move(*prepared), request, {.frame = show, .rest = rest});
    view->change({.text = "camera seen(turn = 0deg) { map u = 1 .. -1, v = square\n"
                          "eye point(0, 0, 0) toward surface(u, v) = [1, u, v]\n"
                          "move rotate(z, turn) }",
                  .size = {{64, 32}}});
    view->change({.values = {{{"turn", 0.1}}}});
    rests.get_future().wait();
    return 0;
}

int main(int argc, char** argv) {
    app::Request request;
    request.scene = argc > 1 ? argv[1] : "scene.obj";
    request.camera = "panorama";
    request.size.width = 64;
    request.output = "picture.exr";
    request.job.resume = true;
    app::Session session;
    const app::Report picture = session.render(request);
    if (has_errors(picture.diagnostics)) {
        return fail(picture.diagnostics);
    }
    std::printf("%zu x %zu pixels of %s\n", picture.width, picture.height, picture.camera.c_str());

    app::LocateRequest question{.camera = request.camera, .size = request.size};
    question.scene = request.scene;
    question.points = {{1.0, 0.5, 0.25}};
    const Result<app::Located> answer = app::locate(question);
    if (!answer) {
        return fail(answer.diagnostics);
    }
    for (const analyse::Sighting& sighting : answer->sightings) {
        std::printf("the point is at (%g, %g)\n", sighting.position.x, sighting.position.y);
    }

    app::AnimationRequest turn{.picture = request, .frames = app::FrameNumbers{1, 2, 3}};
    turn.picture.camera = "pinhole";
    turn.turntable = true;
    turn.pattern = *app::FramePattern::read("turn.##.exr");
    const app::AnimationReport frames = app::animate(turn);
    if (has_errors(frames.diagnostics)) {
        return fail(frames.diagnostics);
    }
    std::printf("%zu frames, %zu of an earlier run\n", frames.rendered.size(), frames.skipped);
    return move_rays() + move_picture(request.scene) + follow_camera(request);
}
