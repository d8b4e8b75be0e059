// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "live/followed_picture.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace balcony::live {

namespace {

const lang::Override* find(const std::vector<lang::Override>& values, const std::string& name) {
    const auto at = std::find_if(values.begin(), values.end(),
                                 [&](const auto& one) { return one.name == name; });
    return at == values.end() ? nullptr : &*at;
}

}  // namespace

bool apply_stereo(const app::PreparedScene& scene,
                  const std::optional<camera::StereoFormat>& stereo, camera::Picture& picture,
                  Diagnostics& found) {
    if (!stereo) {
        return true;
    }
    Result<camera::Picture> seen = scene.in_stereo(picture, *stereo);
    found.insert(found.end(), seen.diagnostics.begin(), seen.diagnostics.end());
    if (seen) {
        picture = std::move(*seen);
    }
    return seen.value.has_value();
}

app::Request with_stereo_of(app::Request request, const Shown& shown) {
    request.stereo.formats.clear();
    if (shown.stereo) {
        request.stereo.formats = {*shown.stereo};
    }
    return request;
}

lang::CameraSource source_of(const Shown& shown, const std::filesystem::path& folder) {
    return {std::make_shared<const SourceText>(std::string(text_name), shown.text), folder};
}

bool FollowedPicture::follow(app::PreparedScene& scene, const Shown& wanted, bool holds,
                             const std::stop_token& stop, Diagnostics& found) {
    if (time_ != wanted.time && !move(scene, wanted.time, stop, found)) {
        return false;
    }
    if ((!picture_ || wanted.text != text_ || wanted.camera != camera_ ||
         wanted.stereo != stereo_) &&
        !make(scene, wanted, {}, stop, found)) {
        return false;
    }
    if (const std::vector<lang::Override> all =
            picture_->all_closed(holds ? with_held(wanted) : wanted.values);
        !can_show(all) && !make(scene, wanted, closed_among(all), stop, found)) {
        return false;
    }
    if (picture_->size() != wanted.size) {
        picture_ = LivePicture(picture_->opened(), wanted.size);
    }
    return true;
}

std::vector<Value> FollowedPicture::with_held(const Shown& wanted) const {
    std::vector<Value> values = wanted.values;
    for (const lang::MovingParameter& one : moving_) {
        const bool is_given = std::any_of(values.begin(), values.end(), [&](const Value& value) {
            return value.parameter == one.number.name;
        });
        if (!is_given) {
            values.push_back({one.number.name, one.at(wanted.time).value});
        }
    }
    return values;
}

// Whether the values that the picture was made with are among these, and the others are open.
bool FollowedPicture::can_show(const std::vector<lang::Override>& values) const {
    const auto is_shown = [&](const lang::Override& one) {
        const lang::Override* const made = find(closed_, one.name);
        return picture_->is_open(one.name) ||
               (made != nullptr && made->expression == one.expression);
    };
    return std::all_of(values.begin(), values.end(), is_shown) &&
           std::all_of(closed_.begin(), closed_.end(), [&](const lang::Override& one) {
               return find(values, one.name) != nullptr;
           });
}

// Those that the picture must be made with. A parameter that changes with time is open once it has
// a value.
std::vector<lang::Override> FollowedPicture::closed_among(
    std::vector<lang::Override> values) const {
    std::erase_if(values, [&](const lang::Override& one) {
        return picture_->is_open(one.name) && find(closed_, one.name) == nullptr;
    });
    return values;
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
    if (made && !apply_stereo(scene, wanted.stereo, made->picture, found)) {
        return false;
    }
    if (made) {
        picture_.emplace(std::move(*made.value), wanted.size);
        text_ = wanted.text;
        camera_ = wanted.camera;
        closed_ = closed;
        stereo_ = wanted.stereo;
        if (closed.empty()) {
            moving_ = picture_->opened().moving;
        }
    }
    return made.value.has_value();
}

}  // namespace balcony::live
