// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Emitter: what stages write their formulas into.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/formula.hpp"
#include "balcony/spaces.hpp"

namespace balcony::camera {

class Stage;

/// What a stage computes on the way to a ray, for programs that show a camera stage by stage.
struct StageValues {
    /// The path that the stage belongs to; the direction rule has its own.
    enum class Owner : std::uint8_t { eye, toward, look };

    const Stage* stage = nullptr;
    Owner owner = Owner::eye;
    /// The coordinates of a point of PCS (two) or of OCS, or the direction (three).
    std::vector<Expr> values;
};

/// The output of stages: a graph and the conditions under which there is a ray.
class Emitter {
public:
    /// What trial() takes for variables 0, 1, ... of the graph, and for inputs other than x, y
    /// and t.
    struct Trial {
        std::vector<double> variables{};
        std::vector<KnownInput> inputs{};
    };
    explicit Emitter(Graph& graph) : Emitter(graph, Trial()) {}
    Emitter(Graph& graph, Trial trial)
        : graph_(&graph), valid_(graph.constant(1.0)), trial_(std::move(trial)) {}

    [[nodiscard]] Graph& graph() const { return *graph_; }
    /// One that writes into another graph, for trials that leave nothing in this one.
    [[nodiscard]] Emitter into(Graph& other) const { return {other, trial_}; }
    [[nodiscard]] Expr operator()(double value) const { return graph_->constant(value); }
    [[nodiscard]] Expr operator()(const Scalar& value) const { return value.emit(*graph_); }
    /// Requires a condition; where it is false, there is no ray.
    void require(Expr condition) { valid_ = valid_ && condition; }
    /// The same, with the error of a camera whose condition holds at no point of its picture.
    void require_somewhere(Expr condition, Diagnostic otherwise) {
        require(condition);
        needs_.push_back({condition, std::move(otherwise)});
    }
    /// The results of a function; no ray where it says that they do not hold.
    [[nodiscard]] std::vector<Expr> call(std::shared_ptr<const expr::Native> function,
                                         std::span<const Expr> at) {
        const std::optional<std::size_t> validity = function->validity();
        std::vector<Expr> results = graph_->call(std::move(function), at);
        if (validity) {
            require(results[*validity]);
        }
        return results;
    }
    [[nodiscard]] Expr valid() const { return valid_; }

    /// A problem that shows only while the formula is written. Camera::make reports it; an error
    /// means that there is no camera.
    void report(Diagnostic problem) { problems_.push_back(std::move(problem)); }
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }
    /// A condition that holds somewhere in the picture, or else a diagnostic.
    struct Need {
        Expr condition;
        Diagnostic otherwise;
    };
    [[nodiscard]] const std::vector<Need>& needs() const { return needs_; }

    /// The values of expressions at a point of the picture, in pixels, at time 0: for a stage that
    /// chooses its formula by trying it out. A camera is emitted for pictures of any size; here its
    /// picture has the aspect that the camera is made for.
    [[nodiscard]] std::vector<double> trial(std::span<const Expr> expressions, double x,
                                            double y) const;

    /// The size of the camera's own picture; none for a stage by itself.
    [[nodiscard]] const std::optional<PictureSize>& picture_size() const { return picture_size_; }
    void set_picture_size(const PictureSize& size) { picture_size_ = size; }

    /// Records what a stage computes.
    void record(StageValues values) { stages_.push_back(std::move(values)); }
    /// In the order in which the stages apply.
    [[nodiscard]] std::vector<StageValues>& stages() { return stages_; }

private:
    Graph* graph_;
    Expr valid_;
    Diagnostics problems_;
    std::vector<Need> needs_;
    Trial trial_;
    std::optional<PictureSize> picture_size_;
    std::vector<StageValues> stages_;
};

}  // namespace balcony::camera
