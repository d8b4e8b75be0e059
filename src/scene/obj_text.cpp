// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/obj_text.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "scene/geometry.hpp"

namespace balcony::scene {

namespace {

constexpr std::string_view blanks = " \t\r\f\v";

// The list entry of an index: from 1, or backwards from the end if negative; 0 if out of range.
std::size_t resolve(std::string_view word, std::size_t size) {
    long long index = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (code != std::errc() || end != word.data() + word.size()) {
        return 0;
    }
    const auto length = static_cast<long long>(size);
    const long long place = index < 0 ? length + 1 + index : index;
    return place >= 1 && place <= length ? static_cast<std::size_t>(place) : 0;
}

class Checker {
public:
    Checker(ObjText& result, Import& import) : result_(result), import_(import) {}

    void read(std::string_view text, std::string_view unnamed);

private:
    void read_statement(const Statement& statement);
    void read_vertex(std::string_view arguments);
    void read_vector(const char* keyword, std::size_t components, std::string_view arguments,
                     std::size_t& count);
    void read_face(std::string_view arguments);
    bool add_corner(std::string_view word);
    std::string& faces_of_section();
    void write_sections();
    void warn();

    // Assimp needs quadratic time to triangulate a polygon.
    static constexpr std::size_t max_corners = 4096;

    struct Corner {
        std::size_t position = 0;
        std::size_t texture_coordinate = 0;
        std::size_t normal = 0;
    };

    ObjText& result_;
    Import& import_;
    bool has_objects_ = false;  // "o" names objects if there is any, otherwise "g" does.
    std::vector<bool> usable_;
    std::size_t texture_coordinates_ = 0;
    std::size_t normals_ = 0;
    std::size_t out_of_range_ = 0;
    std::size_t not_usable_ = 0;
    std::size_t malformed_ = 0;
    std::size_t not_faces_ = 0;
    std::vector<Corner> corners_;
    std::string object_;
    std::string material_;
    std::map<std::pair<std::string, std::string>, std::size_t> section_numbers_;
    std::vector<std::string> faces_;      // Text by section.
    std::optional<std::size_t> section_;  // The section of the next face, if known.
};

void Checker::read(std::string_view text, std::string_view unnamed) {
    object_ = unnamed;
    has_objects_ = text.starts_with("o ") || text.find("\no ") != std::string_view::npos;
    std::string joined;
    while (!text.empty()) {
        read_statement(take_statement(text, joined));
    }
    write_sections();
    warn();
}

void Checker::read_statement(const Statement& statement) {
    const auto& [keyword, arguments] = statement;
    if (keyword == "v") {
        read_vertex(arguments);
    } else if (keyword == "vt") {
        read_vector("vt", 2, arguments, texture_coordinates_);
    } else if (keyword == "vn") {
        read_vector("vn", 3, arguments, normals_);
    } else if (keyword == "f") {
        read_face(arguments);
    } else if (keyword == (has_objects_ ? "o" : "g") && !arguments.empty()) {
        object_ = arguments;
        section_.reset();
    } else if (keyword == "usemtl" && !arguments.empty()) {
        material_ = arguments;
        section_.reset();
    } else if (keyword == "mtllib" && !arguments.empty()) {
        result_.material_libraries.emplace_back(arguments);
    } else if (keyword == "p" || keyword == "l" || keyword == "curv" || keyword == "surf") {
        ++not_faces_;
    }
}

// A vertex that is not finite or too large keeps its index, and faces that use it are skipped.
void Checker::read_vertex(std::string_view arguments) {
    V3f position(0.0F);
    bool good = true;
    for (unsigned i = 0; i < 3; ++i) {
        good = to_float(take_word(arguments), position[static_cast<int>(i)]) && good;
    }
    good = good && usable(position);
    usable_.push_back(good);
    if (!good) {
        position = V3f(0.0F);
    }
    fmt::format_to(std::back_inserter(result_.text), "v {} {} {}\n", position.x, position.y,
                   position.z);
}

void Checker::read_vector(const char* keyword, std::size_t components, std::string_view arguments,
                          std::size_t& count) {
    std::array<float, 3> numbers{};
    for (std::size_t i = 0; i < components; ++i) {
        if (!to_float(take_word(arguments), numbers[i])) {
            numbers[i] = 0.0F;
        }
    }
    ++count;
    auto out = std::back_inserter(result_.text);
    if (components == 2) {
        fmt::format_to(out, "{} {} {}\n", keyword, numbers[0], numbers[1]);
    } else {
        fmt::format_to(out, "{} {} {} {}\n", keyword, numbers[0], numbers[1], numbers[2]);
    }
}

bool Checker::add_corner(std::string_view word) {
    Corner corner;
    const std::size_t first = word.find('/');
    const std::size_t second =
        first == std::string_view::npos ? std::string_view::npos : word.find('/', first + 1);
    corner.position = resolve(word.substr(0, first), usable_.size());
    if (corner.position == 0) {
        return false;
    }
    if (first != std::string_view::npos && first + 1 < word.size() && second != first + 1) {
        const std::size_t length =
            second == std::string_view::npos ? std::string_view::npos : second - first - 1;
        corner.texture_coordinate = resolve(word.substr(first + 1, length), texture_coordinates_);
        if (corner.texture_coordinate == 0) {
            return false;
        }
    }
    if (second != std::string_view::npos && second + 1 < word.size()) {
        corner.normal = resolve(word.substr(second + 1), normals_);
        if (corner.normal == 0) {
            return false;
        }
    }
    corners_.push_back(corner);
    return true;
}

void Checker::read_face(std::string_view arguments) {
    corners_.clear();
    bool coordinates = true;
    bool normals = true;
    for (auto word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
        if (!add_corner(word)) {
            ++out_of_range_;
            return;
        }
        if (!usable_[corners_.back().position - 1]) {
            ++not_usable_;
            return;
        }
        coordinates = coordinates && corners_.back().texture_coordinate > 0;
        normals = normals && corners_.back().normal > 0;
    }
    if (corners_.size() < 3 || corners_.size() > max_corners) {
        ++malformed_;
        return;
    }
    std::string& faces = faces_of_section();
    auto out = std::back_inserter(faces);
    faces += 'f';
    for (const Corner& corner : corners_) {
        fmt::format_to(out, " {}", corner.position);
        if (coordinates) {
            fmt::format_to(out, "/{}", corner.texture_coordinate);
        }
        if (normals) {
            fmt::format_to(out, "{}/{}", coordinates ? "" : "/", corner.normal);
        }
    }
    faces += '\n';
}

std::string& Checker::faces_of_section() {
    if (!section_) {
        const auto [known, is_new] =
            section_numbers_.try_emplace({object_, material_}, faces_.size());
        if (is_new) {
            faces_.emplace_back();
            result_.sections.push_back({object_, material_});
        }
        section_ = known->second;
    }
    return faces_[*section_];
}

void Checker::write_sections() {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        fmt::format_to(std::back_inserter(result_.text), "o {}\n", i);
        result_.text += faces_[i];
    }
}

void Checker::warn() {
    const auto left_out = [&](std::size_t count, const char* noun, const char* reason) {
        if (count > 0) {
            import_.warn(fmt::format("{} skipped {}", counted(count, noun), reason));
        }
    };
    left_out(out_of_range_, "face", "because of a vertex index out of range");
    left_out(not_usable_, "face", "because of a vertex that is not finite or too large");
    left_out(malformed_, "face",
             fmt::format("with fewer than 3 or more than {} corners", max_corners).c_str());
    left_out(not_faces_, "point, line or curve statement", "(only faces are rendered)");
}

}  // namespace

