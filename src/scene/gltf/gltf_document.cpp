// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_document.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "balcony/input_file.hpp"

namespace balcony::scene {

namespace {

constexpr std::size_t glb_header_size = 12;
constexpr std::size_t chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4e4f534aU;
constexpr std::uint32_t binary_chunk = 0x004e4942U;

using Bytes = std::span<const std::uint8_t>;

std::uint32_t word_at(Bytes bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) {
        word = word << 8U | bytes[offset + i];
    }
    return word;
}

bool begins_with(Bytes bytes, std::string_view start) {
    return bytes.size() >= start.size() &&
           std::memcmp(bytes.data(), start.data(), start.size()) == 0;
}

struct GlbChunks {
    Bytes json;
    Bytes binary;
};

// Splits a GLB into its two chunks, with all lengths checked against the file's.
GlbChunks split_glb(Bytes bytes, const std::string& name) {
    const auto cut_off = [&](std::size_t expected) {
        return ReadError{error(fmt::format("{} is truncated: it declares {} and has {}", name,
                                           counted(expected, "byte"), bytes.size()),
                               {}, "copy or download it again")};
    };
    if (bytes.size() < glb_header_size) {
        throw cut_off(glb_header_size);
    }
    if (const std::uint32_t version = word_at(bytes, 4); version != 2) {
        throw ReadError{error(fmt::format("{} is glTF version {}", name, version), {},
                              "only glTF 2.0 is supported")};
    }
    const std::size_t length = word_at(bytes, 8);
    if (length > bytes.size()) {
        throw cut_off(length);
    }
    bytes = bytes.first(length);

    GlbChunks chunks;
    for (std::size_t offset = glb_header_size; offset + chunk_header_size <= bytes.size();) {
        const std::size_t size = word_at(bytes, offset);
        const std::uint32_t kind = word_at(bytes, offset + 4);
        const std::size_t begin = offset + chunk_header_size;
        if (size > bytes.size() - begin) {
            throw cut_off(begin + size);
        }
        if (kind == json_chunk && chunks.json.empty()) {
            chunks.json = bytes.subspan(begin, size);
        } else if (kind == binary_chunk && chunks.binary.empty()) {
            chunks.binary = bytes.subspan(begin, size);
        }
        offset = begin + size;
    }
    if (chunks.json.empty()) {
        throw ReadError{error(fmt::format("{} is a GLB without a JSON chunk", name))};
    }
    return chunks;
}

// A place in a text. Stepping through the text can be stopped, and is progress.
class Characters {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Characters(std::string_view text, std::size_t at, Import& import)
        : text_(text), at_(at), import_(&import) {}

    reference operator*() const { return text_[at_]; }
    Characters& operator++() {
        import_->go_on(++at_, text_.size());
        return *this;
    }
    bool operator==(const Characters& other) const { return at_ == other.at_; }

private:
    std::string_view text_;
    std::size_t at_;
    Import* import_;
};

// The word around a byte, such as Infinity.
std::string_view word_around(Bytes bytes, std::size_t at) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto is_part = [text](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    std::size_t begin = std::min(at, text.size());
    while (begin > 0 && is_part(begin - 1)) {
        --begin;
    }
    std::size_t end = begin;
    while (is_part(end)) {
        ++end;
    }
    return text.substr(begin, end - begin);
}

// What helps against a mistake at a byte of a JSON text.
std::string advice_on_json(Bytes bytes, std::size_t at, std::string_view reason) {
    const std::string_view word = word_around(bytes, at);
    for (const std::string_view name : {"NaN", "nan", "Infinity", "infinity", "Inf", "inf"}) {
        if (word == name) {
            return fmt::format("JSON has no number {}: write a finite one", name);
        }
    }
    const std::size_t expected = reason.rfind("; expected ");
    return expected != std::string_view::npos ? fmt::format("{} here", reason.substr(expected + 2))
                                              : "export the file again";
}

}  // namespace

std::string decode_percent(std::string_view uri) {
    const auto hex = [](char digit) {
        constexpr std::string_view digits = "0123456789abcdef";
        const char lower = digit >= 'A' && digit <= 'F' ? static_cast<char>(digit + 32) : digit;
        return digits.find(lower);
    };
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::size_t high =
            uri[i] == '%' && i + 2 < uri.size() ? hex(uri[i + 1]) : std::string::npos;
        const std::size_t low = high != std::string::npos ? hex(uri[i + 2]) : std::string::npos;
        if (low != std::string::npos) {
            path += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            path += uri[i];
        }
    }
    return path;
}

GltfDocument::GltfDocument(Import& import) : import_(import) {
    const std::string name = in_quotes(import_.file.string());
    import_.begin_phase(0.0, 0.1);
    bytes_ = import_.bytes();
    const Bytes all(bytes_);
    is_binary_ = begins_with(all, "glTF");
    if (is_binary_) {
        const GlbChunks chunks = split_glb(all, name);
        parse(chunks.json);
        read_buffers(chunks.binary);
        return;
    }
    if (import_.file.extension() != ".gltf") {
        throw ReadError{error(fmt::format("{} is not a GLB: it does not start with 'glTF'", name),
                              {},
                              begins_with(all, "{") ? "it looks like JSON: name it .gltf"
                                                    : "export it again as binary glTF (.glb)")};
    }
    parse(all);
    read_buffers({});
}

