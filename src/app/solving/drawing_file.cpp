// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/drawing_file.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/display_file.hpp"
#include "balcony/images.hpp"
#include "balcony/output_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

bool is_svg(const fs::path& file) { return ending_of(file) == ".svg"; }

Diagnostic no_picture(const fs::path& file, const Diagnostic& reason) {
    return error(reason.kind,
                 fmt::format("'{}' cannot be read as a picture: {}", file.string(), reason.message),
                 reason.remedy);
}

// The colours of a picture, whose grey is one channel.
Result<Image> read_picture(const fs::path& file) {
    Result<std::unique_ptr<images::ImageFile>> opened = images::ImageFile::open(file);
    if (!opened) {
        return no_picture(file, opened.diagnostics.front());
    }
    images::ImageFile& input = **opened;
    input.turn_upright();
    const std::size_t channels = input.channels();
    std::vector<std::uint8_t> rows(input.width() * input.height() * channels);
    if (const auto failure = input.read_rows(0, input.height(), rows)) {
        return no_picture(file, *failure);
    }
    Image made{input.width(), input.height(), {}};
    made.samples.reserve(3 * made.width * made.height);
    for (std::size_t i = 0; i < rows.size(); i += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            made.samples.push_back(rows[i + (channels < 3 ? 0 : c)]);
        }
    }
    return made;
}

Diagnostics usage(std::string message, std::string remedy) {
    return {error(Kind::usage, std::move(message), std::move(remedy))};
}

Diagnostics write_image(const Image& image, const fs::path& file) {
    return render::write_samples(image.samples, {image.width, image.height, 3}, file);
}

}  // namespace

Diagnostics check_uncertainty_of(const SolveRequest& request) {
    if (request.uncertainty.empty()) {
        return {};
    }
    if (render::display_format(request.uncertainty) == nullptr) {
        return usage(fmt::format("the file extension of '{}' is not that of a picture",
                                 request.uncertainty.string()),
                     "use a file name that ends in .png, .jpg, .webp or .tif");
    }
    return OutputFile::check(request.uncertainty);
}

Diagnostics write_uncertainty_of(const SolveReport& report, const SolveRequest& request) {
    return request.uncertainty.empty() ? Diagnostics()
                                       : write_image(uncertainty_map(report), request.uncertainty);
}

Diagnostics check_drawing_of(const SolveRequest& request) {
    if (request.drawing.empty()) {
        return request.over.empty() ? Diagnostics()
                                    : usage("there is no drawing to put over a picture",
                                            "name the file of the drawing");
    }
    if (is_svg(request.drawing) && !request.over.empty()) {
        return usage(
            fmt::format("'{}' has no pixels to put over a picture", request.drawing.string()),
            "use a file name that ends in .png");
    }
    if (!is_svg(request.drawing) && render::display_format(request.drawing) == nullptr) {
        return usage(fmt::format("the file extension of '{}' is not a drawing format",
                                 request.drawing.string()),
                     "use a file name that ends in .svg, .png, .jpg, .webp or .tif");
    }
    return OutputFile::check(request.drawing);
}

Diagnostics write_drawing_of(const SolveReport& report, const SolveRequest& request) {
    if (request.drawing.empty()) {
        return {};
    }
    analyse::Drawing drawing = draw_marks(report);
    if (is_svg(request.drawing)) {
        return write_whole(request.drawing, analyse::to_svg(drawing));
    }
    Diagnostics found;
    if (!request.over.empty()) {
        Result<Image> picture = read_picture(request.over);
        add(found, picture.diagnostics);
        if (picture && (picture->width != drawing.width || picture->height != drawing.height)) {
            add(found, {error(fmt::format("'{}' has {} x {} pixels, but the marks are of {} x {}",
                                          request.over.string(), picture->width, picture->height,
                                          drawing.width, drawing.height),
                              {}, "name the picture that was marked, or scale it to this size")});
        }
        if (has_errors(found)) {
            return found;
        }
        drawing.background = std::move(*picture);
    }
    add(found, write_image(analyse::rasterise(drawing), request.drawing));
    return found;
}

}  // namespace balcony::app
