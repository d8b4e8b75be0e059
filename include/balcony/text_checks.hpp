// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Text checks: what is wrong with texts that are being edited, found in the background.

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "balcony/base.hpp"

namespace balcony::app {

/// What is wrong with one state of a text.
struct TextCheck {
    std::string name;
    std::shared_ptr<const SourceText> text;
    /// The mistakes, and then as warnings what `check` finds about its cameras, each at the name of
    /// its camera.
    Diagnostics found;
    /// Whether the cameras have been looked at, too; they are if there is no error.
    bool is_complete = false;
};

/// Checks texts on a thread of its own. A new text of a name takes the place of the one before,
/// whose check is stopped. What is found is told twice: the mistakes first, as soon as they are
/// known, and all of it at the end.
class TextChecks {
public:
    /// `tell` is called on that thread, must not use this object, and is not called once it is
    /// destroyed. A text is checked once there has been none for `pause`.
    explicit TextChecks(std::function<void(const TextCheck&)> tell,
                        std::chrono::milliseconds pause = std::chrono::milliseconds(200));
    TextChecks(const TextChecks&) = delete;
    TextChecks& operator=(const TextChecks&) = delete;
    ~TextChecks();

    /// Imports, tables, images and meshes of the text are looked for in `folder`.
    void check(const std::string& name, std::shared_ptr<const SourceText> text,
               std::filesystem::path folder);
    /// Nothing more is told about a name.
    void forget(const std::string& name);

private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace balcony::app
