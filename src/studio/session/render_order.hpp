// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a page orders in full quality: a picture or a film of what is shown.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <variant>

#include <nlohmann/json_fwd.hpp>

#include "balcony/animation.hpp"
#include "balcony/inspect.hpp"
#include "studio/serve.hpp"

namespace balcony::studio {

/// What came of an order.
struct Rendered {
    std::filesystem::path file{};  ///< Empty if there is none.
    bool stopped = false;
    std::size_t samples = 0;  ///< Of a pixel.
    double seconds = 0.0;
    Diagnostics diagnostics{};
};

class RenderOrder {
public:
    /// In the scene and the light of the studio. Throws a Refusal.
    RenderOrder(const Options& options, const nlohmann::json& asked);

    [[nodiscard]] const std::string& ending() const { return ending_; }
    /// Whether something is there that would be lost if this file were made.
    [[nodiscard]] bool is_used(const std::filesystem::path& file) const;

    /// The file to make. Throws a Refusal if that cannot be.
    void write_to(const std::filesystem::path& file);
    /// Makes it of what the inspector shows. `tell` is called with the part that is done and the
    /// seconds so far, by any thread, one at a time.
    [[nodiscard]] Rendered carry_out(live::Inspector& inspector,
                                     const std::function<void(double, double)>& tell,
                                     const std::stop_token& stop) const;

private:
    std::string ending_;  ///< Of its file: ".png".
    std::variant<app::Request, app::AnimationRequest> order_;
};

}  // namespace balcony::studio