ObjText check_obj(std::string_view file_text, std::string_view unnamed, Import& import) {
    ObjText result;
    result.text.reserve(file_text.size() + file_text.size() / 4);
    Checker(result, import).read(file_text, unnamed);
    return result;
}

Statement take_statement(std::string_view& text, std::string& joined) {
    const auto take_line = [&] {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!line.empty() && blanks.find(line.back()) != std::string_view::npos) {
            line.remove_suffix(1);
        }
        return line;
    };
    std::string_view line = take_line();
    if (line.ends_with('\\') && !line.starts_with('#')) {
        joined = line.substr(0, line.size() - 1);
        bool goes_on = true;
        while (goes_on && !text.empty()) {
            const std::string_view next = take_line();
            goes_on = next.ends_with('\\');
            joined += ' ';
            joined += next.substr(0, next.size() - (goes_on ? 1 : 0));
        }
        line = joined;
    }
    Statement statement;
    statement.keyword = take_word(line);
    if (statement.keyword.starts_with('#')) {
        return {};
    }
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    statement.arguments = line;
    return statement;
}

std::string_view take_word(std::string_view& arguments) {
    arguments.remove_prefix(std::min(arguments.find_first_not_of(blanks), arguments.size()));
    const std::string_view word = arguments.substr(0, arguments.find_first_of(blanks));
    arguments.remove_prefix(word.size());
    return word;
}

bool to_float(std::string_view word, float& number) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    // Converts via double: a number too small for a float is zero, not an error.
    double value = 0.0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size() || word.empty()) {
        return false;
    }
    number = static_cast<float>(value);
    return std::isfinite(number);
}

}  // namespace balcony::scene
