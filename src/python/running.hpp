// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Work that takes long, while Python goes on: its other threads run, Ctrl-C stops the work, and
// what is told meanwhile is told by the thread that called.

#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

namespace balcony::python {

/// Calls work(stop) on a thread of its own, and returns when it has ended. Must be called with the
/// lock of Python, which is released meanwhile. `meanwhile` is called with the lock again and
/// again. What it raises, a signal, and the end of the interpreter stop the work; the exception is
/// raised when the work has ended. Raises balcony.UsageError in a process that was forked after a
/// first run, since such a process lacks the threads of the library.
void run(const std::function<void(const std::stop_token&)>& work,
         const std::function<void()>& meanwhile = {});

/// The same for work that makes something.
template <class Work>
[[nodiscard]] auto made_by(const Work& work, const std::function<void()>& meanwhile = {}) {
    std::optional<decltype(work(std::stop_token()))> made;
    run([&](const std::stop_token& stop) { made.emplace(work(stop)); }, meanwhile);
    return std::move(*made);
}

/// Stops all work and waits for its end, as the interpreter is about to end.
void stop_all();

}  // namespace balcony::python
