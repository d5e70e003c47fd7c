// Compares the tanh and the logistic function of recurrent layers with the standard library's in
// double precision, over the whole range of floats.
//
//     c++ -std=c++17 -O2 -ffp-contract=off -Icpp cpp/tests/recurrent_units.cpp -o recurrent_units
//     ./recurrent_units [distance between the bit patterns that are tried; 1 tries all]
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "kernels/memory.hpp"

namespace {

using namespace matrixworld;

float float_of(std::uint32_t bits) {
    float value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

// A function, and the largest error that kernels/memory.hpp states.
struct Function {
    const char* name;
    Vec (*ours)(Vec x);
    double (*exact)(double x);
    double lowest;  // value, from -18 on; from 18 on it is 1, and where x is not a number
    double limit;   // of the error
    double worst = 0;
    float worst_at = 0;
    long n_wrong = 0;

    void try_at(const float (&x)[kLanes]) {
        const Vec y = ours(load<Vec>(x));
        for (int i = 0; i < kLanes; ++i) {
            const double wanted = std::isnan(x[i]) ? 1 : exact(x[i]);
            const double error = std::fabs(y[i] - wanted);
            if (error > worst) worst_at = x[i];
            worst = std::max(worst, error);
            const bool ends = x[i] >= 18 ? y[i] == 1 : x[i] > -18 || y[i] == lowest;
            n_wrong += !(error <= limit && (ends || std::isnan(x[i])));
        }
    }
};

}  // namespace

int main(int argc, char** argv) {
    const long stride = argc > 1 ? std::atol(argv[1]) : 1;
    Function functions[] = {
        {"tanh", saturating_tanh<0, Vec>, std::tanh, -1, 3.6e-7},
        {"logistic", logistic<Vec>, [](double x) { return 1 / (1 + std::exp(-x)); }, 0, 2e-7}};
    long n_cases = 0;
    for (std::uint64_t bits = 0; bits < std::uint64_t{1} << 32;) {
        float x[kLanes];
        for (float& each : x) {
            each = float_of(static_cast<std::uint32_t>(bits));
            bits += stride;
        }
        for (Function& function : functions) function.try_at(x);
        n_cases += kLanes;
    }
    for (const Function& function : functions) {
        std::printf("%s: %ld cases, %ld wrong, largest error %.3g at %a\n", function.name, n_cases,
                    function.n_wrong, function.worst, function.worst_at);
    }
    return functions[0].n_wrong + functions[1].n_wrong > 0;
}
