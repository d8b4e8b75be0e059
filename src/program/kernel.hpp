// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiled instructions as seen by the code that runs them, in plain structs that any
// instruction set can be compiled against (kernels.inl says why they must be plain).

#include <cstddef>
#include <cstdint>

#include "balcony/expr.hpp"

namespace balcony::program {

/// Registers start and end at multiples of this many doubles (64 bytes, the widest vector), and a
/// value that does not vary along a run of points is stored this many times.
inline constexpr std::size_t register_alignment = 8;

/// A table for the look-up kernels; owned by the tape. Missing axes have degree 0.
struct TableView {
    struct Axis {
        double first = 0.0;
        double scale = 1.0;            ///< Cells per unit of the argument.
        double last_cell = 0.0;        ///< The index of the last cell.
        double cell_stride = 0.0;      ///< Coefficients from one cell to the next.
        std::size_t power_stride = 0;  ///< Coefficients from one power to the next.
        std::size_t degree = 0;
    };
    Axis axes[3];
    std::size_t axis_count = 0;
    std::size_t number = 0;  ///< Among the tables of the tape.
    const double* coefficients = nullptr;
};

struct NativeCall;  // tape.hpp

/// The location of an argument. Its point i is at offset + (i & mask): the mask is all ones for a
/// value that varies along the run and 0 for a constant one, so that loading needs no branch.
struct Operand {
    std::uint32_t offset = 0;
    std::uint32_t mask = 0;
};

struct Instruction {
    expr::Op op = expr::Op::constant;
    std::uint32_t result = 0;  ///< Offset of the result register.
    std::int32_t root =
        -1;  ///< The only root with this value if nothing else reads it, otherwise -1.
    Operand arguments[3];
    double (*scalar)(const double* arguments) = nullptr;  ///< The operation's definition.
    const TableView* table = nullptr;                     ///< Of a look-up.
    const NativeCall* native = nullptr;                   ///< Of a native function; has no kernel.
};

/// Runs one instruction over `count` points, a multiple of register_alignment. The results go to
/// `to`, which needs no alignment and may be one of the arguments.
using Kernel = void (*)(const Instruction& instruction, const double* registers, double* to,
                        std::size_t count);

/// The kernel of an operation, null for a leaf; one function for each instruction set compiled.
Kernel kernel_avx512(expr::Op op);
Kernel kernel_avx2(expr::Op op);
Kernel kernel_sse4(expr::Op op);
Kernel kernel_neon(expr::Op op);
/// For any machine: calls the operation's definition point by point.
Kernel kernel_scalar(expr::Op op);

}  // namespace balcony::program
