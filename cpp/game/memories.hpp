// What the agents of a world remember: numbers that a network with memory keeps for each agent from
// one step to the next. No rule reads them. They are zeros at the start of an episode, no other agent
// sees them, and they are gone with the agent.
//
// To decide twice in one step is the same as once: both begin from what was kept in earlier steps.
#pragma once

#include <algorithm>
#include <vector>

#include "grid/rules.hpp"

namespace matrixworld {

class Memories {
  public:
    void clear() { held_.clear(); }
    void drop(int agent) {
        if (agent < static_cast<int>(held_.size())) held_[agent] = {};
    }

    // Writes the `size` numbers with which an agent begins a step. They are zeros where another
    // number of them, or nothing, was kept.
    void recall(int agent, int step, int size, float* out) const {
        std::fill_n(out, size, 0.0f);
        if (agent >= static_cast<int>(held_.size())) return;
        const Held& held = held_[agent];
        const std::vector<float>& numbers = held.step == step ? held.before : held.after;
        if (static_cast<int>(numbers.size()) == size)
            std::copy(numbers.begin(), numbers.end(), out);
    }

    void keep(int agent, int step, int size, const float* numbers) {
        if (agent >= static_cast<int>(held_.size())) held_.resize(agent + 1);
        Held& held = held_[agent];
        if (held.step != step) held.before.swap(held.after);
        held.step = step;
        if (static_cast<int>(held.before.size()) != size) {
            held.before.assign(static_cast<std::size_t>(size), 0.0f);
        }
        held.after.assign(numbers, numbers + size);
    }

    // All of it as plain numbers: for each agent the step and the length of both lists, and then the
    // lists of all agents, one after the other.
    void write(IntArray& steps, IntArray& sizes, std::vector<float>& numbers) const {
        for (std::size_t a = 0; a < held_.size(); ++a) {
            const Held& held = held_[a];
            steps[a] = held.step;
            sizes[a] = static_cast<int>(held.after.size());
            for (const auto& list : {held.before, held.after}) {
                numbers.insert(numbers.end(), list.begin(), list.end());
            }
        }
    }

    // Precondition: as many numbers as the sizes say.
    void read(const IntArray& steps, const IntArray& sizes, const std::vector<float>& numbers) {
        held_.assign(static_cast<std::size_t>(sizes.size()), {});
        auto next = numbers.begin();
        for (std::size_t a = 0; a < held_.size(); ++a) {
            held_[a].step = steps[a];
            for (auto* list : {&held_[a].before, &held_[a].after}) {
                list->assign(next, next + sizes[a]);
                next += sizes[a];
            }
        }
    }

  private:
    struct Held {
        int step = -1;              // in which `after` was kept
        std::vector<float> before;  // what the agent remembered then; as long as `after`
        std::vector<float> after;
    };

    std::vector<Held> held_;  // by agent; as long as the last agent of whom anything was kept
};

}  // namespace matrixworld
