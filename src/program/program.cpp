// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/program.hpp"

#include <new>

#include "program/tape.hpp"

namespace balcony::program {

Program::Program(std::span<const expr::Expr> roots, Sampling sampling)
    : tape_(compile(expr::simplify(roots), sampling)) {}

Sampling Program::sampling() const { return tape_->sampling; }

std::size_t Program::root_count() const { return tape_->roots.size(); }

Rate Program::rate(std::size_t root) const { return tape_->roots[root].rate; }

std::size_t Program::instruction_count(Rate rate) const { return tape_->section(rate).size(); }

namespace {

constexpr std::align_val_t alignment{register_alignment * sizeof(double)};

}  // namespace

void Scratch::Free::operator()(double* memory) const { ::operator delete[](memory, alignment); }

double* Scratch::reserve(std::size_t doubles) {
    if (doubles > size_) {
        memory_.reset(static_cast<double*>(::operator new[](doubles * sizeof(double), alignment)));
        size_ = doubles;
    }
    return memory_.get();
}

}  // namespace balcony::program
