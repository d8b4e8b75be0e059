// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "lang/build/resolved_layer.hpp"

namespace balcony::lang {

/// A picture that was made with some parameters open.
struct OpenAttempt {
    camera::Picture picture;
    std::vector<OpenParameter> numbers;  ///< Its parameters that are constant numbers.
    std::vector<std::string> others;
    std::vector<MovingParameter> moving{};  ///< Of the others.
};

/// Makes a picture with the parameters of some names open.
using MakeOpen = std::function<Result<OpenAttempt>(const std::vector<std::string>& open)>;

/// The picture with as many of the requested parameters open as can be; all without a request.
[[nodiscard]] Result<OpenPicture> open_picture(
    const MakeOpen& make, const std::optional<std::vector<std::string>>& requested);

/// The parameters of a definition, sorted by what they are.
[[nodiscard]] OpenAttempt open_attempt(camera::Picture picture, const ResolvedLayer& found,
                                       const std::vector<Value>& values, Session& session);

/// The source text of a parameter's value: that of its base, or else its default.
[[nodiscard]] std::string default_text(const ResolvedLayer& found,
                                       const DefinitionParameter& parameter);

}  // namespace balcony::lang
