"""Policy networks for other libraries: PyTorch and ONNX, imported when they are needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.version import __version__
from matrixworld.world.policy import CHANNELS, Network

if TYPE_CHECKING:
    import onnx
    import torch

Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]
"""Weights (inputs, outputs) and biases (outputs,) of each layer."""

OPSET = 13
"""The ONNX operators' version, of 2020: enough for a perceptron, and read by old runtimes."""
_IR_VERSION = 8


def torch_module(network: Network, layers: Layers) -> torch.nn.Sequential:
    """Return a perceptron of PyTorch with these weights, without a softmax at its end."""
    try:
        import torch
    except ImportError as error:
        raise ImportError("to_torch: expected PyTorch, install it: pip install torch") from error
    activation = torch.nn.ReLU if network.activation == "relu" else torch.nn.Tanh
    modules: list[torch.nn.Module] = [torch.nn.Flatten()]
    for weights, bias in layers:
        linear = torch.nn.Linear(*weights.shape)
        # PyTorch keeps weights as (outputs, inputs).
        linear.load_state_dict(
            {"weight": torch.from_numpy(weights.T.copy()), "bias": torch.from_numpy(bias)}
        )
        modules += [linear, activation()]
    return torch.nn.Sequential(*modules[:-1])


def onnx_model(network: Network, layers: Layers) -> onnx.ModelProto:
    """Return an ONNX model with these weights and the outputs logits and probabilities."""
    try:
        import onnx
    except ImportError as error:
        raise ImportError("to_onnx: expected the package onnx, install it: pip install onnx") from (
            error
        )
    helper, real = onnx.helper, onnx.TensorProto.FLOAT
    view = [CHANNELS, network.fov, network.fov]
    activation = "Relu" if network.activation == "relu" else "Tanh"
    nodes: list[Any] = [helper.make_node("Flatten", ["observations"], ["hidden_0"], axis=1)]
    weights: list[Any] = []
    for number, (matrix, bias) in enumerate(layers):
        names = [f"weights_{number}", f"bias_{number}"]
        weights += map(onnx.numpy_helper.from_array, (matrix, bias), names)
        inputs = [f"hidden_{number}", *names]
        if number == len(layers) - 1:
            nodes.append(helper.make_node("Gemm", inputs, ["logits"]))
            break
        nodes.append(helper.make_node("Gemm", inputs, [f"sum_{number}"]))
        nodes.append(helper.make_node(activation, [f"sum_{number}"], [f"hidden_{number + 1}"]))
    nodes.append(helper.make_node("Softmax", ["logits"], ["probabilities"], axis=1))
    graph = helper.make_graph(
        nodes,
        "policy",
        [helper.make_tensor_value_info("observations", real, ["n", *view])],
        [
            helper.make_tensor_value_info(name, real, ["n", network.n_actions])
            for name in ("logits", "probabilities")
        ],
        weights,
    )
    model = helper.make_model(
        graph,
        opset_imports=[helper.make_opsetid("", OPSET)],
        ir_version=_IR_VERSION,
        producer_name="matrixworld",
        producer_version=__version__,
    )
    onnx.checker.check_model(model, full_check=True)
    return model
