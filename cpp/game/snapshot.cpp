// A world written down between two turns, and taken up again.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/world.hpp"

namespace matrixworld {

namespace {

void require_size(const char* name, long size, long expected) {
    if (size == expected) return;
    throw std::invalid_argument(std::string("snapshot, ") + name + ": expected " +
                                std::to_string(expected) + " entries, got " + std::to_string(size));
}

template <typename Values>
void require_below(const char* name, const Values& values, int low, int high) {
    for (const int value : values) {
        if (value >= low && value < high) continue;
        throw std::invalid_argument(std::string("snapshot, ") + name + ": expected " +
                                    std::to_string(low) + " to " + std::to_string(high - 1) +
                                    ", got " + std::to_string(value));
    }
}

}  // namespace

Snapshot World::snapshot(const Scratch& scratch) const {
    Snapshot s;
    s.key = key_;
    s.map.resize(config().rows * config().cols);
    terrain_->write_map(s.map.data());
    const auto index = [&](int cell) {
        return cell == kGone ? kGone : grid().row(cell) * config().cols + grid().col(cell);
    };
    s.cell = cell_.unaryExpr(index);
    s.last_cells = last_cell_.unaryExpr(index);
    s.captured = captured_;
    s.ever_captured = ever_captured_;
    s.capture_paid = capture_paid_;
    s.captors = captors_;
    s.rewards = rewards_;
    s.report = report_.cast<int>();
    s.participants = scratch.participants;
    s.steps = steps_;
    s.fresh_round = fresh_round_;
    s.terminated = terminated_;
    s.truncated = truncated_;
    return s;
}

void World::check(const Snapshot& s) const {
    const int area = config().rows * config().cols;
    const int n_agents = config().n_agents();
    require_size("map", s.map.size(), area);
    require_size("cell", s.cell.size(), n_agents);
    require_size("last_cells", s.last_cells.size(), n_agents);
    require_size("rewards", s.rewards.size(), n_agents);
    require_size("report", s.report.size(), n_agents);
    require_size("captured", s.captured.size(), config().n_evaders);
    require_size("ever_captured", s.ever_captured.size(), config().n_evaders);
    require_size("capture_paid", s.capture_paid.size(), config().n_evaders);
    require_size("captors", s.captors.size(), config().n_evaders);
    require_below("cell", s.cell, kGone, area);
    require_below("last_cells", s.last_cells, kGone, area);
    require_below("participants", s.participants, 0, n_agents);
}

void World::restore(const Snapshot& s, Scratch& scratch) {
    check(s);
    begin_episode(s.key);
    lay_terrain(s.map);
    const auto cell = [&](int index) {
        return index == kGone ? kGone : grid().cell(index / config().cols, index % config().cols);
    };
    last_cell_ = s.last_cells.unaryExpr(cell);
    living_.clear();
    n_living_[0] = n_living_[1] = 0;
    for (int a = 0; a < config().n_agents(); ++a) {
        cell_[a] = kGone;
        if (s.cell[a] == kGone) continue;
        living_.push_back(a);
        ++n_living_[static_cast<int>(team(a))];
        place(a, cell(s.cell[a]), scratch);
    }
    scratch.occupancy.occupy(living_, cell_);
    captured_ = s.captured;
    ever_captured_ = s.ever_captured;
    capture_paid_ = s.capture_paid;
    captors_ = s.captors;
    rewards_ = s.rewards;
    report_ = s.report.cast<Flags>();
    count_captures();
    scratch.participants = s.participants;
    steps_ = s.steps;
    fresh_round_ = s.fresh_round;
    terminated_ = s.terminated;
    truncated_ = s.truncated;
}

void World::count_captures() {
    n_captured_ = n_at_large_ = 0;
    for (int e = 0; e < config().n_evaders; ++e) {
        n_captured_ += counts_as_captured(e);
        n_at_large_ += alive(evader_agent(e)) && !counts_as_captured(e);
    }
}

}  // namespace matrixworld
