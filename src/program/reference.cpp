// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "program/tape.hpp"

namespace balcony::program {

namespace {

void call(const NativeCall& native, std::vector<double>& registers) {
    std::vector<const double*> arguments;
    for (const Operand& operand : native.arguments) {
        arguments.push_back(&registers[operand.offset]);
    }
    std::vector<double*> results;
    for (const std::uint32_t result : native.results) {
        results.push_back(&registers[result]);
    }
    native.function->evaluate(1, arguments.data(), results.data());
}

// One value per register, in its first double.
void run_section(const Tape& tape, Rate rate, std::vector<double>& registers) {
    for (const Instruction& instruction : tape.section(rate)) {
        if (instruction.native != nullptr) {
            call(*instruction.native, registers);
            continue;
        }
        std::array<double, 3> arguments{};
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            arguments[i] = registers[instruction.arguments[i].offset];
        }
        if (instruction.table != nullptr) {
            const expr::Table& table = *tape.tables[instruction.table->number];
            registers[instruction.result] = table(std::span(arguments).first(table.axes.size()));
        } else {
            registers[instruction.result] = instruction.scalar(arguments.data());
        }
    }
}

// One point, with the values of its inputs by their sources.
void run_point(const Tape& tape, std::span<const double> inputs, std::vector<double>& registers) {
    for (const Tape::Input& input : tape.inputs) {
        registers[input.offset] = inputs[input.source];
    }
    for (const Tape::Constant& constant : tape.constants) {
        registers[constant.offset] = constant.value;
    }
    run_section(tape, Rate::uniform, registers);
    run_section(tape, Rate::column, registers);
    run_section(tape, Rate::row, registers);
    for (const Tape::Replication& replication : tape.replications) {
        registers[replication.replicated] = registers[replication.row_value];
    }
    run_section(tape, Rate::pixel, registers);
}

}  // namespace

void run_reference(const Program& program, const Tile& tile, std::span<double* const> results) {
    const Tape& tape = program.tape();
    assert(fits(program, tile));
    assert(results.size() == tape.roots.size());
    if (results.empty()) {
        return;
    }
    std::vector<double> registers(tape.register_doubles);
    for (std::size_t j = 0; j < tile.height; ++j) {
        for (std::size_t i = 0; i < tile.width; ++i) {
            std::vector<double> inputs{tile.column(i), tile.row(j), tile.time};
            for (std::size_t k = 0; k < tile.inputs.size(); ++k) {
                const Rate rate = program.inputs()[k].rate;
                inputs.push_back(tile.inputs[k][rate == Rate::uniform  ? 0
                                                : rate == Rate::column ? i
                                                : rate == Rate::row    ? j
                                                                       : j * tile.width + i]);
            }
            run_point(tape, inputs, registers);
            for (std::size_t r = 0; r < results.size(); ++r) {
                results[r][j * tile.width + i] = registers[tape.roots[r].offset];
            }
        }
    }
}

void run_reference(const Program& program, const Points& points, std::span<double* const> results) {
    const Tape& tape = program.tape();
    assert(fits(program, points));
    assert(results.size() == tape.roots.size());
    std::vector<double> registers(tape.register_doubles);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        std::vector<double> inputs{points.x[i], points.y[i], points.time};
        for (std::size_t k = 0; k < points.inputs.size(); ++k) {
            const bool uniform = program.inputs()[k].rate == Rate::uniform;
            inputs.push_back(points.inputs[k][uniform ? 0 : i]);
        }
        run_point(tape, inputs, registers);
        for (std::size_t r = 0; r < results.size(); ++r) {
            results[r][i] = registers[tape.roots[r].offset];
        }
    }
}

}  // namespace balcony::program
