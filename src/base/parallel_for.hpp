// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/tsan.hpp"

namespace balcony {

namespace detail {

inline char forked = 0;
inline char joined = 0;

}  // namespace detail

/// Calls visit(i) for each i below the count, in parallel, by at most so many threads; 0 for all of
/// the machine, which is the most. What visit throws is thrown again here, once.
template <class Visit>
void parallel_for(std::size_t count, const Visit& visit, std::size_t threads = 0) {
    const auto ordered = tsan::ordered<detail::forked, detail::joined>(visit);
    tsan::release(detail::forked);
    const auto visit_all = [&] { tbb::parallel_for(std::size_t{0}, count, ordered); };
    const auto most = static_cast<std::size_t>(tbb::info::default_concurrency());
    if (threads == 0 || threads >= most) {
        visit_all();
    } else {
        tbb::task_arena(static_cast<int>(threads)).execute(visit_all);
    }
    tsan::acquire(detail::joined);
}

}  // namespace balcony
