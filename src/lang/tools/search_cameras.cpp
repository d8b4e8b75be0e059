// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cctype>

#include "balcony/lang.hpp"
#include "lang/built_in_cameras.hpp"

namespace balcony::lang {

namespace {

// How much a word says about a camera, by where it is in its file.
enum Weight : int {
    nowhere = 0,
    in_text = 1,
    in_use = 3,
    in_family = 4,
    in_keywords = 8,
    in_name = 12
};

constexpr std::string_view keywords_mark = "// Keywords: ";

// Words in lower case without those that say nothing.
std::vector<std::string> words_of(std::string_view text) {
    constexpr std::array<std::string_view, 22> empty{
        "a",    "an", "and", "as", "at", "by", "camera",  "for", "from", "how", "in",
        "into", "is", "it",  "my", "of", "on", "picture", "the", "this", "to",  "with"};
    std::vector<std::string> words;
    std::string word;
    const auto finish = [&] {
        if (!word.empty() && std::find(empty.begin(), empty.end(), word) == empty.end()) {
            words.push_back(word);
        }
        word.clear();
    };
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else {
            finish();
        }
    }
    finish();
    return words;
}

// Without an ending, so that "flattens", "flattened" and "flattening" are one word.
std::string_view stem_of(std::string_view word) {
    for (const std::string_view ending : {"ing", "ed", "es", "s"}) {
        if (word.size() > ending.size() + 2 && word.ends_with(ending)) {
            return word.substr(0, word.size() - ending.size());
        }
    }
    return word;
}

bool contains(const std::vector<std::string>& words, const std::string& wanted) {
    return std::any_of(words.begin(), words.end(), [&wanted](const std::string& word) {
        return stem_of(word) == stem_of(wanted);
    });
}

bool contains_beginning(const std::vector<std::string>& words, const std::string& wanted) {
    constexpr std::size_t shortest = 4;
    return contains(words, wanted) ||
           (wanted.size() >= shortest &&
            std::any_of(words.begin(), words.end(),
                        [&wanted](const std::string& word) { return word.starts_with(wanted); }));
}

/// A camera's words by weight.
struct Index {
    explicit Index(const BuiltInCamera& camera)
        : name(words_of(camera.name)), family(words_of(camera.family)) {
        bool first = true;
        for (std::size_t begin = 0; begin < camera.text.size();) {
            const std::size_t end = std::min(camera.text.find('\n', begin), camera.text.size());
            const std::string_view line = camera.text.substr(begin, end - begin);
            begin = end + 1;
            if (line.starts_with(keywords_mark)) {
                keywords = words_of(line.substr(keywords_mark.size()));
            } else if (line.starts_with("//")) {
                const std::vector<std::string> words = words_of(line);
                std::vector<std::string>& place = first ? use : text;
                place.insert(place.end(), words.begin(), words.end());
                first = false;
            }
        }
    }

    [[nodiscard]] Weight weight_of(const std::string& word) const {
        return contains(name, word)             ? in_name
               : contains(keywords, word)       ? in_keywords
               : contains(family, word)         ? in_family
               : contains_beginning(use, word)  ? in_use
               : contains_beginning(text, word) ? in_text
                                                : nowhere;
    }

    std::vector<std::string> name, family, keywords, use, text;
};

struct Found {
    CameraMatch match;
    std::size_t words = 0;
    bool is_map = false;
    int weight = 0;
};

}  // namespace

std::vector<CameraMatch> search_built_in_cameras(std::string_view words) {
    const std::vector<std::string> wanted = words_of(words);
    std::vector<Found> all;
    std::size_t most = 0;
    for (const BuiltInCamera& camera : built_in_camera_files()) {
        const Index index(camera);
        Found found{{std::string(camera.name), true}, 0, camera.family == map_family, 0};
        for (const std::string& word : wanted) {
            const Weight weight = index.weight_of(word);
            found.words += weight != nowhere ? 1 : 0;
            found.weight += weight;
            found.match.is_named = found.match.is_named && weight >= in_family;
        }
        most = std::max(most, found.words);
        all.push_back(std::move(found));
    }
    // Those with most of the words, and at least half of them.
    std::erase_if(all, [&](const Found& one) {
        return most == 0 || one.words < most || 2 * one.words < wanted.size();
    });
    std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
        return a.is_map != b.is_map ? b.is_map : a.weight > b.weight;
    });
    std::vector<CameraMatch> matches;
    for (Found& one : all) {
        matches.push_back(std::move(one.match));
    }
    return matches;
}

}  // namespace balcony::lang
