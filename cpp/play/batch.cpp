#include "play/batch.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace matrixworld {

namespace {

// Copies n values as bytes, and returns whether all of them are at least 0 and below the limit. Each
// value is read once and the copies are judged, since another thread may be writing to the values.
// Two loops without branches, which the compiler turns into vector instructions: nearly always all
// actions of a batch are legal.
template <typename Integer>
bool copy_below(int limit, const Integer* values, std::size_t n, std::uint8_t* copies) {
    std::make_unsigned_t<Integer> bits = 0;  // of all values; those of a negative one are high
    for (std::size_t i = 0; i < n; ++i) {
        const Integer value = values[i];
        bits |= static_cast<std::make_unsigned_t<Integer>>(value);
        copies[i] = static_cast<std::uint8_t>(value);
    }
    std::uint8_t most = 0;
    for (std::size_t i = 0; i < n; ++i) most = std::max(most, copies[i]);
    return bits <= UINT8_MAX && most < limit;
}

EpisodeKey next_episode(const World& world) { return {world.key().seed, world.key().episode + 1}; }

}  // namespace

Batch::Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, Autoreset autoreset)
    : setup_(std::move(setup)),
      autoreset_(autoreset),
      worlds_(static_cast<std::size_t>(n_worlds), World(setup_)),
      statistics_(worlds_.size(), StatisticsAccumulator(setup_->config)),
      actions_(worlds_.size() * setup_->config.n_agents(), 0),
      was_over_(worlds_.size(), 0),
      workers_(n_threads) {
    for (int i = 0; i < workers_.n_threads(); ++i) {
        workspaces_.push_back(std::make_unique<Workspace>(*setup_));
    }
}

template <typename Integer>
void Batch::commit(const Integer* actions, std::pair<int, int> agents) {
    const std::size_t n_agents = static_cast<std::size_t>(setup_->config.n_agents());
    if (copy_below(setup_->config.n_actions(), actions, actions_.size(), actions_.data())) return;
    // Some action is out of range, which is allowed for agents that are gone or do not act, and in
    // worlds that are over.
    std::fill(actions_.begin(), actions_.end(), std::uint8_t{0});
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        if (worlds_[w].over()) continue;
        commit_actions(worlds_[w], w, agents.first, agents.second, actions + w * n_agents,
                       actions_.data() + w * n_agents);
    }
}

template void Batch::commit(const std::int8_t*, std::pair<int, int>);
template void Batch::commit(const std::uint8_t*, std::pair<int, int>);
template void Batch::commit(const std::int32_t*, std::pair<int, int>);
template void Batch::commit(const std::int64_t*, std::pair<int, int>);

template <typename Play>
void Batch::for_each_world(Play play) {
    const std::int64_t n_pieces = (n_worlds() + kWorldsPerPiece - 1) / kWorldsPerPiece;
    workers_.run(n_pieces, [&](std::int64_t piece, int thread) {
        const std::int64_t end = std::min((piece + 1) * kWorldsPerPiece, std::int64_t{n_worlds()});
        for (std::int64_t w = piece * kWorldsPerPiece; w < end; ++w) {
            play(worlds_[w], static_cast<std::size_t>(w), *workspaces_[thread]);
        }
    });
}

void Batch::reset(const std::uint64_t* seeds, std::uint64_t episode, const std::uint8_t* mask,
                  const std::vector<Placement>& placements, const Buffers& buffers) {
    const Placement drawn;
    const auto placement = [&](std::size_t w) -> const Placement& {
        if (placements.empty()) return drawn;
        return placements.size() == 1 ? placements[0] : placements[w];
    };
    // All placements are checked before the first world changes, and by this thread, so that the
    // exception is always that of the first world with a wrong one.
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        if (!mask || mask[w]) worlds_[w].check(placement(w));
    }
    turn_ = 0;
    for_each_world([&](World& world, std::size_t w, Workspace& workspace) {
        if (mask && !mask[w]) return;
        const EpisodeKey key = seeds ? EpisodeKey{seeds[w], episode} : next_episode(world);
        if (buffers.has_inputs()) workspace.serve_networks(*setup_);
        Scratch& scratch = *workspace.scratch;
        begin(world, w, key, scratch, placement(w));
        OutputSource& source = workspace.source;
        source.look_at(world, scratch.occupancy);
        source.acts = source.ended = false;  // a reset is no step
        for (const Written when : {Written::StepStart, Written::Step, Written::Moment}) {
            buffers.write(when, source, w);
        }
        world.leave(scratch);
    });
}

