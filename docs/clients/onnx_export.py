"""A network policy as an ONNX model: copy this file.

``pip install onnx``
"""

import numpy as np
import onnx
from onnx import helper
from onnx.numpy_helper import from_array


def to_onnx(policy):
    """Return the network of a `NetworkPolicy` as a model, for ``onnx.save``.

    Its input is ``observations``, float32 (n, 3, fov, fov); outputs are ``logits`` and
    ``probabilities``, float32 (n, n_actions). With memory a second input is ``states`` and the
    third output ``next_states``, float32 (n, state_size).
    """
    # Versions of 2020: enough for a perceptron, and read by old runtimes.
    versions = {"opset_imports": [helper.make_opsetid("", 13)], "ir_version": 8}
    model = helper.make_model(graph_of(policy.policy, policy.layers()), **versions)
    onnx.checker.check_model(model, full_check=True)
    return model


def graph_of(network, layers):
    """Return the network's nodes, and the softmax of its logits, with these weights."""
    activation = "Relu" if network.activation == "relu" else "Tanh"
    nodes, weights = [helper.make_node("Flatten", ["observations"], ["hidden_0"], axis=1)], []
    for number, (matrix, bias) in enumerate(layers):
        if number == 1 and network.state_size:
            cell, of_cell = gated_unit(network.state_size, matrix, bias)
            nodes, weights = nodes + cell, weights + of_cell
            continue
        names = [f"weights_{number}", f"bias_{number}"]
        weights += map(from_array, (matrix, bias), names)
        last = number == len(layers) - 1
        total = "logits" if last else f"sum_{number}"
        nodes.append(helper.make_node("Gemm", [f"hidden_{number}", *names], [total]))
        if not last:
            nodes.append(helper.make_node(activation, [total], [f"hidden_{number + 1}"]))
    nodes.append(helper.make_node("Softmax", ["logits"], ["probabilities"], axis=1))

    def values(**shapes):
        floats = onnx.TensorProto.FLOAT
        return [helper.make_tensor_value_info(name, floats, each) for name, each in shapes.items()]

    inputs = values(observations=["n", 3, network.fov, network.fov])
    answer = ["n", network.n_actions]
    outputs = values(logits=answer, probabilities=answer)
    if network.state_size:
        state = ["n", network.state_size]
        inputs, outputs = inputs + values(states=state), outputs + values(next_states=state)
    return helper.make_graph(nodes, "policy", inputs, outputs, weights)


def gated_unit(size, matrix, bias):
    """Return nodes from hidden_1 and states to next_states, also named hidden_2, with weights."""
    order = np.r_[size : 2 * size, :size, 2 * size : 3 * size]  # ONNX has the gates as z, r, c
    rows, bias = matrix[:, order].T, bias[order]
    weights = {
        "steps": np.array([0], np.int64),  # the axis of time, of one step
        "weights_1": rows[None, :, :size],
        "states_1": rows[None, :, size:],
        "bias_1": np.concatenate([bias, np.zeros_like(bias)])[None],
    }
    inputs = ["input_1", "weights_1", "states_1", "bias_1", "", "before_1"]
    nodes = [
        helper.make_node("Unsqueeze", ["hidden_1", "steps"], ["input_1"]),
        helper.make_node("Unsqueeze", ["states", "steps"], ["before_1"]),
        helper.make_node("GRU", inputs, ["", "after_1"], hidden_size=size, linear_before_reset=1),
        helper.make_node("Squeeze", ["after_1", "steps"], ["next_states"]),
        helper.make_node("Identity", ["next_states"], ["hidden_2"]),
    ]
    return nodes, [from_array(np.ascontiguousarray(each), name) for name, each in weights.items()]
