// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Requests that programs make: values that no option can have are refused before anything is read.

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/animation.hpp"
#include "balcony/picture_options.hpp"
#include "balcony/studies.hpp"

namespace balcony::app::request_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

template <class Target>
using Changes = std::vector<std::pair<std::string, std::function<void(Target&)>>>;

void expect_refused(const Diagnostics& found, const std::string& member) {
    ASSERT_EQ(found.size(), 1U) << member << to_text(found);
    EXPECT_EQ(found[0].kind, Kind::internal) << member;
    EXPECT_EQ(found[0].message, member + " is out of range");
}

TEST(RequestValues, OutOfRangeAreNamedBeforeAnythingIsRead) {
    const Changes<Request> changes{
        {"SizeRequest::width", [](Request& r) { r.size.width = 0; }},
        {"SizeRequest::height", [](Request& r) { r.size.height = max_side + 1; }},
        {"Request::crop.scale", [](Request& r) { r.crop.scale = 0.0; }},
        {"Request::crop.corners",
         [](Request& r) {
             r.crop.corners = {0.0, nan, 1.0, 1.0};
         }},
        {"Request::samples", [](Request& r) { r.samples = 0; }},
        {"Request::settings.time", [](Request& r) { r.settings.time = nan; }},
        {"Request::light.rotation", [](Request& r) { r.light.rotation = nan; }},
        {"Request::light.strength", [](Request& r) { r.light.strength = -1.0F; }},
        {"Request::light.emission_scale", [](Request& r) { r.light.emission_scale = -1.0F; }},
        {"Request::shutter.duration", [](Request& r) { r.shutter.duration = -1.0; }},
        {"Request::shutter.rate", [](Request& r) { r.shutter.rate.frames = 0.0; }},
        {"Request::stereo.formats", [](Request& r) { r.stereo.formats.resize(3); }},
        {"Request::exposure", [](Request& r) { r.exposure = nan; }},
        {"Request::job.time_limit", [](Request& r) { r.job.time_limit = nan; }},
        {"Request::job.save_every", [](Request& r) { r.job.save_every = 0.0; }},
        {"Request::job.checkpoint_every", [](Request& r) { r.job.checkpoint_every = -1.0; }},
        {"Request::job.film_memory", [](Request& r) { r.job.film_memory = 0.0; }},
        {"Request::job.shard",
         [](Request& r) {
             r.job.shard = render::Shard{2, 2};
         }},
    };
    EXPECT_TRUE(check_request({}).empty());
    for (const auto& [member, change] : changes) {
        Request request{.scene = "there-is-no-such.glb"};
        change(request);
        expect_refused(check_request(request), member);
        expect_refused(Session().render(request).diagnostics, member);
    }
}

TEST(RequestValues, OfAnAnimationAreNamedToo) {
    const Changes<AnimationRequest> changes{
        {"Request::samples", [](AnimationRequest& a) { a.picture.samples = 0; }},
        {"AnimationRequest::frames", [](AnimationRequest& a) { a.frames.emplace(); }},
        {"AnimationRequest::frames",
         [](AnimationRequest& a) {
             a.frames = {2, 1};
         }},
        {"AnimationRequest::frames",
         [](AnimationRequest& a) {
             a.frames = {1, 1};
         }},
        {"AnimationRequest::frames",
         [](AnimationRequest& a) {
             a.frames = {1, max_frame + 1};
         }},
        {"AnimationRequest::start_time", [](AnimationRequest& a) { a.start_time = HUGE_VAL; }},
        {"AnimationRequest::shard",
         [](AnimationRequest& a) {
             a.shard = render::Shard{0, 0};
         }},
        {"AnimationRequest::parts_per_frame", [](AnimationRequest& a) { a.parts_per_frame = 0; }},
        {"AnimationRequest::film.rate",
         [](AnimationRequest& a) {
             a.film = FilmRequest{"film.mp4", {nan, 1.0}};
         }},
    };
    for (const auto& [member, change] : changes) {
        AnimationRequest request{.picture = {.scene = "there-is-no-such.glb"}};
        change(request);
        expect_refused(animate(request).diagnostics, member);
    }
}

TEST(RequestValues, OfStudiesAreNamedToo) {
    const SizeRequest empty{.width = 0};
    expect_refused(check({.files = {"pinhole"}, .size = empty}).diagnostics, "SizeRequest::width");
    expect_refused(locate({.camera = "pinhole", .size = empty}).diagnostics, "SizeRequest::width");
}

TEST(RequestValues, OfFunctionsWithoutDiagnosticsThrow) {
    EXPECT_THROW(static_cast<void>(SizeRequest{}.resolve(0.0)), std::logic_error);
    EXPECT_THROW(static_cast<void>(SizeRequest{}.resolve(nan)), std::logic_error);
    EXPECT_THROW(static_cast<void>(Crop{.scale = -1.0}.scaled(8, 8)), std::logic_error);
}

TEST(RequestValues, AnOptionHasAWord) {
    Request request;
    Diagnostics found;
    request_options().read({{"--samples", {}}}, request, found);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, Kind::internal);
    EXPECT_EQ(found[0].message, "--samples has too few words");
}

}  // namespace
}  // namespace balcony::app::request_test
