// a * b + c for four floats, rounded once, on processors without an instruction for it.
//
// The product of two floats is exact as a double. The sum with c is not: rounding it to a double and
// then to a float would round twice, and differ from a fused multiply-add where the double lies in
// the middle between two floats. So the sum is rounded to odd: if it is no double, the one of its
// two neighbours with an odd mantissa is taken, which is never in the middle (S. Boldo and
// G. Melquiond, 2008, "Emulation of FMA and correctly rounded sums: proved algorithms using rounding
// to odd", IEEE Transactions on Computers 57(4)).
//
// No case needs a branch: doubles hold products and sums of all floats, subnormal ones as well,
// without overflow or underflow. Included by vector.hpp and by a test.
#pragma once

namespace matrixworld {

namespace {

typedef float Floats __attribute__((vector_size(16)));
// Two numbers at a time, as many as the narrowest registers hold: compilers take wider comparisons
// apart into single numbers.
typedef double FourDoubles __attribute__((vector_size(32)));
typedef double Doubles __attribute__((vector_size(16)));
typedef long long Bits __attribute__((vector_size(16)));  // a comparison of doubles is -1 or 0

// The exact a * b + c rounded to odd.
inline Doubles add_product_to_odd(Doubles a, Doubles b, Doubles c) {
    const Doubles zero{};
    const Doubles product = a * b;
    // The sum rounded to nearest, and what the rounding left over (Knuth's TwoSum). The rest is NaN,
    // neither below nor above 0, where the sum is infinite or NaN: then the sum stays as it is.
    const Doubles sum = product + c;
    const Doubles part = sum - product;
    const Doubles rest = (product - (sum - part)) + (c - part);
    const Bits below = rest < zero;
    const Bits inexact = below | (rest > zero);
    // One unit back towards 0 where the sum was rounded away from it; then the last bit is set where
    // anything was left over.
    const Bits away = inexact & (below ^ (sum < zero));
    return (Doubles)(((Bits)sum + away) | (inexact & 1));
}

inline Floats multiply_add(Floats a, Floats b, Floats c) {
    const FourDoubles wide_a = __builtin_convertvector(a, FourDoubles);
    const FourDoubles wide_b = __builtin_convertvector(b, FourDoubles);
    const FourDoubles wide_c = __builtin_convertvector(c, FourDoubles);
    FourDoubles sums{};
    for (int i = 0; i < 4; i += 2) {
        const auto pair = [i](const FourDoubles& x) { return Doubles{x[i], x[i + 1]}; };
        const Doubles odd = add_product_to_odd(pair(wide_a), pair(wide_b), pair(wide_c));
        sums[i] = odd[0];
        sums[i + 1] = odd[1];
    }
    return __builtin_convertvector(sums, Floats);
}

}  // namespace

}  // namespace matrixworld
