// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "scene/geometry.hpp"
#include "scene/polygons/face_set.hpp"
#include "scene/polygons/ply_header.hpp"
#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

// The numbers after the header, one after the other.
class PlyNumbers {
public:
    PlyNumbers(std::string_view text, PlyEncoding encoding) : text_(text), encoding_(encoding) {}

    [[nodiscard]] std::size_t bytes_left() const { return text_.size(); }
    /// The next number; NaN if it cannot be read. Nothing at the end of the file.
    [[nodiscard]] std::optional<double> take(PlyType type) {
        return encoding_ == PlyEncoding::text ? take_written() : take_binary(type);
    }

private:
    std::optional<double> take_written() {
        text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n\f\v"), text_.size()));
        if (text_.empty()) {
            return std::nullopt;
        }
        const std::string_view word = text_.substr(0, text_.find_first_of(" \t\r\n\f\v"));
        text_.remove_prefix(word.size());
        double number = 0.0;
        return to_number(word, number) ? number : std::numeric_limits<double>::quiet_NaN();
    }

    std::optional<double> take_binary(PlyType type) {
        const std::size_t size = size_of(type);
        if (text_.size() < size) {
            text_ = {};
            return std::nullopt;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t at = encoding_ == PlyEncoding::big_endian ? i : size - 1 - i;
            bits = bits << 8U | static_cast<unsigned char>(text_[at]);
        }
        text_.remove_prefix(size);
        switch (type) {
            case PlyType::int8: return static_cast<std::int8_t>(bits);
            case PlyType::int16: return static_cast<std::int16_t>(bits);
            case PlyType::int32: return static_cast<std::int32_t>(bits);
            case PlyType::uint8:
            case PlyType::uint16:
            case PlyType::uint32: return static_cast<double>(bits);
            case PlyType::float32:
                return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
            case PlyType::float64: return std::bit_cast<double>(bits);
        }
        return std::nullopt;
    }

    std::string_view text_;
    PlyEncoding encoding_;
};

// What a property of a vertex means, under the names that programs give it.
enum class Meaning : std::uint8_t { x, y, z, nx, ny, nz, red, green, blue, u, v, count };

struct MeaningName {
    std::string_view name;
    Meaning meaning;
};

constexpr std::array meaning_names{
    MeaningName{"x", Meaning::x},
    MeaningName{"y", Meaning::y},
    MeaningName{"z", Meaning::z},
    MeaningName{"nx", Meaning::nx},
    MeaningName{"ny", Meaning::ny},
    MeaningName{"nz", Meaning::nz},
    MeaningName{"red", Meaning::red},
    MeaningName{"green", Meaning::green},
    MeaningName{"blue", Meaning::blue},
    MeaningName{"r", Meaning::red},
    MeaningName{"g", Meaning::green},
    MeaningName{"b", Meaning::blue},
    MeaningName{"diffuse_red", Meaning::red},
    MeaningName{"diffuse_green", Meaning::green},
    MeaningName{"diffuse_blue", Meaning::blue},
    MeaningName{"u", Meaning::u},
    MeaningName{"v", Meaning::v},
    MeaningName{"s", Meaning::u},
    MeaningName{"t", Meaning::v},
    MeaningName{"texture_u", Meaning::u},
    MeaningName{"texture_v", Meaning::v},
};

constexpr auto meanings = static_cast<std::size_t>(Meaning::count);

Meaning meaning_of(const PlyProperty& property) {
    for (const MeaningName& row : meaning_names) {
        if (property.name == row.name && !property.list_count) {
            return row.meaning;
        }
    }
    return Meaning::count;
}

// Integers of a colour mean 0 .. 1.
double largest_of(PlyType type) {
    const bool is_float = type == PlyType::float32 || type == PlyType::float64;
    return is_float ? 1.0 : std::exp2(8.0 * static_cast<double>(size_of(type))) - 1.0;
}

class PlyReader {
public:
    explicit PlyReader(Import& import) : import_(import) {
        set_.sections.push_back({import.file.stem().string(), MaterialIndex(0), 0});
    }

    void read(std::string_view text) {
        const PlyHeader header = take_ply_header(text, import_.file.string());
        PlyNumbers numbers(text, header.encoding);
        size_ = text.size();
        for (const PlyElement& element : header.elements) {
            if (!read_element(element, numbers)) {
                import_.warn(fmt::format("the file ends before the last {} of {}",
                                         in_quotes(element.name), element.count),
                             "export it again");
                break;
            }
        }
        set_.warn_of_skipped(import_);
    }

    FaceSet take() { return std::move(set_); }

private:
    // False if the file ends before the element.
    bool read_element(const PlyElement& element, PlyNumbers& numbers) {
        if (element.properties.empty()) {
            return true;
        }
        const bool is_vertex = element.name == "vertex";
        if (is_vertex) {
            begin_vertices(element);
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            const bool complete = is_vertex                     ? read_vertex(element, numbers)
                                  : element.name == "face"      ? read_face(element, numbers)
                                  : element.name == "tristrips" ? read_strips(element, numbers)
                                                                : skip(element, numbers);
            if (!complete) {
                return false;
            }
        }
        return true;
    }