void GltfDocument::parse(Bytes bytes) {
    const std::string name = in_quotes(import_.file.string());
    std::string_view json(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (const std::optional<Diagnostic> fault = begin_text(json, name)) {
        throw ReadError{*fault};
    }
    const auto source_text = [&] {
        return std::make_shared<const SourceText>(import_.file.string(),
                                                  std::string(bytes.begin(), bytes.end()));
    };
    try {
        const std::string text = data_uris_.lift(json);
        import_.begin_phase(0.1, 0.4);
        root_ = Json::parse(Characters(text, 0, import_), Characters(text, text.size(), import_),
                            nullptr, false);
        if (root_.is_discarded()) {
            // For the place of the mistake in the file.
            root_ = Json::parse(json);
        }
    } catch (const Json::parse_error& failure) {
        const std::size_t end = std::min(failure.byte, bytes.size());
        const std::size_t begin = end > 0 ? end - 1 : 0;
        throw ReadError{error(fmt::format("the JSON of {} is broken", name),
                              SourceSpan{source_text(), begin, end},
                              advice_on_json(bytes, begin, failure.what()))};
    } catch (const Json::out_of_range& failure) {
        // It has no position, but ends with the number: "... number overflow parsing '1e999'".
        const std::string reason = failure.what();
        const std::size_t end = reason.rfind('\'');
        const std::size_t begin = reason.substr(0, end).rfind('\'') + 1;
        const std::string number = reason.substr(begin, end - begin);
        const auto source = source_text();
        const std::size_t found = source->text().find(number);
        const std::size_t at = found == std::string_view::npos ? 0 : found;
        throw ReadError{
            error(fmt::format("the JSON of {} has the number {}, which is too large", name, number),
                  SourceSpan{source, at, at + number.size()},
                  fmt::format("numbers of light are at most {:g}, coordinates {:g}", max_quantity,
                              max_coordinate))};
    }
    const Json& asset = member(root_, "asset");
    const std::string version = text_in(asset, "version");
    if (!version.starts_with("2.")) {
        throw ReadError{error(
            version.empty()
                ? fmt::format("{} is not a glTF file: it has no 'asset' with a 'version'", name)
                : fmt::format("{} is glTF version {}", name, in_quotes(version)),
            {}, "only glTF 2.0 is supported")};
    }
}

// A file used by several buffers is read once.
GltfDocument::Bytes GltfDocument::buffer_bytes(std::string_view uri) {
    if (uri.starts_with("data:")) {
        return embedded_.emplace_back(decode_data_uri(uri));
    }
    const std::filesystem::path path = import_.beside(import_.file, decode_percent(uri));
    auto known = files_.find(path);
    if (known == files_.end()) {
        known = files_.emplace(path, import_.bytes_of(path)).first;
    }
    return known->second;
}

void GltfDocument::read_buffers(Bytes binary) {
    const std::string name = in_quotes(import_.file.string());
    import_.begin_phase(0.4, 0.5);
    const std::size_t count = array_size(root_, "buffers");
    for (std::size_t i = 0; i < count; ++i) {
        const Json& buffer = root_["buffers"][i];
        const std::string_view uri = uri_in(buffer);
        const bool is_in_file = !uri.empty() && !uri.starts_with("data:");
        const std::string what =
            is_in_file ? in_quotes(decode_percent(uri)) : fmt::format("buffer {}", i);
        const bool is_chunk = uri.empty() && i == 0;
        try {
            const Bytes bytes = is_chunk ? binary : uri.empty() ? Bytes() : buffer_bytes(uri);
            const std::size_t stated = count_in(buffer, "byteLength", 0);
            if (bytes.size() < stated && (!uri.empty() || is_chunk)) {
                throw PartError{
                    fmt::format("it contains {} of {}", bytes.size(), counted(stated, "byte"))};
            }
            buffers_.push_back(bytes.first(std::min(bytes.size(), stated)));
        } catch (const PartError& fault) {
            throw ReadError{
                error(fmt::format("{} of {} cannot be used: {}", what, name, fault.reason), {},
                      fault.remedy.empty() ? "copy or export the file again" : fault.remedy)};
        } catch (ReadError& fault) {
            fault.diagnostic.message += fmt::format(", which contains the geometry of {}", name);
            throw;
        }
    }
    size_ = bytes_.size();
    for (const auto& [path, content] : files_) {
        size_ += content.size();
    }
    sparse_elements_ = Budget(size_, "the sparse accessors have more elements than the file bytes");
}

std::string_view GltfDocument::uri_in(const Json& owner) const {
    return data_uris_.original(text_view_in(owner, "uri"));
}

GltfDocument::Bytes GltfDocument::view(std::size_t index) const {
    import_.check_stop();
    const Json& view = element(root_, "bufferViews", index);
    const std::size_t buffer = count_in(view, "buffer", buffers_.size());
    if (buffer >= buffers_.size()) {
        throw PartError{fmt::format("buffer view {} refers to a missing buffer", index)};
    }
    const std::size_t offset = count_in(view, "byteOffset", 0);
    const std::size_t length = count_in(view, "byteLength", 0);
    const Bytes bytes = buffers_[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset) {
        throw PartError{
            fmt::format("buffer view {} extends past the end of buffer {}", index, buffer)};
    }
    return bytes.subspan(offset, length);
}

}  // namespace balcony::scene
