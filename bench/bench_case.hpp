// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/camera.hpp"
#include "balcony/program.hpp"

namespace balcony::bench {

/// A camera as one would write it without Balcony: fills the arrays of seven roots (origin,
/// direction, validity) for a tile.
using PlainLoop = void (*)(const program::Tile& tile, std::span<double* const> results);

struct Case {
    std::string name;
    program::Program program;
    PlainLoop plain_loop;
};

inline constexpr std::size_t picture_width = 1920;
inline constexpr std::size_t picture_height = 1080;
inline constexpr std::size_t ray_roots = 7;

/// The rows of the table of rays.
[[nodiscard]] std::vector<Case> cases();

/// The camera of a text in the camera language; throws what is wrong with it.
[[nodiscard]] camera::Camera make_camera(const std::string& text);

/// The program of a camera's rays for a picture of a size.
[[nodiscard]] program::Program compile(const camera::Camera& camera, std::size_t width,
                                       std::size_t height);

/// Prints what each stage costs a ray, and cameras whose speed has a goal.
void print_stages();

/// Prints what the cameras of map projections cost a ray.
void print_maps();

/// Prints how long standard cameras take from text to program.
void print_compilation();

/// Prints how fast points in space are found in pictures.
void print_inverse();

/// Prints how long it takes to find parameters of a camera.
void print_solve();

/// Prints how long calls take that other languages make, too.
void print_calls();

/// Prints how long a large scene file takes to load.
void print_scenes();

/// Prints how long the command takes to start.
void print_start();

/// Prints whole frames: what an extended camera adds to the time of a picture.
void print_frames();

/// What a live view waits for when a parameter moves.
void print_live();

// The constants of the cameras, for the graph and for the loop.

struct Superelliptic {
    double a = 45.0;
    double b = 25.0;
    double c = 25.0;
    double exponent = 8.0;  ///< e = 2/gamma
    double max_u = 3.141592653589793;
    double max_v = 1.2217304763960306;  ///< 70 degrees
};

struct Zoom {
    double u = 0.6;
    double v = 0.1;
    double radius = 0.4;
    double strength = 2.5;
};

struct Pinhole {
    double half_width = 0.8;
    double half_height = 0.45;
};

void plain_superelliptic(const program::Tile& tile, std::span<double* const> results);
void plain_zoomed_superelliptic(const program::Tile& tile, std::span<double* const> results);
void plain_pinhole(const program::Tile& tile, std::span<double* const> results);

}  // namespace balcony::bench
