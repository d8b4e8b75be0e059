// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <fmt/format.h>

#include "balcony/content_hash.hpp"
#include "balcony/output_file.hpp"
#include "balcony/tiled_file.hpp"
#include "base/parallel_for.hpp"
#include "film/files/exr_channels.hpp"

namespace balcony::render {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "numbers in EXR files are little-endian");

using Bytes = std::vector<char>;

// OpenEXR cannot continue a file. So it writes blocks of tiles to memory, as small files of their
// own, whose chunks are appended to the file: the header, a table with the place of each tile, and
// a chunk for each tile, row by row (https://openexr.com/en/latest/OpenEXRFileLayout.html).
class MemoryStream final : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("tiles") {}

    void write(const char* bytes, int count) override {
        const std::size_t end = at_ + static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), end));
        std::copy_n(bytes, count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }

    [[nodiscard]] Bytes& bytes() { return bytes_; }

private:
    Bytes bytes_;
    std::size_t at_ = 0;
};

Imf::Header tiled_header(const Film& film, const Region& window,
                         const std::vector<ChannelGroup>& groups) {
    Imf::Header header = exr_header(film, window, groups);
    constexpr auto side = static_cast<unsigned>(file_tile_side);
    header.setTileDescription(Imf::TileDescription(side, side, Imf::ONE_LEVEL));
    header.lineOrder() = Imf::INCREASING_Y;
    return header;
}

// How a chunk begins: the tile's column and row, its level, and the number of bytes that follow.
struct ChunkHead {
    std::int32_t column = 0;
    std::int32_t row = 0;
    std::array<std::int32_t, 2> level{};
    std::int32_t size = 0;
};
static_assert(sizeof(ChunkHead) == 20);

struct Chunks {
    Bytes bytes;
    std::vector<std::size_t> sizes;  // Of each chunk with its head.
};

// The chunks of a block of tiles, which begins at the column and the row of tiles.
Chunks compress(const Film& film, const std::vector<ChannelGroup>& groups, const Region& block,
                std::size_t column, std::size_t row) {
    MemoryStream stream;
    ChannelValues values(groups);
    std::size_t at = 0;
    {
        constexpr int no_threads = 0;
        Imf::TiledOutputFile output(stream, tiled_header(film, block, groups), no_threads);
        at = stream.tellp();
        output.setFrameBuffer(values.read(film, block));
        output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
    }
    Chunks made{std::move(stream.bytes()), {}};
    made.bytes.erase(made.bytes.begin(), made.bytes.begin() + static_cast<std::ptrdiff_t>(at));
    for (std::size_t begin = 0; begin < made.bytes.size(); begin += made.sizes.back()) {
        ChunkHead head;
        std::memcpy(&head, made.bytes.data() + begin, sizeof head);
        head.column += static_cast<std::int32_t>(column);
        head.row += static_cast<std::int32_t>(row);
        std::memcpy(made.bytes.data() + begin, &head, sizeof head);
        made.sizes.push_back(sizeof head + static_cast<std::size_t>(head.size));
    }
    return made;
}

constexpr std::size_t tiles_across(std::size_t length) {
    return (length + file_tile_side - 1) / file_tile_side;
}

}  // namespace

