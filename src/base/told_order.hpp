// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// oneTBB is compiled without ThreadSanitizer, which therefore has to be told in which order the
// work runs that is handed to threads. Pieces of work that no mark puts in order stay unordered, so
// races between them are still detected. Other builds do nothing here.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace balcony::told_order {

/// What follows comes after what came before() the same mark until now.
inline void after([[maybe_unused]] char& mark) {
#if defined(__SANITIZE_THREAD__)
    __tsan_acquire(&mark);
#endif
}

/// What comes until now is before what follows after() the same mark.
inline void before([[maybe_unused]] char& mark) {
#if defined(__SANITIZE_THREAD__)
    __tsan_release(&mark);
#endif
}

/// The same function, after one mark and before another. Marks are global, so that nothing is read
/// before the order is known. The function must outlive the result.
template <char& after_mark, char& before_mark, class Function>
auto between(const Function& function) {
    struct Before {
        ~Before() { before(before_mark); }
    };
    return [&function](auto&&... arguments) -> decltype(auto) {
        after(after_mark);
        const Before at_the_end;
        return function(arguments...);
    };
}

}  // namespace balcony::told_order
