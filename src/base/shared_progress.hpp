// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "balcony/progress.hpp"

namespace balcony {

/// Passes on the progress of work that several threads do together: one call at a time, under no
/// lock, and never less than before.
class SharedProgress {
public:
    /// The function, which may be empty, must outlive this.
    explicit SharedProgress(const PartDone& told) : told_(told) {}

    void reach(double part) {
        double known = reached_;
        while (part > known && !reached_.compare_exchange_weak(known, part)) {
        }
        // While one thread tells, the others go on, and it tells what they have reached as well.
        for (double latest = -1.0; told_ && latest < reached_ && !telling_.test_and_set();) {
            latest = reached_;
            if (latest > last_told_) {
                last_told_ = latest;
                told_(latest);
            }
            telling_.clear();
        }
    }

private:
    const PartDone& told_;
    std::atomic<double> reached_ = 0.0;
    std::atomic_flag telling_;
    double last_told_ = -1.0;
};

}  // namespace balcony
