"""Pages that show runs and play their matches, with the engine inside.

==============  ====================================================================================
page.py         a self-contained page: template, script, style sheet and data
built.py        the built scripts and style sheets
==============  ====================================================================================
"""
