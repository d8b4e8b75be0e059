// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Progress: how long work tells how far it is. A std::stop_token tells it to end early, which is an
// error of Kind::interrupted.

#include <functional>

#include "balcony/base.hpp"

namespace balcony {

/// Called with the part of some work that is done, from 0 to 1 and never less than before, one call
/// at a time. Must be fast and not throw.
using PartDone = std::function<void(double part)>;

/// For work that is a part of other work, from `begin` to `end` of it.
[[nodiscard]] inline PartDone part_of(const PartDone& whole, double begin, double end) {
    if (!whole) {
        return {};
    }
    return [=](double part) { whole(begin + part * (end - begin)); };
}

/// The error of work that was stopped.
[[nodiscard]] inline Diagnostic stopped() { return error(Kind::interrupted, "interrupted"); }

}  // namespace balcony
