// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/film_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/animation/program_run.hpp"
#include "app/words.hpp"
#include "balcony/output_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

struct Encoder {
    std::string_view name;
    std::string_view options;     // Words between blanks.
    std::string_view crf_option;  // Empty if it has none.
    double crf = 0.0;             // Unless another is asked for.
    double max_crf = 0.0;
};

// H.264 plays everywhere. Builds of ffmpeg without x264 have one of the others.
constexpr std::array h264{
    Encoder{"libx264", "-preset medium", "-crf", 18.0, 51.0},
    Encoder{"libopenh264", "-b:v 16M", "", 0.0, 0.0},
    Encoder{"mpeg4", "-q:v 2", "", 0.0, 0.0},
};
constexpr std::array vp9{
    Encoder{"libvpx-vp9", "-b:v 0 -row-mt 1 -cpu-used 2", "-crf", 24.0, 63.0},
    Encoder{"libvpx", "-b:v 16M", "-crf", 8.0, 63.0},
};
constexpr std::array gif{Encoder{"gif", "-loop 0", "", 0.0, 0.0}};

// Limited range and the matrix of BT.709, as tagged; sides are even, as 4:2:0 needs.
constexpr std::string_view to_video =
    "crop=trunc(iw/2)*2:trunc(ih/2)*2,"
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p";
constexpr std::string_view video_tags =
    "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv";
// The 256 colours that suit what moves.
constexpr std::string_view to_palette =
    "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a";

struct FilmFormat {
    std::string_view extension;
    std::string_view muxer;
    std::string_view options;
    std::span<const Encoder> encoders;  // The first that ffmpeg has.
    bool is_video = true;
};

constexpr std::array formats{
    FilmFormat{".mp4", "mp4", "-movflags +faststart", h264},
    FilmFormat{".mov", "mov", "-movflags +faststart", h264},
    FilmFormat{".mkv", "matroska", "", h264},
    FilmFormat{".webm", "webm", "", vp9},
    FilmFormat{".gif", "gif", "", gif, false},
};

const FilmFormat* format_of(const fs::path& file) {
    const std::string ending = ending_of(file.string());
    const auto* const found =
        std::find_if(formats.begin(), formats.end(),
                     [&](const FilmFormat& format) { return format.extension == ending; });
    return found == formats.end() ? nullptr : found;
}

void add_words(std::vector<std::string>& words, std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
}

Diagnostic no_ffmpeg(const fs::path& film) {
    fs::path frames = film;
    frames.replace_extension();
    return error(
        Kind::environment,
        fmt::format("'{}' needs the program ffmpeg, which is not installed", film.string()),
        fmt::format("install ffmpeg (Debian: apt install ffmpeg), or render the frames alone: "
                    "--output '{}.####.png'",
                    frames.string()));
}

// A line of `ffmpeg -encoders`: " V....D libx264   description".
bool lists(std::string_view encoders, std::string_view name) {
    return encoders.find(fmt::format(" {} ", name)) != std::string_view::npos;
}

// The first encoder for the film that ffmpeg has.
Result<const Encoder*> encoder_for(const fs::path& film) {
    const ProgramEnd listed = run_program({"ffmpeg", "-hide_banner", "-encoders"});
    if (!listed.found || !listed.succeeded) {
        return no_ffmpeg(film);
    }
    const FilmFormat& format = *format_of(film);
    std::vector<std::string_view> names;
    for (const Encoder& encoder : format.encoders) {
        if (lists(listed.output, encoder.name)) {
            return &encoder;
        }
        names.push_back(encoder.name);
    }
    return error(Kind::environment,
                 fmt::format("ffmpeg has no encoder for {} files", format.extension),
                 fmt::format("install an ffmpeg that has {}, or write a film of another format: {}",
                             fmt::join(names, " or "), fmt::join(film_extensions(), ", ")));
}

