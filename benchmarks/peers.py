"""Cells of the peers: the same arm and sliders, its picture drawn anew by the kernel."""

# The same arm and sliders for all peers; a plain line through the joints, the least to draw.
COMMON = """\
import io
import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
import kinlab as kl
from matplotlib.figure import Figure

arm = kl.robots.alpha_ii()
sliders = [widgets.FloatSlider(value=np.degrees(home), min=round(np.degrees(link.limits[0])),
                               max=round(np.degrees(link.limits[1])), step=1,
                               description=f"q{i}", layout=widgets.Layout(width="500px"))
           for i, (link, home) in enumerate(zip(arm.links, arm.home), start=1)]

def joints(degrees):
    return kl.link_frames(arm, np.radians(degrees))[:, :3, 3].T

def axes(figure):
    ax = figure.add_subplot(projection="3d")
    ax.set(xlim=(-500, 500), ylim=(-500, 500), zlim=(-200, 700), xlabel="x", ylabel="y",
           zlabel="z")
    return ax

def draw(figure):
    return axes(figure).plot(*joints([s.value for s in sliders]), "o-", lw=4)[0]

def on_move(react):
    for slider in sliders:
        slider.observe(react, "value")
"""
INTERACT = """\
def show(**degrees):
    axes(plt.figure(figsize=(5, 4))).plot(*joints(list(degrees.values())), "o-", lw=4)
    plt.show()

widgets.interact(show, **{s.description: s for s in sliders});
"""
IPYMPL = """\
%matplotlib widget
with plt.ioff():
    figure = plt.figure(figsize=(5, 4))
line = draw(figure)

def move(change):
    line.set_data_3d(*joints([s.value for s in sliders]))
    figure.canvas.draw_idle()

on_move(move)
widgets.VBox([*sliders, figure.canvas])
"""
IMAGE = """\
figure = Figure(figsize=(5, 4))
line = draw(figure)

def png():
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    return buffer.getvalue()

image = widgets.Image(value=png(), width=500)

def move(change):
    line.set_data_3d(*joints([s.value for s in sliders]))
    image.value = png()

on_move(move)
widgets.VBox([*sliders, image])
"""
