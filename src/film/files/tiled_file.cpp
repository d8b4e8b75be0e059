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
#include <tbb/parallel_for.h>

#include "balcony/output_file.hpp"
#include "balcony/tiled_file.hpp"
#include "balcony/work_file.hpp"
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
          places(tiles_across(window.width) * tiles_across(window.height), 0) {
        MemoryStream stream;
        { const Imf::TiledOutputFile nothing(stream, tiled_header(film, window, groups), 0); }
        beginning = std::move(stream.bytes());
        beginning.resize(beginning.size() - places_bytes());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() = default;

    [[nodiscard]] std::size_t places_bytes() const { return places.size() * sizeof places[0]; }

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

    // Whether the file begins as this one does and has this many tiles, which it is cut to.
    [[nodiscard]] bool keep(std::size_t tiles) {
        Bytes found(beginning.size());
        if (!read(found.data(), found.size(), 0) || found != beginning ||
            !read(places.data(), places_bytes(), beginning.size())) {
            return false;
        }
        end = beginning.size() + places_bytes();
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            ChunkHead head;
            if (places[tile] != end || !read(&head, sizeof head, end) || head.size < 0) {
                return false;
            }
            end += sizeof head + static_cast<std::size_t>(head.size);
        }
        std::fill(places.begin() + static_cast<std::ptrdiff_t>(tiles), places.end(), 0);
        count = tiles;
        const off_t length = ::lseek(file->descriptor(), 0, SEEK_END);
        return length >= static_cast<off_t>(end) &&
               ::ftruncate(file->descriptor(), static_cast<off_t>(end)) == 0;
    }

    fs::path name;
    fs::path part;
    Region window;
    std::vector<ChannelGroup> groups;
    std::vector<std::uint64_t> places;  // Of the tiles in the file; 0 if they are missing.
    Bytes beginning;                    // Of the file, up to the places.
    std::optional<WorkFile> file;
    std::size_t count = 0;  // The number of tiles in the file.
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
    state->end = state->beginning.size() + state->places_bytes();
    if (const int reason = state->write(state->beginning.data(), state->beginning.size(), 0)) {
        return state->failure(reason);
    }
    return TiledFile(std::move(state));
}

Result<TiledFile> TiledFile::reopen(const fs::path& picture, const Film& film,
                                    const Region& window) {
    auto state = std::make_unique<State>(picture, film, window);
    const auto refused = [&](std::string_view fault) {
        return error(fmt::format("'{}', the finished part of the picture, is {}",
                                 state->part.string(), fault),
                     {}, "restore it, or render without --resume to begin anew");
    };
    if (!fs::exists(fs::symlink_status(state->part))) {
        return refused("missing");
    }
    Result<WorkFile> opened = WorkFile::reopen(state->part);
    if (!opened) {
        return opened.diagnostics;
    }
    state->file = std::move(opened.value);
    const std::size_t above = (film.window.y - window.y) / file_tile_side;
    if (!state->keep(above * tiles_across(window.width))) {
        return refused("damaged or of another one");
    }
    return TiledFile(std::move(state));
}

Diagnostics TiledFile::add(const Film& band) {
    // Blocks of a row of tiles, in parallel.
    constexpr std::size_t block_width = 16 * file_tile_side;
    const Region& region = band.window;
    const std::size_t columns = (region.width + block_width - 1) / block_width;
    std::vector<Chunks> blocks(columns * tiles_across(region.height));
    try {
        tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
            const std::size_t x = i % columns * block_width;
            const std::size_t y = i / columns * file_tile_side;
            const Region block{region.x + x, region.y + y, std::min(block_width, region.width - x),
                               std::min(file_tile_side, region.height - y)};
            blocks[i] = compress(band, state_->groups, block, x / file_tile_side,
                                 (block.y - state_->window.y) / file_tile_side);
        });
    } catch (const std::exception& failed) {
        return {
            error(fmt::format("'{}' cannot be written: {}", state_->part.string(), failed.what()))};
    }
    for (const Chunks& block : blocks) {
        if (const int reason = state_->write(block.bytes.data(), block.bytes.size(), state_->end)) {
            return state_->failure(reason);
        }
        for (const std::size_t size : block.sizes) {
            state_->places[state_->count++] = state_->end;
            state_->end += size;
        }
    }
    return {};
}

Diagnostics TiledFile::flush() {
    // The chunks come before their places, in case the machine stops.
    if (::fsync(state_->file->descriptor()) != 0) {
        return state_->failure(errno);
    }
    if (const int reason = state_->write(state_->places.data(), state_->places_bytes(),
                                         state_->beginning.size())) {
        return state_->failure(reason);
    }
    return ::fsync(state_->file->descriptor()) == 0 ? Diagnostics{} : state_->failure(errno);
}

Diagnostics TiledFile::commit() {
    if (Diagnostics found = flush(); !found.empty()) {
        return found;
    }
    return move_into_place(state_->part, state_->name);
}

}  // namespace balcony::render