    void begin_vertices(const PlyElement& element) {
        std::array<bool, meanings + 1> has{};
        places_.clear();
        scales_.clear();
        for (const PlyProperty& property : element.properties) {
            const Meaning meaning = meaning_of(property);
            const bool is_color = meaning >= Meaning::red && meaning <= Meaning::blue;
            places_.push_back(static_cast<std::size_t>(meaning));
            scales_.push_back(is_color ? 1.0 / largest_of(property.type) : 1.0);
            has[static_cast<std::size_t>(meaning)] = true;
        }
        const auto has_all = [&](Meaning first, Meaning last) {
            return std::all_of(has.begin() + static_cast<std::ptrdiff_t>(first),
                               has.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                               [](bool present) { return present; });
        };
        if (!has_all(Meaning::x, Meaning::z)) {
            throw ReadError{error(fmt::format("the vertices of {} have no x, y and z",
                                              in_quotes(import_.file.string())),
                                  {}, "export the file again")};
        }
        has_normals_ = has_all(Meaning::nx, Meaning::nz);
        has_colors_ = has_all(Meaning::red, Meaning::blue);
        has_coordinates_ = has_all(Meaning::u, Meaning::v);
    }

    bool read_vertex(const PlyElement& element, PlyNumbers& numbers) {
        std::array<double, meanings + 1> values{};
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (!read_property(element.properties[i], numbers)) {
                return false;
            }
            values[places_[i]] = scales_[i] * (list_.empty() ? 0.0 : list_.front());
        }
        const auto vector = [&](Meaning first) {
            const auto at = static_cast<std::size_t>(first);
            return V3f(V3d(values[at], values[at + 1], values[at + 2]));
        };
        set_.positions.push_back(vector(Meaning::x));
        if (has_normals_) {
            set_.normals.push_back(vector(Meaning::nx));
        }
        if (has_colors_) {
            set_.colors.push_back(linear_of_srgb(Color3f(vector(Meaning::red))));
        }
        if (has_coordinates_) {
            const auto u = static_cast<std::size_t>(Meaning::u);
            // v counts from the bottom of the image.
            set_.texture_coordinates.emplace_back(static_cast<float>(values[u]),
                                                  static_cast<float>(1.0 - values[u + 1]));
        }
        return true;
    }

    bool read_face(const PlyElement& element, PlyNumbers& numbers) {
        for (const PlyProperty& property : element.properties) {
            if (!read_property(property, numbers)) {
                return false;
            }
            if (is_indices(property)) {
                corners_.clear();
                for (const double index : list_) {
                    corners_.push_back(corner(index));
                }
                set_.add_polygon(corners_, smooth_by_angle, 0);
            }
        }
        return true;
    }

    // Strips of triangles, which -1 separates. Every second triangle is reversed.
    bool read_strips(const PlyElement& element, PlyNumbers& numbers) {
        for (const PlyProperty& property : element.properties) {
            if (!read_property(property, numbers)) {
                return false;
            }
            std::size_t begin = 0;
            for (std::size_t i = 0; is_indices(property) && i < list_.size(); ++i) {
                if (list_[i] == -1.0) {
                    begin = i + 1;
                } else if (i >= begin + 2) {
                    const std::size_t odd = (i - begin) % 2;
                    std::array<Corner, 3> triangle{corner(list_[i - 2]), corner(list_[i - 1 + odd]),
                                                   corner(list_[i - odd])};
                    set_.add_polygon(triangle, smooth_by_angle, 0);
                }
            }
        }
        return true;
    }

    bool skip(const PlyElement& element, PlyNumbers& numbers) {
        return std::all_of(
            element.properties.begin(), element.properties.end(),
            [&](const PlyProperty& property) { return read_property(property, numbers); });
    }

    // Reads the values of a property, one unless it is a list.
    bool read_property(const PlyProperty& property, PlyNumbers& numbers) {
        list_.clear();
        double length = 1.0;
        if (property.list_count) {
            const auto stated = numbers.take(*property.list_count);
            if (!stated || !(*stated >= 0.0)) {
                return false;
            }
            length = *stated;
        }
        for (double i = 0.0; i < length; ++i) {
            import_.go_on(size_ - numbers.bytes_left(), size_);
            const auto value = numbers.take(property.type);
            if (!value) {
                return false;
            }
            list_.push_back(*value);
        }
        return true;
    }

    static bool is_indices(const PlyProperty& property) {
        return property.name == "vertex_indices" || property.name == "vertex_index";
    }

    // What a vertex has is at the same index in every list.
    [[nodiscard]] Corner corner(double index) const {
        if (!(index >= 0.0 && index < static_cast<double>(set_.positions.size()))) {
            return {};
        }
        const auto vertex = static_cast<std::uint32_t>(index);
        return {vertex, has_coordinates_ ? vertex : no_index, has_normals_ ? vertex : no_index};
    }

    Import& import_;
    FaceSet set_;
    std::size_t size_ = 0;             // Of the numbers, in bytes.
    std::vector<std::size_t> places_;  // By property of a vertex: its Meaning.
    std::vector<double> scales_;
    bool has_normals_ = false;
    bool has_colors_ = false;
    bool has_coordinates_ = false;
    std::vector<double> list_;
    std::vector<Corner> corners_;
};

FaceSet read_ply_faces(Import& import) {
    import.begin_phase(0.0, text_begins);
    const std::vector<std::uint8_t> bytes = import.bytes();
    import.begin_phase(text_begins, normals_begin);
    PlyReader reader(import);
    reader.read(text_of(bytes, import.file));
    return reader.take();
}

}  // namespace

void read_ply(Import& import) {
    import.scene.format = "PLY";
    import.scene.axes = Axes::z_up;
    import.scene.materials.emplace_back();
    add_to_scene(read_ply_faces(import), import);
}

}  // namespace balcony::scene
