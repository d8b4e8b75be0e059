// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "scene/geometry.hpp"
#include "scene/polygons/face_set.hpp"
#include "scene/polygons/obj_materials.hpp"
#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

// A word of a face: "7", "7/2", "7//3" or "7/2/3".
class CornerWord {
public:
    explicit CornerWord(std::string_view word) : at_(word.data()), end_(at_ + word.size()) {}

    /// Reads the next index into a list: from 1, or backwards from the end if negative. It may be
    /// missing. False if it is not an index into the list.
    bool take_index(std::size_t size, std::uint32_t& index) {
        if (at_ == end_ || *at_ == '/') {
            return true;
        }
        std::int64_t written = 0;
        const auto [stop, code] = std::from_chars(at_, end_, written);
        at_ = stop;
        const auto length = static_cast<std::int64_t>(size);
        const std::int64_t number = written < 0 ? length + 1 + written : written;
        index = static_cast<std::uint32_t>(number - 1);
        return code == std::errc() && number >= 1 && number <= length;
    }

    /// Steps over a slash; false at another character.
    bool take_slash() {
        if (at_ != end_ && *at_ != '/') {
            return false;
        }
        at_ += at_ != end_ ? 1 : 0;
        return true;
    }

    [[nodiscard]] bool is_at_end() const { return at_ == end_; }

private:
    const char* at_;
    const char* end_;
};

class ObjReader {
public:
    explicit ObjReader(Import& import) : import_(import) {}

    /// `unnamed` is the name for faces before any object.
    void read(std::string_view text, std::string unnamed) {
        object_ = std::move(unnamed);
        has_objects_ = text.starts_with("o ") || text.find("\no ") != std::string_view::npos;
        std::string joined;
        const std::size_t size = text.size();
        while (!text.empty()) {
            import_.go_on(size - text.size(), size);
            read_statement(take_statement(text, joined));
        }
        set_.warn_of_skipped(import_);
        if (not_faces_ > 0) {
            import_.warn(fmt::format("{} skipped (only faces are rendered)",
                                     counted(not_faces_, "point, line or curve statement")));
        }
    }

    /// The faces, with their materials in the scene.
    FaceSet take() {
        ObjMaterials materials(libraries_, import_);
        std::map<std::string, MaterialIndex> known;
        for (std::size_t i = 0; i < set_.sections.size(); ++i) {
            const auto [material, is_new] = known.try_emplace(material_names_[i]);
            if (is_new) {
                material->second = materials.add_to_scene(material_names_[i]);
            }
            set_.sections[i].material = material->second;
        }
        return std::move(set_);
    }

private:
    void read_statement(const Statement& statement) {
        const auto& [keyword, arguments] = statement;
        if (keyword == "v") {
            read_vertex(arguments);
        } else if (keyword == "vt") {
            V2f coordinate = read_vector<V2f>(arguments);
            // OBJ counts v from the bottom of the image, Scene from its top.
            coordinate.y = 1.0F - coordinate.y;
            set_.texture_coordinates.push_back(coordinate);
        } else if (keyword == "vn") {
            set_.normals.push_back(read_vector<V3f>(arguments));
        } else if (keyword == "f") {
            read_face(arguments);
        } else if (keyword == (has_objects_ ? "o" : "g") && !arguments.empty()) {
            object_ = arguments;
            section_.reset();
        } else if (keyword == "usemtl" && !arguments.empty()) {
            material_ = arguments;
            section_.reset();
        } else if (keyword == "s") {
            read_smoothing(arguments);
        } else if (keyword == "mtllib" && !arguments.empty()) {
            libraries_.emplace_back(arguments);
        } else if (keyword == "p" || keyword == "l" || keyword == "curv" || keyword == "surf") {
            ++not_faces_;
        }
    }

    // A vertex that cannot be read keeps its index, and faces that use it are skipped. A colour may
    // follow the position.
    void read_vertex(std::string_view arguments) {
        V3f position;
        if (!take_vector(arguments, position)) {
            position = V3f(std::numeric_limits<float>::quiet_NaN());
        }
        set_.positions.push_back(position);
        Color3f color;
        if (!arguments.empty() && take_vector(arguments, color)) {
            set_.colors.resize(set_.positions.size() - 1, Color3f(1.0F));
            set_.colors.push_back(linear_of_srgb(color));
        } else if (!set_.colors.empty()) {
            set_.colors.emplace_back(1.0F);
        }
    }

    template <class Vector>
    static Vector read_vector(std::string_view arguments) {
        Vector vector(0.0F);
        (void)take_vector(arguments, vector);
        return vector;
    }

    void read_face(std::string_view arguments) {
        corners_.clear();
        for (auto word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
            CornerWord indices(word);
            Corner corner;
            if (!indices.take_index(set_.positions.size(), corner.position) ||
                !indices.take_slash() ||
                !indices.take_index(set_.texture_coordinates.size(), corner.texture_coordinate) ||
                !indices.take_slash() || !indices.take_index(set_.normals.size(), corner.normal) ||
                !indices.is_at_end()) {
                set_.skip_out_of_range();
                return;
            }
            corners_.push_back(corner);
        }
        set_.add_polygon(corners_, smoothing_, current_section());
    }

    // "s off" and "s 0" mean flat.
    void read_smoothing(std::string_view arguments) {
        SmoothingGroup group = 0;
        const auto [stop, code] =
            std::from_chars(arguments.data(), arguments.data() + arguments.size(), group);
        const bool is_number = code == std::errc() && stop == arguments.data() + arguments.size();
        smoothing_ = is_number            ? std::min(group, smooth_by_angle - 1)
                     : arguments == "off" ? flat
                     : arguments == "on"  ? 1
                                          : smoothing_;
    }

    std::uint32_t current_section() {
        if (!section_) {
            const auto [object, is_new_object] = object_numbers_.try_emplace(
                object_, static_cast<std::uint32_t>(object_numbers_.size()));
            const auto [known, is_new] = section_numbers_.try_emplace(
                {object->second, material_}, static_cast<std::uint32_t>(set_.sections.size()));
            if (is_new) {
                set_.sections.push_back({object_, {}, object->second});
                material_names_.push_back(material_);
            }
            section_ = known->second;
        }
        return *section_;
    }

    Import& import_;
    FaceSet set_;
    std::vector<std::string> libraries_;
    std::vector<std::string> material_names_;  // By section.
    bool has_objects_ = false;  // "o" names objects if there is any, otherwise "g" does.
    std::string object_;
    std::string material_;
    SmoothingGroup smoothing_ = smooth_by_angle;
    std::map<std::string, std::uint32_t> object_numbers_;
    std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> section_numbers_;
    std::optional<std::uint32_t> section_;  // The section of the next face, if known.
    std::vector<Corner> corners_;
    std::size_t not_faces_ = 0;
};

FaceSet read_obj_faces(Import& import) {
    import.begin_phase(0.0, text_begins);
    const std::vector<std::uint8_t> bytes = import.bytes();
    import.begin_phase(text_begins, normals_begin);
    ObjReader reader(import);
    reader.read(text_of(bytes, import.file), import.file.stem().string());
    return reader.take();
}

}  // namespace

void read_obj(Import& import) {
    import.scene.format = "Wavefront OBJ";
    add_to_scene(read_obj_faces(import), import);
}

}  // namespace balcony::scene
