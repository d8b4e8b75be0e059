// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Zemax's sequential files, .zmx: what is common in them. A line has a keyword; those of a surface
// follow its line SURF. The first surface is the object, the last one the image.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "data/lenses/lens_file.hpp"

namespace balcony::data {

namespace {

using camera::LensSurface;
using camera::Medium;

class ZemaxReader {
public:
    ZemaxReader(const std::shared_ptr<const SourceText>& source, Diagnostics& found)
        : source_(source), found_(found) {}

    camera::Prescription run() {
        for (const LensLine& line : lens_lines(source_, '\0')) {
            const std::string_view word = line.front().text;
            if (word == "SURF") {
                surfaces_.emplace_back().shape.written = span_of(line);
            } else if (word == "UNIT" && line.size() > 1) {
                unit_ = lens_unit(line[1], found_).value_or(unit_);
            } else if (word == "MODE" && line.size() > 1 && line[1].text != "SEQ") {
                fault(span_of(line), "this is no sequential lens", "export it as one");
            } else if (!surfaces_.empty()) {
                property(line, surfaces_.back());
            }
        }
        return made();
    }

private:
    struct Surface {
        LensSurface shape{};
        bool even = false;      ///< Its parameters are coefficients.
        bool toroidal = false;  ///< The same behind the first one, a radius.
    };

    void fault(const SourceSpan& span, std::string message, std::string remedy) {
        found_.push_back(error(std::move(message), span, std::move(remedy)));
    }

    std::optional<double> number(const LensLine& line, std::size_t i) {
        if (i >= line.size()) {
            fault(span_of(line), "this line has too few words", "check that the file is whole");
            return std::nullopt;
        }
        return lens_number(line[i], found_);
    }

    void property(const LensLine& line, Surface& surface) {
        const std::string_view word = line.front().text;
        LensSurface& s = surface.shape;
        if (word == "STOP") {
            s.stop = true;
            s.written = span_of(line);
        } else if (word == "TYPE") {
            type(line, surface);
        } else if (word == "CURV") {
            s.curvature = number(line, 1).value_or(0.0) / unit_;
        } else if (word == "CONI") {
            s.conic = number(line, 1).value_or(0.0);
        } else if (word == "DISZ" && line.size() > 1) {
            s.gap = line[1].text == "INFINITY" ? 0.0 : unit_ * number(line, 1).value_or(0.0);
        } else if (word == "DIAM") {
            s.radius = unit_ * number(line, 1).value_or(0.0);
        } else if (word == "PARM") {
            parameter(line, surface);
        } else if (word == "GLAS") {
            glass(line, s);
        } else if (word == "SQAP" || word == "ELAP" || word == "OBSC" || word == "OBDC") {
            fault(span_of(line), "holes other than round ones are not supported",
                  "remove this aperture");
        }
    }

    void type(const LensLine& line, Surface& surface) {
        const std::string_view name = line.size() > 1 ? line[1].text : "";
        surface.even = name == "EVENASPH";
        surface.toroidal = name == "TOROIDAL";
        if (surface.toroidal) {
            surface.shape.curvature_x = 0.0;
        } else if (name != "STANDARD" && name != "EVENASPH") {
            fault(span_of(line),
                  fmt::format("surfaces of the type '{}' are not supported", printable(name)),
                  "STANDARD, EVENASPH and TOROIDAL are");
        }
    }

    // PARM i: the coefficient of h to the power 2 i; of a toroidal surface, the horizontal radius,
    // and behind it the coefficient of h to the power 2 i - 2.
    void parameter(const LensLine& line, Surface& surface) {
        const auto index = number(line, 1);
        const auto value = number(line, 2);
        if (!(surface.even || surface.toroidal) || !index || !value || *value == 0.0) {
            return;
        }
        if (surface.toroidal && *index == 1.0) {
            surface.shape.curvature_x = 1.0 / (unit_ * *value);
            return;
        }
        const double place = *index - (surface.toroidal ? 3.0 : 2.0);
        auto& terms = surface.shape.aspheric;
        if (place < 0.0 || place >= static_cast<double>(terms.size()) ||
            place != std::floor(place)) {
            fault(span_of(line), "of an aspheric surface, only a4 to a12 are supported",
                  "leave out this coefficient");
            return;
        }
        terms[static_cast<std::size_t>(place)] = *value / std::pow(unit_, 2.0 * place + 3.0);
    }

    // GLAS name, two numbers, index, Abbe number.
    void glass(const LensLine& line, LensSurface& s) {
        if (line.size() < 2) {
            fault(span_of(line), "this glass has no name", "check that the file is whole");
            return;
        }
        if (line[1].text == "MIRROR") {
            fault(span_of(line), "mirrors are not supported", "use a lens without them");
            return;
        }
        if (const Medium* known = camera::find_glass(line[1].text)) {
            s.behind = *known;
            return;
        }
        const double index = line.size() > 4 ? number(line, 4).value_or(0.0) : 0.0;
        const double abbe = line.size() > 5 ? number(line, 5).value_or(0.0) : 0.0;
        if (!(index > 1.0)) {
            found_.push_back(unknown_glass(line[1], {}));
            return;
        }
        s.behind = abbe > 0.0 ? Medium::by_abbe_number(index, abbe)
                              : Medium{{}, Medium::Dispersion::none, {index}};
        s.behind.name = std::string(line[1].text);
    }

    // Without the object and the image, and without planes that only mark a place.
    camera::Prescription made() {
        camera::Prescription lens;
        const std::size_t count = surfaces_.size();
        if (count < 3) {
            fault({source_, 0, 0}, "this file has no surfaces of a lens",
                  "check that it is a .zmx file of a sequential lens");
            return lens;
        }
        bool in_air = true;
        for (std::size_t i = 1; i + 1 < count; ++i) {
            const LensSurface& s = surfaces_[i].shape;
            const bool into_air = s.behind.name.empty() && s.behind.coefficients[0] == 1.0;
            if (in_air && into_air && !s.stop) {
                if (!lens.surfaces.empty()) {
                    lens.surfaces.back().gap += s.gap;
                }
                continue;
            }
            in_air = into_air;
            lens.surfaces.push_back(s);
        }
        return lens;
    }

    std::shared_ptr<const SourceText> source_;
    Diagnostics& found_;
    std::vector<Surface> surfaces_;
    double unit_ = 1.0;
};

}  // namespace

camera::Prescription read_zemax(const std::shared_ptr<const SourceText>& source,
                                Diagnostics& found) {
    return ZemaxReader(source, found).run();
}

}  // namespace balcony::data
