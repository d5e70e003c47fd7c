// A world that a page plays: it keeps its scratch, the number of the next turn and the conflicts.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "play/batch.hpp"
#include "play/mlp.hpp"
#include "play/output_fields.hpp"
#include "play/rating.hpp"
#include "settings.hpp"

namespace matrixworld {

// A world with a scratch of its own, in which its agents stay between two calls.
class PlayedWorld {
  public:
    explicit PlayedWorld(std::shared_ptr<const Setup> setup)
        : setup_(std::move(setup)), world_(setup_), scratch_(*setup_), observer_(*setup_) {
        source_.observer = &observer_;
        world_.reset({}, scratch_);
    }

    // `source_` points to this object's own observer.
    PlayedWorld(const PlayedWorld&) = delete;
    PlayedWorld& operator=(const PlayedWorld&) = delete;

    void reset(EpisodeKey key, const Placement& placement) {
        world_.check(placement);  // a refused start leaves the world as it was
        world_.leave(scratch_);
        world_.reset(key, scratch_, placement);
        turn_ = 0;
        conflicts_.clear();
    }

    void play_turn(const std::vector<int>& actions) {
        if (turn_ == 0) require_open();
        const auto [first, last] = actors();
        const std::vector<std::uint8_t> committed = commit(actions, first, last);
        if (turn_ == 0) {
            conflicts_.clear();
            world_.begin_round();
        }
        world_.play_turn(turn_, committed.data(), scratch_, &conflicts_);
        if (++turn_ < world_.n_turns()) return;
        world_.end_round();
        turn_ = 0;
    }

    void step(const std::vector<int>& actions) {
        require_open();
        if (turn_ != 0) {
            throw std::invalid_argument("turn " + std::to_string(turn_) + " of " +
                                        std::to_string(world_.n_turns()) +
                                        " is next: finish the round turn by turn");
        }
        const std::vector<std::uint8_t> committed = commit(actions, 0, setup_->config.n_agents());
        conflicts_.clear();
        world_.step(committed.data(), scratch_, &conflicts_);
    }

    // Writes the actions that a policy chooses now for living agents [first, last) of one team.
    void decide(const Candidates& policy, int first, int last, std::vector<int>& actions) {
        if (world_.over()) return;
        LoadedPolicy loaded(policy, *setup_);
        loaded.load(0).decide(world_, scratch_.occupancy, first, last, actions.data());
    }

    // The outputs of a network for one agent, which is alive.
    std::vector<float> logits(const Player& player, int agent) const {
        const std::optional<Network>& network = player.candidates.network;
        if (!network) throw std::invalid_argument("policy: expected a network, got another one");
        require_alive(agent);
        Mlp mlp(*network, setup_->grid);
        mlp.load(player.genome.data());
        std::vector<std::uint8_t> actions(1);
        mlp.act(world_, scratch_.occupancy, {agent}, {0.0f}, actions);
        return {mlp.logits(), mlp.logits() + network->n_actions()};
    }

    // How a policy rates the moves of an agent, which is alive.
    struct RatedMoves {
        std::vector<float> ratings;         // by move
        std::vector<std::uint8_t> refused;  // by move, as flags: those that the mask refuses
    };
    RatedMoves rate(const Player& player, int agent) const {
        const std::optional<RatingShape>& shape = player.candidates.rating;
        if (!shape)
            throw std::invalid_argument("policy: expected one that rates moves, got another");
        require_alive(agent);
        MoveInputs inputs(config());
        MoveRows rows{};
        inputs.gather(world_, scratch_.occupancy);
        inputs.look(agent, rows);
        const std::unique_ptr<MoveRater> rater = make_rater(*shape);
        rater->load(player.genome.data());
        MoveRatings ratings;
        rater->rate(&rows, 1, &ratings);
        const std::uint32_t refused = shape->mask == MoveMask::None        ? 0
                                      : shape->mask == MoveMask::Obstacles ? rows.blocked
                                                                           : rows.forbidden;
        RatedMoves rated;
        for (int move = 0; move < shape->n_actions; ++move) {
            rated.ratings.push_back(ratings.of[move]);
            rated.refused.push_back(refused >> move & 1);
        }
        return rated;
    }

    // What an agent remembers at the beginning of this step for a network.
    std::vector<float> memory(const Player& player, int agent) const {
        std::vector<float> numbers(player.candidates.network->state_size());
        world_.memories().recall(agent, world_.steps(), static_cast<int>(numbers.size()),
                                 numbers.data());
        return numbers;
    }

    void write(const OutputField& field, void* out) {
        source_.look_at(world_, scratch_.occupancy);
        field.write(source_, out);
    }

    Snapshot snapshot() const { return world_.snapshot(scratch_); }

    void restore(const Snapshot& snapshot, int turn) {
        if (turn < 0 || turn >= world_.n_turns()) {
            throw std::invalid_argument("snapshot, turn: expected 0 to " +
                                        std::to_string(world_.n_turns() - 1) + ", got " +
                                        std::to_string(turn));
        }
        world_.leave(scratch_);
        try {
            World fresh(setup_);
            fresh.restore(snapshot, scratch_);
            world_ = std::move(fresh);
        } catch (...) {
            world_.enter(scratch_);
            throw;
        }
        turn_ = turn;
        conflicts_.clear();
    }

    std::pair<int, int> actors() const {
        int first = 0;
        int last = 0;
        world_.actors(turn_, first, last);
        return {first, last};
    }

    const World& world() const { return world_; }
    const Config& config() const { return setup_->config; }
    int turn() const { return turn_; }
    const std::vector<Conflict>& conflicts() const { return conflicts_; }

  private:
    void require_alive(int agent) const {
        if (agent >= 0 && agent < config().n_agents() && world_.alive(agent)) return;
        throw std::invalid_argument("agent: expected one that is alive, got " +
                                    std::to_string(agent));
    }

    void require_open() const {
        if (!world_.over()) return;
        throw std::invalid_argument("the episode has ended: reset it before the next step");
    }

    std::vector<std::uint8_t> commit(const std::vector<int>& actions, int first, int last) const {
        const auto n_agents = static_cast<std::size_t>(setup_->config.n_agents());
        if (actions.size() != n_agents) {
            throw std::invalid_argument("actions: expected " + std::to_string(n_agents) + ", got " +
                                        std::to_string(actions.size()));
        }
        std::vector<std::uint8_t> committed(n_agents, 0);
        commit_actions(world_, 0, first, last, actions.data(), committed.data());
        return committed;
    }

    std::shared_ptr<const Setup> setup_;
    World world_;
    Scratch scratch_;
    Observer observer_;
    OutputSource source_;
    int turn_ = 0;  // the next one of the round
    std::vector<Conflict> conflicts_;
};

}  // namespace matrixworld
