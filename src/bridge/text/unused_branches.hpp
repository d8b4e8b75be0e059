// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Formulas for programs that differentiate them operation by operation. Such a program computes
// both branches of a condition, and multiplies the gradient 0 of the branch that is not taken by
// derivatives there. Where one of these is infinite or not a number, the product is not a number,
// and so is the gradient of all that both branches depend on.

#include <cstddef>

#include "bridge/text/camera_formulas.hpp"

namespace balcony::bridge {

/// An operand with which an operation has a finite value and finite derivatives, whatever finite
/// numbers the other operands are.
struct HarmlessOperand {
    Op op = Op::constant;
    std::size_t operand = 0;
    double number = 0.0;
};

/// That of an operation that may need one; null if finite numbers always give finite derivatives.
[[nodiscard]] const HarmlessOperand* harmless_operand(const expr::Graph& graph, expr::NodeId id);

/// Gives operations in branches their harmless operands wherever the branch is not taken. Values
/// that are used stay as they are. An error if the formulas of the camera get too large.
[[nodiscard]] Result<CameraFormulas> with_guarded_branches(CameraFormulas formulas,
                                                           std::string_view camera);

}  // namespace balcony::bridge
