// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace balcony::scene {

/// The elements of an accessor, decoded in place: all of them are inside the file's bytes.
class GltfAccessor {
public:
    /// The type of the components, by glTF's number. Throws PartError if it is unknown.
    GltfAccessor(std::size_t component, std::size_t components, std::size_t count, bool normalized);

    /// Sets the location of the elements; by default all are zero. Throws PartError unless they
    /// fit.
    void place(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t stride);

    /// Elements of `values` replace those listed in `indices`. Throws PartError if an index
    /// is past the end.
    void replace(const GltfAccessor& indices, const GltfAccessor& values);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t components() const { return components_; }
    [[nodiscard]] bool is_normalized() const { return normalized_; }
    [[nodiscard]] std::size_t element_size() const { return component_size_ * components_; }

    /// The components of the elements with these indices, one element after the other; normalised
    /// integers in 0 .. 1 or -1 .. 1.
    void read(std::span<const std::uint32_t> elements, float* numbers) const;

    /// All elements, which are unsigned scalars. Throws PartError if they are not unsigned.
    void read_integers(std::span<std::uint32_t> integers) const;

private:
    [[nodiscard]] const std::uint8_t* at(std::size_t element) const;
    template <class Stored>
    void read_as(std::span<const std::uint32_t> elements, float* numbers) const;
    template <class Stored>
    void read_as(std::span<std::uint32_t> integers) const;

    std::span<const std::uint8_t> bytes_;
    std::size_t count_;
    std::size_t stride_ = 0;
    std::size_t component_;
    std::size_t component_size_;
    std::size_t components_;
    bool normalized_;
    std::unordered_map<std::size_t, const std::uint8_t*> replaced_;
};

}  // namespace balcony::scene
