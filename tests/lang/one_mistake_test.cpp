// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// One wrong token gives one error: what follows from it is not reported. BALCONY_SHOW_MISTAKES
// prints the texts that give several.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <iostream>

#include "support.hpp"

namespace balcony::lang::one_mistake_test {
namespace {

namespace fs = std::filesystem;

struct Piece {
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The words, numbers and symbols of a text without its comments.
std::vector<Piece> pieces_of(const std::string& text) {
    constexpr std::array<std::string_view, 7> pairs = {"..", "<=", ">=", "==", "!=", "&&", "||"};
    std::vector<Piece> pieces;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = std::string_view(text).substr(at);
        std::size_t length = 1;
        if (rest.starts_with("//")) {
            at += std::min(rest.find('\n'), rest.size());
            continue;
        }
        if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
            ++at;
            continue;
        }
        if (rest.front() == '"') {
            length = std::min(rest.find('"', 1), rest.size() - 1) + 1;
        } else if (is_word(rest.front())) {
            const auto more = [&] {
                return length < rest.size() &&
                       (is_word(rest[length]) ||
                        (rest[length] == '.' && !rest.substr(length).starts_with("..") &&
                         std::isdigit(static_cast<unsigned char>(rest[length - 1])) != 0));
            };
            while (more()) {
                ++length;
            }
        } else if (std::find(pairs.begin(), pairs.end(), rest.substr(0, 2)) != pairs.end()) {
            length = 2;
        }
        pieces.push_back({at, at + length});
        at += length;
    }
    return pieces;
}

std::vector<fs::path> cameras() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(BALCONY_SOURCE_DIR "/cameras")) {
        if (entry.path().extension() == ".cam") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

struct Count {
    std::size_t mistakes = 0;
    std::size_t several = 0;  // Two errors and more.
    std::size_t many = 0;     // Three and more.
};

void add_to(Count& count, const std::string& text, const fs::path& file) {
    const Diagnostics found = test::check(
        CameraSource(std::make_shared<const SourceText>("test.cam", text), file.parent_path()));
    const auto errors = std::count_if(found.begin(), found.end(), [](const Diagnostic& one) {
        return one.severity == Severity::error;
    });
    count.mistakes += errors > 0 ? 1 : 0;
    count.several += errors > 1 ? 1 : 0;
    count.many += errors > 2 ? 1 : 0;
    if (errors > 1 && std::getenv("BALCONY_SHOW_MISTAKES") != nullptr) {
        std::cout << "======== " << errors << '\n' << to_text(found);
    }
}

Count count_mistakes(std::size_t every) {
    constexpr std::array<std::string_view, 6> others = {"zz", "7", ")", "(", ",", "eye"};
    Count count;
    std::size_t number = 0;
    for (const fs::path& file : cameras()) {
        const std::string text = test::read_file(file);
        for (const Piece& piece : pieces_of(text)) {
            const std::string before = text.substr(0, piece.begin);
            const std::string after = text.substr(piece.end);
            const std::string own = text.substr(piece.begin, piece.end - piece.begin);
            std::vector<std::string> texts{before + after, before + own + " " + own + after};
            for (const std::string_view other : others) {
                texts.push_back(test::joined({before, other, after}));
                texts.push_back(test::joined({before, other, " ", own, after}));
            }
            for (const std::string& changed : texts) {
                if (number++ % every == 0) {
                    add_to(count, changed, file);
                }
            }
        }
    }
    return count;
}

TEST(OneMistake, IsOneError) {
    const char* const every = std::getenv("BALCONY_MISTAKES_EVERY");
    const Count count = count_mistakes(every != nullptr ? std::strtoul(every, nullptr, 10) : 101);
    std::cout << count.mistakes << " mistakes, " << count.several << " with two errors and more, "
              << count.many << " with three and more\n";
    EXPECT_GT(count.mistakes, 500U) << "there is too little to try";
    // Of all, 2.8 and 0.3 in a hundred.
    EXPECT_LE(count.several, count.mistakes * 4 / 100);
    EXPECT_LE(count.many, count.mistakes / 100);
}

}  // namespace
}  // namespace balcony::lang::one_mistake_test
