// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "scene/part_error.hpp"

namespace balcony::scene {

/// A limit on the amount of data that a file may request. A few bytes can refer to the same data
/// again and again, so the data created from a file is limited by its size; docs/scenes.md states
/// the limits.
class Budget {
public:
    /// `reason` completes a sentence about the part that exceeds the budget.
    Budget(std::size_t total, std::string reason) : left_(total), reason_(std::move(reason)) {}

    /// Throws PartError, and takes nothing, if less remains.
    void take(std::size_t count) {
        if (count > left_) {
            throw PartError{reason_};
        }
        left_ -= count;
    }

private:
    std::size_t left_;
    std::string reason_;
};

}  // namespace balcony::scene
