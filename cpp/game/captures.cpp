// Captures: which evaders are captured after a turn, and by which pursuers. All are judged before
// any captured evader is removed, so that the order of evaders does not matter.
#include <algorithm>

#include "game/world.hpp"

namespace matrixworld {

bool World::counts_as_captured(int evader) const {
    return config().rules.capture == Capture::Occupation ? ever_captured_[evader]
                                                         : captured_[evader];
}

// Changes whether an evader is captured now, and keeps the counters that follow from it.
void World::set_captured(int evader, bool captured) {
    const bool counted = counts_as_captured(evader);
    captured_[evader] = captured;
    ever_captured_[evader] |= captured;
    const int change = static_cast<int>(counts_as_captured(evader)) - static_cast<int>(counted);
    n_captured_ += change;
    if (alive(evader_agent(evader))) n_uncaptured_ -= change;
}

void World::clear_capture(int evader) {
    captors_[evader] = 0;
    if (captured_[evader]) set_captured(evader, false);
}

void World::add_captor(int evader, int pursuer) {
    if (!captured_[evader]) set_captured(evader, true);
    ++captors_[evader];
    if (!capture_paid_[evader]) payable_captures_.emplace_back(evader, pursuer);
}

// Collects the evaders whose capture this turn can change. Under agent turns these are few: the
// evaders among the participants, those of the turn before (their contact is over), and those
// beside the cells that the actor left and entered. Judging all evaders in every turn would cost
// O(agents * evaders) a round. The first turn of a round judges every evader.
void World::find_affected_evaders(const Turn& turn, const Scratch& scratch) {
    affected_.clear();
    const bool captured_live_on =
        config().rules.capture == Capture::Surround || config().rules.evader == Outcome::Reach;
    if (!captured_live_on) return;  // no evader that is captured lives on
    const bool surround = config().rules.capture == Capture::Surround;
    const bool none_captured = n_uncaptured_ == n_living(Team::Evader);
    if (surround && none_captured && !teams_adjacent_) return;  // and none can become captured
    if (first_turn_ || !one_by_one()) {
        for (int a : living_) add_affected(a);
        return;
    }
    for (int a : turn.participants) add_affected(a);
    for (int a : scratch.last_participants) add_affected(a);
    if (surround) {
        add_affected_beside(scratch.actor_cell, scratch);
        add_affected_beside(scratch.actor_target, scratch);
    }
}

void World::add_affected_beside(int cell, const Scratch& scratch) {
    if (terrain_->kind[cell] == kBorder) return;
    const CellLists& lists = scratch.occupancy.lists();
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        for (int a : lists.at(beside)) add_affected(a);
    }
}

void World::add_affected(int agent) {
    if (team(agent) != Team::Evader || !alive(agent)) return;
    const int evader = evader_number(agent);
    if (is_affected_[evader]) return;
    is_affected_[evader] = 1;
    affected_.push_back(evader);
}

void World::judge_captures(const Turn& turn, Scratch& scratch) {
    payable_captures_.clear();
    find_affected_evaders(turn, scratch);
    for (int e : affected_) {
        is_affected_[e] = 0;
        clear_capture(e);
    }
    if (config().rules.capture == Capture::Occupation) {
        judge_contacts(turn, scratch);
    } else {
        for (int e : affected_) judge_surround(e, scratch);
    }
}

void World::judge_contacts(const Turn& turn, Scratch& scratch) {
    for (const auto& [agent, pursuer] : scratch.resolver.captures()) {
        add_captor(evader_number(agent), pursuer);
    }
    if (config().rules.evader == Outcome::Reach && config().rules.contact_captures()) {
        for (int e : affected_) add_captors_on_cell(e, turn, scratch);
    }
}

// Under (Reach, Reach) an evader is captured as long as it shares its cell with a pursuer. Pursuers
// in conflict with it in this turn have been added; this adds those that are on its cell and, like
// the evader, did not act.
void World::add_captors_on_cell(int evader, const Turn& turn, Scratch& scratch) {
    const int agent = evader_agent(evader);
    if (turn.acts(agent)) return;
    if (scratch.occupancy.count(cell_[agent], Team::Pursuer) == 0) return;
    scratch.occupancy.make_lists(living_, cell_);
    const CellLists& lists = scratch.occupancy.lists();
    for (int p : lists.at(cell_[agent])) {
        if (team(p) == Team::Pursuer && !turn.acts(p)) add_captor(evader, p);
    }
}

// Most evaders have a free cell beside them: the first pass, which reads counts only, returns at
// once. The lists of agents are made only when the captors must be named.
void World::judge_surround(int evader, Scratch& scratch) {
    Occupancy& occupancy = scratch.occupancy;
    const int cell = cell_[evader_agent(evader)];
    bool any_pursuer = false;
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        const bool pursuer_there = occupancy.count(beside, Team::Pursuer) > 0;
        if (!pursuer_there && terrain_->kind[beside] == kFree) return;
        any_pursuer |= pursuer_there;
    }
    if (!any_pursuer) return;
    occupancy.make_lists(living_, cell_);
    const CellLists& lists = occupancy.lists();
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        for (int a : lists.at(beside)) {
            if (team(a) == Team::Pursuer) add_captor(evader, a);
        }
    }
}

void World::remove_captured(Scratch& scratch) {
    const Rules& rules = config().rules;
    if (rules.capture != Capture::Surround || !rules.captured_disappear) return;
    for (int e : affected_) {
        if (!captured_[e]) continue;
        const int cell = cell_[evader_agent(e)];
        scratch.occupancy.remove(evader_agent(e), cell);
        remove(evader_agent(e), cell);
    }
}

}  // namespace matrixworld
