"""Solutions of notebook 8, "Read what evolution wrote"."""

# 8.1  Run a program.
#
# Names and numbers go onto the stack. An operation takes the last two from it, the second one
# first, and puts its result there. What is left is the rating.


def exercise_1(tokens, inputs):
    stack = []
    for token in tokens:
        if token in ("add", "subtract", "multiply", "min", "max"):
            b, a = stack.pop(), stack.pop()
            results = {"add": a + b, "subtract": a - b, "multiply": a * b}
            stack.append((results | {"min": min(a, b), "max": max(a, b)})[token])
        else:
            stack.append(inputs[token] if isinstance(token, str) else token)
    return stack[0]


# 8.2  Shorten a program as long as its score stays above a limit.
#
# The first shorter program that is good enough takes its place, and the search begins again.


def exercise_2(program, shorter, score, least):
    while True:
        good = (other for other in shorter(program) if score(other) >= least)
        found = next(good, None)
        if found is None:
            return program
        program = found


# 8.3  Seven tokens for a team that is fast and never at fault.
#
# Go to a free side of the evader, keep apart from teammates a little, and give way where the rule
# of the road says so.

exercise_3 = "0.3 * teammate - open_side - must_yield"
