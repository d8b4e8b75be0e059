// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The EXR file of a picture whose film is larger than the memory: see bands.hpp.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"
#include "balcony/work_file.hpp"

namespace balcony::render {

/// The memory that a film takes, without what a job adds to it.
[[nodiscard]] double film_bytes(const FilmLayout& layout);

/// The side of the tiles of a file: bands have a multiple of this many rows.
inline constexpr std::size_t file_tile_side = 64;

/// The rows of a band whose film takes at most this many bytes, or one row of tiles.
[[nodiscard]] std::size_t band_height(const FilmLayout& layout, double bytes);

/// An EXR file with tiles that grows. Until it is complete, its name is that of the picture with
/// ".part" at the end; it stays there if it is not completed. A failure to write is an error of
/// Kind::environment, and leaves what was flushed before.
class TiledFile {
public:
    /// A new file for bands like this film, over a window of the picture. If it cannot be begun,
    /// there is none.
    [[nodiscard]] static Result<TiledFile> create(const std::filesystem::path& picture,
                                                  const Film& film, const Region& window);
    /// The unfinished file for this process alone. It is an error if it is missing, and one of
    /// Kind::usage if another process writes it.
    [[nodiscard]] static Result<WorkFile> open(const std::filesystem::path& picture);
    /// That file with the rows of tiles that have these hashes, as flush() gave them, or with those
    /// above the first damaged one: rows() tells. What comes after them is removed. A file of
    /// another picture is an error.
    [[nodiscard]] static Result<TiledFile> reopen(WorkFile file,
                                                  const std::filesystem::path& picture,
                                                  const Film& film, const Region& window,
                                                  std::vector<std::uint64_t> hashes);
    TiledFile(TiledFile&&) noexcept;
    TiledFile& operator=(TiledFile&&) noexcept;
    ~TiledFile();

    [[nodiscard]] static std::filesystem::path unfinished(const std::filesystem::path& picture);

    /// The rows of tiles in the file.
    [[nodiscard]] std::size_t rows() const;
    /// Appends the tiles of the next band.
    [[nodiscard]] Diagnostics add(const Film& band);
    /// Removes what was added of a band and what is after it. What is before it is on the disk
    /// then: gives the hashes of its rows of tiles.
    [[nodiscard]] Result<std::vector<std::uint64_t>> flush(const Film& band);
    /// After the last band: gives the file its name.
    [[nodiscard]] Diagnostics commit();
    /// Deletes the unfinished file, which is of no use any more.
    void remove();

private:
    struct State;
    explicit TiledFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::render
