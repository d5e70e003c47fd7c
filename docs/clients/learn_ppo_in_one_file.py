"""PPO in one file, in the manner of CleanRL, on `VectorEnv`: worlds and agents are two axes.

``pip install torch``. Tried with PyTorch 2.13.0, Gymnasium 1.2.2 and NumPy 2.4.6.
"""

import torch
from torch import nn
from torch.distributions import Categorical

import matrixworld as mw

STEPS = 160_000  # of agents
ROLLOUT, EPOCHS, MINIBATCHES = 128, 4, 8
RATE, GAMMA, LAMBDA, CLIP, ENTROPY, VALUE = 1e-3, 0.99, 0.95, 0.2, 0.01, 0.5


def layer(inputs, outputs, gain=2**0.5):
    made = nn.Linear(inputs, outputs)
    nn.init.orthogonal_(made.weight, gain)
    nn.init.zeros_(made.bias)
    return made


def network(inputs, outputs, gain):
    hidden = [layer(inputs, 64), nn.Tanh(), layer(64, 64), nn.Tanh()]
    return nn.Sequential(*hidden, layer(64, outputs, gain))


def play(observations):
    """Play a rollout; return what follows it, and its transitions, (ROLLOUT, worlds, agents)."""
    steps = []
    for _ in range(ROLLOUT):
        seen = torch.from_numpy(observations)
        with torch.no_grad():
            policy, value = Categorical(logits=actor(seen)), critic(seen).squeeze(-1)
        action = policy.sample()
        observations, reward, terminated, truncated, infos = envs.step(action.numpy())
        results = reward, terminated, terminated | truncated, infos["acted"]
        chosen = seen, action, policy.log_prob(action), value
        steps.append([*chosen, *map(torch.from_numpy, results)])
    return observations, [torch.stack(each) for each in zip(*steps, strict=True)]


def estimate(values, last, rewards, terminated, ended):
    """Return the generalised advantage estimates of all transitions."""
    following = torch.cat([values[1:], last[None]])
    # After a truncation the next row holds the last observation of the episode.
    errors = rewards + GAMMA * following * ~terminated - values
    advantages = torch.zeros_like(values)
    later = torch.zeros_like(last)
    for t in reversed(range(ROLLOUT)):
        advantages[t] = later = errors[t] + GAMMA * LAMBDA * later * ~ended[t]
    return advantages


def learn(seen, actions, log_probs, advantages, returns):
    for _ in range(EPOCHS):
        for part in torch.randperm(len(seen)).chunk(MINIBATCHES):
            policy = Categorical(logits=actor(seen[part]))
            ratio = (policy.log_prob(actions[part]) - log_probs[part]).exp()
            gain = advantages[part]
            gain = (gain - gain.mean()) / (gain.std() + 1e-8)
            clipped = ratio.clamp(1 - CLIP, 1 + CLIP)
            policy_loss = -torch.min(gain * ratio, gain * clipped).mean()
            value_loss = (critic(seen[part]).squeeze(-1) - returns[part]).square().mean() / 2
            loss = policy_loss + VALUE * value_loss - ENTROPY * policy.entropy().mean()
            optimizer.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(parameters, 0.5)
            optimizer.step()


def score():
    def policy(seen):
        with torch.no_grad():
            return Categorical(logits=actor(torch.from_numpy(seen).flatten(1).float())).sample()

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(policy, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
torch.manual_seed(0)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
envs = mw.VectorEnv(config, 8, evaders="clumsy-fleer", dtype="float32", flatten=True, threads=1)
observations, _ = envs.reset(seed=0)
worlds, agents, inputs = observations.shape
actor, critic = network(inputs, config.n_actions, 0.01), network(inputs, 1, 1.0)
parameters = [*actor.parameters(), *critic.parameters()]
optimizer = torch.optim.Adam(parameters, RATE, eps=1e-5)
print("before", score())
for _ in range(STEPS // (ROLLOUT * worlds * agents)):
    observations, transitions = play(observations)
    seen, actions, log_probs, values, rewards, terminated, ended, acted = transitions
    with torch.no_grad():
        last = critic(torch.from_numpy(observations)).squeeze(-1)
    advantages = estimate(values, last, rewards, terminated, ended)
    batch = seen, actions, log_probs, advantages, advantages + values
    learn(*(each[acted] for each in batch))  # agents that were gone have no transitions
print("after", score())
