// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Solving: a camera of a file, and a file of marks that says what its picture is to show.
//
//     read_marks(file) ─▶ Marks ─┐
//                                ├─▶ solve_camera(SolveRequest) ─▶ SolveReport, the new camera file
//     a camera of a file ────────┘
//
// docs/solve.md has the format of the file.

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/drawing.hpp"
#include "balcony/lang.hpp"
#include "balcony/solve.hpp"

namespace balcony::app {

/// What a picture is to show.
struct Marks {
    /// A number of a file, which is an angle in radians if it has a unit.
    struct Number {
        double value = 0.0;
        bool is_angle = false;
        SourceSpan written{};
    };
    /// What is said of a parameter of the camera.
    struct Parameter {
        std::string name;
        SourceSpan written{};
        std::optional<Number> start{};
        std::optional<std::array<Number, 2>> range{};
        std::optional<Number> deviation{};
    };

    /// A mark that is on an object of a scene.
    struct OnObject {
        std::size_t mark = 0;  ///< Its index in the problem.
        std::string object;
        /// Where in the bounding box of the object, which reaches from -1 to 1 along each axis of
        /// the scene.
        Imath::V3d part{0.0};
        SourceSpan written{};
    };
    /// A mark that is infinitely far away, in the direction from one mark to another.
    struct Direction {
        std::size_t mark = 0;               ///< Its index in the problem.
        std::array<std::size_t, 2> ends{};  ///< Those of the other two.
        SourceSpan written{};
    };
    /// An outline of an object of a scene.
    struct OutlineOfObject {
        std::size_t outline = 0;  ///< Its index in the problem.
        std::string object;
        SourceSpan written{};
    };

    std::size_t width = 0;  ///< Of the picture, in pixels.
    std::size_t height = 0;
    /// Of places and directions; if empty, those of the scene or, without one, of the camera.
    std::optional<Axes> axes{};
    std::filesystem::path scene{};  ///< Relative to the folder of the file; empty if there is none.
    std::vector<OnObject> on_objects{};
    std::vector<Direction> directions{};
    std::vector<OutlineOfObject> outlines_of_objects{};
    /// The parameters to be found; if empty, all that are numbers and not fixed.
    std::optional<std::vector<Parameter>> unknowns{};
    /// The others are found. With `unknowns`, these say more about some of those.
    std::optional<std::vector<Parameter>> fixed{};
    /// Without unknowns. Its marks are in the axes of the file.
    solve::Problem problem{};
    /// What reports call each constraint: "at gable", "corner 3 of board 1".
    std::vector<std::string> labels{};
};

/// Reads a file of marks, a text in YAML of at most 16 MB. All mistakes that it has without a
/// camera are reported, with their place.
[[nodiscard]] Result<Marks> read_marks(const std::filesystem::path& file);
[[nodiscard]] Result<Marks> read_marks(const std::shared_ptr<const SourceText>& text);

struct SolveRequest {
    std::string camera;              ///< FILE, FILE:NAME or the name of a built-in camera.
    std::vector<std::string> set{};  ///< Values of parameters, where the search begins.
    std::filesystem::path marks;
    std::size_t starts = 1;  ///< As solve::Options::starts.
    /// The camera file with the values that were found; none is written without a name.
    std::filesystem::path output{};
    /// The drawing of draw_marks(): .svg, .png, .jpg, .webp or .tif; none without a name.
    std::filesystem::path drawing{};
    /// A picture of the size of the marks' picture, such as the photo, that a drawing of pixels is
    /// over; white without a name.
    std::filesystem::path over{};
    /// The map of uncertainty_map(): .png, .jpg, .webp or .tif; none without a name.
    std::filesystem::path uncertainty{};
};

struct SolvedParameter {
    std::string name;
    bool is_angle = false;   ///< Numbers are in radians.
    double first = 0.0;      ///< Where the search began.
    double value = 0.0;      ///< As the camera file has it.
    double deviation = 0.0;  ///< Infinite if the constraints do not determine it.
    std::string written;     ///< How the camera file has it.
};

/// Two parameters whose errors are nearly the same.
struct Correlation {
    std::string first, second;
    double value = 0.0;  ///< Between -1 and 1.
};

struct SolveReport {
    std::string camera;  ///< Its name.
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<SolvedParameter> parameters{};
    std::vector<Correlation> correlations{};  ///< The strong ones.
    /// As it was solved: of marks in the axes of the camera.
    solve::Problem problem{};
    std::vector<std::string> labels{};  ///< As Marks::labels.
    solve::ErrorGrid grid{};            ///< Of the solution's errors.
    solve::Solution solution{};
    std::string text{};  ///< The new camera file.
};

/// The root mean square of what marks miss their positions by, in pixels; nothing without
/// positions.
[[nodiscard]] std::optional<double> position_error(const SolveReport& report);

/// The expected uncertainty of projections over the picture, in pixels.
struct Uncertainty {
    double least = 0.0, median = 0.0, most = 0.0;
};
/// Nothing if it is known at no place.
[[nodiscard]] std::optional<Uncertainty> uncertainty(const SolveReport& report);

/// The numbers of all constraints, those first that are missed by the most deviations.
[[nodiscard]] std::vector<std::size_t> worst_constraints(const SolveReport& report);

/// Where the marks are demanded and where the picture shows them, with what the constraints miss
/// several times as large as it is, over a tint that says how uncertain projections are.
[[nodiscard]] analyse::Drawing draw_marks(const SolveReport& report);

/// The expected uncertainty of projections over the picture, as a map in colours with lines of
/// equal deviation.
[[nodiscard]] Image uncertainty_map(const SolveReport& report);

/// Finds the camera, and writes it. Constraints that are missed by far are warnings.
[[nodiscard]] Result<SolveReport> solve_camera(const SolveRequest& request,
                                               const std::stop_token& stop = {});

/// The values that were found, as --set has them.
[[nodiscard]] std::vector<std::string> settings_of(const SolveReport& report);

}  // namespace balcony::app
