// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// COLMAP's cameras.txt: a line for each camera, with its number, its model, the width and height of
// the image and the parameters of the model.

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "data/calibration/calibration.hpp"

namespace balcony::data {

namespace {

using camera::Calibration;

constexpr std::size_t max_colmap_errors = 10;

/// A model with its parameters in the order of the file, by the names of the row's parameters; f is
/// both focal lengths.
struct ColmapModel {
    std::string_view name;
    std::string_view row;
    std::vector<std::string_view> parameters;
};

/// COLMAP's documentation, "Camera Models".
const std::vector<ColmapModel>& colmap_models() {
    static const std::vector<ColmapModel> models{
        {"SIMPLE_PINHOLE", "opencv_pinhole", {"f", "cx", "cy"}},
        {"PINHOLE", "opencv_pinhole", {"fx", "fy", "cx", "cy"}},
        {"SIMPLE_RADIAL", "opencv_pinhole", {"f", "cx", "cy", "k1"}},
        {"RADIAL", "opencv_pinhole", {"f", "cx", "cy", "k1", "k2"}},
        {"OPENCV", "opencv_pinhole", {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"}},
        {"FULL_OPENCV",
         "opencv_pinhole",
         {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"}},
        {"OPENCV_FISHEYE", "opencv_fisheye", {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"}},
        {"SIMPLE_RADIAL_FISHEYE", "opencv_fisheye", {"f", "cx", "cy", "k1"}},
        {"RADIAL_FISHEYE", "opencv_fisheye", {"f", "cx", "cy", "k1", "k2"}},
        {"FOV", "field_of_view", {"fx", "fy", "cx", "cy", "omega"}},
        {"THIN_PRISM_FISHEYE",
         "thin_prism_fisheye",
         {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "sx1", "sy1"}}};
    return models;
}

class ColmapReader {
public:
    explicit ColmapReader(std::shared_ptr<const SourceText> source) : source_(std::move(source)) {}

    Result<std::vector<Calibration>> run() {
        const std::string_view text = source_->text();
        for (std::size_t begin = 0; begin < text.size() && errors_ < max_colmap_errors;) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::vector<Word> words = split(begin, end);
            if (!words.empty() && words.front().text.front() != '#') {
                line(words);
            }
            begin = end + 1;
        }
        if (cameras_.empty() && found_.empty()) {
            error({source_, 0, 0}, fmt::format("'{}' has no cameras", source_->name()),
                  "each line of COLMAP's cameras.txt is: number MODEL width height parameters");
        }
        if (has_errors(found_)) {
            return std::move(found_);
        }
        return {std::move(cameras_), std::move(found_)};
    }

private:
    struct Word {
        std::string_view text;
        SourceSpan span;
    };

    void error(SourceSpan span, std::string message, std::string remedy) {
        found_.push_back(balcony::error(std::move(message), std::move(span), std::move(remedy)));
        ++errors_;
    }

    [[nodiscard]] std::vector<Word> split(std::size_t begin, std::size_t end) const {
        constexpr std::string_view blanks = " \t\r";
        const std::string_view text = source_->text().substr(0, end);
        std::vector<Word> words;
        while ((begin = text.find_first_not_of(blanks, begin)) != text.npos) {
            const std::size_t stop = std::min(text.find_first_of(blanks, begin), end);
            words.push_back({text.substr(begin, stop - begin), {source_, begin, stop}});
            begin = stop;
        }
        return words;
    }

    std::optional<EntryNumber> number(const Word& word, std::string_view name) {
        const std::optional<double> value = finite_number(word.text);
        if (!value) {
            error(word.span, fmt::format("{} is not a finite number", name),
                  "write it with a decimal point, for example 1.5e-3");
            return std::nullopt;
        }
        return EntryNumber{*value, word.span};
    }

    void line(const std::vector<Word>& words) {
        const SourceSpan whole = join(words.front().span, words.back().span);
        if (words.size() < 5) {
            error(whole, "this line has too few entries for a camera",
                  "write: number MODEL width height parameters");
            return;
        }
        const auto id = number(words[0], "the number of the camera");
        const auto model =
            std::find_if(colmap_models().begin(), colmap_models().end(),
                         [&words](const ColmapModel& one) { return one.name == words[1].text; });
        if (model == colmap_models().end()) {
            std::vector<std::string> known;
            for (const ColmapModel& one : colmap_models()) {
                known.emplace_back(one.name);
            }
            error(words[1].span, fmt::format("there is no camera model '{}'", words[1].text),
                  suggestion(words[1].text, known, "COLMAP's models are"));
            return;
        }
        if (words.size() != 4 + model->parameters.size()) {
            error(whole,
                  fmt::format("the model {} has {} parameters, but this line has {}", model->name,
                              model->parameters.size(), words.size() - 4),
                  fmt::format("they are {}", fmt::join(model->parameters, " ")));
            return;
        }
        if (id && !(id->value >= 0.0 && id->value <= 1e6 &&
                    id->value == static_cast<double>(static_cast<std::size_t>(id->value)))) {
            error(words[0].span, "the number of a camera must be a whole number from 0 to 1000000",
                  "each line begins with the number of its camera");
            return;
        }
        if (id) {
            camera(words, *model, static_cast<std::size_t>(id->value));
        }
    }

    void camera(const std::vector<Word>& words, const ColmapModel& model, std::size_t id) {
        if (std::any_of(cameras_.begin(), cameras_.end(),
                        [id](const Calibration& one) { return one.id == id; })) {
            error(words[0].span, fmt::format("there are two cameras with the number {}", id),
                  "give each its own number");
            return;
        }
        Calibration made{.id = id, .model = std::string(model.row), .origin = "pixel_corner"};
        ImageEntries image{.width = number(words[2], "the width"),
                           .height = number(words[3], "the height")};
        bool complete = image.width && image.height;
        for (std::size_t i = 0; i < model.parameters.size(); ++i) {
            const std::string_view name = model.parameters[i];
            const auto value = number(words[4 + i], name);
            if (!value) {
                complete = false;
            } else if (name == "f") {
                image.fx = image.fy = *value;
            } else if (EntryNumber* entry = entry_of(image, name)) {
                *entry = *value;
            } else {
                made.numbers.push_back({std::string(name), value->value});
            }
        }
        if (complete) {
            check_image(image, found_);
            add_image(image, made);
            cameras_.push_back(std::move(made));
        }
    }

    static EntryNumber* entry_of(ImageEntries& image, std::string_view name) {
        return name == "fx"   ? &image.fx
               : name == "fy" ? &image.fy
               : name == "cx" ? &image.cx
               : name == "cy" ? &image.cy
                              : nullptr;
    }

    std::shared_ptr<const SourceText> source_;
    std::vector<Calibration> cameras_;
    Diagnostics found_;
    std::size_t errors_ = 0;
};

}  // namespace

Result<std::vector<Calibration>> read_colmap_cameras(
    const std::shared_ptr<const SourceText>& source) {
    return ColmapReader(source).run();
}

}  // namespace balcony::data
