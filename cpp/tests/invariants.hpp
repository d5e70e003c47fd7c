// Invariants of a world: conditions that hold at every moment and after every round, checked by
// slow, obvious code that reads the agents' cells and nothing that the engine has derived from
// them.
#pragma once

#include <map>
#include <set>

#include "scenes.hpp"

namespace matrixworld::tests {

inline bool inside(const World& world, int cell) {
    return cell >= 0 && cell < world.grid().n_cells() && world.terrain().kind[cell] != kBorder;
}

inline bool counts_as_captured(const World& world, int evader) {
    return world.config().rules.capture == Capture::Surround ? world.captured()[evader]
                                                             : world.ever_captured()[evader];
}

inline void check_positions(const World& world) {
    for (int a = 0; a < world.config().n_agents(); ++a) {
        if (!world.alive(a)) continue;
        require(inside(world, world.cell(a)), "every living agent is on the grid");
        const bool on_obstacle = world.terrain().kind[world.cell(a)] == kObstacle;
        require(!on_obstacle || world.config().rules.obstacle == Outcome::Reach,
                "an agent is on an obstacle only under the outcome Reach");
    }
}

inline void check_counters(const World& world) {
    const Config& config = world.config();
    std::vector<int> living;
    int n_living[kTeams] = {0, 0};
    for (int a = 0; a < config.n_agents(); ++a) {
        if (!world.alive(a)) continue;
        living.push_back(a);
        ++n_living[static_cast<int>(world.team(a))];
    }
    int n_captured = 0;
    int n_at_large = 0;
    for (int e = 0; e < config.n_evaders; ++e) {
        const bool captured = counts_as_captured(world, e);
        n_captured += captured;
        n_at_large += world.alive(config.n_pursuers + e) && !captured;
        require(!world.captured()[e] || world.ever_captured()[e],
                "an evader captured now is captured ever");
        require(!world.captors()[e] || world.captured()[e], "only a captured evader has captors");
    }
    require(world.living() == living, "the list of living agents");
    require(world.n_living(Team::Pursuer) == n_living[0], "the number of living pursuers");
    require(world.n_living(Team::Evader) == n_living[1], "the number of living evaders");
    require(world.n_captured() == n_captured, "the number of captured evaders");
    const bool ended = n_at_large == 0 || n_living[0] == 0 || n_living[1] == 0;
    // A reset does not judge the end: an episode has at least one step.
    require(world.steps() == 0 || world.terminated() == ended, "terminated");
    require(world.truncated() == (world.steps() >= config.max_steps), "truncated");
}

// The occupancy agrees with the agents' cells, or is empty where the world has not entered.
inline void check_occupancy(const World& world, const Occupancy& occupancy, bool entered) {
    std::map<int, int> expected[kTeams];  // agents by cell
    for (int a : world.living()) {
        if (entered) ++expected[static_cast<int>(world.team(a))][world.cell(a)];
    }
    for (int t = 0; t < kTeams; ++t) {
        const Team team = static_cast<Team>(t);
        std::map<int, int> counted;
        for (int cell = 0; cell < world.grid().n_cells(); ++cell) {
            if (occupancy.count(cell, team) != 0) counted[cell] = occupancy.count(cell, team);
        }
        require(counted == expected[t], "the number of agents on each cell");
    }
    // Only under agent turns are the lists of agents by cell kept between turns.
    if (world.config().rules.interaction != Interaction::AgentTurns) return;
    std::multiset<int> listed;
    for (int cell = 0; cell < world.grid().n_cells(); ++cell) {
        const CellLists& lists = occupancy.lists();
        for (int a : lists.at(cell)) {
            require(entered && world.cell(a) == cell, "the list of agents on each cell");
            listed.insert(a);
        }
    }
    const std::vector<int>& living = world.living();
    require(listed ==
                (entered ? std::multiset<int>(living.begin(), living.end()) : std::multiset<int>()),
            "every living agent is listed once");
}

// One agent's view as numbers and as a list, compared cell by cell with the state.
inline void check_view(const World& world, const Occupancy& occupancy, int agent) {
    const Config& config = world.config();
    const int fov = config.fov;
    const int area = config.rows * config.cols;
    std::vector<std::uint8_t> state(static_cast<std::size_t>(kChannels) * area);
    std::vector<std::uint8_t> view(static_cast<std::size_t>(kChannels) * fov * fov);
    std::vector<int> listed(view.size());
    write_state(world, state.data());
    const auto size = static_cast<std::ptrdiff_t>(view.size());
    std::vector<std::uint8_t> views(view.size() * static_cast<std::size_t>(config.n_agents()));
    Observer(Setup(world.config())).write(world, occupancy, views.data());
    std::copy_n(views.begin() + agent * size, size, view.begin());
    listed.resize(static_cast<std::size_t>(list_agents(world, occupancy, agent, listed.data())));
    std::vector<std::uint64_t> words(static_cast<std::size_t>(n_obstacle_words(fov)));
    const int cell = world.cell(agent);
    pack_obstacles(world, world.grid().row(cell), world.grid().col(cell), words.data());
    for (std::size_t i = 0; i < 64 * words.size(); ++i) {
        if (words[i / 64] >> (i % 64) & 1)
            listed.push_back(kObstacles * fov * fov + static_cast<int>(i));
    }

    int n_mates = 0;
    for (int a : world.living()) {
        n_mates +=
            a != agent && world.team(a) == world.team(agent) && world.cell(a) == world.cell(agent);
    }
    const int own_channel = world.team(agent) == Team::Pursuer ? kPursuers : kEvaders;
    std::vector<int> expected;
    bool agrees = true;
    for (int i = 0; i < static_cast<int>(view.size()); ++i) {
        const int channel = i / (fov * fov);
        const int at = i % (fov * fov);
        const int row = world.grid().row(world.cell(agent)) + at / fov - fov / 2;
        const int col = world.grid().col(world.cell(agent)) + at % fov - fov / 2;
        const bool outside = row < 0 || row >= config.rows || col < 0 || col >= config.cols;
        const bool self = channel == own_channel && at == fov * fov / 2 && n_mates == 0;
        const bool set = outside ? channel == kObstacles
                                 : state[channel * area + row * config.cols + col] && !self;
        agrees &= view[i] == set;
        if (set && !outside) expected.push_back(i);
    }
    require(agrees, "a view shows the state");
    std::sort(listed.begin(), listed.end());
    require(listed == expected, "the list of a view's cells");
}

inline void check_moment(const World& world, const Scratch& scratch, Random& random) {
    check_positions(world);
    check_counters(world);
    check_occupancy(world, scratch.occupancy, true);
    if (world.living().empty()) return;
    const int n_living = static_cast<int>(world.living().size());
    check_view(world, scratch.occupancy, world.living()[random.below(n_living)]);
}

// Compares the world before a round with the world after it.
inline void check_moves(const World& before, const World& after,
                        const std::vector<std::uint8_t>& actions) {
    for (int a = 0; a < after.config().n_agents(); ++a) {
        const bool silent = after.report(a) == 0 && after.rewards()[a] == 0;
        require(before.alive(a) || (!after.alive(a) && silent),
                "a gone agent stays gone, without reward or report");
        require((after.report(a) >> kKinds & ~after.report(a) & ((1 << kKinds) - 1)) == 0,
                "an agent at fault is involved");
        if (!after.alive(a)) continue;
        // Whatever the rules: a turn moves an agent by its own action or not at all.
        const int step = after.cell(a) - before.cell(a);
        require(step == 0 || step == after.grid().delta(actions[a]),
                "an agent moves by its action or stays");
    }
}

// Agents that the rules keep apart neither share a cell nor have swapped.
inline void check_apart(const World& before, const World& after) {
    const Rules& rules = after.config().rules;
    const bool adversaries_pass = rules.evader == Outcome::Reach && rules.pursuer == Outcome::Reach;
    for (int a : after.living()) {
        for (int b : after.living()) {
            const bool mates = after.team(a) == after.team(b);
            const bool apart = mates ? rules.teammate == Outcome::Bounce : !adversaries_pass;
            if (b <= a || !apart) continue;
            require(after.cell(a) != after.cell(b),
                    "agents kept apart by the rules do not share a cell");
            require(after.cell(a) != before.cell(b) || after.cell(b) != before.cell(a),
                    "agents kept apart by the rules do not swap");
        }
    }
}

inline void check_conflict(const World& before, const World& after, const Conflict& conflict) {
    require(conflict.turn >= 0 && conflict.turn < after.n_turns(), "the turn of a conflict");
    require(inside(after, conflict.cell) || conflict.kind == Kind::Obstacle,
            "the cell of a conflict");
    require((conflict.kind == Kind::Obstacle) == (conflict.second < 0), "the sides of a conflict");
    for (int side = 0; side < (conflict.second < 0 ? 1 : 2); ++side) {
        const int agent = side == 0 ? conflict.first : conflict.second;
        const auto bit = [&](std::uint8_t bits) { return (bits >> side & 1) != 0; };
        require(before.alive(agent), "agents in conflict are alive");
        require(after.report(agent) & involved(conflict.kind),
                "agents in conflict are reported as involved");
        require(!bit(conflict.at_fault) || after.report(agent) & at_fault(conflict.kind),
                "agents at fault are reported");
        require(!bit(conflict.doomed) || !after.alive(agent), "doomed agents are gone");
        require(
            !bit(conflict.held) || !after.alive(agent) || after.cell(agent) == before.cell(agent),
            "held agents stay");
    }
}

// Two worlds agree in everything that a caller can read.
inline void check_equal(const World& a, const World& b) {
    for (int i = 0; i < a.config().n_agents(); ++i) {
        require(a.cell(i) == b.cell(i), "the same cells");
        require(a.report(i) == b.report(i), "the same reports");
    }
    require((a.rewards() == b.rewards()).all(), "the same rewards");
    require((a.captured() == b.captured()).all(), "the same captures");
    require((a.ever_captured() == b.ever_captured()).all(), "the same captures so far");
    require((a.captors() == b.captors()).all(), "the same captors");
    require(a.steps() == b.steps() && a.terminated() == b.terminated(),
            "the same number of steps and the same end");
}

}  // namespace matrixworld::tests
