"""Colours of figures and drawings, safe for colour-blind readers.

Strings ``"#RRGGBB"``, after Okabe and Ito 2008, "Color universal design: how to make figures and
presentations that are friendly to colorblind people".
"""

ORANGE = "#E69F00"
SKY_BLUE = "#56B4E9"
GREEN = "#009E73"
YELLOW = "#F0E442"
BLUE = "#0072B2"
VERMILLION = "#D55E00"
PURPLE = "#CC79A7"

PAPER = "#FFFFFF"
INK = "#1A1A1A"
MUTED = "#767676"  # the lightest grey still readable as text on paper (contrast 4.5 to 1)
GRID = "#E3E3E3"

PURSUER = VERMILLION
EVADER = BLUE
OBSTACLE = "#4D4D4D"
CAPTURE = YELLOW  # much lighter than both teams; pictures draw it with an outline of INK
COLLISION = PURPLE

TEAMS = (PURSUER, EVADER)  # in the order of every team axis
CONFLICTS = (INK, PURPLE, GREEN)  # in the order of every kind axis: obstacle, teammate, adversary

# Backgrounds of cells in a terminal, on which text in the colours of both teams is readable.
CAPTURE_GROUND = "#F7F0A0"
COLLISION_GROUND = "#E9BFD6"
FREE = "#BDBDBD"  # the dot on a free cell
