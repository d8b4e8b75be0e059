// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the texts of all languages share: the camera, its formulas, and the names in the text.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/text/c_like.hpp"

namespace balcony::bridge {

/// The base of a class that writes the text of one camera. Its functions have names that begin with
/// the camera's.
class TextExport {
protected:
    /// Reserved are the words of the language and the names that the text needs itself. Something
    /// that is `named_as_camera` has just the camera's name.
    TextExport(const ExportSource& source, CameraFormulas formulas,
               const std::set<std::string_view>& reserved, std::string_view reserved_prefix = {},
               bool named_as_camera = false);
    ~TextExport() = default;
    TextExport(const TextExport&) = delete;
    TextExport& operator=(const TextExport&) = delete;

    /// An input as it is called in the text: a parameter by its name there, others by their own.
    [[nodiscard]] std::string input_name(std::string_view input) const;
    /// The formulas in the words of the language.
    [[nodiscard]] Listing listing(const Dialect& dialect, const InputText& input_text);
    [[nodiscard]] Listing listing(const Dialect& dialect);
    /// The comment before a function that gives the ray of one point, with lines on what its
    /// arguments and results mean.
    [[nodiscard]] std::string comment(const std::vector<std::string>& meaning) const;

    const ExportSource& source_;
    CameraFormulas formulas_;
    Names names_;
    const std::string name_;  ///< The camera's, as the text has it.
    const ParameterNames parameters_;
};

}  // namespace balcony::bridge
