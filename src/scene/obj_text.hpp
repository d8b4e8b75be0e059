// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/import.hpp"

namespace balcony::scene {

/// The geometry of an OBJ file, checked and written anew for Assimp, whose OBJ importer reads and
/// writes out of bounds when an index or a statement is malformed. In the text every number is
/// finite, every index counts from 1 and is in range, and all faces of one object with one material
/// stand together, in a section "o 3" that Assimp makes a mesh of. There is nothing else.
struct ObjText {
    struct Section {
        std::string object;    ///< The name in the file.
        std::string material;  ///< The name in the file; empty if there is none.
    };

    std::string text;
    std::vector<Section> sections;                ///< By number.
    std::vector<std::string> material_libraries;  ///< As the file names them.
};

/// Warns of what is left out. `unnamed` names faces that come before any object.
[[nodiscard]] ObjText check_obj(std::string_view file_text, std::string_view unnamed,
                                Import& import);

/// A line without the blanks around it, split into the first word and the rest.
struct Statement {
    std::string_view keyword;
    std::string_view arguments;
};

/// Takes the next line off a text of OBJ or MTL; comments give an empty statement. A backslash at
/// the end of a line continues it on the next, for which `joined` is the storage.
[[nodiscard]] Statement take_statement(std::string_view& text, std::string& joined);

/// Takes the next word off a list of arguments; empty at its end.
[[nodiscard]] std::string_view take_word(std::string_view& arguments);

/// A finite number in single precision; false if the word is none.
[[nodiscard]] bool to_float(std::string_view word, float& number);

}  // namespace balcony::scene
