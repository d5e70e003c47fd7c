#include "play/program.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace matrixworld {

const Operation (&operations()) [kOperators] {
    static const Operation all[kOperators] = {
        {"end", 0},   {"input", 0}, {"constant", 0}, {"add", 2},  {"subtract", 2}, {"multiply", 2},
        {"min", 2},   {"max", 2},   {"negate", 1},   {"less", 2},  // 1 if a < b, else 0
        {"where", 3},                                              // b if a > 0, else c
    };
    return all;
}

void Program::load(const float* genome) {
    code_.clear();
    reads_ = 0;
    int depth = 0;
    const auto refuse = [&](std::size_t number, const std::string& expected) {
        throw std::invalid_argument("program: expected " + expected + ", got another in " +
                                    "instruction " + std::to_string(number));
    };
    bool ended = false;
    for (int i = 0; i < shape_.length; ++i) {
        const float number = genome[2 * i], operand = genome[2 * i + 1];
        const auto n_inputs = static_cast<float>(shape_.inputs.size());
        if (!(number >= 0 && number < kOperators && number == static_cast<int>(number)))
            refuse(i, "an operation from 0 to " + std::to_string(kOperators - 1));
        const int operation = static_cast<int>(number);
        ended = ended || operation == kEnd;
        if (ended && (operation != kEnd || operand != 0)) refuse(i, "zeros after the end");
        if (ended) continue;
        int input = 0;
        if (operation == kInput) {
            if (!(operand >= 0 && operand < n_inputs && operand == static_cast<int>(operand)))
                refuse(i, "an input from 0 to " + std::to_string(shape_.inputs.size() - 1));
            input = shape_.inputs[static_cast<std::size_t>(operand)];
            reads_ |= 1u << input;
        } else if (operation != kConstant && operand != 0) {
            refuse(i, std::string("0 as the operand of ") + operations()[operation].name);
        }
        const int n_arguments = operations()[operation].n_arguments;
        if (depth < n_arguments)
            refuse(i, std::to_string(n_arguments) + " numbers on the stack for " +
                          operations()[operation].name);
        depth += 1 - n_arguments;
        if (depth > kDepth)
            refuse(i, "at most " + std::to_string(kDepth) + " numbers on the stack");
        code_.push_back({operation, input, operand});
    }
    if (depth != 1) {
        throw std::invalid_argument("program: expected code that leaves one number, got " +
                                    std::to_string(depth));
    }
}

void Program::rate(const MoveRows* rows, int n, MoveRatings* ratings) {
    for (int i = 0; i < n; ++i) {
        if (shape_.n_actions == kCompassMoves) {
            run<kMoveLanes / 2>(rows[i], ratings[i].of);
        } else {
            run<kMoveLanes>(rows[i], ratings[i].of);
        }
    }
}

// Each instruction works on all moves at once, in whole vectors.
template <int n>
void Program::run(const MoveRows& rows, float* ratings) const {
    float stack[kDepth][n];
    int top = -1;
    const auto each = [&](int n_arguments, const auto& function) {
        top -= n_arguments - 1;
        float* const a = stack[top];
        const float* const b = stack[n_arguments > 1 ? top + 1 : top];
        const float* const c = stack[n_arguments > 2 ? top + 2 : top];
        for (int move = 0; move < n; ++move) a[move] = function(a[move], b[move], c[move]);
    };
    for (const Instruction& next : code_) {
        switch (next.operation) {
            case kInput:
                std::copy_n(rows.of[next.input], n, stack[++top]);
                break;
            case kConstant:
                std::fill_n(stack[++top], n, next.value);
                break;
            case kAdd:
                each(2, [](float a, float b, float) { return a + b; });
                break;
            case kSubtract:
                each(2, [](float a, float b, float) { return a - b; });
                break;
            case kMultiply:
                each(2, [](float a, float b, float) { return a * b; });
                break;
            case kMin:
                each(2, [](float a, float b, float) { return a < b ? a : b; });
                break;
            case kMax:
                each(2, [](float a, float b, float) { return a < b ? b : a; });
                break;
            case kNegate:
                each(1, [](float a, float, float) { return -a; });
                break;
            case kLess:
                each(2, [](float a, float b, float) { return a < b ? 1.0f : 0.0f; });
                break;
            case kIf:
                each(3, [](float a, float b, float c) { return a > 0 ? b : c; });
                break;
        }
    }
    constexpr float kLowest = std::numeric_limits<float>::lowest();
    for (int move = 0; move < n; ++move) {
        ratings[move] = stack[0][move] > kLowest ? stack[0][move] : kLowest;
    }
}

}  // namespace matrixworld
