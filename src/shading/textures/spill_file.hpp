// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texels that do not fit into the memory limit, in temporary files.
//
// The files are divided into chunks. Those in use are copied to frames, which are all the memory
// that the limit allows. If all frames are taken, a chunk that was not used since it was last
// considered gives its frame away (the clock algorithm). Readers take no lock for a chunk that is
// in a frame: they read, and read again if the chunk has lost its frame meanwhile (a sequence lock:
// H.-J. Boehm, "Can Seqlocks Get Along with Programming Language Memory Models?", 2012).
//
// They are not mapped into memory, since a disk that fails would then end the process by a
// signal.

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::render {

class SpillFile;

/// Memory for texels: on the heap, or a part of a file.
class TexelBlock {
public:
    /// On the heap. Throws std::bad_alloc.
    explicit TexelBlock(std::size_t bytes) : heap_(new std::byte[bytes]) {}

    [[nodiscard]] bool in_memory() const { return heap_ != nullptr; }
    /// The bytes of a block in memory.
    [[nodiscard]] std::byte* data() const { return heap_.get(); }

    /// The texel with an index. Any number of threads may read.
    template <class Texel>
    [[nodiscard]] Texel at(std::size_t index) const {
        return in_memory() ? reinterpret_cast<const Texel*>(heap_.get())[index]
                           : in_file<Texel>(index * sizeof(Texel));
    }

    static constexpr std::size_t chunk_bytes = std::size_t{1} << 16U;

    /// Writes the first bytes of a block in a file. Returns the reason if that fails.
    using Fill = std::function<std::optional<Diagnostic>(const TexelBlock&)>;

private:
    friend class SpillFile;

    // Chunks that are not written before one of them is read.
    struct Later {
        std::size_t chunks = 0;
        Fill fill;
        std::once_flag once{};
    };

    // Where a chunk is: the number of its frame, and a number that is new whenever it is read from
    // the file. 0 if it is in no frame.
    using Slot = std::atomic<std::uint64_t>;

    TexelBlock() = default;

    template <class Texel>
    [[nodiscard]] Texel in_file(std::size_t offset) const;

    std::unique_ptr<std::byte[]> heap_;
    // In a file:
    SpillFile* file_ = nullptr;
    int descriptor_ = -1;
    std::size_t begin_ = 0;
    std::unique_ptr<Slot[]> slots_;
    std::unique_ptr<Later> later_;
};

/// Any number of threads may use it. It must outlive its blocks, and all of them must be there as
/// long as one is read.
class SpillFile {
public:
    /// `resident` is the limit for the chunks in use, in bytes, but at least 16 of them.
    explicit SpillFile(std::size_t resident);
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    /// Space in a file. `fill` writes the first chunks of the block as soon as one of them is read;
    /// others are written before. The files have no names, so that the system removes them whatever
    /// ends the process; they are created with the first blocks, in $TMPDIR or /var/tmp. It is an
    /// error if the folder has no space.
    [[nodiscard]] Result<TexelBlock> reserve(std::size_t bytes, std::size_t filled_later,
                                             TexelBlock::Fill fill);
    /// From an offset in the block on.
    [[nodiscard]] std::optional<Diagnostic> write(const TexelBlock& block, std::size_t offset,
                                                  std::span<const std::byte> bytes) const;

    /// Why a part could not be read back; its texels are 0. Nothing if that has not happened.
    [[nodiscard]] std::optional<Diagnostic> failure() const;
    [[nodiscard]] bool has_failed() const { return failed_.load(std::memory_order_relaxed); }

    /// The bytes of the chunks in use.
    [[nodiscard]] std::size_t resident_bytes() const;

private:
    friend class TexelBlock;
    using Slot = TexelBlock::Slot;

    struct Frame {
        std::unique_ptr<std::byte[]> bytes;
        Slot* holder = nullptr;  // The slot of its chunk; null while it is filled.
        std::atomic<bool> recent = false;
    };
    // The low bits of a slot are the number of the frame, counted from 1.
    static constexpr unsigned frame_bits = 24;

    [[nodiscard]] Frame& frame_at(std::uint64_t slot) const {
        return frames_[(slot & ((std::uint64_t{1} << frame_bits) - 1)) - 1];
    }
    [[nodiscard]] std::uint64_t fetch(const TexelBlock& block, std::size_t chunk);
    [[nodiscard]] std::size_t take_frame(std::unique_lock<std::mutex>& lock);
    [[nodiscard]] std::optional<std::size_t> frame_without_use();
    void read_chunk(const TexelBlock& block, std::size_t chunk, std::byte* to);
    void fill(const TexelBlock& block);
    void fail(std::string reason);

    std::size_t max_frames_;
    std::unique_ptr<Frame[]> frames_;
    std::atomic<bool> failed_ = false;
    mutable std::mutex mutex_;  // Of everything below, and of the holders of frames.
    std::condition_variable filled_;
    struct Part {
        int descriptor = -1;
        std::size_t size = 0;
    };
    std::array<Part, 4> parts_;  // Files: the system lets one thread at a time write to each.
    std::size_t blocks_ = 0;     // Reserved by now.
    std::size_t made_frames_ = 0;
    std::vector<std::size_t> free_;  // Frames that hold nothing.
    std::size_t hand_ = 0;           // Of the clock.
    std::uint64_t reads_ = 0;
    std::optional<std::string> failure_;  // The first one.
};

template <class Texel>
Texel TexelBlock::in_file(std::size_t offset) const {
    static_assert(chunk_bytes % sizeof(Texel) == 0, "no texel is in two chunks");
    const std::size_t chunk = offset / chunk_bytes;
    const Slot& slot = slots_[chunk];
    for (;;) {
        const std::uint64_t known = slot.load(std::memory_order_acquire);
        const std::uint64_t found = known != 0 ? known : file_->fetch(*this, chunk);
        SpillFile::Frame& frame = file_->frame_at(found);
        Texel texel;
        std::memcpy(&texel, frame.bytes.get() + offset % chunk_bytes, sizeof texel);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (slot.load(std::memory_order_relaxed) == found) {
            if (!frame.recent.load(std::memory_order_relaxed)) {
                frame.recent.store(true, std::memory_order_relaxed);
            }
            return texel;
        }
    }
}

}  // namespace balcony::render
