// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/read_source.hpp"

#include <fstream>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "balcony/lang.hpp"

namespace balcony::lang {

namespace fs = std::filesystem;

Result<std::shared_ptr<const SourceText>> read_text(const fs::path& file) {
    return read_source(file, file.string(), {});
}

Result<std::shared_ptr<const SourceText>> read_source(const fs::path& file, const std::string& name,
                                                      const SourceSpan& asked) {
    if (std::optional<Diagnostic> fault = not_a_file(file, fmt::format("'{}'", name))) {
        fault->span = asked;
        return std::move(*fault);
    }
    const auto too_large = [&] {
        return error(fmt::format("'{}' is larger than 1 MB, the maximum for camera files", name),
                     asked, "check that it is a camera file");
    };
    std::error_code failure;
    if (fs::file_size(file, failure) > max_file && !failure) {
        return too_large();
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text(max_file + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream.is_open() || stream.bad()) {
        Diagnostic unreadable =
            error(fmt::format("'{}' cannot be read", name), asked, "check its read permission");
        unreadable.kind = Kind::environment;
        return unreadable;
    }
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_file) {
        return too_large();
    }
    return std::make_shared<const SourceText>(name, std::move(text));
}

}  // namespace balcony::lang
    std::string_view begun = text;
    if (std::optional<Diagnostic> fault = begin_text(begun, fmt::format("'{}'", name))) {
        fault->span = asked;
        return std::move(*fault);
    }
