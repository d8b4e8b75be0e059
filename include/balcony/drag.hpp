// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drag: a hand pulls at what a picture shows, and the parameters of its camera follow.
//
//     Dragger::make(picture, parameters) ─▶ drag(Drag) ─▶ Dragged: values, and what did not follow
//
// A view drags by Change::drag (live.hpp).

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/lang.hpp"

namespace balcony::live {

/// Another value for a parameter, in place of what the text says.
struct Value {
    std::string parameter;
    double value = 0.0;  ///< In radians if it is an angle.

    bool operator==(const Value&) const = default;
};

/// A point of space that is pulled, or held where it is.
struct Pull {
    Imath::V3d point{0.0};     ///< In the axes of the scene; at infinity, the direction to it.
    bool at_infinity = false;  ///< As what a ray shows that meets nothing.
    Imath::V2d from{0.0};      ///< Where the picture showed it before, in its pixels.
    Imath::V2d to{0.0};        ///< Where it is wanted; the same if it is held.

    bool operator==(const Pull&) const = default;
};

/// All that is pulled at once.
struct Drag {
    std::vector<Pull> pulls{};              ///< Without any, nothing is dragged.
    std::vector<std::string> parameters{};  ///< What follows; all open ones if it is empty.
    std::size_t layer = 0;                  ///< The camera layer that is pulled, from the back.

    bool operator==(const Drag&) const = default;
};

/// What became of a drag.
struct Dragged {
    std::uint64_t change = 0;  ///< Of a view: the number of the change that asked for it.
    /// Of the parameters that follow; as they were if nothing could.
    std::vector<Value> values{};
    /// Of a pull.
    struct Point {
        std::optional<Imath::V2d> at{};  ///< Where the picture shows it now.
        double miss = 0.0;               ///< How far that is from where it is wanted, in pixels.
        bool follows = false;            ///< It is there, within half a pixel.
    };
    std::vector<Point> points{};  ///< By pull.
    Diagnostics diagnostics{};    ///< Why nothing follows.
    double seconds = 0.0;         ///< That it took.
};

/// The camera of one picture in one size at one time, at which a hand pulls. Belongs to one thread.
class Dragger {
public:
    /// Compiles a camera layer of a picture, by its number from the back, in a picture of a size in
    /// pixels, at a time in seconds.
    [[nodiscard]] static Result<Dragger> make(const lang::OpenPicture& picture, std::size_t layer,
                                              const std::array<std::size_t, 2>& size,
                                              double time = 0.0, const std::stop_token& stop = {});
    Dragger(Dragger&&) noexcept;
    Dragger& operator=(Dragger&&) noexcept;
    ~Dragger();

    /// Finds values for the parameters that follow, from those before the drag: other open
    /// parameters keep theirs. What is pulled less than it is asked for is least in all, and
    /// parameters change no more than they need to. `axes` are those of the points.
    [[nodiscard]] Dragged drag(const Drag& drag, const std::vector<Value>& before, Axes axes,
                               const std::stop_token& stop = {});

private:
    struct State;
    explicit Dragger(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::live
