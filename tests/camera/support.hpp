// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/camera.hpp"
#include "balcony/catalogue.hpp"

namespace balcony::camera {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
double length(const Vector& a);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(double factor, const Vector& a);
void expect_near(const Vector& found, const Vector& wanted, double tolerance);

/// Values of parameters by name; what is not given is left out if it may be, else it takes its
/// default or, where there is none, some sensible value.
using Given = std::map<std::string_view, Arguments::Value>;
Arguments::Value numbers(std::vector<double> values);
Arguments arguments_for(const StageEntry& row, const Given& given);

/// The words of a choice; none for other parameters.
[[nodiscard]] std::vector<std::string_view> choices_of(const StageParameter& parameter);

Result<std::shared_ptr<const Stage>> try_stage(StageKind kind, std::string_view name,
                                               const Given& given);

template <class Port>
std::shared_ptr<const Port> stage(StageKind kind, std::string_view name, const Given& given = {}) {
    const auto made = try_stage(kind, name, given);
    EXPECT_TRUE(made) << name << ": " << to_text(made.diagnostics);
    return made ? std::dynamic_pointer_cast<const Port>(*made) : nullptr;
}

ObjectGeneratorPointer object(std::string_view name, const Given& given = {});
ObjectTransformerPointer move(std::string_view name, const Given& given = {});
ParameterTransformerPointer warp(std::string_view name, const Given& given = {});
PictureMapperPointer range(double u_first, double u_last, double v_first, double v_last);
DirectionRulePointer look(std::string_view name, const Given& given = {});

/// A formula in a graph of its own: build(graph, variables) gives the results.
template <class Build>
Formula formula(std::size_t parameters, const Build& build) {
    auto graph = std::make_shared<Graph>();
    std::vector<Expr> variables;
    for (std::size_t i = 0; i < parameters; ++i) {
        variables.push_back(graph->fresh_variable());
    }
    std::vector<Expr> results = build(*graph, variables);
    return {graph, variables, results};
}

/// The results of a stage as a function of its coordinates, with partial derivatives.
struct Sample {
    Vector point{};
    Vector along_u{};
    Vector along_v{};
    bool valid = false;
};

class GeneratorProbe {
public:
    explicit GeneratorProbe(const ObjectGeneratorPointer& generator);
    [[nodiscard]] Sample operator()(double u, double v = 0.0, double time = 0.0) const;

private:
    std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
    std::vector<Expr> roots_;
};

/// Where an object transformer takes a point.
Vector transformed(const ObjectTransformerPointer& transformer, const Vector& point);

/// Where a parameter transformer takes (u, v).
std::array<double, 2> warped(const ParameterTransformerPointer& transformer, double u, double v);

struct Ray {
    Vector origin{};
    Vector direction{};
    bool valid = false;
    std::array<double, 2> parameters{};
};

class CameraProbe {
public:
    CameraProbe(const Camera& camera, double width, double height);
    [[nodiscard]] Ray operator()(double x, double y, double time = 0.0) const;
    [[nodiscard]] std::span<const Expr> roots() const { return roots_; }

private:
    std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
    std::vector<Expr> roots_;
};

Camera camera(Camera::Parts parts);

}  // namespace balcony::camera
