"""PPO of TorchRL, by the recipe `torchrl_envs.py`: the agents that learn are a group.

``pip install 'torchrl>=0.11'``. Tried with TorchRL 0.14.1, PyTorch 2.13.0, Gymnasium 1.2.2,
PettingZoo 1.27.0 and NumPy 2.4.6.
"""

import torch
from tensordict.nn import TensorDictModule
from torch.distributions import Categorical
from torchrl.collectors import Collector
from torchrl.envs.utils import check_env_specs
from torchrl.modules import MultiAgentMLP, ProbabilisticActor
from torchrl.objectives import ClipPPOLoss, ValueEstimators

import matrixworld as mw
from torchrl_envs import env as make_env

STEPS = 65_536  # of agents
ROLLOUT, EPOCHS, MINIBATCHES = 1024, 4, 8
SEEN, ACTION = ("pursuer", "observation"), ("pursuer", "action")


def network(outputs):
    """Return a network that maps what each agent observes to its own outputs."""
    return MultiAgentMLP(
        n_agent_inputs=inputs,
        n_agent_outputs=outputs,
        n_agents=config.n_pursuers,
        centralized=False,
        share_params=True,
        depth=2,
        num_cells=64,
        activation_class=torch.nn.Tanh,
    )


def score():
    def sample(seen):
        # The network takes teams, and each agent's outputs depend on this agent only.
        x = torch.from_numpy(seen).flatten(1).float()
        team = x[:, None].expand(-1, config.n_pursuers, -1)
        with torch.no_grad():
            return Categorical(logits=actor_network(team)[:, 0]).sample()

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
torch.manual_seed(0)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
env = make_env(config, evaders="clumsy-fleer", seed=0)
check_env_specs(env)
inputs = env.observation_spec[SEEN].shape[-1]
actor_network, critic_network = network(config.n_actions), network(1)
actor = ProbabilisticActor(
    TensorDictModule(actor_network, in_keys=[SEEN], out_keys=[("pursuer", "logits")]),
    in_keys=[("pursuer", "logits")],
    out_keys=[ACTION],
    spec=env.action_spec_unbatched,
    distribution_class=Categorical,
    return_log_prob=True,
)
critic = TensorDictModule(critic_network, in_keys=[SEEN], out_keys=[("pursuer", "state_value")])
ppo = ClipPPOLoss(actor, critic, clip_epsilon=0.2, entropy_coeff=0.01, normalize_advantage=True)
ppo.set_keys(
    action=ACTION,
    **{key: ("pursuer", key) for key in ("reward", "done", "terminated")},
    value=("pursuer", "state_value"),
)
ppo.make_value_estimator(ValueEstimators.GAE, gamma=0.99, lmbda=0.95)
optimizer = torch.optim.Adam(ppo.parameters(), 1e-3)
print("before", score())
collector = Collector(env, actor, frames_per_batch=ROLLOUT, total_frames=STEPS // config.n_pursuers)
for rollout in collector:
    with torch.no_grad():
        ppo.value_estimator(rollout, params=ppo.critic_network_params)
    for _ in range(EPOCHS):
        for part in torch.randperm(ROLLOUT).chunk(MINIBATCHES):
            losses = ppo(rollout[part])
            loss = sum(losses[f"loss_{name}"] for name in ("objective", "critic", "entropy"))
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(ppo.parameters(), 0.5)
            optimizer.step()
collector.shutdown()
print("after", score())
