// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/studies/check_subjects.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace balcony::app {

namespace {

class SubjectList {
public:
    explicit SubjectList(const CheckRequest& request) : request_(request) {}

    void add(const camera::Picture& picture) {
        const auto [whole_width, whole_height] =
            request_.size.resolve(picture.aspect(), picture.parts().size);
        const auto width = static_cast<double>(whole_width);
        const auto height = static_cast<double>(whole_height);
        for (const camera::ShownCamera& shown :
             shown_cameras(picture.with_fit(request_.size.fit))) {
            CheckSubject subject{shown.camera, picture.only_camera() != nullptr};
            for (const camera::ShownCamera::LayerUse& use : shown.uses) {
                if (!is_wanted(use.layer)) {
                    continue;
                }
                subject.objects = subject.layers.empty() ? use.objects : camera::ObjectFilter();
                if (!subject.by_itself) {
                    subject.layers.push_back({picture.name(), use.layer});
                }
                enlarge(subject, size_of(use, width, height, request_.time));
            }
            if (subject.width > 0.0) {
                join(std::move(subject));
            }
        }
    }

    std::vector<CheckSubject> take() { return std::move(subjects_); }

private:
    [[nodiscard]] bool is_wanted(const std::string& layer) const {
        return request_.layer.empty() || layer == request_.layer ||
               layer.starts_with(request_.layer + ".");
    }

    // Whole pixels, at least one.
    static void enlarge(CheckSubject& subject, const std::array<double, 2>& size) {
        const double width = std::max(1.0, std::round(size[0]));
        const double height = std::max(1.0, std::round(size[1]));
        if (width * height > subject.width * subject.height) {
            subject.width = width;
            subject.height = height;
        }
    }

    void join(CheckSubject subject) {
        const auto known =
            std::find_if(subjects_.begin(), subjects_.end(), [&subject](const CheckSubject& one) {
                return &one.camera.parts() == &subject.camera.parts();
            });
        if (known == subjects_.end()) {
            subjects_.push_back(std::move(subject));
            return;
        }
        known->by_itself = known->by_itself || subject.by_itself;
        known->objects.clear();
        known->layers.insert(known->layers.end(), subject.layers.begin(), subject.layers.end());
        enlarge(*known, {subject.width, subject.height});
    }

    const CheckRequest& request_;
    std::vector<CheckSubject> subjects_;
};

// The requested pictures of a file.
Result<std::vector<camera::Picture>> make_pictures(const CameraArgument& wanted,
                                                   const CheckRequest& request,
                                                   lang::Workspace& workspace) {
    std::string name = wanted.name;
    if (name.empty() && !request.layer.empty()) {
        const auto known = workspace.describe(wanted.file);
        name = known && !known->empty() ? known->back().name : "";
    }
    auto all = workspace.make_all(wanted.file, wanted.overrides, name);
    if (all && !name.empty()) {
        std::erase_if(*all, [&](const camera::Picture& one) { return one.name() != name; });
    }
    return all;
}

}  // namespace

Result<std::vector<CheckSubject>> check_subjects(const std::string& argument,
                                                 const CheckRequest& request,
                                                 lang::Workspace& workspace) {
    const Result<CameraArgument> wanted = read_camera(argument, request.set);
    if (!wanted) {
        return wanted.diagnostics;
    }
    const auto pictures = make_pictures(*wanted, request, workspace);
    if (!pictures) {
        return pictures.diagnostics;
    }
    if (!request.layer.empty() && pictures->front().only_camera() != nullptr) {
        return error(fmt::format("'{}' is a camera, which has no layers", pictures->front().name()),
                     {}, "omit --layer, or name a picture");
    }
    SubjectList list(request);
    for (const camera::Picture& picture : *pictures) {
        list.add(picture);
    }
    std::vector<CheckSubject> subjects = list.take();
    if (!request.layer.empty() && subjects.empty()) {
        return error(
            fmt::format("picture '{}' has no layer {}", pictures->front().name(), request.layer),
            {}, "give its number, counted from 1 at the back: 2, or 3.1 in the picture of layer 3");
    }
    return {std::move(subjects), pictures.diagnostics};
}

std::vector<CheckSubject> check_subjects(const camera::Picture& picture,
                                         const CheckRequest& request) {
    SubjectList list(request);
    list.add(picture);
    return list.take();
}

}  // namespace balcony::app
