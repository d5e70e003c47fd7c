#include "game/world.hpp"

#include <algorithm>

namespace matrixworld {

void World::enter(Scratch& scratch) const {
    for (int a : living_) scratch.occupancy.add(a, cell_[a]);
    scratch.occupancy.occupy(living_, cell_);
}

void World::leave(Scratch& scratch) const { scratch.occupancy.clear(living_, cell_); }

// ---- A round ------------------------------------------------------------------------------------

void World::step(const std::uint8_t* actions, Scratch& scratch, std::vector<Conflict>* log) {
    begin_round();
    for (int turn = 0; turn < n_turns(); ++turn) play_turn(turn, actions, scratch, log);
    end_round();
}

int World::n_turns() const {
    switch (config().rules.interaction) {
        case Interaction::Simultaneous:
            return 1;
        case Interaction::SwarmTurns:
            return kTeams;
        case Interaction::AgentTurns:
            break;
    }
    return config().n_agents();
}

void World::actors(int turn, int& first, int& last) const {
    switch (config().rules.interaction) {
        case Interaction::Simultaneous:
            first = 0;
            last = config().n_agents();
            return;
        case Interaction::SwarmTurns:
            first = turn == 0 ? 0 : config().n_pursuers;
            last = turn == 0 ? config().n_pursuers : config().n_agents();
            return;
        case Interaction::AgentTurns:
            first = turn;
            last = turn + 1;
            return;
    }
}

void World::begin_round() {
    rewards_.setZero();
    for (int a : reported_) report_[a] = 0;
    reported_.clear();
    captors_.setZero();
    if (config().rewards.capture_repeats) capture_paid_.setZero();
    first_turn_ = true;
}

void World::play_turn(int number, const std::uint8_t* actions, Scratch& scratch,
                      std::vector<Conflict>* log) {
    int first = 0;
    int last = 0;
    actors(number, first, last);
    // A turn whose agents are gone, or that comes after the end, is skipped.
    const bool no_actor = last - first == 1 ? !alive(first) : n_living(team(first)) == 0;
    if (terminated_ || no_actor) return;

    const std::vector<int>& participants =
        one_by_one() ? choose_participants(first, actions[first], scratch) : living_;
    const Turn turn = make_turn(participants, actions, first, last, number);
    scratch.occupancy.release(participants, cell_);
    // Stages 1 to 4: obstacles, teammates, adversaries, chains.
    scratch.resolver.resolve(turn, scratch.occupancy.reservations(), log);
    may_overlap_ = one_by_one() || scratch.resolver.may_conflict();
    // Stage 5.
    settle(turn, scratch);
    scratch.occupancy.occupy(participants, cell_);
    teams_adjacent_ = one_by_one() || teams_are_adjacent(turn, scratch);
    judge_captures(turn, scratch);
    pay_captures();
    remove_captured(scratch);
    pay_actors(turn, scratch);
    report_and_penalize(scratch);
    scratch.occupancy.clear_lists();
    update_living();
    judge_end();
    first_turn_ = false;
}

// The round counts even where the episode ended in the middle of it, but none counts after the last.
void World::end_round() {
    steps_ = std::min(steps_ + 1, config().max_steps);
    truncated_ = steps_ >= config().max_steps;
}

// The participants of a single agent's turn: the actor and the agents on the cell it leaves and on
// the cell it enters. No other agent can be in conflict with it, so a turn costs O(1), not
// O(agents).
const std::vector<int>& World::choose_participants(int actor, int action, Scratch& scratch) const {
    std::swap(scratch.participants, scratch.last_participants);
    scratch.participants.clear();
    scratch.actor_cell = cell_[actor];
    scratch.actor_target = scratch.actor_cell + grid().delta(action);
    const CellLists& lists = scratch.occupancy.lists();
    for (Team wanted : {Team::Pursuer, Team::Evader}) {
        const auto add = [&](int cell) {
            for (int a : lists.at(cell)) {
                if (team(a) == wanted) scratch.participants.push_back(a);
            }
        };
        add(scratch.actor_cell);
        if (scratch.actor_target != scratch.actor_cell) add(scratch.actor_target);
    }
    return scratch.participants;
}

// Participants list the pursuers first, so each team and the actors are ranges of them.
Turn World::make_turn(const std::vector<int>& participants, const std::uint8_t* actions, int first,
                      int last, int number) const {
    const Agents all{participants.data(), participants.data() + participants.size()};
    const int* first_evader = all.first + n_living(Team::Pursuer);
    Agents actors = all;
    if (one_by_one()) {
        first_evader =
            std::find_if(all.first, all.last, [&](int a) { return team(a) == Team::Evader; });
        actors.first = std::find(all.first, all.last, first);
        actors.last = actors.first + 1;
    } else if (first != 0) {
        actors.first = first_evader;
    } else if (last != config().n_agents()) {
        actors.last = first_evader;
    }
    return {all,   first_evader, actors, cell_.data(), actions, terrain_->kind.data(),
            first, last,         number};
}

void World::settle(const Turn& turn, Scratch& scratch) {
    const Resolver& resolver = scratch.resolver;
    for (int a : turn.participants) cell_[a] = resolver.target(a);
    for (int a : resolver.flagged()) {
        if (!(resolver.flags(a) & (kCrashed | kDoomed))) continue;
        // An evader that disappears is captured only if this turn's judgement says so.
        if (team(a) == Team::Evader) clear_capture(evader_number(a));
        remove(a, cell_[a]);
    }
}

void World::remove(int agent, int cell) {
    cell_[agent] = kGone;
    last_cell_[agent] = cell;
    memories_.drop(agent);
    --n_living_[static_cast<int>(team(agent))];
    if (team(agent) == Team::Evader && !counts_as_captured(evader_number(agent))) --n_uncaptured_;
}

// Gone agents stay in `living_` during a turn, since its loops run over the list; they are erased
// once at the end.
void World::update_living() {
    if (n_living_[0] + n_living_[1] == static_cast<int>(living_.size())) return;
    living_.erase(std::remove_if(living_.begin(), living_.end(), [&](int a) { return !alive(a); }),
                  living_.end());
}

// ---- Rewards and the end ------------------------------------------------------------------------

// Each captor is paid for each evader; the evader pays once, whatever the number of its captors.
void World::pay_captures() {
    const auto& capture = config().rewards.capture;
    for (const auto& [evader, pursuer] : payable_captures_) {
        rewards_[pursuer] += pay(capture, pursuer);
        if (capture_paid_[evader]) continue;
        capture_paid_[evader] = 1;
        rewards_[evader_agent(evader)] += pay(capture, evader_agent(evader));
    }
}

void World::pay_actors(const Turn& turn, const Scratch& scratch) {
    const Rewards& rewards = config().rewards;
    const ReservationTable reservations = scratch.occupancy.reservations();
    for (int a : turn.actors) rewards_[a] += pay(rewards.step, a);
    if (!teams_adjacent_) return;
    for (int a : turn.actors) {
        if (alive(a) && reservations.any_beside(cell_[a], opponent(team(a)), grid(), false)) {
            rewards_[a] += pay(rewards.neighbor, a);
        }
    }
}

// Is any agent beside an adversary? Every such pair has a member in the smaller team, so only that
// team is looked at. Where the answer is no, which is common, captures by surround and rewards for
// neighbours need no further work.
bool World::teams_are_adjacent(const Turn& turn, const Scratch& scratch) const {
    const ReservationTable reservations = scratch.occupancy.reservations();
    const bool fewer = n_living(Team::Pursuer) <= n_living(Team::Evader);
    const Team team = fewer ? Team::Pursuer : Team::Evader;
    const bool diagonal = config().diagonal;
    bool adjacent = false;
    for (int a : turn.of(team)) {
        if (alive(a))
            adjacent |= reservations.any_beside(cell_[a], opponent(team), grid(), diagonal);
    }
    return adjacent;
}

void World::report_and_penalize(const Scratch& scratch) {
    for (int a : scratch.resolver.flagged()) {
        // Each kind is reported, and its penalty paid, once a round, however many turns it has.
        const Flags added = scratch.resolver.flags(a) & kReportMask & ~report_[a];
        if (report_[a] == 0 && added != 0) reported_.push_back(a);
        report_[a] |= added;
        const int blamed = config().rewards.blame == Blame::Fault ? added >> kKinds : added;
        rewards_[a] += setup_->penalties[static_cast<int>(team(a))][blamed & ((1 << kKinds) - 1)];
    }
}

void World::judge_end() {
    terminated_ = n_uncaptured_ == 0 || n_living_[0] == 0 || n_living_[1] == 0;
}

}  // namespace matrixworld
