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

#include "grid/compiler.hpp"

namespace matrixworld {

namespace {

using Floats = Lanes<float, 4>;
// Two numbers at a time, as many as the narrowest registers hold: compilers take wider comparisons
// apart into single numbers.
using TwoFloats = Lanes<float, 2>;
using FourDoubles = Lanes<double, 4>;
using Doubles = Lanes<double, 2>;
using Bits = Mask<Doubles>;

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
    return as<Doubles>((as<Bits>(sum) + away) | (inexact & 1));
}

// The numbers of four floats as doubles.
struct Wide {
    Doubles halves[2];
};

inline Wide widened(Floats x) {
    const auto wide = converted<FourDoubles>(x);
    return {{Doubles{wide[0], wide[1]}, Doubles{wide[2], wide[3]}}};
}

inline Floats narrowed(const Wide& x) {
    const FourDoubles wide{x.halves[0][0], x.halves[0][1], x.halves[1][0], x.halves[1][1]};
    return converted<Floats>(wide);
}

inline Floats multiply_add(Floats a, Floats b, Floats c) {
    const Wide x = widened(a), y = widened(b), z = widened(c);
    Wide sums;
    for (int i = 0; i < 2; ++i) {
        sums.halves[i] = add_product_to_odd(x.halves[i], y.halves[i], z.halves[i]);
    }
    return narrowed(sums);
}

// Long sums of products take a shorter way. Rounding a double to a float goes wrong only where the
// double is in the middle between two floats, that is where the last 29 of its bits are a 1 and
// zeros, or where the float is subnormal and has fewer bits. Both are rare. So products are added
// without more ado, and `doubt` remembers whether a sum was one of these: then the caller does all
// of it again by `multiply_add`.
using Words = Lanes<std::uint32_t, 4>;  // lower and upper words of two doubles
using Signs = Lanes<std::int32_t, 4>;

struct Doubt {
    Signs found{};

    // One comparison tests both words: after the addition the lower word is the smallest integer in
    // the middle between two floats; the upper word is among the smallest if the exponent is that of
    // a subnormal float, and the largest for 0, which is exact.
    void look_at(Doubles sum) {
        constexpr Words kept = {0x1FFFFFFF, 0x7FFFFFFF, 0x1FFFFFFF, 0x7FFFFFFF};
        constexpr Words shift = {0x70000000, 0x7FFFFFFF, 0x70000000, 0x7FFFFFFF};
        constexpr int lowest = -0x7FFFFFFF - 1;
        constexpr int subnormal = lowest + 0x380FFFFF;  // the exponent of 2^-126, less 1
        constexpr Signs limit = {lowest + 1, subnormal, lowest + 1, subnormal};
        found |= as<Signs>((as<Words>(sum) & kept) + shift) < limit;
    }

    bool any() const { return found[0] | found[1] | found[2] | found[3]; }
};

// sum += x * y, rounded to floats; all numbers are floats, as doubles.
inline void add_product(Wide& sum, double x, const Wide& y, Doubt& doubt) {
    for (int i = 0; i < 2; ++i) {
        const Doubles near = sum.halves[i] + Doubles{x, x} * y.halves[i];
        doubt.look_at(near);
        const auto rounded = converted<TwoFloats>(near);
        sum.halves[i] = converted<Doubles>(rounded);
    }
}

}  // namespace

}  // namespace matrixworld
