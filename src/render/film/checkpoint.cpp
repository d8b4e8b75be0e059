// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/checkpoint.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "balcony/content_hash.hpp"
#include "render/film/film_arrays.hpp"

namespace balcony::render {

namespace {

namespace fs = std::filesystem;

// The format is that of this machine: numbers as they are in memory. All parts but the first are
// preceded by their sizes in bytes; the hash of everything before it is the end.
//
//     signature | facts | array | ... | hash
constexpr std::string_view signature = "Balcony checkpoint 1\n";

std::string text_of(const RenderFacts& facts) {
    std::string text;
    for (const RenderFact& fact : facts) {
        text += fact.name + '\0' + fact.value + '\0';
    }
    return text;
}

RenderFacts facts_of(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\0'), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    RenderFacts facts;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        facts.push_back({words[i], words[i + 1]});
    }
    return facts;
}

// A file that becomes visible when it is complete. Its temporary name is always the same, so that
// a process that is killed leaves one such file at most.
class ReplacedFile {
public:
    explicit ReplacedFile(const fs::path& file) : file_(file), fresh_(file) {
        constexpr mode_t what_the_user_allows = 0666;
        fresh_ += ".new";
        descriptor_ =
            ::open(fresh_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, what_the_user_allows);
        note(descriptor_ >= 0);
    }
    ReplacedFile(const ReplacedFile&) = delete;
    ReplacedFile& operator=(const ReplacedFile&) = delete;
    ~ReplacedFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
            ::unlink(fresh_.c_str());
        }
    }

    void write(std::span<const std::byte> bytes) {
        hash_.add(bytes);
        while (reason_ == 0 && !bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written >= 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(written));
            } else {
                note(errno == EINTR);
            }
        }
    }
    void write_hash() {
        const std::uint64_t hash = hash_.value();
        write(std::as_bytes(std::span(&hash, 1)));
    }

    // On the disk before it is renamed, so that a power failure leaves a complete file.
    [[nodiscard]] Diagnostics commit() {
        note(reason_ == 0 ? ::fsync(descriptor_) == 0 : true);
        note(reason_ == 0 ? ::rename(fresh_.c_str(), file_.c_str()) == 0 : true);
        if (reason_ != 0) {
            return {error(fmt::format("the checkpoint '{}' cannot be written: {}", file_.string(),
                                      std::generic_category().message(reason_)))};
        }
        ::close(descriptor_);
        descriptor_ = -1;
        return {};
    }

private:
    void note(bool success) {
        if (!success && reason_ == 0) {
            reason_ = errno;
        }
    }

    fs::path file_;
    fs::path fresh_;
    int descriptor_ = -1;
    int reason_ = 0;
    ContentHash hash_;
};

class CheckpointReader {
public:
    explicit CheckpointReader(const fs::path& file) : stream_(file, std::ios::binary) {
        std::error_code failed;
        const std::uintmax_t size = fs::file_size(file, failed);
        rest_ = failed ? 0 : size;
    }

    // False if the file is shorter.
    [[nodiscard]] bool read(std::span<std::byte> bytes) {
        if (bytes.size() > rest_) {
            return false;
        }
        rest_ -= bytes.size();
        stream_.read(reinterpret_cast<char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        hash_.add(bytes);
        return stream_.good();
    }
    // The size of the next part; nothing if the file is shorter.
    [[nodiscard]] std::optional<std::uint64_t> read_size() {
        std::uint64_t size = 0;
        const bool complete = read(std::as_writable_bytes(std::span(&size, 1)));
        return complete && size <= rest_ ? std::optional(size) : std::nullopt;
    }
    [[nodiscard]] bool ends_with_hash() {
        const std::uint64_t expected = hash_.value();
        std::uint64_t found = 0;
        return read(std::as_writable_bytes(std::span(&found, 1))) && found == expected &&
               rest_ == 0;
    }

private:
    std::ifstream stream_;
    std::uintmax_t rest_ = 0;
    ContentHash hash_;
};

Diagnostic refused(const fs::path& file, std::string_view reason) {
    return error(fmt::format("'{}' cannot be resumed: {}", file.string(), reason), {},
                 "render without --resume to begin anew");
}

Diagnostic damaged(const fs::path& file) {
    return refused(file, "the file is damaged or no checkpoint");
}

std::optional<std::string_view> find(const RenderFacts& facts, std::string_view name) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const RenderFact& fact) { return fact.name == name; });
    return found != facts.end() ? std::optional<std::string_view>(found->value) : std::nullopt;
}

// The beginning of a checkpoint.
Result<RenderFacts> read_facts(CheckpointReader& input, const fs::path& file) {
    std::string beginning(signature.size(), '\0');
    if (!input.read(std::as_writable_bytes(std::span(beginning))) || beginning != signature) {
        return damaged(file);
    }
    const auto size = input.read_size();
    std::string text(size.value_or(0), '\0');
    if (!size || !input.read(std::as_writable_bytes(std::span(text)))) {
        return damaged(file);
    }
    return facts_of(text);
}

// What differs, in words; empty if nothing does.
std::string difference(const RenderFacts& before, const RenderFacts& now) {
    std::vector<std::string> found;
    for (const RenderFact& fact : now) {
        const auto value = find(before, fact.name);
        if (!value) {
            found.push_back(fmt::format("{} is new", fact.name));
        } else if (*value != fact.value && fact.value.starts_with('#')) {
            found.push_back(fmt::format("{} has changed", fact.name));
        } else if (*value != fact.value) {
            found.push_back(fmt::format("{} was '{}' and is '{}'", fact.name, *value, fact.value));
        }
    }
    for (const RenderFact& fact : before) {
        if (!find(now, fact.name)) {
            found.push_back(fmt::format("{} is missing", fact.name));
        }
    }
    return fmt::format("{}", fmt::join(found, "; "));
}

}  // namespace

Diagnostics write_checkpoint(const Film& film, const RenderFacts& facts, const fs::path& file) {
    ReplacedFile output(file);
    const auto write_part = [&output](std::span<const std::byte> bytes) {
        const std::uint64_t size = bytes.size();
        output.write(std::as_bytes(std::span(&size, 1)));
        output.write(bytes);
    };
    output.write(std::as_bytes(std::span(signature)));
    write_part(std::as_bytes(std::span<const char>(text_of(facts))));
    for_each_array(film, [&](const auto& array) { write_part(std::as_bytes(std::span(array))); });
    output.write_hash();
    return output.commit();
}

Result<RenderFacts> read_facts(const fs::path& file) {
    CheckpointReader input(file);
    return read_facts(input, file);
}

Diagnostics read_checkpoint(Film& film, const RenderFacts& facts, const fs::path& file) {
    CheckpointReader input(file);
    const Result<RenderFacts> before = read_facts(input, file);
    if (!before) {
        return before.diagnostics;
    }
    if (const std::string found = difference(*before, facts); !found.empty()) {
        return {refused(file, fmt::format("it is of another render: {}", found))};
    }
    Film read = film;
    bool fits = true;
    for_each_array(read, [&](auto& array) {
        const auto bytes = std::as_writable_bytes(std::span(array));
        fits = fits && input.read_size() == bytes.size() && input.read(bytes);
    });
    if (!fits || !input.ends_with_hash()) {
        return {damaged(file)};
    }
    film = std::move(read);
    return {};
}

}  // namespace balcony::render
