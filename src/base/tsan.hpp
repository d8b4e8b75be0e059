// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Annotations for ThreadSanitizer. oneTBB is compiled without it, so what the library puts in order
// is invisible to it. Pieces of work that no annotation puts in order stay unordered, so races
// between them are still detected. Other builds do nothing here.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace balcony::tsan {

/// What follows happens after what came before each release() of the same mark until now.
inline void acquire([[maybe_unused]] char& mark) {
#if defined(__SANITIZE_THREAD__)
    __tsan_acquire(&mark);
#endif
}

/// What came until now happens before what follows an acquire() of the same mark.
inline void release([[maybe_unused]] char& mark) {
#if defined(__SANITIZE_THREAD__)
    __tsan_release(&mark);
#endif
}

/// The same function, which acquires one mark before and releases another afterwards. Marks are
/// global, so that nothing is read before the order is known. The function must outlive the result.
template <char& acquired, char& released, class Function>
auto ordered(const Function& function) {
    struct Release {
        ~Release() { release(released); }
    };
    return [&function](auto&&... arguments) -> decltype(auto) {
        acquire(acquired);
        const Release at_the_end;
        return function(arguments...);
    };
}

}  // namespace balcony::tsan
