// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include <hwy/targets.h>

#include "program/tape.hpp"

namespace balcony::program {

namespace {

using Kernels = std::array<Kernel, expr::operation_count>;

struct Runners {
    std::vector<InstructionSet> sets;
    std::vector<Kernels> kernels;

    void add(std::string_view name, std::size_t lanes, Kernel (*kernel)(expr::Op)) {
        sets.push_back({name, lanes});
        Kernels& table = kernels.emplace_back();
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = kernel(static_cast<expr::Op>(i));
        }
    }
};

Runners detect_runners() {
    Runners runners;
#if HWY_ARCH_X86
    const auto supported = hwy::SupportedTargets();
    if ((supported & HWY_AVX3) != 0) {
        runners.add("avx512", 8, kernel_avx512);
    }
    if ((supported & HWY_AVX2) != 0) {
        runners.add("avx2", 4, kernel_avx2);
    }
    if ((supported & HWY_SSE4) != 0) {
        runners.add("sse4", 2, kernel_sse4);
    }
#elif HWY_ARCH_ARM_A64
    runners.add("neon", 2, kernel_neon);
#endif
    runners.add("scalar", 1, kernel_scalar);
    return runners;
}

const Runners& runners() {
    static const Runners detected = detect_runners();
    return detected;
}

std::size_t padded(std::size_t count) {
    return (count + register_alignment - 1) / register_alignment * register_alignment;
}

// The arguments and results of the native called last, kept for the next call.
struct CallPointers {
    std::vector<const double*> arguments;
    std::vector<double*> results;
};

// Arguments that do not vary along the run are repeated for it.
void call(const NativeCall& native, double* registers, double* repeated, std::size_t count,
          CallPointers& pointers) {
    pointers.arguments.clear();
    for (const Operand& operand : native.arguments) {
        const double* values = registers + operand.offset;
        if (operand.mask == 0) {
            std::fill_n(repeated, count, *values);
            values = std::exchange(repeated, repeated + max_tile_width);
        }
        pointers.arguments.push_back(values);
    }
    pointers.results.clear();
    for (const std::uint32_t result : native.results) {
        pointers.results.push_back(registers + result);
    }
    native.function->evaluate(count, pointers.arguments.data(), pointers.results.data());
}

// One tile or list of points on one instruction set. Registers are padded to whole vectors, so
// kernels never handle a remainder; the caller's arrays receive only the requested points.
class TapeRun {
public:
    TapeRun(const Tape& tape, const Kernels& kernels, Scratch& scratch, InputValues inputs,
            std::span<double* const> results, CallPointers& pointers)
        : tape_(tape),
          kernels_(kernels),
          registers_(scratch.reserve(tape.register_doubles)),
          inputs_(inputs),
          results_(results),
          pointers_(pointers) {
        assert(results.size() == tape.roots.size());
    }

    void operator()(const Tile& tile) {
        for (const Tape::Input& input : tape_.inputs) {
            double* to = registers_ + input.offset;
            switch (input.source) {
                case Tape::Input::x:
                    for (std::size_t i = 0; i < padded(tile.width); ++i) {
                        to[i] = tile.column(i);
                    }
                    break;
                case Tape::Input::y:
                    for (std::size_t j = 0; j < padded(tile.height); ++j) {
                        to[j] = tile.row(j);
                    }
                    break;
                case Tape::Input::time: replicate(input.offset, tile.time); break;
                default: fill_declared(input);
            }
        }
        run_rows(tile.width, tile.height);
    }

    void operator()(const Points& points) {
        for (const Tape::Input& input : tape_.inputs) {
            switch (input.source) {
                case Tape::Input::x: fill_padded(input.offset, points.x); break;
                case Tape::Input::y: fill_padded(input.offset, points.y); break;
                case Tape::Input::time: replicate(input.offset, points.time); break;
                default: fill_declared(input);
            }
        }
        run_rows(points.x.size(), 1);
    }

private:
    void replicate(std::uint32_t offset, double value) {
        std::fill_n(registers_ + offset, register_alignment, value);
    }

    // The rest of the last vector repeats the last value, so that only given points are evaluated.
    void fill_padded(std::uint32_t offset, std::span<const double> values) {
        double* end = std::copy(values.begin(), values.end(), registers_ + offset);
        std::fill_n(end, padded(values.size()) - values.size(), values.back());
    }

