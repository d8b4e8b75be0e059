// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras and pictures as views of a stereo pair.

#include <map>

#include <fmt/format.h>

#include "balcony/picture.hpp"

namespace balcony::camera {

namespace {

using Content = decltype(Layer::content);
using NestedPicture = std::shared_ptr<const Picture>;

/// Makes views of cameras and pictures, of each of them once, so that layers still share them.
class StereoContents {
public:
    explicit StereoContents(StereoViewPointer view) : view_(std::move(view)) {}

    Result<Content> view_of(const Content& content) {
        const auto* picture = std::get_if<NestedPicture>(&content);
        const void* const identity =
            picture != nullptr ? static_cast<const void*>(picture->get())
                               : static_cast<const void*>(&std::get<Camera>(content).parts());
        if (const auto known = made_.find(identity); known != made_.end()) {
            return known->second;
        }
        Result<Content> made =
            picture != nullptr ? view_of(**picture) : view_of(std::get<Camera>(content));
        if (made) {
            made_.emplace(identity, *made);
        }
        return made;
    }

    Result<Picture::Parts> parts_of(const Picture& picture) {
        Picture::Parts made = picture.parts();
        for (Layer& layer : made.layers) {
            Result<Content> content = view_of(layer.content);
            if (!content) {
                return std::move(content.diagnostics);
            }
            layer.content = std::move(*content);
        }
        return made;
    }

private:
    Result<Content> view_of(const Camera& camera) {
        Result<Camera> made = camera.with_stereo(view_);
        return made ? Result<Content>(std::move(*made), std::move(made.diagnostics))
                    : Result<Content>(std::move(made.diagnostics));
    }

    Result<Content> view_of(const Picture& picture) {
        Result<Picture::Parts> parts = parts_of(picture);
        Result<Picture> made = parts ? Picture::make(std::move(*parts))
                                     : Result<Picture>(std::move(parts.diagnostics));
        return made ? Result<Content>(std::make_shared<const Picture>(std::move(*made)))
                    : Result<Content>(std::move(made.diagnostics));
    }

    StereoViewPointer view_;
    std::map<const void*, Content> made_;
};

}  // namespace

Result<Camera> Camera::with_stereo(StereoViewPointer view) const {
    if (parts().stereo) {
        return error(fmt::format("camera '{}' is a view of a stereo pair already", name()), {},
                     "leave its own stereo(...) out, or show it as it is");
    }
    Parts made = parts();
    made.stereo = std::move(view);
    return make(std::move(made));
}

Result<Content> with_stereo(const Content& content, const StereoViewPointer& view) {
    return StereoContents(view).view_of(content);
}

Result<Picture> Picture::with_stereo(const StereoViewPointer& view) const {
    Result<Parts> parts = StereoContents(view).parts_of(*this);
    Result<Picture> made =
        parts ? make(std::move(*parts)) : Result<Picture>(std::move(parts.diagnostics));
    if (made) {
        made->of_layers_ = of_layers_;
    }
    return made;
}

}  // namespace balcony::camera
