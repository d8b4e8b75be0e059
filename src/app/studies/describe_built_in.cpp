// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include "balcony/studies.hpp"

namespace balcony::app {

Result<std::vector<lang::Description>> describe_built_in() {
    lang::Workspace workspace;
    std::vector<lang::Description> all;
    for (const std::string& name : lang::built_in_cameras()) {
        auto described = workspace.describe(name);
        if (!described) {
            return described;
        }
        for (lang::Description& one : *described) {
            if (one.name == name) {
                all.push_back(std::move(one));
            }
        }
    }
    return all;
}

}  // namespace balcony::app
