// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace balcony {

#if defined(__SANITIZE_THREAD__)
namespace detail {

// oneTBB is compiled without ThreadSanitizer, which therefore has to be told that work handed to
// threads starts after the preceding code and ends before the following code. Two pieces of the
// work are unordered, so races between them are still detected. These are not members, so that
// nothing is read before the order is known.
inline char forked = 0;
inline char joined = 0;

}  // namespace detail
#endif

/// Calls visit(i) for each i below the count, in parallel, by at most so many threads; 0 for all of
/// the machine, which is the most. What visit throws is thrown again here, once.
template <class Visit>
void parallel_for(std::size_t count, const Visit& visit, std::size_t threads = 0) {
#if defined(__SANITIZE_THREAD__)
    const auto ordered = [&visit](std::size_t i) {
        __tsan_acquire(&detail::forked);
        visit(i);
        __tsan_release(&detail::joined);
    };
    __tsan_release(&detail::forked);
#else
    const Visit& ordered = visit;
#endif
    const auto visit_all = [&] { tbb::parallel_for(std::size_t{0}, count, ordered); };
    const auto most = static_cast<std::size_t>(tbb::info::default_concurrency());
    if (threads == 0 || threads >= most) {
        visit_all();
    } else {
        tbb::task_arena(static_cast<int>(threads)).execute(visit_all);
    }
#if defined(__SANITIZE_THREAD__)
    __tsan_acquire(&detail::joined);
#endif
}

}  // namespace balcony
