#include "play/batch.hpp"

#include <algorithm>

namespace matrixworld {

namespace {

constexpr int kWorldsPerPiece = 16;

}  // namespace

Batch::Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, Autoreset autoreset)
    : setup_(std::move(setup)),
      autoreset_(autoreset),
      worlds_(static_cast<std::size_t>(n_worlds), World(setup_)),
      statistics_(worlds_.size(), StatisticsAccumulator(setup_->config)),
      actions_(worlds_.size() * setup_->config.n_agents(), 0),
      workers_(n_threads) {
    for (int i = 0; i < workers_.n_threads(); ++i) {
        workspaces_.push_back(std::make_unique<Workspace>(*setup_));
    }
}

template <typename Play>
void Batch::for_each_world(Play play) {
    const int n_pieces = (n_worlds() + kWorldsPerPiece - 1) / kWorldsPerPiece;
    workers_.run(n_pieces, [&](int piece, int thread) {
        const int end = std::min((piece + 1) * kWorldsPerPiece, n_worlds());
        for (int w = piece * kWorldsPerPiece; w < end; ++w) {
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
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        if (!mask || mask[w]) worlds_[w].check(placement(w));
    }
    for_each_world([&](World& world, std::size_t w, Workspace& workspace) {
        if (mask && !mask[w]) return;
        const EpisodeKey next{world.key().seed, world.key().episode + 1};
        begin(world, w, seeds ? EpisodeKey{seeds[w], episode} : next, workspace.scratch,
              placement(w));
        write_step(world, w, buffers);
        write_moment(world, workspace.scratch.occupancy, workspace.observer, w, buffers);
        if (buffers.acted) {
            const int n_agents = setup_->config.n_agents();
            std::fill_n(buffers.acted + w * n_agents, n_agents, std::uint8_t{0});
        }
        if (buffers.ended) buffers.ended[w] = 0;
        world.leave(workspace.scratch);
    });
}

void Batch::begin(World& world, std::size_t number, EpisodeKey key, Scratch& scratch,
                  const Placement& placement) {
    world.reset(key, scratch, placement);
    statistics_[number] = StatisticsAccumulator(setup_->config);
}

void Batch::play(const Buffers& buffers) {
    for_each_world([&](World& world, std::size_t w, Workspace& workspace) {
        play(world, w, workspace, buffers);
    });
}

void Batch::play(World& world, std::size_t number, Workspace& workspace, const Buffers& buffers) {
    Scratch& scratch = workspace.scratch;
    write_acted(world, number, buffers);
    const EpisodeKey next{world.key().seed, world.key().episode + 1};
    const bool was_over = world.over();
    if (was_over && autoreset_ == Autoreset::NextStep) {
        begin(world, number, next, scratch, {});
    } else {
        if (was_over || world.one_by_one()) world.enter(scratch);
        if (was_over) {
            world.begin_round();  // nothing happens any more
        } else {
            world.step(actions_.data() + number * setup_->config.n_agents(), scratch);
            if (buffers.tells_episodes()) statistics_[number].add(world, scratch.occupancy);
        }
    }
    write_step(world, number, buffers);
    const bool ended = world.over() && !was_over;
    if (buffers.ended) buffers.ended[number] = ended;
    if (ended) finish(world, number, workspace, buffers);
    if (world.over() && autoreset_ == Autoreset::SameStep) {
        world.leave(scratch);
        begin(world, number, next, scratch, {});
    }
    write_moment(world, scratch.occupancy, workspace.observer, number, buffers);
    world.leave(scratch);
}

void Batch::finish(World& world, std::size_t number, Workspace& workspace, const Buffers& buffers) {
    if (buffers.tells_episodes()) write_score(statistics_[number].total(world), number, buffers);
    write_final_views(world, workspace.scratch.occupancy, workspace.observer, number, buffers);
}

}  // namespace matrixworld
