// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The editors' files know every word that the language knows.

#include <regex>

#include <gtest/gtest.h>

#include "lang/names/value.hpp"
#include "lang/syntax/statement_rows.hpp"
#include "support.hpp"

namespace balcony::lang::editors_test {

namespace {

class Editor : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(Editor, KnowsEveryWord) {
    const std::string text =
        test::read_file(std::filesystem::path(BALCONY_SOURCE_DIR) / "editors" / GetParam());
    std::vector<std::string> words = function_names();
    for (const StatementRow& row : statement_rows()) {
        words.emplace_back(row.keyword);
    }
    words.insert(words.end(),
                 {"import", "camera", "pi", "t", "square", "deg", "rad", "above", "from", "to"});
    for (const std::string& word : words) {
        EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + word + "\\b"))) << word;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Editor,
                         testing::Values("vim/syntax/balcony.vim",
                                         "vscode/syntaxes/balcony-camera.tmLanguage.json"),
                         [](const auto& file) {
                             return std::string(file.param).starts_with("vim") ? "Vim" : "VsCode";
                         });

}  // namespace balcony::lang::editors_test
