// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The built-in cameras for laws that hold for all: without those that are pictures of several
// layers, which have no rays of their own, and with one of the maps, which are one stage and have a
// test of their own.

#include <string>
#include <vector>

#include "balcony/lang.hpp"

namespace balcony::laws {

inline std::vector<std::string> single_built_in_cameras() {
    std::vector<std::string> names = lang::built_in_cameras();
    std::erase_if(names, [](const std::string& name) {
        if (lang::family_of(name) == "maps") {
            return name != "mercator";
        }
        const Result<camera::Picture> made = lang::make_picture(name, "");
        return made && made->only_camera() == nullptr;
    });
    return names;
}

}  // namespace balcony::laws
