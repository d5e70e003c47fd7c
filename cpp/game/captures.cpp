// Who is captured, by whom, and what becomes of it.
#include <algorithm>

#include "game/world.hpp"

namespace matrixworld {

bool World::counts_as_captured(int evader) const {
    return config().rules.capture == Capture::Occupation ? ever_captured_[evader]
                                                         : captured_[evader];
}

void World::set_captured(int evader, bool captured) {
    const bool counted = counts_as_captured(evader);
    captured_[evader] = captured;
    ever_captured_[evader] |= captured;
    const int change = static_cast<int>(counts_as_captured(evader)) - static_cast<int>(counted);
    n_captured_ += change;
    if (alive(evader_agent(evader))) n_uncaptured_ -= change;
}

void World::release(int evader) {
    captors_[evader] = 0;
    if (captured_[evader]) set_captured(evader, false);
}

void World::add_captor(int evader, int pursuer) {
    if (!captured_[evader]) set_captured(evader, true);
    ++captors_[evader];
    if (!capture_paid_[evader]) unpaid_.emplace_back(evader, pursuer);
}

// A turn in which one agent acted can change the capture of those it met, of those met in the
// turn before (a contact is over), and of those beside the cells it left and entered. The first
// turn of a round judges every evader.
void World::choose_judged(const Turn& turn, const Scratch& scratch) {
    judged_.clear();
    const bool captured_live_on =
        config().rules.capture == Capture::Surround || config().rules.evader == Outcome::Reach;
    if (!captured_live_on) return;  // no living evader is captured
    const bool surround = config().rules.capture == Capture::Surround;
    const bool none_captured = n_uncaptured_ == n_living(Team::Evader);
    if (surround && none_captured && !teams_touch_) return;  // and none is going to be
    if (first_turn_ || !one_by_one()) {
        for (int a : living_) choose_evader(a);
        return;
    }
    for (int a : turn.participants) choose_evader(a);
    for (int a : scratch.last_participants) choose_evader(a);
    if (surround) {
        choose_near(scratch.here, scratch);
        choose_near(scratch.there, scratch);
    }
}

void World::choose_near(int cell, const Scratch& scratch) {
    if (terrain_->kind[cell] == kBorder) return;
    const CellLists& lists = scratch.occupancy.lists();
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        for (int a : lists.at(beside)) choose_evader(a);
    }
}

void World::choose_evader(int agent) {
    if (team(agent) != Team::Evader || !alive(agent)) return;
    const int evader = evader_number(agent);
    if (is_judged_[evader]) return;
    is_judged_[evader] = 1;
    judged_.push_back(evader);
}

void World::judge_captures(const Turn& turn, Scratch& scratch) {
    unpaid_.clear();
    choose_judged(turn, scratch);
    for (int e : judged_) {
        is_judged_[e] = 0;
        release(e);
    }
    if (config().rules.capture == Capture::Occupation) {
        judge_contacts(turn, scratch);
    } else {
        for (int e : judged_) judge_surround(e, scratch);
    }
}

void World::judge_contacts(const Turn& turn, Scratch& scratch) {
    for (const auto& [agent, pursuer] : scratch.resolver.captures()) {
        add_captor(evader_number(agent), pursuer);
    }
    if (config().rules.evader == Outcome::Reach && config().rules.contact_captures()) {
        for (int e : judged_) add_companions(e, turn, scratch);
    }
}

// Pursuers that share the evader's cell without having been in conflict with it in this turn.
void World::add_companions(int evader, const Turn& turn, Scratch& scratch) {
    const int agent = evader_agent(evader);
    if (turn.acts(agent)) return;
    if (scratch.occupancy.count(cell_[agent], Team::Pursuer) == 0) return;
    scratch.occupancy.list(living_, cell_);
    const CellLists& lists = scratch.occupancy.lists();
    for (int p : lists.at(cell_[agent])) {
        if (team(p) == Team::Pursuer && !turn.acts(p)) add_captor(evader, p);
    }
}

void World::judge_surround(int evader, Scratch& scratch) {
    Occupancy& occupancy = scratch.occupancy;
    const int cell = cell_[evader_agent(evader)];
    bool pursued = false;
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        const bool held = occupancy.count(beside, Team::Pursuer) > 0;
        if (!held && terrain_->kind[beside] == kFree) return;
        pursued |= held;
    }
    if (!pursued) return;
    occupancy.list(living_, cell_);
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
    for (int e : judged_) {
        if (!captured_[e]) continue;
        const int cell = cell_[evader_agent(e)];
        scratch.occupancy.remove(evader_agent(e), cell);
        remove(evader_agent(e), cell);
    }
}

}  // namespace matrixworld
