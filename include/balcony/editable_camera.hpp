// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Editable camera: a camera of a file or a text with the values that a program gives its
// parameters.

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/camera_export.hpp"
#include "balcony/lang.hpp"
#include "balcony/picture.hpp"
#include "balcony/prepared_scene.hpp"

namespace balcony::app {

/// Belongs to one thread at a time. What it makes may be used anywhere.
class EditableCamera {
public:
    /// A parameter as it stands.
    struct Parameter {
        std::string name;
        std::string written;  ///< The source text of its value.
        /// In radians if it is an angle; nothing if it is no number, or changes with time.
        std::optional<double> value{};
        bool is_angle = false;
        camera::Range limits{};     ///< The values that it may have.
        std::string limits_text{};  ///< The source text; empty without limits.
    };

    /// FILE, FILE:NAME or the name of a built-in camera.
    [[nodiscard]] static Result<EditableCamera> make(const std::string& camera,
                                                     const std::vector<lang::Override>& values,
                                                     const std::stop_token& stop = {});
    /// One of a text, by default the last.
    [[nodiscard]] static Result<EditableCamera> make(const lang::CameraSource& source,
                                                     const std::string& name,
                                                     const std::vector<lang::Override>& values,
                                                     const std::stop_token& stop = {});
    EditableCamera(EditableCamera&&) noexcept;
    EditableCamera& operator=(EditableCamera&&) noexcept;
    ~EditableCamera();
    /// The same camera for other values.
    [[nodiscard]] EditableCamera copy() const;

    [[nodiscard]] const std::string& name() const;
    /// What the author of the file says about it.
    [[nodiscard]] const std::string& comment() const;
    /// In the order of the file.
    [[nodiscard]] const std::vector<Parameter>& parameters();

    /// Gives parameters other values. After an error, nothing has changed.
    [[nodiscard]] Diagnostics set(const std::vector<lang::Override>& values,
                                  const std::stop_token& stop = {});

    /// Puts the camera into a pose, from where its file has it; a scene does not place it then.
    void set_pose(const std::optional<camera::Pose>& pose);
    [[nodiscard]] const std::optional<camera::Pose>& pose() const;

    /// The picture with these values, in this pose.
    [[nodiscard]] const camera::Picture& picture() const;
    /// The same in a scene, which may place it. PreparedScene::picture() has the rest.
    [[nodiscard]] Result<camera::Picture> picture(PreparedScene& scene,
                                                  const std::stop_token& stop = {});
    /// The same with these parameters open, or all that can be, alone or in a scene.
    [[nodiscard]] Result<lang::OpenPicture> open_picture(
        const std::optional<std::vector<std::string>>& open, PreparedScene* scene = nullptr,
        const std::stop_token& stop = {});

    /// As `balcony export` writes it, with these values. Of the request, the title and the comment
    /// are not read.
    [[nodiscard]] Result<CameraExport> export_camera(CameraExportRequest request);

    /// The text of a file with this camera, its values written into it. It has no pose.
    [[nodiscard]] Result<std::string> text();
    /// What tells its picture from that of another camera: the text and the pose.
    [[nodiscard]] Result<std::string> identity();

private:
    struct State;
    explicit EditableCamera(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::app
