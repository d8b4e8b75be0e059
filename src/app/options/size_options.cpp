// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

Value<std::size_t> side() {
    Value<std::size_t> made = count(1, max_side);
    made.info.unit = "px";
    made.remedy = [](std::string_view) { return fmt::format("give 1 to {} pixels", max_side); };
    return made;
}

// WIDTH or WIDTHxHEIGHT.
void read_both(const std::string& name, std::string_view word, SizeRequest& size,
               Diagnostics& found) {
    const std::size_t cross = word.find_first_of("xX");
    const bool has_height = cross != std::string_view::npos;
    size.width = side().read(word.substr(0, cross));
    size.height = has_height ? side().read(word.substr(cross + 1)) : std::nullopt;
    if (!size.width || (has_height && !size.height)) {
        found.push_back(refused(
            name, word,
            fmt::format("write {0} 1920x1080, or {0} 1920 for the camera's aspect ratio; a side "
                        "has 1 to {1} pixels",
                        name, max_side)));
    }
}

}  // namespace

Option<SizeRequest> size_option(OptionInfo info) {
    info.type = OptionType::size;
    info.unit = "px";
    return custom_option<SizeRequest>(
        info,
        [name = info.name](auto words, SizeRequest& size, Diagnostics& found) {
            read_both(name, words.back(), size, found);
        },
        [](const SizeRequest& size) {
            return !size.width    ? std::vector<std::string>{}
                   : !size.height ? std::vector{fmt::format("{}", *size.width)}
                                  : std::vector{fmt::format("{}x{}", *size.width, *size.height)};
        });
}

Options<SizeRequest> size_options(const std::string& meaning) {
    const auto exclusion = [](SizeRequest&, const GivenWords& given, Diagnostics& found) {
        if (given.contains("--size") && (given.contains("--width") || given.contains("--height"))) {
            found.push_back(error(Kind::usage, "--size and --width or --height exclude each other",
                                  "write --size 1920x1080, or --width 1920 --height 1080"));
        }
    };
    return {{size_option({.name = "--size",
                          .others = {"--resolution", "--res", "--geometry"},
                          .placeholder = "WIDTH[xHEIGHT]",
                          .meaning = meaning}),
             option({.name = "--width",
                     .letter = "-W",
                     .placeholder = "PIXELS",
                     .meaning = "width in pixels; alone, as --size WIDTH"},
                    maybe(side()), &SizeRequest::width),
             option({.name = "--height",
                     .letter = "-H",
                     .placeholder = "PIXELS",
                     .meaning = "height in pixels; alone, the width follows from the aspect ratio"},
                    maybe(side()), &SizeRequest::height)},
            {exclusion}};
}

Options<SizeRequest> aspect_options() {
    Value<camera::Fit> fit = choice(camera::fits());
    fit.remedy = [](std::string_view word) {
        return suggestion(word, camera::fits().all(), "the choices are");
    };
    return {{option({.name = "--aspect",
                     .placeholder = "MODE",
                     .meaning = fmt::format(
                         "what the picture does in a size of another aspect ratio: {}; a camera "
                         "with 'square' in its map shows more or less instead",
                         described(fit.info.choices, ", "))},
                    fit, &SizeRequest::fit)}};
}

}  // namespace balcony::app
