#include "play/lockstep.hpp"

#include <algorithm>

namespace matrixworld {

namespace {

// Lanes beyond these fill no vector better. Where worlds draw obstacles, what the networks keep for
// each world takes most of a core's cache.
constexpr std::int64_t kLanes = 16;
constexpr std::int64_t kLanesWithObstacles = 2;

bool has_hidden_layer(const Candidates& candidates) {
    return candidates.network && candidates.network->sizes.size() > 2;
}

}  // namespace

bool Lockstep::can_play(const Config& config, const Candidates& pursuers,
                        const Candidates& evaders) {
    return config.rules.interaction != Interaction::AgentTurns &&
           config.n_agents() <= kMaxPositions && has_hidden_layer(pursuers) &&
           has_hidden_layer(evaders);
}

Lockstep::Lockstep(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
                   const Candidates& evaders)
    : setup_(setup),
      scratch_(*setup, false),
      pursuers_(pursuers, *setup, Team::Pursuer),
      evaders_(evaders, *setup, Team::Evader) {}

Lockstep::Lane::Lane(const std::shared_ptr<const Setup>& setup, std::size_t number)
    : number(number),
      world(setup),
      crowd(setup->config),
      accumulator(setup->config),
      units(static_cast<std::size_t>(setup->config.n_agents()) + kAgentsPerBlock),
      actions(static_cast<std::size_t>(setup->config.n_agents())) {}

void Lockstep::play(const Match& match, std::int64_t first, std::int64_t last,
                    const std::function<void()>& check, EpisodeStatistics* statistics) {
    pursuers_.load(match.pursuer);
    evaders_.load(match.evader);
    const std::int64_t most = setup_->config.density > 0 ? kLanesWithObstacles : kLanes;
    const std::int64_t n_lanes = std::min(most, last - first);
    // As many as are used: to make a lane takes as long as some rounds.
    while (static_cast<std::int64_t>(lanes_.size()) < n_lanes) {
        lanes_.push_back(std::make_unique<Lane>(setup_, lanes_.size()));
    }
    for (std::int64_t begin = first; begin < last; begin += n_lanes) {
        playing_.clear();
        pursuers_.forget();
        evaders_.forget();
        for (std::int64_t w = begin; w < std::min(begin + n_lanes, last); ++w) {
            enter(*lanes_[w - begin], {match.seed, static_cast<std::uint64_t>(w)}, statistics++);
        }
        while (!playing_.empty()) {
            check();
            play_round();
            drop_ended();
        }
    }
}

void Lockstep::enter(Lane& lane, EpisodeKey key, EpisodeStatistics* statistics) {
    lane.world.reset(key, scratch_);
    lane.crowd.gather(lane.world, scratch_.occupancy);
    lane.world.leave(scratch_);
    lane.accumulator = StatisticsAccumulator(setup_->config);
    lane.statistics = statistics;
    playing_.push_back(&lane);
}

// ---- A round ------------------------------------------------------------------------------------

// The agents of a turn decide at its beginning, so they see what earlier turns of the round did.
void Lockstep::play_round() {
    for (Lane* lane : playing_) {
        lane->world.begin_round();
        draw_units(lane->world, lane->units.data());
    }
    const int n_turns = playing_.front()->world.n_turns();  // 1, or one for each team
    for (int turn = 0; turn < n_turns; ++turn) {
        if (turn == 0) pursuers_.decide(playing_);
        if (turn == n_turns - 1) evaders_.decide(playing_);
        for (Lane* lane : playing_) play_turn(*lane, turn);
    }
}

// A world enters the scratch by its turn, and leaves it for the next world.
void Lockstep::play_turn(Lane& lane, int turn) {
    World& world = lane.world;
    if (world.terminated()) {
        world.enter(scratch_);  // by the turn before: this one is skipped
    } else {
        world.play_turn(turn, lane.actions.data(), scratch_);
    }
    lane.crowd.gather(world, scratch_.occupancy);
    if (turn == world.n_turns() - 1) {
        world.end_round();
        lane.accumulator.add(world, scratch_.occupancy);
    }
    world.leave(scratch_);
}

void Lockstep::drop_ended() {
    for (Lane* lane : playing_) {
        if (lane->world.over()) *lane->statistics = lane->accumulator.total(lane->world);
    }
    const auto has_ended = [](const Lane* lane) { return lane->world.over(); };
    playing_.erase(std::remove_if(playing_.begin(), playing_.end(), has_ended), playing_.end());
}

// ---- A team -------------------------------------------------------------------------------------

Lockstep::Squad::Squad(const Candidates& candidates, const Setup& setup, Team team)
    : candidates_(candidates), team_(team), mlp_(*candidates.network, setup.grid) {}

void Lockstep::Squad::load(int candidate) {
    if (candidate == loaded_) return;
    mlp_.load(candidates_.genomes + candidate * candidates_.network->genome_size());
    loaded_ = candidate;
}

// The rows of a lane's agents follow those of the lane before.
void Lockstep::Squad::decide(const std::vector<Lane*>& lanes) {
    std::size_t n = 0;
    for (const Lane* lane : lanes) n += static_cast<std::size_t>(lane->world.n_living(team_));
    mlp_.make_room(n);
    if (units_.size() < n + kPad) units_.resize(n + kPad);  // whole vectors are read and written
    if (actions_.size() < n + kPad) actions_.resize(n + kPad);
    std::size_t row = 0;
    for (const Lane* lane : lanes) {
        const int first = lane->first(team_), last = lane->last(team_);
        mlp_.look(lane->world, lane->crowd, first, last, static_cast<Eigen::Index>(row),
                  lane->number);
        for (int i = first; i < last; ++i) units_[row++] = lane->units[lane->world.living()[i]];
    }
    if (mlp_.network().memory != Memory::None) recall(lanes, n);
    mlp_.choose(n, units_.data(), actions_.data());
    const std::uint8_t* action = actions_.data();
    for (Lane* lane : lanes) {
        const int first = lane->first(team_), last = lane->last(team_);
        for (int i = first; i < last; ++i) lane->actions[lane->world.living()[i]] = *action++;
    }
}

// Moves what each agent remembers to its row: zeros in the first round. Later the rows only close up
// behind agents that are gone, since the order of the others stays.
void Lockstep::Squad::recall(const std::vector<Lane*>& lanes, std::size_t n) {
    Rows& states = mlp_.states();
    if (n == holders_.size()) return;
    const bool begins = holders_.empty();
    if (begins) holders_.resize(n);
    std::size_t row = 0, from = 0;
    for (const Lane* lane : lanes) {
        const int first_holder = static_cast<int>(lane->number) * lane->world.config().n_agents();
        for (int i = lane->first(team_); i < lane->last(team_); ++i, ++row, ++from) {
            const int holder = first_holder + lane->world.living()[i];
            if (begins) {
                std::fill_n(states[row], states.width(), 0.0f);
            } else {
                while (holders_[from] != holder) ++from;
                if (from != row) std::copy_n(states[from], states.width(), states[row]);
            }
            holders_[row] = holder;
        }
    }
    holders_.resize(n);
}

}  // namespace matrixworld
