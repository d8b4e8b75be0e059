// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a text may have at a place, by the tokens before it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "lang/service/token_places.hpp"

namespace balcony::lang {

struct Expected {
    enum class What : std::uint8_t {
        nothing,     ///< Nothing that is known by name: a new name, a file, ...
        item,        ///< import, let, camera, picture.
        statement,   ///< A keyword of `block`.
        stage,       ///< One of `kind`.
        value,       ///< An expression.
        choice,      ///< One of `parameter`.
        camera,      ///< The name of a camera or a picture.
        coordinate,  ///< u or v of a map.
    };
    /// The innermost call.
    struct Call {
        std::size_t callee = TokenPlaces::none;  ///< Its name; none outside of a call.
        const camera::StageEntry* stage = nullptr;
        bool is_camera = false;
        std::size_t argument = 0;     ///< The number of the argument.
        std::string_view name{};      ///< That of the argument, if it is written.
        bool begins_argument = true;  ///< The argument may be given a name here.
    };

    What what = What::nothing;
    Block block = Block::camera;
    const StatementRow* statement = nullptr;
    camera::StageKind kind = camera::StageKind::object_generator;
    std::optional<int> dimension{};                     ///< Of an object generator.
    bool takes_number = false;                          ///< Instead of the stage.
    const camera::StageParameter* parameter = nullptr;  ///< What the value is for.
    Call call{};
    /// Tokens that name parameters of the formulas around the place, from outside.
    std::vector<std::size_t> formula_parameters{};
};

/// What token i is or, at the end of what is written, may be: by the tokens before it.
[[nodiscard]] Expected expected_at(const TokenPlaces& places, std::size_t i,
                                   TokenPlaces::Around around, const camera::Catalogue& catalogue);

/// The parameter that an argument of a stage is for; null if there is none.
[[nodiscard]] const camera::StageParameter* parameter_of(const camera::StageEntry& row,
                                                         const Expected::Call& call);

/// The parameter of a name; null if there is none.
[[nodiscard]] const camera::StageParameter* find_parameter(const camera::StageEntry& row,
                                                           std::string_view name);

}  // namespace balcony::lang