    void fill_declared(const Tape::Input& input) {
        const std::span<const double> values = inputs_[input.source - Tape::Input::first_declared];
        switch (input.rate) {
            case Rate::uniform: replicate(input.offset, values.front()); break;
            case Rate::column:
            case Rate::row: fill_padded(input.offset, values); break;
            case Rate::pixel: break;  // Filled in for each row.
        }
    }

    void run_rows(std::size_t width, std::size_t height) {
        width_ = width;
        in_place_ = padded(width) == width;
        for (const Tape::Constant& constant : tape_.constants) {
            replicate(constant.offset, constant.value);
        }
        run_section(Rate::uniform, register_alignment);
        run_section(Rate::column, padded(width));
        run_section(Rate::row, padded(height));
        for (std::size_t j = 0; j < height; ++j) {
            run_row(j);
        }
    }

    void run(const Instruction& instruction, double* to, std::size_t count) {
        if (instruction.native != nullptr) {
            call(*instruction.native, registers_, registers_ + tape_.repeated, count, pointers_);
            return;
        }
        kernels_[static_cast<std::size_t>(instruction.op)](instruction, registers_, to, count);
    }

    void run_section(Rate rate, std::size_t count) {
        for (const Instruction& instruction : tape_.section(rate)) {
            run(instruction, registers_ + instruction.result, count);
        }
    }

    void run_row(std::size_t j) {
        for (const Tape::Input& input : tape_.inputs) {
            if (input.rate == Rate::pixel && input.source >= Tape::Input::first_declared) {
                const std::span<const double> values =
                    inputs_[input.source - Tape::Input::first_declared];
                fill_padded(input.offset, values.subspan(j * width_, width_));
            }
        }
        for (const Tape::Replication& replication : tape_.replications) {
            replicate(replication.replicated, registers_[replication.row_value + j]);
        }
        for (const Instruction& instruction : tape_.section(Rate::pixel)) {
            const bool in_place = in_place_ && instruction.root >= 0;
            double* to = in_place ? row_of(static_cast<std::size_t>(instruction.root), j)
                                  : registers_ + instruction.result;
            run(instruction, to, padded(width_));
        }
        for (std::size_t r = 0; r < results_.size(); ++r) {
            if (!in_place_ || !tape_.roots[r].made_in_place) {
                write_row(tape_.roots[r], j, row_of(r, j));
            }
        }
    }

    double* row_of(std::size_t root, std::size_t j) const { return results_[root] + j * width_; }

    void write_row(const Tape::Root& root, std::size_t j, double* row) const {
        const double* value = registers_ + root.offset;
        switch (root.rate) {
            case Rate::uniform: std::fill_n(row, width_, *value); break;
            case Rate::row: std::fill_n(row, width_, value[j]); break;
            case Rate::column:
            case Rate::pixel: std::copy_n(value, width_, row); break;
        }
    }

    const Tape& tape_;
    const Kernels& kernels_;
    double* registers_;
    InputValues inputs_;
    std::span<double* const> results_;
    CallPointers& pointers_;
    std::size_t width_ = 0;
    bool in_place_ = false;  ///< Rows are whole vectors, so that pixel roots need no copy.
};

}  // namespace

std::span<const InstructionSet> instruction_sets() { return runners().sets; }

void run_on(std::size_t set, const Program& program, const Tile& tile, Scratch& scratch,
            std::span<double* const> results) {
    assert(set < runners().kernels.size());
    assert(tile.width <= max_tile_width && tile.height <= max_tile_height);
    if (!results.empty() && tile.width > 0 && tile.height > 0) {
        const auto& shortening = program.tape().shortening;
        const std::shared_ptr<const Tape> shorter =
            shortening ? shortening->tape_for(tile) : nullptr;
        CallPointers pointers;
        TapeRun(shorter ? *shorter : program.tape(), runners().kernels[set], scratch, tile.inputs,
                results, pointers)(tile);
    }
}

void run_on(std::size_t set, const Program& program, const Points& points, Scratch& scratch,
            std::span<double* const> results) {
    assert(set < runners().kernels.size());
    assert(points.x.size() <= max_points);
    if (!results.empty() && !points.x.empty()) {
        CallPointers pointers;
        TapeRun(program.tape(), runners().kernels[set], scratch, points.inputs, results,
                pointers)(points);
    }
}

}  // namespace balcony::program
