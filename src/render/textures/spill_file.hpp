// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texels that do not fit into the memory limit, in a temporary file that is mapped into memory.
//
// The file is divided into chunks. Those in use stay in the memory of the process; when they exceed
// the limit, one that was not used since it was last considered is given back to the system (the
// clock algorithm) and mapped again when needed. A reader need not lock anything: reading a chunk
// that another thread gives back only maps it once more.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

#include "balcony/base.hpp"

namespace balcony::render {

class SpillFile;

/// Memory for texels: on the heap, or a part of a file.
class TexelBlock {
public:
    /// On the heap. Throws std::bad_alloc.
    explicit TexelBlock(std::size_t bytes) : heap_(new std::byte[bytes]), data_(heap_.get()) {}
    TexelBlock(TexelBlock&& other) noexcept;
    TexelBlock& operator=(TexelBlock&&) = delete;
    ~TexelBlock();

    [[nodiscard]] std::byte* data() const { return data_; }
    /// On the heap, where use() has nothing to do.
    [[nodiscard]] bool in_memory() const { return chunks_ == nullptr; }

    /// To be called before bytes near an offset are read, so that they count as used.
    void use(std::size_t offset) const {
        if (chunks_ &&
            chunks_[offset / chunk_bytes].state.load(std::memory_order_relaxed) != recent) {
            use_chunk(offset / chunk_bytes);
        }
    }
    /// To be called once all texels are written: nothing counts as used.
    void finish_writing() const;

    /// What one fault of a page maps at once by default on Linux.
    static constexpr std::size_t chunk_bytes = std::size_t{1} << 16U;

private:
    friend class SpillFile;

    enum State : std::uint8_t { absent, present, recent };
    struct Chunk {
        std::atomic<std::uint8_t> state = absent;
        std::byte* begin = nullptr;
    };

    TexelBlock() = default;
    void use_chunk(std::size_t index) const;

    std::unique_ptr<std::byte[]> heap_;
    std::byte* data_ = nullptr;
    SpillFile* file_ = nullptr;
    std::unique_ptr<Chunk[]> chunks_;  // Null on the heap.
    std::byte* mapping_ = nullptr;     // The reserved addresses, which begin before the data.
    std::size_t bytes_ = 0;
};

/// Any number of threads may use it. It must outlive its blocks.
class SpillFile {
public:
    /// `resident` is the limit for the chunks in use, in bytes, but at least 16 of them.
    explicit SpillFile(std::size_t resident);
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    /// A part of the file. The file has no name, so that the system removes it whatever ends the
    /// process; it is created with the first block, in $TMPDIR or /var/tmp. It is an error if the
    /// folder has no space.
    [[nodiscard]] Result<TexelBlock> allocate(std::size_t bytes);

    /// The bytes of the chunks in use.
    [[nodiscard]] std::size_t resident_bytes() const;

private:
    friend class TexelBlock;
    void admit(TexelBlock::Chunk& chunk);

    std::size_t max_chunks_;
    mutable std::mutex mutex_;
    int descriptor_ = -1;
    std::size_t size_ = 0;
    std::deque<TexelBlock::Chunk*> in_use_;  // In the order in which the clock's hand meets them.
};

}  // namespace balcony::render
