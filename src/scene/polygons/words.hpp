// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Statements, words and numbers of text formats: OBJ, MTL, STL and PLY.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace balcony::scene {

/// A trimmed line, split into the first word and the rest.
struct Statement {
    std::string_view keyword;
    std::string_view arguments;
};

/// The text of a file in UTF-8 or an 8-bit encoding, without a byte order mark. Throws ReadError if
/// it is UTF-16, with the name of the file.
[[nodiscard]] std::string_view text_of(std::span<const std::uint8_t> bytes,
                                       const std::filesystem::path& file);

/// Removes the next line from a text; a comment gives an empty statement. A backslash at the end of
/// a line continues it on the next, for which `joined` is the storage.
[[nodiscard]] Statement take_statement(std::string_view& text, std::string& joined);

/// Removes the next word from a list of arguments; empty at its end.
[[nodiscard]] std::string_view take_word(std::string_view& arguments);

/// Parses a number; false if the word is not one.
[[nodiscard]] bool to_number(std::string_view word, double& number);

/// Parses a finite number in single precision; false if the word is not one.
[[nodiscard]] bool to_float(std::string_view word, float& number);

/// The same for the next words, one per component of the vector.
template <class Vector>
[[nodiscard]] bool take_vector(std::string_view& arguments, Vector& vector) {
    bool good = true;
    for (unsigned i = 0; i < Vector::dimensions(); ++i) {
        good = to_float(take_word(arguments), vector[static_cast<int>(i)]) && good;
    }
    return good;
}

}  // namespace balcony::scene
