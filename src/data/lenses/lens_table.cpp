// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tables of surfaces, one a line: radius of curvature, gap to the next surface, medium behind it,
// diameter. pbrt's .dat files are such tables.

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

class LensTableReader {
public:
    LensTableReader(const std::shared_ptr<const SourceText>& source, Diagnostics& found)
        : source_(source), found_(found) {}

    camera::Prescription run() {
        for (const LensLine& line : lens_lines(source_, '#')) {
            const std::string_view first = line.front().text;
            if (first == "unit") {
                unit(line);
            } else if (first == "glass") {
                glass(line);
            } else if (first != "radius") {
                surface(line);
            }
        }
        return std::move(lens_);
    }

private:
    void fault(const SourceSpan& span, std::string message, std::string remedy) {
        found_.push_back(error(std::move(message), span, std::move(remedy)));
    }

    void unit(const LensLine& line) {
        if (line.size() != 2) {
            fault(span_of(line), "a unit has one name", "write unit mm");
        } else if (!lens_.surfaces.empty()) {
            fault(span_of(line), "the unit stands behind a surface", "write it in the first line");
        } else if (const auto read = lens_unit(line[1], found_)) {
            unit_ = *read;
        }
    }

    // glass NAME INDEX ABBE, glass NAME sellmeier B1 B2 B3 C1 C2 C3, ...
    void glass(const LensLine& line) {
        using Dispersion = Medium::Dispersion;
        struct Form {
            std::string_view name;
            Dispersion dispersion;
            std::size_t count;
        };
        static constexpr std::array forms{Form{"cauchy", Dispersion::cauchy, 3},
                                          Form{"schott", Dispersion::schott, 6},
                                          Form{"sellmeier", Dispersion::sellmeier, 6}};
        const auto* form = std::find_if(forms.begin(), forms.end(), [&](const Form& one) {
            return line.size() > 2 && line[2].text == one.name;
        });
        const bool by_abbe = form == forms.end();
        const std::size_t first = by_abbe ? 2 : 3;
        const std::size_t count = by_abbe ? 2 : form->count;
        if (line.size() != first + count) {
            fault(span_of(line), "this is no glass",
                  "write glass NAME INDEX ABBE, or glass NAME and sellmeier, schott or cauchy with "
                  "6, 6 or 3 coefficients, in micrometres");
            return;
        }
        Medium made{std::string(line[1].text), by_abbe ? Dispersion::none : form->dispersion, {}};
        for (std::size_t i = 0; i < count; ++i) {
            const auto read = lens_number(line[first + i], found_);
            if (!read) {
                return;
            }
            made.coefficients[i] = *read;
        }
        if (by_abbe && !(made.coefficients[1] > 0.0)) {
            fault(line[3].span, "an Abbe number is above 0", "write one such as 64.2");
            return;
        }
        glasses_[made.name] =
            by_abbe ? Medium::by_abbe_number(made.coefficients[0], made.coefficients[1]) : made;
    }

    void surface(const LensLine& line) {
        if (line.size() < 4) {
            fault(span_of(line), "a surface has a radius, a gap, a medium and a diameter",
                  "write for instance 29.475 3.76 1.67 25.2");
            return;
        }
        LensSurface made;
        made.written = span_of(line);
        const auto gap = lens_number(line[1], found_);
        const auto diameter = lens_number(line[3], found_);
        const bool curved = curvature(line[0], made);
        const bool filled = medium(line[2], made);
        for (std::size_t i = 4; i < line.size(); ++i) {
            if (!further(line[i], made)) {
                return;
            }
        }
        if (gap && diameter && curved && filled) {
            made.gap = unit_ * *gap;
            made.radius = 0.5 * unit_ * *diameter;
            lens_.surfaces.push_back(std::move(made));
        }
    }

    // A radius of 0 is pbrt's stop.
    bool curvature(const LensWord& word, LensSurface& made) {
        if (word.text == "stop") {
            made.stop = true;
            return true;
        }
        const auto read = curvature_of(word);
        made.stop = !is_plane(word) && read == 0.0;
        made.curvature = read.value_or(0.0);
        return read.has_value();
    }

    static bool is_plane(const LensWord& word) {
        return word.text == "plane" || word.text == "inf";
    }

    // 0 for a plane, whose radius may be written as 0.
    std::optional<double> curvature_of(const LensWord& word) {
        if (is_plane(word)) {
            return 0.0;
        }
        const auto radius = lens_number(word, found_);
        return radius ? std::optional(*radius == 0.0 ? 0.0 : 1.0 / (unit_ * *radius)) : radius;
    }

    bool medium(const LensWord& word, LensSurface& made) {
        const std::string name(word.text);
        if (const auto own = glasses_.find(name); own != glasses_.end()) {
            made.behind = own->second;
            return true;
        }
        if (name == "air") {
            return true;
        }
        if (const Medium* known = camera::find_glass(name)) {
            made.behind = *known;
            return true;
        }
        if (std::isdigit(static_cast<unsigned char>(name.front())) == 0 && name.front() != '.') {
            std::vector<std::string> own;
            for (const auto& [one, glass] : glasses_) {
                own.push_back(one);
            }
            found_.push_back(unknown_glass(word, std::move(own)));
            return false;
        }
        const std::size_t slash = std::min(word.text.find('/'), word.text.size());
        const auto index = lens_number({word.text.substr(0, slash), word.span}, found_);
        if (!index) {
            return false;
        }
        if (slash == word.text.size()) {
            made.behind.coefficients[0] = *index == 0.0 ? 1.0 : *index;
            return true;
        }
        const auto abbe = lens_number({word.text.substr(slash + 1), word.span}, found_);
        if (abbe && !(*abbe > 0.0)) {
            fault(word.span, "an Abbe number is above 0", "write for instance 1.67/47.1");
            return false;
        }
        if (abbe) {
            made.behind = Medium::by_abbe_number(*index, *abbe);
        }
        return abbe.has_value();
    }

    // stop, conic=-1, a4=2e-5, radius_x=plane, ...
    bool further(const LensWord& word, LensSurface& made) {
        if (word.text == "stop") {
            made.stop = true;
            return true;
        }
        const std::size_t sign = word.text.find('=');
        const std::string_view name = word.text.substr(0, sign);
        static constexpr std::array terms{"a4", "a6", "a8", "a10", "a12"};
        const auto* term = std::find(terms.begin(), terms.end(), name);
        if (sign == word.text.npos ||
            (name != "conic" && name != "radius_x" && term == terms.end())) {
            fault(word.span, fmt::format("a surface has no '{}'", printable(word.text)),
                  "write stop, conic=-1, radius_x=plane, or a4=2e-5 and so on to a12");
            return false;
        }
        const LensWord behind{word.text.substr(sign + 1), word.span};
        if (name == "radius_x") {
            made.curvature_x = curvature_of(behind);
            return made.curvature_x.has_value();
        }
        const auto value = lens_number(behind, found_);
        if (!value) {
            return false;
        }
        if (name == "conic") {
            made.conic = *value;
        } else {
            const auto i = static_cast<std::size_t>(term - terms.begin());
            made.aspheric[i] = *value / std::pow(unit_, 2.0 * static_cast<double>(i) + 3.0);
        }
        return true;
    }

    std::shared_ptr<const SourceText> source_;
    Diagnostics& found_;
    camera::Prescription lens_;
    std::map<std::string, Medium> glasses_;
    double unit_ = 1.0;
};

}  // namespace

camera::Prescription read_lens_table(const std::shared_ptr<const SourceText>& source,
                                     Diagnostics& found) {
    return LensTableReader(source, found).run();
}

}  // namespace balcony::data