void Batch::decide(const std::vector<Candidates>& policies, const std::vector<std::int32_t>& chosen,
                   int first, int last, std::int64_t* actions) {
    std::vector<std::size_t> acting;
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        const Candidates& policy = policies[chosen[w]];
        if (!worlds_[w].over() && policy) acting.push_back(w);
    }
    // Worlds with the same policy follow each other, so that a thread seldom loads another one.
    std::stable_sort(acting.begin(), acting.end(),
                     [&](std::size_t v, std::size_t w) { return chosen[v] < chosen[w]; });
    struct Memory {
        int policy = -1;
        std::optional<LoadedPolicy> loaded;
    };
    std::vector<Memory> memories(workspaces_.size());
    const auto n = static_cast<std::int64_t>(acting.size());
    workers_.run((n + kWorldsPerPiece - 1) / kWorldsPerPiece, [&](std::int64_t piece, int thread) {
        auto& [policy, loaded] = memories[thread];
        workspaces_[thread]->serve_networks(*setup_);
        Scratch& scratch = *workspaces_[thread]->scratch;
        const std::int64_t end = std::min((piece + 1) * kWorldsPerPiece, n);
        for (std::int64_t i = piece * kWorldsPerPiece; i < end; ++i) {
            const std::size_t w = acting[i];
            if (policy != chosen[w]) loaded.emplace(policies[chosen[w]], *setup_);
            policy = chosen[w];
            Policy& decider = loaded->load(0);
            worlds_[w].enter(scratch);
            decider.decide(worlds_[w], scratch.occupancy, first, last,
                           actions + w * setup_->config.n_agents());
            worlds_[w].leave(scratch);
        }
    });
}

void Batch::begin(World& world, std::size_t w, EpisodeKey key, Scratch& scratch,
                  const Placement& placement) {
    world.reset(key, scratch, placement);
    statistics_[w] = StatisticsAccumulator(setup_->config);
}

void Batch::play(int turns, const Buffers& buffers) {
    for_each_world([&](World& world, std::size_t w, Workspace& workspace) {
        play(turns, world, w, workspace, buffers);
    });
    turn_ = (turn_ + turns) % n_turns();
}

void Batch::play(int turns, World& world, std::size_t w, Workspace& workspace,
                 const Buffers& buffers) {
    if (buffers.has_inputs()) workspace.serve_networks(*setup_);
    Scratch& scratch = *workspace.scratch;
    OutputSource& source = workspace.source;
    source.look_at(world, scratch.occupancy);
    if (turn_ == 0) {
        was_over_[w] = world.over();
        source.acts = !was_over_[w];
        buffers.write(Written::StepStart, source, w);
    }

    advance(turns, world, w, scratch, buffers);
    source.look_at(world, scratch.occupancy);
    source.acts = !was_over_[w];
    source.ended = turn_ + turns == n_turns() && world.over() && !was_over_[w];
    buffers.write(Written::Step, source, w);
    if (source.ended) finish(world, w, source, buffers);

    if (world.over() && autoreset_ == Autoreset::SameStep) {
        world.leave(scratch);
        begin(world, w, next_episode(world), scratch);
        source.look_at(world, scratch.occupancy);
    }
    buffers.write(Written::Moment, source, w);
    world.leave(scratch);
}

// Plays turns, or what takes their place in a world that was over. The world is in the scratch
// afterwards.
void Batch::advance(int turns, World& world, std::size_t w, Scratch& scratch,
                    const Buffers& buffers) {
    if (was_over_[w] && autoreset_ == Autoreset::NextStep) {
        begin(world, w, next_episode(world), scratch);
        return;
    }
    if (was_over_[w]) {
        world.enter(scratch);
        if (turn_ == 0) world.begin_round();  // clears rewards and reports
        return;
    }
    // Where all agents of a turn move together, a turn itself brings them into the scratch. A turn
    // without actors, which is skipped, does not; of a whole round one turn has some.
    if (world.one_by_one() || turns < n_turns()) world.enter(scratch);
    if (turn_ == 0) world.begin_round();
    const int end = turn_ + turns;
    const std::uint8_t* actions = actions_.data() + w * setup_->config.n_agents();
    for (int turn = turn_; turn < end; ++turn) world.play_turn(turn, actions, scratch);
    if (end < n_turns()) return;
    world.end_round();
    if (buffers.has(Written::EpisodeEnd)) statistics_[w].add(world, scratch.occupancy);
}

void Batch::finish(const World& world, std::size_t w, OutputSource& source,
                   const Buffers& buffers) {
    const EpisodeStatistics statistics = statistics_[w].total(world);
    source.statistics = &statistics;
    buffers.write(Written::EpisodeEnd, source, w);
    source.statistics = nullptr;
}

}  // namespace matrixworld