struct TiledFile::State {
    State(const fs::path& picture, const Film& film, const Region& region)
        : name(resolved(picture)),
          part(unfinished(picture)),
          window(region),
          groups(channel_groups(film)),
          columns(tiles_across(window.width)),
          all_rows(tiles_across(window.height)) {
        MemoryStream stream;
        { const Imf::TiledOutputFile nothing(stream, tiled_header(film, window, groups), 0); }
        beginning = std::move(stream.bytes());
        end = beginning.size();
        beginning.resize(end - columns * all_rows * sizeof places[0]);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() = default;

    [[nodiscard]] Diagnostics failure(int reason) const {
        return {error(Kind::environment, fmt::format("'{}' cannot be written: {}", part.string(),
                                                     std::generic_category().message(reason)))};
    }

    // Returns the reason of a failure, or 0.
    [[nodiscard]] int write(const void* data, std::size_t size, std::uint64_t at) const {
        const auto* bytes = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t written =
                ::pwrite(file->descriptor(), bytes, size, static_cast<off_t>(at));
            if (written < 0 && errno != EINTR) {
                return errno;
            }
            const auto done = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
            bytes += done;
            size -= done;
            at += done;
        }
        return 0;
    }
    [[nodiscard]] bool read(void* data, std::size_t size, std::uint64_t at) const {
        return ::pread(file->descriptor(), data, size, static_cast<off_t>(at)) ==
               static_cast<ssize_t>(size);
    }

    [[nodiscard]] bool begins_as_this_one() const {
        Bytes found(beginning.size());
        return read(found.data(), found.size(), 0) && found == beginning;
    }

    // Finds the rows of tiles with these hashes, up to the first that has another one.
    void find_rows(const std::vector<std::uint64_t>& expected) {
        const off_t length = ::lseek(file->descriptor(), 0, SEEK_END);
        Bytes chunk;
        for (const std::uint64_t hash : expected) {
            std::vector<std::size_t> sizes;
            ContentHash found;
            for (std::uint64_t next = end; sizes.size() < columns; next += sizes.back()) {
                ChunkHead head;
                if (!read(&head, sizeof head, next) || head.size < 0 || head.size > length) {
                    return;
                }
                sizes.push_back(sizeof head + static_cast<std::size_t>(head.size));
                chunk.resize(sizes.back());
                if (!read(chunk.data(), chunk.size(), next)) {
                    return;
                }
                found.add(std::as_bytes(std::span(chunk)));
            }
            if (found.value() != hash) {
                return;
            }
            add_row(sizes, hash);
        }
    }
    // Notes a row of tiles that was appended: the sizes of its chunks, and the hash of all.
    void add_row(const std::vector<std::size_t>& sizes, std::uint64_t hash) {
        for (const std::size_t size : sizes) {
            places.push_back(end);
            end += size;
        }
        hashes.push_back(hash);
    }
    // Forgets the rows of tiles after the first ones, and what was not noted. Returns as write().
    [[nodiscard]] int cut_to(std::size_t rows) {
        if (rows < hashes.size()) {
            end = places[rows * columns];
            places.resize(rows * columns);
            hashes.resize(rows);
        }
        return ::ftruncate(file->descriptor(), static_cast<off_t>(end)) == 0 ? 0 : errno;
    }

    fs::path name;
    fs::path part;
    Region window;
    std::vector<ChannelGroup> groups;
    std::size_t columns;  // Of tiles.
    std::size_t all_rows;
    std::vector<std::uint64_t> places;  // Of the tiles in the file.
    std::vector<std::uint64_t> hashes;  // Of the rows of tiles in the file.
    Bytes beginning;                    // Of the file, up to the places.
    std::optional<WorkFile> file;
    std::uint64_t end = 0;
};

TiledFile::TiledFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
TiledFile::TiledFile(TiledFile&&) noexcept = default;
TiledFile& TiledFile::operator=(TiledFile&&) noexcept = default;
TiledFile::~TiledFile() = default;

fs::path TiledFile::unfinished(const fs::path& picture) {
    fs::path part = resolved(picture);
    part += ".part";
    return part;
}

Result<TiledFile> TiledFile::create(const fs::path& picture, const Film& film,
                                    const Region& window) {
    auto state = std::make_unique<State>(picture, film, window);
    Result<WorkFile> made = WorkFile::create(state->part);
    if (!made) {
        return made.diagnostics;
    }
    state->file = std::move(made.value);
    if (const int reason = state->write(state->beginning.data(), state->beginning.size(), 0)) {
        ::unlink(state->part.c_str());
        return state->failure(reason);
    }
    return TiledFile(std::move(state));
}

