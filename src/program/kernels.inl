// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The kernels, one for each operation, for the instruction set that the including file is compiled
// for. That file defines BALCONY_KERNEL, the name of the function that returns them.
//
// Rule: nothing here may emit code that other files share. The linker keeps one copy of an
// inline function or template that several files emit; if it kept the one compiled for AVX-512, the
// library would crash on machines without it. So everything is in an unnamed namespace, no
// container, algorithm or inline function of another header is used, and Highway's functions are
// all forced inline. A test looks for shared symbols in the object files.

#define HWY_COMPILE_ONLY_STATIC
#include <hwy/highway.h>
#include <sleef.h>

#include "program/kernel.hpp"

// An operation without a kernel does not compile.
#pragma GCC diagnostic error "-Wswitch"

HWY_BEFORE_NAMESPACE();

namespace balcony::program {

namespace {

namespace lanes = hwy::HWY_NAMESPACE;
using Tag = lanes::ScalableTag<double>;
using Vector = lanes::Vec<Tag>;
using Mask = lanes::Mask<Tag>;
constexpr Tag tag;

static_assert(lanes::MaxLanes(tag) > 1 && register_alignment % lanes::MaxLanes(tag) == 0);

// SLEEF's functions with a stated error of 1.0 ULP, in the variants that promise the same bits on
// every machine. Those with fused multiply-add (AVX2, AVX-512, NEON) agree with each other.
#if HWY_TARGET == HWY_AVX3
#define BALCONY_SLEEF(function) Sleef_finz_##function##d8_u10avx512f
#elif HWY_TARGET == HWY_AVX2
#define BALCONY_SLEEF(function) Sleef_finz_##function##d4_u10avx2
#elif HWY_TARGET == HWY_SSE4
#define BALCONY_SLEEF(function) Sleef_cinz_##function##d2_u10sse4
#elif HWY_TARGET == HWY_NEON
#define BALCONY_SLEEF(function) Sleef_finz_##function##d2_u10advsimd
#else
#error "There are no SLEEF functions for this instruction set here"
#endif
#define BALCONY_SLEEF_1(function) [](Vector a) { return Vector{BALCONY_SLEEF(function)(a.raw)}; }
#define BALCONY_SLEEF_2(function) \
    [](Vector a, Vector b) { return Vector{BALCONY_SLEEF(function)(a.raw, b.raw)}; }

// Arguments during a run of points: varying, constant, or either.
// They are created before the loop over the points, because the compiler must assume that each
// store of a vector may change the instruction.
struct Varying {
    const double* from;
    Vector operator()(std::size_t i) const { return lanes::Load(tag, from + i); }
};
struct Fixed {
    Vector value;
    Vector operator()(std::size_t) const { return value; }
};
struct Masked {
    const double* from;
    std::size_t mask;
    Vector operator()(std::size_t i) const { return lanes::Load(tag, from + (i & mask)); }
};

inline Masked argument(const Instruction& in, std::size_t number, const double* registers) {
    return {registers + in.arguments[number].offset, in.arguments[number].mask};
}

enum class Overflow { as_defined, too_early };

// Replaces every infinite result by the scalar definition. For SLEEF's functions that overflow
// too early: exp and pow from 1.79766e308 on, sinh and cosh from half of that, asinh and acosh
// where the square of the argument overflows.
HWY_NOINLINE void redefine_infinite(const Instruction& in, Vector a, Vector b, double* results) {
    HWY_ALIGN double first[lanes::MaxLanes(tag)];
    HWY_ALIGN double second[lanes::MaxLanes(tag)];
    lanes::Store(a, tag, first);
    lanes::Store(b, tag, second);
    for (std::size_t lane = 0; lane < lanes::Lanes(tag); ++lane) {
        if (__builtin_isinf(results[lane])) {
            const double arguments[2]{first[lane], second[lane]};
            results[lane] = in.scalar(arguments);
        }
    }
}

// Writes a result; the arguments are those of the operation.
template <Overflow overflow>
inline void finish(const Instruction& in, Vector a, Vector b, Vector result, double* to) {
    lanes::StoreU(result, tag, to);
    if constexpr (overflow == Overflow::too_early) {
        const Mask infinite = lanes::Eq(lanes::Abs(result), lanes::Inf(tag));
        if (!lanes::AllFalse(tag, infinite)) {
            redefine_infinite(in, a, b, to);
        }
    }
}

// If no argument varies, this is the uniform section: a run is one register of equal values.
template <auto function, Overflow overflow = Overflow::as_defined>
void unary(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const Varying first{argument(in, 0, registers).from};
    for (std::size_t i = 0; i < count; i += lanes::Lanes(tag)) {
        const Vector a = first(i);
        finish<overflow>(in, a, a, function(a), to + i);
    }
}

// An argument that does not vary is loaded once, before the loop.
template <auto function, Overflow overflow = Overflow::as_defined>
void binary(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const Masked first = argument(in, 0, registers);
    const Masked second = argument(in, 1, registers);
    const auto loop = [&](auto load_first, auto load_second) {
        for (std::size_t i = 0; i < count; i += lanes::Lanes(tag)) {
            const Vector a = load_first(i);
            const Vector b = load_second(i);
            finish<overflow>(in, a, b, function(a, b), to + i);
        }
    };
    if (second.mask == 0) {
        loop(Varying{first.from}, Fixed{second(0)});
    } else if (first.mask == 0) {
        loop(Fixed{first(0)}, Varying{second.from});
    } else {
        loop(Varying{first.from}, Varying{second.from});
    }
}

inline Vector truth(Mask condition) {
    return lanes::IfThenElseZero(condition, lanes::Set(tag, 1.0));
}

// As in C, NaN is true.
inline Mask holds(Vector condition) { return lanes::Not(lanes::Eq(condition, lanes::Zero(tag))); }

inline Vector sign(Vector a) {
    const Vector zero = lanes::Zero(tag);
    const Vector one = lanes::Set(tag, 1.0);
    // Adding 0 turns -0 into 0 and keeps a NaN.
    const Vector not_positive =
        lanes::IfThenElse(lanes::Lt(a, zero), lanes::Neg(one), lanes::Add(a, zero));
    return lanes::IfThenElse(lanes::Gt(a, zero), one, not_positive);
}

void select(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const Masked condition = argument(in, 0, registers);
    const Masked if_true = argument(in, 1, registers);
    const Masked if_false = argument(in, 2, registers);
    for (std::size_t i = 0; i < count; i += lanes::Lanes(tag)) {
        lanes::StoreU(lanes::IfThenElse(holds(condition(i)), if_true(i), if_false(i)), tag, to + i);
    }
}

// The coefficients of each lane's cell. They are read one by one, which takes less time than the
// gathering instructions of many processors.
struct Cells {
    HWY_ALIGN std::int64_t start[lanes::MaxLanes(tag)];

