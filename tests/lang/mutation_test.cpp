// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Good and bad files with random changes: there is a camera or there is an error, never a crash.
// BALCONY_FUZZ_SEED and BALCONY_FUZZ_TEXTS make it look elsewhere and longer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "support.hpp"

namespace balcony::lang {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> seeds() {
    std::vector<fs::path> files;
    for (const char* folder : {BALCONY_SOURCE_DIR "/cameras", BALCONY_BAD_FILES}) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".cam") {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files) {
        // There are many more bad files than good ones, which have more to lose.
        const std::size_t weight = file.parent_path() == BALCONY_BAD_FILES ? 1 : 7;
        texts.insert(texts.end(), weight, test::read_file(file));
    }
    return texts;
}

class Mutator {
public:
    Mutator(std::vector<std::string> texts, unsigned seed)
        : texts_(std::move(texts)), random_(seed) {}

    std::string operator()() {
        std::string text = texts_[below(texts_.size())];
        for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
            change(text);
        }
        return text;
    }

private:
    std::size_t below(std::size_t bound) {
        return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_);
    }

    // A piece of some text: what stands between two random places, not long.
    std::string piece() {
        const std::string& text = texts_[below(texts_.size())];
        return text.empty() ? "" : text.substr(below(text.size()), 1 + below(30));
    }

    void change(std::string& text) {
        static constexpr std::array<std::string_view, 22> pieces = {
            "(",  ")",  "{", "}", "[", "]",     ",", "=",   "..",       "\"",      "/*",
            "*/", "//", "-", "^", "0", "1e308", "t", "deg", "\xcf\x80", "camera ", "map "};
        const std::size_t at = below(text.size() + 1);
        switch (below(5)) {
            case 0: text.insert(at, pieces[below(pieces.size())]); break;
            case 1: text.insert(at, piece()); break;
            case 2: text.erase(at, 1 + below(10)); break;
            case 3: text.resize(at); break;
            default:
                if (at < text.size()) {
                    text[at] = static_cast<char>(below(256));
                }
        }
    }

    std::vector<std::string> texts_;
    std::mt19937 random_;
};

unsigned from_environment(const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

TEST(Mutation, ThereIsACameraOrAnError) {
    const unsigned seed = from_environment("BALCONY_FUZZ_SEED", 1996);
    const unsigned texts = from_environment("BALCONY_FUZZ_TEXTS", 10'000);
    Mutator mutate(seeds(), seed);
    unsigned made_count = 0;
    for (unsigned i = 0; i < texts; ++i) {
        const std::string text = mutate();
        const Result<camera::Camera> made = test::make(text);
        ASSERT_NE(made.value.has_value(), has_errors(made.diagnostics)) << text;
        EXPECT_LE(made.diagnostics.size(), 100U) << text;
        (void)to_text(made.diagnostics);
        if (made) {
            ++made_count;
            (void)test::ray(*made, 3.5, 2.5, 16, 9);
        }
    }
    RecordProperty("cameras", static_cast<int>(made_count));
    EXPECT_GT(made_count, texts / 100) << "the changes leave too little to try";
}

}  // namespace
}  // namespace balcony::lang
