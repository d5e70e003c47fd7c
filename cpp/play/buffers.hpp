// What worlds tell of themselves, written into arrays of the caller.
#pragma once

#include <cstddef>
#include <cstdint>

#include "game/world.hpp"
#include "observe/observe.hpp"
#include "play/episode_statistics.hpp"

namespace matrixworld {

// Where to write what, by world and then by agent, evader, team or kind; nothing is written to a
// null one.
struct Buffers {
    // Of the moment.
    std::int32_t* positions = nullptr;       // (W, A, 2) row, col; -1, -1 when gone
    std::int32_t* last_positions = nullptr;  // (W, A, 2) the same, and of the gone where they went
    std::uint8_t* alive = nullptr;           // (W, A)
    std::int32_t* steps = nullptr;           // (W,)
    std::uint64_t* seed = nullptr;           // (W,)
    std::uint64_t* episode = nullptr;        // (W,)
    std::uint8_t* views = nullptr;           // (W, A, 3, fov, fov)
    float* float_views = nullptr;            // the same as numbers
    std::uint8_t* state = nullptr;           // (W, 3, rows, cols)

    // Of the last step.
    std::uint8_t* captured = nullptr;       // (W, E)
    std::uint8_t* ever_captured = nullptr;  // (W, E)
    std::int32_t* captors = nullptr;        // (W, E)
    std::uint8_t* involved = nullptr;       // (W, A, 3)
    std::uint8_t* fault = nullptr;          // (W, A, 3)
    float* cost = nullptr;                  // (W, A) kinds of collision in which it is at fault
    float* rewards = nullptr;               // (W, A)
    std::uint8_t* terminations = nullptr;   // (W, A) gone, or the world terminated
    std::uint8_t* truncations = nullptr;    // (W, A) the world truncated and nothing terminated
    std::uint8_t* terminated = nullptr;     // (W,)
    std::uint8_t* truncated = nullptr;      // (W,)
    float* capture_rate = nullptr;          // (W,)
    float* ever_capture_rate = nullptr;     // (W,)
    float* survival_rate = nullptr;         // (W, 2)

    // Of a batch: who was alive as the step began, and how the last episode to end came out.
    std::uint8_t* acted = nullptr;                // (W, A)
    std::uint8_t* ended = nullptr;                // (W,) in this very step
    std::uint8_t* final_views = nullptr;          // (W, A, 3, fov, fov)
    float* final_float_views = nullptr;           // the same as numbers
    double* episode_return = nullptr;             // (W, 2)
    std::int32_t* episode_length = nullptr;       // (W,)
    float* episode_capture_rate = nullptr;        // (W,)
    float* episode_ever_capture_rate = nullptr;   // (W,)
    std::int32_t* episode_survivors = nullptr;    // (W, 2)
    std::int32_t* episode_collisions = nullptr;   // (W, 2, 3)
    std::int32_t* episode_faults = nullptr;       // (W, 2, 3)
    std::int64_t* episode_agent_steps = nullptr;  // (W, 2)

    bool tells_episodes() const {
        return episode_return || episode_length || episode_capture_rate ||
               episode_ever_capture_rate || episode_survivors || episode_collisions ||
               episode_faults || episode_agent_steps;
    }
};

// Each writes the share of world `number`. The agents must be in the occupancy.
void write_moment(const World& world, const Occupancy& occupancy, Observer& observer,
                  std::size_t number, const Buffers& buffers);
void write_step(const World& world, std::size_t number, const Buffers& buffers);
void write_acted(const World& world, std::size_t number, const Buffers& buffers);
void write_final_views(const World& world, const Occupancy& occupancy, Observer& observer,
                       std::size_t number, const Buffers& buffers);
void write_score(const EpisodeStatistics& score, std::size_t number, const Buffers& buffers);

}  // namespace matrixworld
