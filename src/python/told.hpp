// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far work is, told to a function of Python by the thread that called.

#include <atomic>
#include <utility>

#include <pybind11/pybind11.h>

namespace balcony::python {

/// Any thread sets the part that is done; calls, with the lock of Python, tell what is new.
class ToldPart {
public:
    /// Tells nothing to None.
    explicit ToldPart(pybind11::object tell) : tell_(std::move(tell)) {}

    void set(double done) { done_ = done; }
    void operator()() {
        const double done = done_;
        if (!tell_.is_none() && done != told_) {
            told_ = done;
            tell_(done);
        }
    }

private:
    pybind11::object tell_;
    std::atomic<double> done_ = 0.0;
    double told_ = 0.0;
};

}  // namespace balcony::python