    inline explicit Cells(Vector index) {
        lanes::Store(lanes::ConvertTo(lanes::RebindToSigned<Tag>(), index),
                     lanes::RebindToSigned<Tag>(), start);
    }
    inline Vector operator()(const double* coefficients) const {
        HWY_ALIGN double values[lanes::MaxLanes(tag)];
        for (std::size_t lane = 0; lane < lanes::Lanes(tag); ++lane) {
            values[lane] = coefficients[start[lane]];
        }
        return lanes::Load(tag, values);
    }
};

// Horner's rule along an axis and those behind it.
inline Vector horner_last(const TableView::Axis& axis, const double* c, const Cells& cells,
                          Vector s) {
    Vector value = cells(c + axis.degree);
    for (std::size_t power = axis.degree; power-- > 0;) {
        value = lanes::Add(lanes::Mul(value, s), cells(c + power));
    }
    return value;
}

template <int from, int count>
inline Vector horner(const TableView& table, const double* c, const Cells& cells, const Vector* s) {
    const TableView::Axis& axis = table.axes[from];
    if constexpr (from + 1 == count) {
        return horner_last(axis, c, cells, s[from]);
    } else {
        Vector value =
            horner<from + 1, count>(table, c + axis.degree * axis.power_stride, cells, s);
        for (std::size_t power = axis.degree; power-- > 0;) {
            value =
                lanes::Add(lanes::Mul(value, s[from]),
                           horner<from + 1, count>(table, c + power * axis.power_stride, cells, s));
        }
        return value;
    }
}

// The steps of expr::Table: no cell outside the table is read, and NaN gives NaN.
template <int count_of_axes>
void lookup_in(const Instruction& in, const double* registers, double* to, std::size_t count) {
    const TableView table = *in.table;
    const Vector zero = lanes::Zero(tag);
    for (std::size_t i = 0; i < count; i += lanes::Lanes(tag)) {
        Vector s[count_of_axes];
        Vector start = zero;
        for (std::size_t k = 0; k < count_of_axes; ++k) {
            const TableView::Axis& axis = table.axes[k];
            const Vector x = argument(in, k, registers)(i);
            const Vector position =
                lanes::Mul(lanes::Sub(x, lanes::Set(tag, axis.first)), lanes::Set(tag, axis.scale));
            const Vector floored = lanes::Floor(position);
            const Vector last = lanes::Set(tag, axis.last_cell);
            const Vector within = lanes::IfThenElse(lanes::Lt(last, floored), last, floored);
            const Vector cell = lanes::IfThenElse(lanes::Gt(floored, zero), within, zero);
            s[k] = lanes::Sub(position, cell);
            start = lanes::Add(start, lanes::Mul(cell, lanes::Set(tag, axis.cell_stride)));
        }
        lanes::StoreU(horner<0, count_of_axes>(table, table.coefficients, Cells(start), s), tag,
                      to + i);
    }
}

void lookup(const Instruction& in, const double* registers, double* to, std::size_t count) {
    switch (in.table->axis_count) {
        case 1: lookup_in<1>(in, registers, to, count); break;
        case 2: lookup_in<2>(in, registers, to, count); break;
        default: lookup_in<3>(in, registers, to, count); break;
    }
}

}  // namespace

Kernel BALCONY_KERNEL(expr::Op op) {
    using V = Vector;
    using expr::Op;
    switch (op) {
        case Op::constant:
        case Op::input:
        case Op::variable: return nullptr;

        case Op::negate: return unary<[](V a) { return lanes::Neg(a); }>;
        case Op::add: return binary<[](V a, V b) { return lanes::Add(a, b); }>;
        case Op::subtract: return binary<[](V a, V b) { return lanes::Sub(a, b); }>;
        case Op::multiply: return binary<[](V a, V b) { return lanes::Mul(a, b); }>;
        case Op::divide: return binary<[](V a, V b) { return lanes::Div(a, b); }>;
        case Op::modulo:
            return binary<[](V a, V b) {
                return lanes::Sub(a, lanes::Mul(b, lanes::Floor(lanes::Div(a, b))));
            }>;
        case Op::minimum:
            return binary<[](V a, V b) { return lanes::IfThenElse(lanes::Lt(b, a), b, a); }>;
        case Op::maximum:
            return binary<[](V a, V b) { return lanes::IfThenElse(lanes::Lt(a, b), b, a); }>;
        case Op::absolute: return unary<[](V a) { return lanes::Abs(a); }>;
        case Op::sign: return unary<sign>;
        case Op::floor: return unary<[](V a) { return lanes::Floor(a); }>;

        case Op::square_root: return unary<[](V a) { return lanes::Sqrt(a); }>;
        case Op::power: return binary<BALCONY_SLEEF_2(pow), Overflow::too_early>;
        case Op::exponential: return unary<BALCONY_SLEEF_1(exp), Overflow::too_early>;
        case Op::logarithm: return unary<BALCONY_SLEEF_1(log)>;

        case Op::sine: return unary<BALCONY_SLEEF_1(sin)>;
        case Op::cosine: return unary<BALCONY_SLEEF_1(cos)>;
        case Op::tangent: return unary<BALCONY_SLEEF_1(tan)>;
        case Op::arcsine: return unary<BALCONY_SLEEF_1(asin)>;
        case Op::arccosine: return unary<BALCONY_SLEEF_1(acos)>;
        case Op::arctangent: return unary<BALCONY_SLEEF_1(atan)>;
        case Op::arctangent2: return binary<BALCONY_SLEEF_2(atan2)>;

        case Op::hyperbolic_sine: return unary<BALCONY_SLEEF_1(sinh), Overflow::too_early>;
        case Op::hyperbolic_cosine: return unary<BALCONY_SLEEF_1(cosh), Overflow::too_early>;
        case Op::hyperbolic_tangent: return unary<BALCONY_SLEEF_1(tanh)>;
        case Op::inverse_hyperbolic_sine: return unary<BALCONY_SLEEF_1(asinh), Overflow::too_early>;
        case Op::inverse_hyperbolic_cosine:
            return unary<BALCONY_SLEEF_1(acosh), Overflow::too_early>;
        case Op::inverse_hyperbolic_tangent: return unary<BALCONY_SLEEF_1(atanh)>;

        case Op::less: return binary<[](V a, V b) { return truth(lanes::Lt(a, b)); }>;
        case Op::less_equal: return binary<[](V a, V b) { return truth(lanes::Le(a, b)); }>;
        case Op::equal: return binary<[](V a, V b) { return truth(lanes::Eq(a, b)); }>;
        case Op::logical_and:
            return binary<[](V a, V b) { return truth(lanes::And(holds(a), holds(b))); }>;
        case Op::logical_or:
            return binary<[](V a, V b) { return truth(lanes::Or(holds(a), holds(b))); }>;
        case Op::logical_not: return unary<[](V a) { return truth(lanes::Not(holds(a))); }>;
        case Op::is_finite: return unary<[](V a) { return truth(lanes::IsFinite(a)); }>;
        case Op::select: return select;

        case Op::call: return lookup;
        case Op::result: return nullptr;
    }
    return nullptr;
}

}  // namespace balcony::program

HWY_AFTER_NAMESPACE();
