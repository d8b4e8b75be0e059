// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A picture of a scene through a built-in camera, where it shows a point, and a turn around the
// scene in three frames.

#include <cstdio>

#include "balcony/animation.hpp"
#include "balcony/app.hpp"
#include "balcony/studies.hpp"

using namespace balcony;

int fail(const Diagnostics& diagnostics) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
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
}
