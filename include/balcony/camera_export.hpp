// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Camera export: the cameras of files and texts in other languages.
//
//     lang::OpenCamera ─▶ export_camera() ─▶ CameraExport: the text, and what it is good for

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/export.hpp"
#include "balcony/lang.hpp"

namespace balcony::app {

struct CameraExportRequest {
    const bridge::ExportTarget* target = nullptr;  ///< The language. Must not be null.
    std::string title{};         ///< Where the camera comes from, as bridge::ExportSource::title.
    std::string comment{};       ///< As bridge::ExportSource::comment.
    bool single = false;         ///< Single precision, where the language has both.
    bool inverse = false;        ///< Also a function from points to positions, where it has one.
    std::optional<Axes> axes{};  ///< As bridge::ExportOptions::axes.
    /// In which single precision is judged, in pixels.
    std::array<std::size_t, 2> size{1280, 720};
};

struct CameraExport {
    std::string text;
    std::vector<std::string> open;    ///< The parameters that stay open in the text.
    std::vector<std::string> closed;  ///< Those that cannot.
    /// What single precision changes, if the text has it.
    std::optional<bridge::SinglePrecision> single{};
};

/// Open parameters as those of a text.
[[nodiscard]] std::vector<bridge::ExportParameter> export_parameters(
    const std::vector<lang::OpenParameter>& open);

/// The parameters that suit a language: nothing for all that can be open, or no names for none.
[[nodiscard]] std::optional<std::vector<std::string>> parameters_for(
    const bridge::ExportTarget& target);

/// Writes a camera with its open parameters. What other programs cannot do or will show otherwise
/// is a warning; errors are as those of bridge::export_camera().
[[nodiscard]] Result<CameraExport> export_camera(const lang::OpenCamera& opened,
                                                 const CameraExportRequest& request);

/// The same of a picture that is one camera; one with layers is an error.
[[nodiscard]] Result<CameraExport> export_camera(const lang::OpenPicture& opened,
                                                 const CameraExportRequest& request);

/// What the author of a camera says about it in its text; empty if that is nothing.
[[nodiscard]] std::string comment_of(lang::Workspace& workspace, const lang::CameraSource& source,
                                     const std::string& camera);

}  // namespace balcony::app
