// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Animation: the frames of a scene, as a sequence of pictures or as a film.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/app.hpp"

namespace balcony::app {

/// In increasing order, each once.
using FrameNumbers = std::vector<std::size_t>;

inline constexpr std::size_t max_frame = 9'999'999;

/// "1-240", "7", "1-240x10" (every tenth), or several of these with commas between them, as other
/// programs and render farms write them; nothing if the text is none of these.
[[nodiscard]] std::optional<FrameNumbers> frame_numbers_of(std::string_view text);

/// The same for a film, of which one number is the length: "48" are the frames from 1 to 48.
[[nodiscard]] std::optional<FrameNumbers> frames_of_film(std::string_view text);

/// The time of a frame in seconds, if frame 1 is at `start`.
[[nodiscard]] inline double time_of(std::size_t frame, double start, const FrameRate& rate) {
    return start + (static_cast<double>(frame) - 1.0) * rate.frame_time();
}

/// The shortest such text: "1-4,7".
[[nodiscard]] std::string text_of(std::span<const std::size_t> frames);

/// The name of a file with a place for the number of a frame: "frame.####.png", where each # is a
/// digit, or "frame.%04d.png". Longer numbers take more room.
class FramePattern {
public:
    /// Nothing if the name of the file (not of its folder) has no such place.
    [[nodiscard]] static std::optional<FramePattern> read(const std::string& text);

    [[nodiscard]] std::filesystem::path file(std::size_t frame) const;
    /// The number of the frame whose file has this name, without its folder.
    [[nodiscard]] std::optional<std::size_t> number_of_file(std::string_view name) const;
    /// The frames whose files exist.
    [[nodiscard]] FrameNumbers existing() const;

    [[nodiscard]] std::size_t digits() const { return digits_; }
    /// With #, whichever way it was written.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;  ///< Empty for the current one.
    std::string before_, after_;
    std::size_t digits_ = 1;
};

/// A film that the program ffmpeg makes of pictures.
struct FilmRequest {
    std::filesystem::path file;
    FrameRate rate{};
    std::optional<double> crf{};  ///< The constant rate factor of the encoder: less is better.
};

/// Whether the name of a file has the extension of a film.
[[nodiscard]] bool is_film(const std::filesystem::path& file);
/// The same also of a film in a format that is not written.
[[nodiscard]] bool names_film(const std::filesystem::path& file);
/// The extensions of films that are written: ".mp4", ...
[[nodiscard]] std::vector<std::string> film_extensions();
/// The frames of a film are in a folder beside it until it is complete.
[[nodiscard]] FramePattern pattern_of_film(const std::filesystem::path& film);

/// Where frames go.
struct FrameOutput {
    FramePattern pattern{};             ///< Of the frames' files.
    std::optional<FilmRequest> film{};  ///< That the frames become.
};

/// By the name of a film, or of a sequence with # for the number of the frame; an error of
/// Kind::usage if it is neither.
[[nodiscard]] Result<FrameOutput> frame_output_of(const std::string& output);

/// The frames of an animation.
struct AnimationRequest {
    /// Of each frame, but for its time and its output.
    Request picture{};
    std::optional<FrameNumbers> frames{};  ///< As many as the scene's animations need if empty.
    std::optional<double> duration{};      ///< In seconds, in place of `frames`.
    double start_time = 0.0;               ///< Of frame 1, in seconds.
    bool turntable = false;
    std::string around{};  ///< The object that the turntable is for; empty for the scene.
    bool keep_frames = false;
    bool overwrite = false;
    bool same_noise = false;
    std::optional<render::Shard> shard{};
    std::size_t parts_per_frame = 1;
    FramePattern pattern{};             ///< Of the frames' files.
    std::optional<FilmRequest> film{};  ///< That the frames become.
    /// What tells the picture of PreparedScene::animate() from others, such as the text of its
    /// camera.
    std::optional<std::string> identity{};

    /// Of the frames, in seconds.
    [[nodiscard]] double time_of(std::size_t frame) const {
        return app::time_of(frame, start_time, picture.shutter.rate);
    }
};

/// A frame, or a part of it, that was rendered.
struct FrameReport {
    std::size_t frame = 0;
    std::filesystem::path file;
    double trace_seconds = 0.0;
    double write_seconds = 0.0;
    double seconds = 0.0;  ///< In all.
};

struct AnimationReport {
    Diagnostics diagnostics;
    bool interrupted = false;
    bool is_rendered = false;  ///< Whether what follows is known.
    FrameNumbers frames{};     ///< That were asked for.
    std::vector<FrameReport> rendered{};
    std::size_t skipped = 0;  ///< Finished before.
    double exposure = 0.0;    ///< In stops.
    std::size_t width = 0;
    std::size_t height = 0;
    double seconds = 0.0;
    bool is_film_missing = false;  ///< Stopped after the last frame, before the film was made.
    std::filesystem::path film{};  ///< That was made; empty if none was.
};

/// What is known to be wrong with the output before rendering: a missing folder or program.
[[nodiscard]] Diagnostics check_output(const AnimationRequest& request);
/// The same; makes the folder for the frames of a film.
[[nodiscard]] Diagnostics prepare_output(const AnimationRequest& request);

/// Renders what is not finished yet, and makes the film. The same request continues after a stop.
[[nodiscard]] AnimationReport animate(const AnimationRequest& request,
                                      const Observer& observer = {},
                                      const std::stop_token& stop = {});

/// Whether a name is that of a film, or of frames with their record beside them.
[[nodiscard]] bool is_animation(const std::string& name);

struct MergedAnimation {
    Diagnostics diagnostics;
    bool interrupted = false;
    std::filesystem::path output{};  ///< A film, or the pattern of a sequence.
    FrameNumbers frames{};
    std::size_t merged = 0;  ///< Frames that were joined of parts.
};

/// Joins the parts of frames that are in parts, and makes the film: the one of this name, or of a
/// sequence the one that `output` names, if it is not empty. Frames that are missing are an error,
/// which names them.
[[nodiscard]] MergedAnimation merge_animation(const std::string& name, const std::string& output,
                                              const Observer& observer = {},
                                              const std::stop_token& stop = {});

}  // namespace balcony::app
