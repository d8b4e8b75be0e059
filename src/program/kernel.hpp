// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a compiled instruction looks like to the code that runs it, in plain structs that any
// instruction set can be compiled against (kernels.inl says why they must be plain).

#include <cstddef>
#include <cstdint>

#include "balcony/expr.hpp"

namespace balcony::program {

/// Registers start and end at multiples of this many doubles (64 bytes, the widest vector), and a
/// value that does not vary along a run of points is stored this many times.
inline constexpr std::size_t register_alignment = 8;

/// A table as the look-up kernel reads it; owned by the tape.
struct TableView {
    double first;
    double scale;      ///< Cells per unit of x.
    double last_cell;  ///< The index of the last cell.
    const double* cells;
};

/// Where an argument stands. Point i of it is at offset + (i & mask): the mask is all ones for a
/// value that varies along the run and 0 for one that does not, so that loading needs no branch.
struct Operand {
    std::uint32_t offset = 0;
    std::uint32_t mask = 0;
};

struct Instruction {
    expr::Op op = expr::Op::constant;
    std::uint32_t result = 0;  ///< Offset of the register that is written.
    std::int32_t root = -1;    ///< The one root that is this value if nothing reads it, else -1.
    Operand arguments[3];
    double (*scalar)(const double* arguments) = nullptr;  ///< The operation's definition.
    const TableView* table = nullptr;                     ///< Of a look-up.
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
