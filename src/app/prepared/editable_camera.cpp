// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/editable_camera.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/inputs.hpp"

namespace balcony::app {

using lang::Override;
using Names = std::vector<std::string>;

namespace {

// All that two copies of a camera have in common.
struct Facts {
    lang::CameraSource source;
    std::string name;
    std::vector<Override> values;
    std::string comment{};
    std::vector<EditableCamera::Parameter> parameters{};
    bool has_values = false;  // Of the parameters.
    std::optional<camera::Pose> pose{};
    std::optional<camera::Picture> made{};     // As its file has it.
    std::optional<camera::Picture> picture{};  // In its pose.
};

// The last of some values for a parameter; null if there is none.
const Override* find(const std::vector<Override>& values, const std::string& name) {
    const auto found = std::find_if(values.rbegin(), values.rend(),
                                    [&](const Override& one) { return one.name == name; });
    return found == values.rend() ? nullptr : &*found;
}

const lang::OpenParameter* find(const std::vector<lang::OpenParameter>& parameters,
                                const std::string& name) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const auto& one) { return one.name == name; });
    return found == parameters.end() ? nullptr : &*found;
}

}  // namespace

struct EditableCamera::State : Facts {
    explicit State(Facts facts) : Facts(std::move(facts)) {}

    lang::Workspace workspace{};

    void place() { picture = pose ? made->with_pose(*pose) : *made; }
    [[nodiscard]] Diagnostics make(const std::stop_token& stop);
    [[nodiscard]] Diagnostics describe();
    void find_values();
};

// What the declaration says, whatever the values are.
Diagnostics EditableCamera::State::describe() {
    const auto all = workspace.describe(source);
    if (!all) {
        return all.diagnostics;
    }
    for (const lang::Description& one : *all) {
        if (one.name == name) {
            comment = one.comment;
            for (const auto& parameter : one.parameters) {
                parameters.push_back({parameter.name,
                                      parameter.default_text,
                                      {},
                                      false,
                                      parameter.limits,
                                      parameter.limits_text});
            }
        }
    }
    return {};
}

// Numbers are known of parameters that are open, or cannot be.
void EditableCamera::State::find_values() {
    const auto opened = workspace.make_open_picture(source, name, values);
    for (Parameter& parameter : parameters) {
        if (const Override* const set = find(values, parameter.name)) {
            parameter.written = set->expression;
        }
        const lang::OpenParameter* found = opened ? find(opened->open, parameter.name) : nullptr;
        if (opened && found == nullptr) {
            found = find(opened->numbers, parameter.name);
        }
        parameter.value = found != nullptr ? std::optional(found->value) : std::nullopt;
        parameter.is_angle = found != nullptr && found->is_angle;
    }
    has_values = true;
}

Diagnostics EditableCamera::State::make(const std::stop_token& stop) {
    workspace.stop_with(stop);
    Result<camera::Picture> result = workspace.make_picture(source, name, values);
    workspace.stop_with({});
    if (!result) {
        return std::move(result.diagnostics);
    }
    if (!made) {
        name = result->name();
        if (Diagnostics found = describe(); has_errors(found)) {
            return found;
        }
    }
    made = std::move(*result);
    has_values = false;
    place();
    return std::move(result.diagnostics);
}

EditableCamera::EditableCamera(std::unique_ptr<State> state) : state_(std::move(state)) {}
EditableCamera::EditableCamera(EditableCamera&&) noexcept = default;
EditableCamera& EditableCamera::operator=(EditableCamera&&) noexcept = default;
EditableCamera::~EditableCamera() = default;

Result<EditableCamera> EditableCamera::make(const std::string& camera,
                                            const std::vector<Override>& values,
                                            const std::stop_token& stop) {
    const Result<CameraArgument> wanted = read_camera(camera, {});
    return wanted ? make(wanted->file, wanted->name, values, stop)
                  : Result<EditableCamera>(wanted.diagnostics);
}

Result<EditableCamera> EditableCamera::make(const lang::CameraSource& source,
                                            const std::string& name,
                                            const std::vector<Override>& values,
                                            const std::stop_token& stop) {
    auto state = std::make_unique<State>(Facts{source, name, values});
    Diagnostics found = state->make(stop);
    if (has_errors(found)) {
        return found;
    }
    return {EditableCamera(std::move(state)), std::move(found)};
}

EditableCamera EditableCamera::copy() const {
    return EditableCamera(std::make_unique<State>(static_cast<const Facts&>(*state_)));
}

const std::string& EditableCamera::name() const { return state_->name; }
const std::string& EditableCamera::comment() const { return state_->comment; }
const std::vector<EditableCamera::Parameter>& EditableCamera::parameters() {
    if (!state_->has_values) {
        state_->find_values();
    }
    return state_->parameters;
}
const camera::Picture& EditableCamera::picture() const { return *state_->picture; }

Diagnostics EditableCamera::set(const std::vector<Override>& values, const std::stop_token& stop) {
    std::vector<Override> before = state_->values;
    for (const Override& value : values) {
        std::erase_if(state_->values, [&](const Override& one) { return one.name == value.name; });
        state_->values.push_back(value);
    }
    Diagnostics found = state_->make(stop);
    if (has_errors(found)) {
        state_->values = std::move(before);
    }
    return found;
}

void EditableCamera::set_pose(const std::optional<camera::Pose>& pose) {
    state_->pose = pose;
    state_->place();
}

const std::optional<camera::Pose>& EditableCamera::pose() const { return state_->pose; }

Result<camera::Picture> EditableCamera::picture(PreparedScene& scene, const std::stop_token& stop) {
    auto made = open_picture(Names(), &scene, stop);
    return made ? Result<camera::Picture>(std::move(made->picture), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

Result<lang::OpenPicture> EditableCamera::open_picture(const std::optional<Names>& open,
                                                       PreparedScene* scene,
                                                       const std::stop_token& stop) {
    State& own = *state_;
    if (scene != nullptr && !own.pose) {
        return scene->picture(own.source, own.name, own.values, stop, open);
    }
    own.workspace.stop_with(stop);
    auto made = own.workspace.make_open_picture(own.source, own.name, own.values, open);
    own.workspace.stop_with({});
    if (made && own.pose) {
        made->picture = made->picture.with_pose(*own.pose);
    }
    if (made && scene != nullptr) {
        Diagnostics found = scene->prepare(made->picture, stop);
        made.diagnostics.insert(made.diagnostics.end(), found.begin(), found.end());
        if (has_errors(found)) {
            made.value.reset();
        }
    }
    return made;
}

Result<CameraExport> EditableCamera::export_camera(CameraExportRequest request) {
    const auto opened = open_picture(parameters_for(*request.target));
    if (!opened) {
        return opened.diagnostics;
    }
    request.title = state_->name;
    for (const Override& one : state_->values) {
        request.title += fmt::format(" --set {}={}", one.name, one.expression);
    }
    request.comment = state_->comment;
    return app::export_camera(*opened, request);
}

Result<std::string> EditableCamera::text() {
    return state_->workspace.with_values(state_->source, state_->name, state_->values);
}

Result<std::string> EditableCamera::identity() {
    Result<std::string> made = text();
    if (made && pose()) {
        for (std::size_t row = 0; row < 3; ++row) {
            *made += fmt::format("\n{} {}", fmt::join(pose()->rotation[row], " "),
                                 pose()->position[row]);
        }
    }
    return made;
}

}  // namespace balcony::app
