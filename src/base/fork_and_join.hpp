// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tells ThreadSanitizer what it cannot see, because oneTBB is compiled without it: work handed
// to threads starts after the preceding code and ends before the following code. Two
// pieces of the work are unordered, so races between them are still detected.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace balcony::render::fork_and_join {

// Only for ThreadSanitizer; in other builds these do nothing. They are not members, so that nothing
// is read before the order is known.
#if defined(__SANITIZE_THREAD__)
inline char forked = 0;
inline char joined = 0;
inline void before_all() { __tsan_release(&forked); }
inline void before_each() { __tsan_acquire(&forked); }
inline void after_each() { __tsan_release(&joined); }
inline void after_all() { __tsan_acquire(&joined); }
#else
inline void before_all() {}
inline void before_each() {}
inline void after_each() {}
inline void after_all() {}
#endif

}  // namespace balcony::render::fork_and_join
