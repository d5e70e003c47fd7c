// Compares multiply_add and add_product with the standard library's fma: on hard cases, on random bit patterns and on
// patterns that make sums that lie in, or next to, the middle between two floats.
//
//     c++ -std=c++17 -O2 -ffp-contract=off -Icpp cpp/tests/multiply_add.cpp -o multiply_add
//     ./multiply_add [random cases, in millions]
#include "kernels/multiply_add.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr int kLanes = 4;

long n_cases = 0;
long n_doubts = 0;
long n_wrong = 0;

std::uint32_t bits_of(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

float float_of(std::uint32_t bits) {
    float value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

// The same bits; which NaN it is may differ between processors.
bool same(float a, float b) { return (std::isnan(a) && std::isnan(b)) || bits_of(a) == bits_of(b); }

void compare(const char* name, float a, float b, float c, float given) {
    const float wanted = std::fmaf(a, b, c);
    if (same(given, wanted)) return;
    if (++n_wrong <= 10) {
        std::printf("%s(%a, %a, %a): expected %a, got %a\n", name, a, b, c, wanted, given);
    }
}

// The short way is right wherever it has no doubt.
void check_short(float a, float b, float c) {
    const auto splat = [](float x) { return matrixworld::Floats{x, x, x, x}; };
    matrixworld::Wide sum = matrixworld::widened(splat(c));
    matrixworld::Doubt doubt;
    matrixworld::add_product(sum, a, matrixworld::widened(splat(b)), doubt);
    n_doubts += doubt.any();
    if (!doubt.any()) compare("add_product", a, b, c, matrixworld::narrowed(sum)[kLanes - 1]);
}

// Collects cases until there is one for each lane.
void check(float a, float b, float c) {
    static matrixworld::Floats as, bs, cs;
    const int lane = static_cast<int>(n_cases++ % kLanes);
    as[lane] = a;
    bs[lane] = b;
    cs[lane] = c;
    check_short(a, b, c);
    if (lane + 1 < kLanes) return;
    const matrixworld::Floats given = matrixworld::multiply_add(as, bs, cs);
    for (int i = 0; i < kLanes; ++i) compare("multiply_add", as[i], bs[i], cs[i], given[i]);
}

// Every triple of values at which formats and roundings change.
void check_edges() {
    std::vector<float> edges;
    const float least = std::numeric_limits<float>::denorm_min();
    const float normal = std::numeric_limits<float>::min();
    const float most = std::numeric_limits<float>::max();
    for (const float value : {0.0f,
                              least,
                              3 * least,
                              normal - least,
                              normal,
                              0x1p-75f,
                              0x1.000002p-75f,
                              0x1p-24f,
                              0x1.000002p-24f,
                              0x1.fffffep-25f,
                              0.5f,
                              1.0f,
                              0x1.000002p0f,
                              0x1.fffffep0f,
                              3.0f,
                              0x1p24f,
                              0x1.000002p24f,
                              0x1p63f,
                              most,
                              most / 2,
                              std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()}) {
        edges.push_back(value);
        edges.push_back(-value);
    }
    for (const float a : edges) {
        for (const float b : edges) {
            for (const float c : edges) check(a, b, c);
        }
    }
}

// Random patterns, and c near the product: then sums cancel, or end in the middle of two floats.
void check_random(long n) {
    std::mt19937_64 random(2008);
    for (long i = 0; i < n; ++i) {
        const std::uint64_t word = random();
        const float a = float_of(static_cast<std::uint32_t>(word));
        const float b = float_of(static_cast<std::uint32_t>(word >> 32));
        check(a, b, float_of(static_cast<std::uint32_t>(random())));

        // Mantissas of few bits, of numbers about 1.
        const auto few = [&](int shift) {
            const auto mantissa = static_cast<std::uint32_t>(word >> shift) & 0x7FF;
            const std::uint32_t placed = word >> 63 ? mantissa : mantissa << 12;
            return float_of((word >> (shift + 12) & 1) << 31 | 0x3F800000u | placed);
        };
        const int exponent = static_cast<int>(word >> 50 & 127) - 64;
        check(few(0), few(13), std::ldexp(few(26), exponent));
        const float product = few(0) * few(13);
        check(few(0), few(13), -product);
        check(few(0), few(13), std::ldexp(product, exponent));
        // The same close to the smallest floats.
        check(std::ldexp(few(0), -70), std::ldexp(few(13), exponent - 70),
              std::ldexp(few(26), -140));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const double millions = argc > 1 ? std::atof(argv[1]) : 1;
    check_edges();
    check_random(static_cast<long>(millions * 1e6));
    while (n_cases % kLanes) check(0, 0, 0);
    std::printf("%ld cases, %ld wrong, %ld by the long way only\n", n_cases, n_wrong, n_doubts);
    return n_wrong == 0 ? 0 : 1;
}
