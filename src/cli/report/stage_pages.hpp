// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pages of docs/stages, from the catalogue.

#include <string>
#include <vector>

namespace balcony::cli {

struct StagePage {
    std::string file;  ///< Within the folder of the pages.
    std::string text;
};

/// README.md with an index, a page for each kind of stage in Markdown, and each stage's example in
/// examples/. The pages show pictures/KIND-NAME.png for each example, which are made from them.
[[nodiscard]] std::vector<StagePage> stage_pages();

}  // namespace balcony::cli
