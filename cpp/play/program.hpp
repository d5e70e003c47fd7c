// Programs that rate moves: a genome read as code for a stack of numbers. An instruction is two numbers
// of the genome: the operation, and for an input its place among the policy's inputs, for a constant
// its value, else 0. After the last instruction all numbers are 0. It leaves one number, the rating.
//
//     input 0, input 1, constant 0.5, multiply, subtract    is    a - b * 0.5
#pragma once

#include <cstdint>
#include <vector>

#include "play/rating.hpp"

namespace matrixworld {

struct Operation {
    const char* name;
    int n_arguments;  // that it takes from the stack, on which it leaves one number
};

// By number. Operation 0 ends a program.
enum Operator : int {
    kEnd,
    kInput,
    kConstant,
    kAdd,
    kSubtract,
    kMultiply,
    kMin,
    kMax,
    kNegate,
    kLess,
    kIf,
    kOperators
};
const Operation (&operations())[kOperators];

class Program : public MoveRater {
  public:
    static constexpr int kDepth = 32;  // numbers on the stack

    explicit Program(const RatingShape& shape) : shape_(shape) {}

    void load(const float* genome) override;
    void rate(const MoveRows* rows, int n, MoveRatings* ratings) override;
    std::uint32_t reads() const override { return reads_; }

  private:
    struct Instruction {
        int operation;
        int input;
        float value;
    };

    template <int n>
    void run(const MoveRows& rows, float* ratings) const;

    RatingShape shape_;
    std::vector<Instruction> code_;
    std::uint32_t reads_ = 0;
};

}  // namespace matrixworld
