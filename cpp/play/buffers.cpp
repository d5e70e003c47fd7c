#include "play/buffers.hpp"

#include <algorithm>
#include <vector>

#include "observe/observe.hpp"

namespace matrixworld {

namespace {

std::size_t view_size(const Config& config) {
    return static_cast<std::size_t>(kChannels) * config.fov * config.fov;
}

// The views of all agents of one world, as bytes and as floats.
void write_views(const World& world, const Occupancy& occupancy, Observer& observer,
                 std::size_t number, std::uint8_t* bytes, float* floats) {
    const std::size_t at = number * world.config().n_agents() * view_size(world.config());
    if (bytes) observer.write(world, occupancy, bytes + at);
    if (floats) observer.write(world, occupancy, floats + at);
}

}  // namespace

namespace {

// Rows and columns of cells, (n, 2); kGone, kGone where there is none.
void write_pairs(const Grid& grid, const int* cells, std::size_t n, std::int32_t* out) {
    for (std::size_t i = 0; i < n; ++i) {
        const bool gone = cells[i] == kGone;
        out[2 * i] = gone ? kGone : grid.row(cells[i]);
        out[2 * i + 1] = gone ? kGone : grid.col(cells[i]);
    }
}

void write_last_positions(const World& world, std::size_t n_agents, std::int32_t* out) {
    const int* last_cells = world.last_cells().data();
    write_pairs(world.grid(), world.cells().data(), n_agents, out);
    for (std::size_t a = 0; a < n_agents; ++a) {
        if (out[2 * a] == kGone) write_pairs(world.grid(), last_cells + a, 1, out + 2 * a);
    }
}

void write_alive(const World& world, std::size_t n_agents, std::uint8_t* out) {
    const int* cells = world.cells().data();
    for (std::size_t a = 0; a < n_agents; ++a) out[a] = cells[a] != kGone;
}

}  // namespace

void write_moment(const World& world, const Occupancy& occupancy, Observer& observer,
                  std::size_t number, const Buffers& buffers) {
    const Config& config = world.config();
    const std::size_t n_agents = config.n_agents();
    const std::size_t at = number * n_agents;
    if (buffers.positions) {
        write_pairs(world.grid(), world.cells().data(), n_agents, buffers.positions + 2 * at);
    }
    if (buffers.last_positions)
        write_last_positions(world, n_agents, buffers.last_positions + 2 * at);
    if (buffers.alive) write_alive(world, n_agents, buffers.alive + at);
    if (buffers.steps) buffers.steps[number] = world.steps();
    if (buffers.seed) buffers.seed[number] = world.key().seed;
    if (buffers.episode) buffers.episode[number] = world.key().episode;
    write_views(world, occupancy, observer, number, buffers.views, buffers.float_views);
    if (buffers.state) {
        const std::size_t size = static_cast<std::size_t>(kChannels) * config.rows * config.cols;
        write_state(world, buffers.state + number * size);
    }
}

namespace {

// Who was in a collision, and who paid for it; few are, so the rest is cleared at once.
void write_reports(const World& world, std::size_t at, std::size_t n_agents,
                   const Buffers& buffers) {
    const auto clear = [&](auto* out, std::size_t each) {
        if (out) std::fill_n(out + at * each, n_agents * each, 0);
    };
    clear(buffers.involved, kKinds);
    clear(buffers.fault, kKinds);
    clear(buffers.cost, 1);
    for (std::size_t a = 0; a < n_agents; ++a) {
        const Flags report = world.report(static_cast<int>(a));
        if (report == 0) continue;
        for (int kind = 0; kind < kKinds; ++kind) {
            const bool fault = report >> (kKinds + kind) & 1;
            const std::size_t entry = (at + a) * kKinds + static_cast<std::size_t>(kind);
            if (buffers.involved) buffers.involved[entry] = report >> kind & 1;
            if (buffers.fault) buffers.fault[entry] = fault;
            if (buffers.cost) buffers.cost[at + a] += fault;
        }
    }
}

void write_ends(const World& world, std::size_t at, std::size_t n_agents, const Buffers& buffers) {
    const int* cells = world.cells().data();
    const bool all_end = world.terminated();
    const bool cut = world.truncated();
    for (std::size_t a = 0; a < n_agents; ++a) {
        const bool terminated = all_end || cells[a] == kGone;
        if (buffers.terminations) buffers.terminations[at + a] = terminated;
        if (buffers.truncations) buffers.truncations[at + a] = cut && !terminated;
    }
}

void write_agents(const World& world, std::size_t number, const Buffers& buffers) {
    const std::size_t n_agents = world.config().n_agents();
    const std::size_t at = number * n_agents;
    if (buffers.involved || buffers.fault || buffers.cost) {
        write_reports(world, at, n_agents, buffers);
    }
    if (buffers.terminations || buffers.truncations) write_ends(world, at, n_agents, buffers);
    if (buffers.rewards) std::copy_n(world.rewards().data(), n_agents, buffers.rewards + at);
}

}  // namespace

void write_step(const World& world, std::size_t number, const Buffers& buffers) {
    write_agents(world, number, buffers);
    const Config& config = world.config();
    const std::size_t n_evaders = config.n_evaders;
    const auto copy = [&](const auto& from, auto* to) {
        if (to) std::copy_n(from.data(), n_evaders, to + number * n_evaders);
    };
    copy(world.captured(), buffers.captured);
    copy(world.ever_captured(), buffers.ever_captured);
    copy(world.captors(), buffers.captors);
    const auto put_share = [](float* to, std::size_t at, int count, int of) {
        if (to) to[at] = static_cast<float>(static_cast<double>(count) / of);
    };
    put_share(buffers.capture_rate, number, world.n_captured(), config.n_evaders);
    if (buffers.ever_capture_rate) {
        put_share(buffers.ever_capture_rate, number, world.n_ever_captured(), config.n_evaders);
    }
    put_share(buffers.survival_rate, kTeams * number, world.n_living(Team::Pursuer),
              config.n_pursuers);
    put_share(buffers.survival_rate, kTeams * number + 1, world.n_living(Team::Evader),
              config.n_evaders);
    if (buffers.terminated) buffers.terminated[number] = world.terminated();
    if (buffers.truncated) buffers.truncated[number] = world.truncated();
}

void write_acted(const World& world, std::size_t number, const Buffers& buffers) {
    if (!buffers.acted) return;
    const std::size_t n_agents = world.config().n_agents();
    std::uint8_t* acted = buffers.acted + number * n_agents;
    if (world.over()) {
        std::fill_n(acted, n_agents, std::uint8_t{0});
    } else {
        write_alive(world, n_agents, acted);
    }
}

void write_final_views(const World& world, const Occupancy& occupancy, Observer& observer,
                       std::size_t number, const Buffers& buffers) {
    write_views(world, occupancy, observer, number, buffers.final_views, buffers.final_float_views);
}

void write_score(const EpisodeStatistics& score, std::size_t number, const Buffers& buffers) {
    const auto put = [&](auto* to, const auto& value) {
        if (to) to[number] = value;
    };
    const auto copy = [&](auto* to, const auto& values) {
        if (to) std::copy(values.begin(), values.end(), to + number * values.size());
    };
    copy(buffers.episode_return, score.returns);
    put(buffers.episode_length, score.length);
    put(buffers.episode_capture_rate, score.capture_rate);
    put(buffers.episode_ever_capture_rate, score.ever_capture_rate);
    copy(buffers.episode_survivors, score.survivors);
    copy(buffers.episode_collisions, score.collisions);
    copy(buffers.episode_faults, score.faults);
    copy(buffers.episode_agent_steps, score.agent_steps);
}

}  // namespace matrixworld
