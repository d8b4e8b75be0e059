// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
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

// Horner's rule along an axis and the following ones; the coefficients of the last are numbers.
double horner(const TableView& table, const double* c, const double* s, std::size_t axis) {
    if (axis == 3) {
        return *c;
    }
    const TableView::Axis& along = table.axes[axis];
    double value = horner(table, c + along.degree * along.power_stride, s, axis + 1);
    for (std::size_t power = along.degree; power-- > 0;) {
        value = value * s[axis] + horner(table, c + power * along.power_stride, s, axis + 1);
    }
    return value;
}

// The steps of expr::Table.
void lookup(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const TableView& table = *in.table;
    for (std::size_t i = 0; i < count; ++i) {
        double s[3]{};
        double start = 0.0;
        for (std::size_t k = 0; k < table.axis_count; ++k) {
            const TableView::Axis& axis = table.axes[k];
            const Operand& operand = in.arguments[k];
            const double x = registers[operand.offset + (i & operand.mask)];
            const double position = (x - axis.first) * axis.scale;
            const double floored = std::floor(position);
            const double within = axis.last_cell < floored ? axis.last_cell : floored;
            const double cell = floored > 0.0 ? within : 0.0;
            s[k] = position - cell;
            start += cell * axis.cell_stride;
        }
        to[i] = horner(table, table.coefficients + static_cast<std::size_t>(start), s, 0);
    }
}

}  // namespace

Kernel kernel_scalar(expr::Op op) {
    if (op == expr::Op::call) {
        return lookup;
    }
    return expr::operation(op).scalar != nullptr ? by_definition : nullptr;
}

}  // namespace balcony::program
