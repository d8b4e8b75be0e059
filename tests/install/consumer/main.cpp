// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cstdio>

#include "balcony/base.hpp"

int main() {
    const auto source = std::make_shared<const balcony::SourceText>("a.cam", "eye tours(3, 1)\n");
    const auto nearest = balcony::nearest_name("tours", {"torus"});
    if (!nearest) {
        return 1;
    }
    const balcony::Diagnostic diagnostic = balcony::error(
        "there is no stage named 'tours'", {source, 4, 9}, "did you mean '" + *nearest + "'?");
    std::fputs(balcony::to_text(diagnostic).c_str(), stdout);
    return 0;
}
