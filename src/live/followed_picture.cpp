// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "live/followed_picture.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace balcony::live {

namespace {

bool is_same(const std::vector<lang::Override>& a, const std::vector<lang::Override>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const lang::Override& one, const lang::Override& other) {
                          return one.name == other.name && one.expression == other.expression;
                      });
}

}  // namespace

lang::CameraSource source_of(const Shown& shown, const std::filesystem::path& folder) {
    return {std::make_shared<const SourceText>(std::string(text_name), shown.text), folder};
}

bool FollowedPicture::follow(app::PreparedScene& scene, const Shown& wanted,
                             const std::stop_token& stop, Diagnostics& found) {
    if (time_ != wanted.time && !move(scene, wanted.time, stop, found)) {
        return false;
    }
    if ((!picture_ || wanted.text != text_ || wanted.camera != camera_) &&
        !make(scene, wanted, {}, stop, found)) {
        return false;
    }
    if (const std::vector<lang::Override> closed = picture_->closed_among(wanted.values);
        !is_same(closed, closed_) && !make(scene, wanted, closed, stop, found)) {
        return false;
    }
    if (picture_->size() != wanted.size) {
        picture_ = LivePicture(picture_->opened(), wanted.size);
    }
    return true;
}

// Moves the scene, and the picture that there is with it.
bool FollowedPicture::move(app::PreparedScene& scene, double time, const std::stop_token& stop,
                           Diagnostics& found) {
    time_.reset();
    found = scene.set_time(time);
    if (picture_) {
        const Diagnostics more = scene.prepare(picture_->opened().picture, stop);
        found.insert(found.end(), more.begin(), more.end());
        picture_->expire();
    }
    if (!has_errors(found)) {
        time_ = time;
    }
    return time_.has_value();
}

bool FollowedPicture::make(app::PreparedScene& scene, const Shown& wanted,
                           const std::vector<lang::Override>& closed, const std::stop_token& stop,
                           Diagnostics& found) {
    Result<lang::OpenPicture> made =
        scene.picture(source_of(wanted, folder_), wanted.camera, closed, stop);
    found = std::move(made.diagnostics);
    if (made) {
        picture_.emplace(std::move(*made.value), wanted.size);
        text_ = wanted.text;
        camera_ = wanted.camera;
        closed_ = closed;
    }
    return made.value.has_value();
}

}  // namespace balcony::live
