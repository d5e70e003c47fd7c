#include "batch.hpp"

#include <algorithm>

#include "observe.hpp"

namespace matrixworld {

namespace {

constexpr int kWorldsPerPiece = 16;

void write_moment(const World& world, const Occupancy& occupancy, std::size_t number,
                  const Buffers& buffers) {
    const Config& config = world.config();
    const std::size_t n_agents = config.n_agents();
    const std::size_t view = static_cast<std::size_t>(kChannels) * config.fov * config.fov;
    for (std::size_t a = 0; a < n_agents; ++a) {
        const int agent = static_cast<int>(a);
        const std::size_t at = number * n_agents + a;
        const bool alive = world.alive(agent);
        const int cell = world.cell(agent);
        if (buffers.positions) {
            buffers.positions[2 * at] = alive ? world.grid().row(cell) : kGone;
            buffers.positions[2 * at + 1] = alive ? world.grid().col(cell) : kGone;
        }
        if (buffers.alive) buffers.alive[at] = alive;
        if (buffers.views) write_view(world, occupancy, agent, buffers.views + at * view);
    }
    if (buffers.steps) buffers.steps[number] = world.steps();
    if (buffers.state) {
        const std::size_t size = static_cast<std::size_t>(kChannels) * config.rows * config.cols;
        write_state(world, buffers.state + number * size);
    }
}

void write_step(const World& world, std::size_t number, const Buffers& buffers) {
    const std::size_t n_agents = world.config().n_agents();
    const std::size_t n_evaders = world.config().n_evaders;
    for (std::size_t a = 0; a < n_agents; ++a) {
        const std::size_t at = number * n_agents + a;
        const Flags report = world.report(static_cast<int>(a));
        for (int kind = 0; kind < kKinds; ++kind) {
            if (buffers.involved) buffers.involved[at * kKinds + kind] = report >> kind & 1;
            if (buffers.fault) buffers.fault[at * kKinds + kind] = report >> (kKinds + kind) & 1;
        }
        if (buffers.rewards) buffers.rewards[at] = world.rewards()[static_cast<int>(a)];
    }
    const auto copy = [&](const auto& from, auto* to) {
        if (to) std::copy_n(from.data(), n_evaders, to + number * n_evaders);
    };
    copy(world.captured(), buffers.captured);
    copy(world.ever_captured(), buffers.ever_captured);
    copy(world.captors(), buffers.captors);
    if (buffers.terminated) buffers.terminated[number] = world.terminated();
    if (buffers.truncated) buffers.truncated[number] = world.truncated();
}

}  // namespace

void write(const World& world, const Occupancy& occupancy, std::size_t number,
           const Buffers& buffers) {
    write_step(world, number, buffers);
    write_moment(world, occupancy, number, buffers);
}

Batch::Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, bool autoreset)
    : setup_(std::move(setup)),
      autoreset_(autoreset),
      worlds_(static_cast<std::size_t>(n_worlds), World(setup_)),
      actions_(static_cast<std::size_t>(n_worlds) * setup_->config.n_agents(), 0),
      workers_(n_threads) {
    for (int i = 0; i < workers_.n_threads(); ++i) {
        scratches_.push_back(std::make_unique<Scratch>(*setup_));
    }
}

void Batch::for_each_world(const std::function<void(World&, std::size_t, Scratch&)>& play) {
    const int n_pieces = (n_worlds() + kWorldsPerPiece - 1) / kWorldsPerPiece;
    workers_.run(n_pieces, [&](int piece, int thread) {
        const int end = std::min((piece + 1) * kWorldsPerPiece, n_worlds());
        for (int w = piece * kWorldsPerPiece; w < end; ++w) {
            play(worlds_[w], static_cast<std::size_t>(w), *scratches_[thread]);
        }
    });
}

void Batch::reset(const std::uint64_t* seeds, std::uint64_t episode, const Buffers& buffers) {
    for_each_world([&](World& world, std::size_t w, Scratch& scratch) {
        world.reset({seeds[w], episode}, scratch);
        write(world, scratch.occupancy, w, buffers);
        world.leave(scratch);
    });
}

void Batch::play(const Buffers& buffers) {
    for_each_world(
        [&](World& world, std::size_t w, Scratch& scratch) { play(world, w, scratch, buffers); });
}

void Batch::play(World& world, std::size_t number, Scratch& scratch, const Buffers& buffers) {
    world.enter(scratch);
    if (world.over()) {
        world.begin_round();  // nothing happens any more
    } else {
        world.step(actions_.data() + number * setup_->config.n_agents(), scratch);
    }
    write_step(world, number, buffers);
    if (autoreset_ && world.over()) {
        world.leave(scratch);
        world.reset({world.key().seed, world.key().episode + 1}, scratch);
    }
    write_moment(world, scratch.occupancy, number, buffers);
    world.leave(scratch);
}

}  // namespace matrixworld
