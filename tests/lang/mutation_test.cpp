// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Good and bad files with random changes: there is a camera or picture or there is an error, never
// a crash, and what a camera calls a ray is one, by the program that a renderer runs.
// BALCONY_FUZZ_SEED and BALCONY_FUZZ_TEXTS make it look elsewhere and longer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "../laws/ray_laws.hpp"
#include "support.hpp"

namespace balcony::lang::mutation_test {
namespace {

namespace fs = std::filesystem;

// Stages that the built-in cameras do not have.
constexpr std::string_view more_cameras[] = {
    R"(camera a(w = 2, p = 1.5) {
    place (0.25, 0) .. (1, 0.75)
    map   u = w .. -w, v = 1 .. -1
    warp  zoom(at = (0.6, 0), radius = (0.4, 1), strength = 2.5), shear(0.5, 0), scale(2, at = (1, 1))
    eye   surface(u, v) = [abs(u)^p, u/v, log(1 + v)]
    look  normal(side = back)
    move  mirror(x), stretch(1, 2, 3), affine(x = (1, 1, 0), at = (0, 0, t))
})",
    R"(camera b(r = 1) {
    map    u = -1 .. 1, v = square
    warp   formula(u, v) = [u/(u^2 + v^2), exp(v)], rotate(10deg), affine(u = (1, 2))
    eye    { object line(at = (0, 0, 1), along = (0, 1, 0))  move scale(2, at = (1, 2, 3)) }
    toward { map u = 0deg .. 90deg, v = -180deg .. 180deg  object torus(3, r)  warp translate(1, 2) }
    look   relative
    move   formula(x, y, z) = [x + 0.1*y^2, sqrt(y), z/x], rotate((1, 1, 0), 30deg)
})",
    R"(camera c(gamma = 1/4) {
    map  u = -60deg .. 60deg, v = -40deg .. 40deg
    eye  product(superhyperbola(3, 2, gamma, by = trigonometric),
                 superhyperbola(3, 2, gamma, by = angle_centre))
    look normal
})",
    R"(camera d(gamma = 3/2) {
    map    u = -2 .. 2, v = square
    eye    circle(3)
    toward product(superhyperbola(3, 2, gamma, by = hyperbolic),
                   superellipse(3, 2, gamma, by = trigonometric))
    look   absolute
})",
    R"(camera e(turn = 72deg) {
    map    u = -2 .. 2, v = square
    warp   repeat(5, zoom(at = (0.6, 0), radius = 0.6, strength = 1.4), rotate(turn))
    eye    sphere(2)
    toward plane
    look   blend(normal, relative, weight(u, v) = [1/(1 + u^4)])
    move   coins([(2, 0.9, 0), (0, 1, 2)], strength = 0.6, radius = 0.5)
})",
    R"(camera f {
    map  u = 180deg .. -180deg, v = -1 .. 1
    eye  cylinder(3)
    look normal outward
})"};

constexpr std::string_view more_pictures[] = {
    R"(camera wall { map u = -1 .. 1, v = -0.75 .. 0.75  eye plane  look along((0, 0, 1)) }
camera ball { map u = -90deg .. 90deg, v = -60deg .. 60deg  eye sphere(2)  look normal(outward) }
picture poster 400 x 300 {
    layer wall
    layer ball { place (0.55, 0.6) .. (0.95, 0.9)  clip ellipse  soft 0.1  alpha 0.9  blend screen }
    layer wall { place (0.1, 0.1) .. (0.4, 0.4)  arrange rotate(8deg) }
})"};

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
    for (const std::string_view camera : more_cameras) {
        texts.insert(texts.end(), 7, std::string(camera));
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
        switch (below(10)) {
            case 0: text.insert(at, pieces[below(pieces.size())]); break;
            case 1: text.insert(at, piece()); break;
            case 2: text.erase(at, 1 + below(10)); break;
            case 3: text.resize(at); break;
            case 4:
                if (at < text.size()) {
                    text[at] = static_cast<char>(below(256));
                }
                break;
            default: change_number(text, at);
        }
    }

    // The next number becomes one for which formulas overflow or have no value or no slope.
    void change_number(std::string& text, std::size_t at) {
        static constexpr std::array<std::string_view, 16> numbers = {
            "0",       "-1",     "1e-3",       "1e-200",    "1e150", "1e200",
            "1e308",   "90deg",  "(1/t)",      "(1e200*t)", "u",     "(1/u)",
            "sqrt(u)", "log(v)", "exp(900*u)", "floor(4*v)"};
        const std::size_t begin = text.find_first_of("0123456789", at);
        if (begin != std::string::npos) {
            const std::size_t end = text.find_first_not_of("0123456789.", begin);
            text.replace(begin, end - begin, numbers[below(numbers.size())]);
        }
    }

    std::vector<std::string> texts_;
    std::mt19937 random_;
};

unsigned from_environment(const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

TEST(Mutation, BeginsWithCameras) {
    for (const std::string_view camera : more_cameras) {
        EXPECT_EQ(to_text(test::make(std::string(camera)).diagnostics), "");
    }
}

Result<camera::Picture> make_poster(const std::string& text) {
    return make_picture(std::make_shared<const SourceText>("test.cam", text), "poster");
}

TEST(Mutation, BeginsWithPictures) {
    for (const std::string_view picture : more_pictures) {
        const Result<camera::Picture> made = make_poster(std::string(picture));
        EXPECT_EQ(to_text(made.diagnostics), "");
        ASSERT_TRUE(made);
        EXPECT_EQ(laws::broken_law(*made), "");
    }
}

TEST(Mutation, ThereIsAPictureOrAnError) {
    const unsigned seed = from_environment("BALCONY_FUZZ_SEED", 1996);
    const unsigned texts = from_environment("BALCONY_FUZZ_TEXTS", 10'000) / 10;
    Mutator mutate({std::begin(more_pictures), std::end(more_pictures)}, seed);
    unsigned made_count = 0;
    for (unsigned i = 0; i < texts; ++i) {
        const std::string text = mutate();
        const Result<camera::Picture> made = make_poster(text);
        ASSERT_NE(made.value.has_value(), has_errors(made.diagnostics)) << text;
        if (made) {
            ++made_count;
            ASSERT_EQ(laws::broken_law(*made), "") << text;
        }
    }
    // Most changes break one of the picture's cameras or the picture itself.
    EXPECT_GT(made_count, texts / 20) << "the changes leave too little to try";
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
            ASSERT_EQ(laws::broken_law(*made), "") << text;
        }
    }
    RecordProperty("cameras", static_cast<int>(made_count));
    EXPECT_GT(made_count, texts / 100) << "the changes leave too little to try";
}

}  // namespace
}  // namespace balcony::lang::mutation_test