std::vector<std::string> words_for(const FilmRequest& film, const Encoder& encoder,
                                   const fs::path& beside) {
    const FilmFormat& format = *format_of(film.file);
    std::vector<std::string> words{"ffmpeg",   "-hide_banner", "-loglevel", "error",
                                   "-nostdin", "-y",           "-f",        "image2pipe"};
    add_words(words, "-c:v png -framerate");
    words.push_back(film.rate.text());
    add_words(words, "-i pipe:0 -vf");
    words.emplace_back(format.is_video ? to_video : to_palette);
    add_words(words, "-c:v");
    words.emplace_back(encoder.name);
    add_words(words, encoder.options);
    if (!encoder.crf_option.empty()) {
        words.emplace_back(encoder.crf_option);
        words.push_back(fmt::format("{:g}", film.crf.value_or(encoder.crf)));
    }
    add_words(words, format.is_video ? video_tags : "");
    add_words(words, format.options);
    words.emplace_back("-f");
    words.emplace_back(format.muxer);
    words.push_back("file:" + beside.string());
    return words;
}

// The end of what ffmpeg said, in one line.
std::string reason_of(const std::string& errors) {
    constexpr std::size_t most = 300;
    std::string text = errors.size() > most ? "..." + errors.substr(errors.size() - most) : errors;
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (text.ends_with(' ')) {
        text.pop_back();
    }
    return text.empty() ? "it gave no reason" : text;
}

}  // namespace

bool is_film(const fs::path& file) { return format_of(file) != nullptr; }

bool names_film(const fs::path& file) {
    constexpr std::array<std::string_view, 8> others{".avi", ".flv", ".m4v", ".mpeg",
                                                     ".mpg", ".mxf", ".ogv", ".wmv"};
    return is_film(file) ||
           std::find(others.begin(), others.end(), ending_of(file)) != others.end();
}

std::vector<std::string> film_extensions() {
    std::vector<std::string> names;
    for (const FilmFormat& format : formats) {
        names.emplace_back(format.extension);
    }
    return names;
}

Result<FrameOutput> frame_output_of(const std::string& output) {
    if (is_film(output)) {
        return FrameOutput{pattern_of_film(output), FilmRequest{output}};
    }
    const std::string films = fmt::format("{}", fmt::join(film_extensions(), ", "));
    if (names_film(output)) {
        return error(Kind::usage,
                     fmt::format("films in the format of '{}' are not written", output),
                     fmt::format("name a film that ends in {}", films));
    }
    if (const auto pattern = FramePattern::read(output)) {
        return FrameOutput{*pattern, {}};
    }
    const std::string ending = ending_of(output);
    return error(Kind::usage, fmt::format("'{}' has no # for the number of the frame", output),
                 fmt::format("write --output '{}.####{}', or name a film ({})",
                             fs::path(output).replace_extension().string(),
                             ending.empty() ? ".png" : ending, films));
}

bool has_even_sides(const fs::path& film) { return format_of(film)->is_video; }

Diagnostics check_film(const FilmRequest& film) {
    if (Diagnostics found = OutputFile::check(film.file); has_errors(found)) {
        return found;
    }
    const auto encoder = encoder_for(film.file);
    if (!encoder) {
        return encoder.diagnostics;
    }
    if (!film.crf) {
        return {};
    }
    if ((*encoder)->crf_option.empty()) {
        return {error(Kind::usage, fmt::format("the encoder {} has no --crf", (*encoder)->name),
                      "omit --crf, or write an .mp4 file")};
    }
    if (*film.crf < 0.0 || *film.crf > (*encoder)->max_crf) {
        return {error(Kind::usage, fmt::format("--crf cannot be {:g}", *film.crf),
                      fmt::format("give a number from 0 (best) to {:g} (smallest); {} has {:g} "
                                  "unless asked otherwise",
                                  (*encoder)->max_crf, (*encoder)->name, (*encoder)->crf))};
    }
    return {};
}

Diagnostics write_film(const FilmRequest& film, std::span<const fs::path> pictures,
                       const std::function<void(std::size_t)>& progress,
                       const std::stop_token& stop) {
    const auto encoder = encoder_for(film.file);
    if (!encoder) {
        return encoder.diagnostics;
    }
    OutputFile output(film.file);
    if (!output.stream()) {
        return {output.failure()};
    }
    const ProgramEnd end =
        run_program(words_for(film, **encoder, output.beside()), pictures, progress, stop);
    if (end.succeeded) {
        return output.commit();
    }
    return {error(stop.stop_requested() ? Kind::interrupted : Kind::environment,
                  fmt::format("ffmpeg cannot make '{}': {}", film.file.string(),
                              stop.stop_requested() ? "interrupted" : reason_of(end.errors)))};
}

}  // namespace balcony::app
