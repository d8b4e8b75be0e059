// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texels that do not fit into the memory limit, in a temporary file.
//
// The file is divided into chunks. Those in use are copied to frames, which are all the memory that
// the limit allows. If all frames are taken, a chunk that was not used since it was last considered
// gives its frame away (the clock algorithm). Readers take no lock for a chunk that is in a frame:
// they read, and read again if the chunk has lost its frame meanwhile (a sequence lock: H.-J.
// Boehm, "Can Seqlocks Get Along with Programming Language Memory Models?", 2012).
//
// The file is not mapped into memory, since a disk that fails would then end the process by a
// signal.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::render {

class SpillFile;

/// Memory for texels: on the heap, or a part of a file.
class TexelBlock {
public:
    /// On the heap. Throws std::bad_alloc.
    explicit TexelBlock(std::size_t bytes) : heap_(new std::byte[bytes]), bytes_(bytes) {}

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

private:
    friend class SpillFile;

    // Where a chunk is: the number of its frame, and a number that is new whenever it is read from
    // the file. 0 if it is in no frame.
    using Slot = std::atomic<std::uint64_t>;

    TexelBlock() = default;

    template <class Texel>
    [[nodiscard]] Texel in_file(std::size_t offset) const;

    std::unique_ptr<std::byte[]> heap_;
    std::size_t bytes_ = 0;
    // In a file:
    SpillFile* file_ = nullptr;
    std::size_t begin_ = 0;
    std::unique_ptr<Slot[]> slots_;
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

    /// The same texels in the file. The file has no name, so that the system removes it whatever
    /// ends the process; it is created with the first block, in $TMPDIR or /var/tmp. It is an error
    /// if the folder has no space.
    [[nodiscard]] Result<TexelBlock> keep(const TexelBlock& in_memory);

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
    void read_chunk(std::size_t offset, std::byte* to);

    std::size_t max_frames_;
    std::unique_ptr<Frame[]> frames_;
    std::atomic<bool> failed_ = false;
    mutable std::mutex mutex_;  // Of everything below, and of the holders of frames.
    std::condition_variable filled_;
    int descriptor_ = -1;
    std::size_t size_ = 0;
    std::size_t made_frames_ = 0;
    std::vector<std::size_t> free_;  // Frames that hold nothing.
    std::size_t hand_ = 0;           // Of the clock.
    std::uint64_t reads_ = 0;
    int failure_ = 0;  // The system's number of the first one.
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
