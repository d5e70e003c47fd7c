#include "buffers.hpp"

#include <algorithm>
#include <vector>

#include "observe.hpp"

namespace matrixworld {

namespace {

std::size_t view_size(const Config& config) {
    return static_cast<std::size_t>(kChannels) * config.fov * config.fov;
}

// The views of all agents of one world, as bytes and as floats.
void write_views(const World& world, const Occupancy& occupancy, Lens& lens, std::size_t number,
                 std::uint8_t* bytes, float* floats) {
    const std::size_t at = number * world.config().n_agents() * view_size(world.config());
    if (bytes) lens.write(world, occupancy, bytes + at);
    if (floats) lens.write(world, occupancy, floats + at);
}

}  // namespace

void write_moment(const World& world, const Occupancy& occupancy, Lens& lens, std::size_t number,
                  const Buffers& buffers) {
    const Config& config = world.config();
    const bool tells_places = buffers.positions || buffers.places || buffers.alive;
    const std::size_t n_agents = config.n_agents();
    for (std::size_t a = 0; tells_places && a < n_agents; ++a) {
        const int agent = static_cast<int>(a);
        const std::size_t at = number * n_agents + a;
        const bool alive = world.alive(agent);
        const int cell = world.last_cell(agent);
        if (buffers.positions) {
            buffers.positions[2 * at] = alive ? world.grid().row(cell) : kGone;
            buffers.positions[2 * at + 1] = alive ? world.grid().col(cell) : kGone;
        }
        if (buffers.places) {
            buffers.places[2 * at] = world.grid().row(cell);
            buffers.places[2 * at + 1] = world.grid().col(cell);
        }
        if (buffers.alive) buffers.alive[at] = alive;
    }
    if (buffers.steps) buffers.steps[number] = world.steps();
    if (buffers.seed) buffers.seed[number] = world.key().seed;
    if (buffers.episode) buffers.episode[number] = world.key().episode;
    write_views(world, occupancy, lens, number, buffers.views, buffers.float_views);
    if (buffers.state) {
        const std::size_t size = static_cast<std::size_t>(kChannels) * config.rows * config.cols;
        write_state(world, buffers.state + number * size);
    }
}

namespace {

void write_agents(const World& world, std::size_t number, const Buffers& buffers) {
    const std::size_t n_agents = world.config().n_agents();
    for (std::size_t a = 0; a < n_agents; ++a) {
        const int agent = static_cast<int>(a);
        const std::size_t at = number * n_agents + a;
        const Flags report = world.report(agent);
        int faults = 0;
        for (int kind = 0; kind < kKinds; ++kind) {
            const bool fault = report >> (kKinds + kind) & 1;
            faults += fault;
            if (buffers.involved) buffers.involved[at * kKinds + kind] = report >> kind & 1;
            if (buffers.fault) buffers.fault[at * kKinds + kind] = fault;
        }
        const bool terminated = world.terminated() || !world.alive(agent);
        if (buffers.cost) buffers.cost[at] = static_cast<float>(faults);
        if (buffers.rewards) buffers.rewards[at] = world.rewards()[agent];
        if (buffers.terminations) buffers.terminations[at] = terminated;
        if (buffers.truncations) buffers.truncations[at] = world.truncated() && !terminated;
    }
}

}  // namespace

void write_step(const World& world, std::size_t number, const Buffers& buffers) {
    if (buffers.tells_agents_steps()) write_agents(world, number, buffers);
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
    for (std::size_t a = 0; a < n_agents; ++a) {
        buffers.acted[number * n_agents + a] = !world.over() && world.alive(static_cast<int>(a));
    }
}

void write_final_views(const World& world, const Occupancy& occupancy, Lens& lens,
                       std::size_t number, const Buffers& buffers) {
    write_views(world, occupancy, lens, number, buffers.final_views, buffers.final_float_views);
}

void write_score(const Score& score, std::size_t number, const Buffers& buffers) {
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
