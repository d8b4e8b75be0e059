// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rows of options: each reads words into values and writes values as words.

#include <map>

#include <gtest/gtest.h>

#include "balcony/picture_options.hpp"

namespace balcony::app::options_test {
namespace {

// A word that is not the default of each option, as it is written back; none is the same word.
const std::map<std::string, std::pair<std::string, std::string>>& examples() {
    static const std::map<std::string, std::pair<std::string, std::string>> words{
        {"--add", {"lamp.glb", ""}},
        {"--camera", {"my.cam:closeup", ""}},
        {"--set", {"fov=60deg", ""}},
        {"--solve", {"marks.yml", ""}},
        {"--unit", {"mm", ""}},
        {"--mm-per-pixel", {"0.5", ""}},
        {"--fit", {"true", ""}},
        {"--no-fit", {"true", ""}},
        {"--fit-to", {"vase", ""}},
        {"--from", {"1,1.6,-2", ""}},
        {"--lamp", {"point 100 at 1,2,3", ""}},
        {"--lamp-at-eye", {"true", ""}},
        {"--duration", {"2.5", ""}},
        {"--time", {"0.5", ""}},
        {"--shutter", {"1/50", "0.02"}},
        {"--glass", {"solid", ""}},
        {"--inside", {"pass", ""}},
        {"--shutter-shape", {"trapezoid", ""}},
        {"--fps", {"30000/1001", ""}},
        {"--stereo", {"files", ""}},
        {"--separation", {"0.1", ""}},
        {"--convergence", {"2.5", ""}},
        {"--baseline", {"level", ""}},
        {"--merge", {"45,90", ""}},
        {"--size", {"320X200", "320x200"}},
        {"--width", {"+32", "32"}},
        {"--height", {"20", ""}},
        {"--aspect", {"fill", ""}},
        {"--crop", {"40x30+10+5", ""}},
        {"--scale", {"0.5", "50%"}},
        {"--samples", {"64", ""}},
        {"--noise", {"0.25", ""}},
        {"--seed", {"4294967295", ""}},
        {"--filter", {"box", ""}},
        {"--integrator", {"direct", ""}},
        {"--bounces", {"2", "all=2,diffuse=2,glossy=2,transmission=2"}},
        {"--clamp", {"1.5", ""}},
        {"--exact", {"true", ""}},
        {"--no-path-reuse", {"true", ""}},
        {"--environment", {"1,2,3", ""}},
        {"--environment-rotation", {"90deg", "90"}},
        {"--environment-strength", {"2", ""}},
        {"--sun-angle", {"45", ""}},
        {"--emission-scale", {"683", ""}},
        {"--exposure", {"-1.5", ""}},
        {"--view-transform", {"filmic", ""}},
        {"--ambient", {"0.5", ""}},
        {"--background", {"white", "1"}},
        {"--layers", {"none", ""}},
        {"--denoise", {"true", ""}},
        {"--denoiser", {"features", ""}},
        {"--no-dither", {"true", ""}},
        {"--dpi", {"300", ""}},
        {"--texture-memory", {"512", "512MiB"}},
        {"--time-limit", {"1.5min", "90s"}},
        {"--save-every", {"10s", ""}},
        {"--display", {"localhost:14158", ""}},
        {"--checkpoint-every", {"off", ""}},
        {"--film-memory", {"4GiB", ""}},
        {"--resume", {"true", ""}},
        {"--shard", {"2/5", ""}},
        {"--threads", {"3", ""}},
        {"--frames", {"1-3,5", "1-3,5"}},
        {"--start-time", {"1.5", ""}},
        {"--turntable", {"true", ""}},
        {"--around", {"vase", ""}},
        {"--output", {"frame.####.png", ""}},
        {"--crf", {"18", ""}},
        {"--keep-frames", {"true", ""}},
        {"--overwrite", {"true", ""}},
        {"--same-noise", {"true", ""}},
        {"--parts-per-frame", {"4", ""}},
    };
    return words;
}

// A target to begin with: --crf is the quality of a film.
template <class Target>
Target target_for(const OptionInfo&) {
    return {};
}
template <>
AnimationRequest target_for(const OptionInfo& row) {
    AnimationRequest animation;
    if (row.name == "--crf") {
        animation.film.emplace();
    }
    return animation;
}

template <class Target>
void expect_rows_write_what_they_have_read(const Options<Target>& options) {
    for (const Option<Target>& row : options.rows) {
        ASSERT_TRUE(examples().contains(row.name)) << row.name << " needs an example";
        const auto& [word, other] = examples().at(row.name);
        const std::vector<std::string> written{other.empty() ? word : other};
        for (const std::vector<std::string>& words : {std::vector{word}, written}) {
            Target target = target_for<Target>(row);
            Diagnostics found;
            EXPECT_NE(row.write(target), written) << row.name << " has the default";
            row.read(words, target, found);
            EXPECT_TRUE(found.empty()) << row.name << ": " << to_text(found);
            EXPECT_EQ(row.write(target), written) << row.name;
        }
    }
}

TEST(OptionRow, WritesWhatItHasRead) {
    expect_rows_write_what_they_have_read(request_options());
    expect_rows_write_what_they_have_read(animation_options());
}

template <class Target>
void expect_rows_refuse_a_word(const Options<Target>& options) {
    for (const Option<Target>& row : options.rows) {
        if (row.type == OptionType::flag || row.repeated || row.name == "--camera" ||
            row.name == "--solve" || row.name == "--fit-to" || row.name == "--around" ||
            row.name == "--environment") {
            continue;
        }
        Target target;
        Diagnostics found;
        row.read(std::vector<std::string>{"?!"}, target, found);
        ASSERT_EQ(found.size(), 1U) << row.name;
        const std::string begin = row.name == "--output" ? "'?!'" : row.name;
        EXPECT_TRUE(found.front().message.starts_with(begin)) << found.front().message;
        EXPECT_EQ(found.front().kind, Kind::usage) << row.name;
        EXPECT_FALSE(found.front().remedy.empty()) << row.name;
    }
}

TEST(OptionRow, RefusesAWordByTheNameOfItsOption) {
    expect_rows_refuse_a_word(request_options());
    expect_rows_refuse_a_word(animation_options());
}

template <class Target>
void expect_rows_refuse_an_empty_word(const Options<Target>& options) {
    for (const Option<Target>& row : options.rows) {
        if (row.type == OptionType::flag) {
            continue;
        }
        Target target;
        Diagnostics found;
        Options<Target>{{row}}.read({{row.name, {""}}}, target, found);
        ASSERT_EQ(found.size(), 1U) << row.name;
        EXPECT_EQ(found.front().message, row.name + " cannot be ''");
        EXPECT_EQ(found.front().kind, Kind::usage) << row.name;
    }
}

TEST(OptionRow, RefusesAnEmptyWord) {
    expect_rows_refuse_an_empty_word(request_options());
    expect_rows_refuse_an_empty_word(animation_options());
}

TEST(OptionRow, HasTheDefaultOfItsTarget) {
    std::map<std::string, std::string> defaults;
    for (const Option<Request>& row : request_options().rows) {
        defaults[row.name] = row.fallback;
    }
    EXPECT_EQ(defaults["--noise"], "0");
    EXPECT_EQ(defaults["--checkpoint-every"], "60s");
    EXPECT_EQ(defaults["--texture-memory"], "1GiB");
    EXPECT_EQ(defaults["--view-transform"], "neutral");
    EXPECT_EQ(defaults["--fps"], "24");
    EXPECT_EQ(defaults["--bounces"], "auto");
    EXPECT_EQ(defaults["--background"], "auto");
    EXPECT_EQ(defaults["--separation"], "");
    EXPECT_EQ(defaults["--samples"], "");
}

TEST(OptionRow, IsCheckedTogetherWithOthers) {
    const auto errors_of = [](const GivenWords& given) {
        Request request;
        Diagnostics found;
        request_options().read(given, request, found);
        return found.size();
    };
    EXPECT_EQ(errors_of({}), 0U);
    EXPECT_EQ(errors_of({{"--set", {"fov=1"}}}), 1U);
    EXPECT_EQ(errors_of({{"--size", {"8x8"}}, {"--width", {"8"}}}), 1U);
    EXPECT_EQ(errors_of({{"--separation", {"0.1"}}}), 1U);
    EXPECT_EQ(errors_of({{"--separation", {"0.1"}}, {"--stereo", {"anaglyph"}}}), 0U);
    EXPECT_EQ(errors_of({{"--shard", {"1/2"}}, {"--save-every", {"1min"}}}), 1U);
}

TEST(OptionRow, OfAnAnimationIsCheckedTogetherWithOthers) {
    const auto errors_of = [](const GivenWords& given) {
        AnimationRequest animation;
        Diagnostics found;
        animation_options().read(given, animation, found);
        return found.size();
    };
    EXPECT_EQ(errors_of({{"--output", {"film.mp4"}}, {"--crf", {"20"}}}), 0U);
    EXPECT_EQ(errors_of({{"--output", {"frame.##.png"}}, {"--crf", {"20"}}}), 1U);
    EXPECT_EQ(errors_of({{"--output", {"frame.##.png"}}, {"--keep-frames", {"true"}}}), 1U);
    EXPECT_EQ(errors_of({{"--output", {"film.mp4"}}, {"--stereo", {"files"}}}), 1U);
}

TEST(OptionRow, OfAnAnimationMakesAFilmOrASequence) {
    AnimationRequest film;
    AnimationRequest sequence;
    Diagnostics found;
    animation_options().read(
        {{"--output", {"film.mp4"}}, {"--fps", {"30"}}, {"--around", {"vase"}}}, film, found);
    animation_options().read({{"--output", {"frame.##.png"}}}, sequence, found);
    EXPECT_TRUE(found.empty()) << to_text(found);
    ASSERT_TRUE(film.film);
    EXPECT_EQ(film.film->file, "film.mp4");
    EXPECT_EQ(film.film->rate, (FrameRate{30.0, 1.0}));
    EXPECT_TRUE(film.turntable);
    EXPECT_FALSE(sequence.film);
    EXPECT_EQ(sequence.pattern.file(7), "frame.07.png");
    EXPECT_FALSE(sequence.turntable);
}

}  // namespace
}  // namespace balcony::app::options_test