namespace {

Diagnostic refused(const fs::path& part, std::string_view fault) {
    return error(Kind::input,
                 fmt::format("'{}', the finished part of the picture, is {}", part.string(), fault),
                 "restore it, or render without --resume to begin anew");
}

}  // namespace

Result<WorkFile> TiledFile::open(const fs::path& picture) {
    const fs::path part = unfinished(picture);
    return fs::exists(fs::symlink_status(part)) ? WorkFile::reopen(part)
                                                : Result<WorkFile>(refused(part, "missing"));
}

Result<TiledFile> TiledFile::reopen(WorkFile file, const fs::path& picture, const Film& film,
                                    const Region& window, std::vector<std::uint64_t> hashes) {
    auto state = std::make_unique<State>(picture, film, window);
    state->file = std::move(file);
    if (!state->begins_as_this_one()) {
        return refused(state->part, "damaged or of another one");
    }
    hashes.resize(std::min(hashes.size(), state->all_rows));
    state->find_rows(hashes);
    if (const int reason = state->cut_to(state->hashes.size())) {
        return state->failure(reason);
    }
    return TiledFile(std::move(state));
}

std::size_t TiledFile::rows() const { return state_->hashes.size(); }

Diagnostics TiledFile::add(const Film& band) {
    // Blocks of a row of tiles, in parallel.
    constexpr std::size_t block_width = 16 * file_tile_side;
    const Region& region = band.window;
    const std::size_t columns = (region.width + block_width - 1) / block_width;
    std::vector<Chunks> blocks(columns * tiles_across(region.height));
    try {
        parallel_for(blocks.size(), [&](std::size_t i) {
            const std::size_t x = i % columns * block_width;
            const std::size_t y = i / columns * file_tile_side;
            const Region block{region.x + x, region.y + y, std::min(block_width, region.width - x),
                               std::min(file_tile_side, region.height - y)};
            blocks[i] = compress(band, state_->groups, block, x / file_tile_side,
                                 (block.y - state_->window.y) / file_tile_side);
        });
    } catch (const std::exception& failed) {
        return {exr_failure(state_->part, failed)};
    }
    for (std::size_t row = 0; row < blocks.size(); row += columns) {
        ContentHash hash;
        std::vector<std::size_t> sizes;
        std::uint64_t at = state_->end;
        for (const Chunks& block : std::span(blocks).subspan(row, columns)) {
            if (const int reason = state_->write(block.bytes.data(), block.bytes.size(), at)) {
                return state_->failure(reason);
            }
            const std::span<const char> bytes = block.bytes;
            for (std::size_t chunk = 0, begin = 0; chunk < block.sizes.size(); ++chunk) {
                hash.add(std::as_bytes(bytes.subspan(begin, block.sizes[chunk])));
                begin += block.sizes[chunk];
            }
            at += block.bytes.size();
            sizes.insert(sizes.end(), block.sizes.begin(), block.sizes.end());
        }
        state_->add_row(sizes, hash.value());
    }
    return {};
}

Result<std::vector<std::uint64_t>> TiledFile::flush(const Film& band) {
    const int reason = state_->cut_to((band.window.y - state_->window.y) / file_tile_side);
    if (reason != 0 || ::fsync(state_->file->descriptor()) != 0) {
        return state_->failure(reason != 0 ? reason : errno);
    }
    return state_->hashes;
}

Diagnostics TiledFile::commit() {
    const std::vector<std::uint64_t>& places = state_->places;
    if (const int reason = state_->write(places.data(), places.size() * sizeof places[0],
                                         state_->beginning.size())) {
        return state_->failure(reason);
    }
    // All of the file comes before its name, in case the machine stops.
    return ::fsync(state_->file->descriptor()) == 0 ? move_into_place(state_->part, state_->name)
                                                    : state_->failure(errno);
}

void TiledFile::remove() { ::unlink(state_->part.c_str()); }

}  // namespace balcony::render
