// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "program/kernel.hpp"

namespace balcony::program {

namespace {

void by_definition(const Instruction& in, const double* registers, double* to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        double arguments[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const Operand& operand = in.arguments[k];
            arguments[k] = registers[operand.offset + (i & operand.mask)];
        }
        to[i] = in.scalar(arguments);
    }
}

// The steps of expr::Table.
void lookup(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const TableView& table = *in.table;
    const Operand& operand = in.arguments[0];
    for (std::size_t i = 0; i < count; ++i) {
        const double x = registers[operand.offset + (i & operand.mask)];
        const double position = (x - table.first) * table.scale;
        const double floored = std::floor(position);
        const double within = table.last_cell < floored ? table.last_cell : floored;
        const double cell = floored > 0.0 ? within : 0.0;
        const double s = position - cell;
        const double* c = table.cells + 4 * static_cast<std::size_t>(cell);
        to[i] = ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
    }
}

}  // namespace

Kernel kernel_scalar(expr::Op op) {
    if (op == expr::Op::lookup) {
        return lookup;
    }
    return expr::operation(op).scalar != nullptr ? by_definition : nullptr;
}

}  // namespace balcony::program
