// The rules of a world as data. A game variant is one row of `Rules`; nothing in the engine is
// written for a particular variant.
//
//   interaction         which agents act together: all, one team, or a single agent
//   obstacle            outcome of an agent that moves into an obstacle or the border
//   teammate            outcome, for both, of a collision of two agents of one team
//   evader, pursuer     outcomes of the two sides of a collision of adversaries
//   capture             whether contact captures an evader, or being surrounded
//   captured_disappear  whether a surrounded evader is removed (read under SURROUND only)
//
//     Config config;
//     config.rules.teammate = Outcome::Bounce;
//     config.validate();
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace matrixworld {

// Disappear: the agent moves and is removed. Reach: it moves and lives. Bounce: it stays and lives.
enum class Outcome : std::uint8_t { Disappear, Reach, Bounce };

// The properties of an outcome. The resolver judges collisions by them: does the agent's move end
// on its own cell, and is the agent removed?
constexpr bool bounces(Outcome outcome) { return outcome == Outcome::Bounce; }
constexpr bool disappears(Outcome outcome) { return outcome == Outcome::Disappear; }

enum class Interaction : std::uint8_t { Simultaneous, SwarmTurns, AgentTurns };
enum class Capture : std::uint8_t { Occupation, Surround };
enum class Blame : std::uint8_t { Fault, Involved };  // which agents pay a penalty

enum class Team : std::uint8_t { Pursuer, Evader };
inline Team opponent(Team team) { return team == Team::Pursuer ? Team::Evader : Team::Pursuer; }

// The kinds of conflict, by what an agent collides with, and their forms: two agents enter one cell
// (vertex), swap their cells (edge), or one enters the cell of an agent that was held (chain).
enum class Kind : std::uint8_t { Obstacle, Teammate, Adversary };
enum class Form : std::uint8_t { Vertex, Edge, Chain };

// The layers of a view and of the state, in this order.
enum Channel : int { kEvaders = 0, kPursuers = 1, kObstacles = 2, kChannels = 3 };
inline int channel(Team team) { return team == Team::Pursuer ? kPursuers : kEvaders; }

constexpr int kTeams = 2;
constexpr int kKinds = 3;
constexpr int kMaxSide = 4096;           // cells along one side of the grid; fits 16 bits
constexpr int kMaxFieldOfView = 255;     // cells along one side of a view
constexpr int kMaxTeam = (1 << 22) - 1;  // agents; what a `Reservation` can count
constexpr int kCompassMoves = 5;         // stay, north, east, south, west
constexpr int kDiagonalMoves = 9;        // the same, then NE, SE, SW, NW

using ByteArray = Eigen::Array<std::uint8_t, Eigen::Dynamic, 1>;
using IntArray = Eigen::ArrayXi;
using FloatArray = Eigen::ArrayXf;

struct Rules {
    Interaction interaction = Interaction::Simultaneous;
    Outcome obstacle = Outcome::Bounce;
    Outcome teammate = Outcome::Reach;
    Outcome evader = Outcome::Disappear;
    Outcome pursuer = Outcome::Reach;
    Capture capture = Capture::Occupation;
    bool captured_disappear = false;

    Outcome adversary(Team team) const { return team == Team::Pursuer ? pursuer : evader; }

    // Does a conflict of adversaries capture the evader? With any other pair of outcomes occupation
    // captures no evader.
    bool contact_captures() const {
        return capture == Capture::Occupation &&
               (disappears(evader) || (evader == Outcome::Reach && pursuer == Outcome::Reach));
    }
};

// The rewards, indexed by team (pursuer, evader). The defaults are those of the paper.
//
//   capture          to each captor for each evader, and to the captured evader
//   neighbor         when an adversary is on an axially adjacent cell
//   collide          the penalty for each kind of collision
//   step             for each round, or for the agent's turn where turns are taken
//   blame            whether the agents at fault pay a penalty, or all that are involved
//   capture_repeats  whether a capture that lasts is paid at every step
struct Rewards {
    float capture[kTeams] = {10.0f, -10.0f};
    float neighbor[kTeams] = {0.1f, -0.1f};
    float collide[kTeams][kKinds] = {{-12.0f, -12.0f, -12.0f}, {-12.0f, -12.0f, -12.0f}};
    float step[kTeams] = {-0.05f, -0.05f};
    Blame blame = Blame::Fault;
    bool capture_repeats = false;
};

// Throws std::invalid_argument that says what was expected and what came.
void require_range(const char* name, int value, int low, int high);

// Everything that is fixed for a world before its first episode.
struct Config {
    Rules rules;
    Rewards rewards;
    int rows = 40;
    int cols = 40;
    int n_pursuers = 8;
    int n_evaders = 30;
    int fov = 11;           // cells along one side of a view, odd
    bool diagonal = false;  // 9 moves and 8 neighbours instead of 5 and 4
    int max_steps = 500;    // rounds until an episode is truncated
    double density = 0.0;   // share of the cells that become obstacles at every reset
    ByteArray map;          // (rows * cols) 1 where an obstacle is; empty when there is none

    int n_agents() const { return n_pursuers + n_evaders; }
    int n_actions() const { return diagonal ? kDiagonalMoves : kCompassMoves; }
    int n_random_obstacles() const;

    // Throws std::invalid_argument that says which field, what was expected and what came.
    void validate() const;
};

}  // namespace matrixworld
