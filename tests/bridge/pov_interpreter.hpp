// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// An interpreter of the part of POV-Ray's scene language that exported cameras are written in:
// declared numbers, float functions and user_defined cameras. Its rules are those of POV-Ray 3.8
// (source/parser/fncode.cpp and source/vm/fnpovfpu.cpp there).

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace balcony::bridge::test {

/// What POV-Ray would refuse, with the line.
class PovError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct PovFunction;

/// A linear spline of vectors.
using PovSpline = std::map<double, std::array<double, 4>>;

struct PovExpression {
    enum class Kind { number, parameter, operation, call, spline };
    Kind kind = Kind::number;
    double number = 0.0;
    std::size_t parameter = 0;
    std::string name{};  ///< Of an operator or of a function that POV-Ray has.
    std::shared_ptr<const PovFunction> function{};
    std::vector<PovExpression> operands{};
    std::shared_ptr<const PovSpline> spline{};
    std::size_t member = 0;  ///< Of the vector of a spline.
};

struct PovFunction {
    std::string name;
    std::vector<std::string> parameters;
    PovExpression body;
};

/// What evaluations have done so far.
struct PovCost {
    std::size_t operations = 0;  ///< Operators and functions that POV-Ray has.
    std::size_t calls = 0;       ///< Of declared functions.
    std::size_t deepest = 0;     ///< The largest number of calls inside each other.
};

class PovScene {
public:
    /// Reads a text into a scene of a picture of some size. Throws PovError.
    PovScene(std::string_view text, double columns, double rows, double clock = 0.0,
             std::map<std::string, double> declared = {});

    struct Ray {
        std::array<double, 3> location{};
        std::array<double, 3> direction{};
        bool valid = false;  ///< Whether POV-Ray traces it.
    };
    /// The ray of a camera at a point in pixels, as POV-Ray computes it.
    [[nodiscard]] Ray ray(const std::string& camera, double x, double y) const;

    [[nodiscard]] double number(const std::string& name) const { return numbers_.at(name); }
    [[nodiscard]] const PovCost& cost() const { return cost_; }
    [[nodiscard]] std::size_t function_count() const { return functions_.size(); }
    [[nodiscard]] std::size_t max_parameters() const;

private:
    friend class PovReader;
    struct Camera {
        std::array<PovExpression, 3> location, direction;
    };

    [[nodiscard]] double evaluate(const PovExpression& expression,
                                  const std::vector<double>& parameters, std::size_t depth) const;
    [[nodiscard]] double operation(const PovExpression& expression,
                                   const std::vector<double>& parameters, std::size_t depth) const;

    double columns_, rows_;
    std::map<std::string, double> numbers_;
    std::map<std::string, std::shared_ptr<const PovFunction>> functions_;
    std::map<std::string, std::shared_ptr<const PovSpline>> splines_;
    std::map<std::string, Camera> cameras_;
    mutable PovCost cost_;
};

}  // namespace balcony::bridge::test
