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

/// The geometry of an OBJ file, checked and rewritten for Assimp, whose OBJ importer reads and
/// writes out of bounds when an index or a statement is malformed. In the text every number is
/// finite, every index counts from 1 and is in range, and all faces of one object with one material
/// are together, in a section "o 3" that Assimp converts to one mesh. It contains nothing else.
struct ObjText {
    struct Section {
        std::string object;    ///< The name in the file.
        std::string material;  ///< The name in the file; empty if there is none.
    };

    std::string text;
    std::vector<Section> sections;                ///< By number.
    std::vector<std::string> material_libraries;  ///< As the file names them.
};

/// Warns about skipped parts. `unnamed` is the name for faces before any object.
[[nodiscard]] ObjText check_obj(std::string_view file_text, std::string_view unnamed,
                                Import& import);

/// A trimmed line, split into the first word and the rest.
struct Statement {
    std::string_view keyword;
    std::string_view arguments;
};

/// Removes the next line from an OBJ or MTL text; comments give an empty statement. A backslash at
/// the end of a line continues it on the next, for which `joined` is the storage.
[[nodiscard]] Statement take_statement(std::string_view& text, std::string& joined);

/// Removes the next word from a list of arguments; empty at its end.
[[nodiscard]] std::string_view take_word(std::string_view& arguments);

/// Parses a finite number in single precision; false if the word is not one.
[[nodiscard]] bool to_float(std::string_view word, float& number);

}  // namespace balcony::scene
