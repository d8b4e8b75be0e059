// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Generates the pages of docs/stages from the catalogue.

#include <string>
#include <vector>

namespace balcony::cli {

struct StagePage {
    std::string file;  ///< Relative to the folder of the pages.
    std::string text;
};

/// Returns README.md with an index, a Markdown page for each kind of stage, and the example of each
/// stage in examples/. The pages refer to pictures/KIND-NAME.png, a picture of each example.
[[nodiscard]] std::vector<StagePage> stage_pages();

}  // namespace balcony::cli
