"""What lesson 05b asks, held against the arms' kinematics and tables typed by hand."""
import numpy as np

import kinlab as kl

from . import Held
from .dh_recipe import exam, turned

CYLINDRICAL = kl.robots.cylindrical()


def cylinder(i, degrees, d_2=0.3, d_3=0.4):
    return kl.link_frames(CYLINDRICAL, [np.radians(degrees), d_2, d_3])[i]


def x_2(degrees):
    return Held(turned(cylinder(2, degrees)[:3, 0], "z"),
                [(degrees, "There z₂ points"), (degrees - 90, "off")])


def height(d_2, d_3, wrong, words):
    return Held(cylinder(2, 0, d_2, d_3)[:3, 3], [(wrong, words), ((0.3, 0, 0.2), "away")])


def textbook(wanted, ours):
    """The textbook's arm reaches along (-sin, cos): 90 degrees further than its theta_1."""
    right = np.degrees(np.arctan2(-np.cos(np.radians(wanted)), np.sin(np.radians(wanted))))
    return Held(right, [(right + 180, "opposite direction"), (ours, "counts from another zero")])


def z_1(degrees):
    return Held(turned(exam(1, degrees, 0, 0.4)[:3, 2], "z"),
                [(degrees, "There x₁ points"), (degrees + 90, "That is −z₁")])


def tip(degrees, d_3, wrong):
    q = [0, np.radians(degrees), d_3]
    return Held(kl.forward_kinematics(kl.robots.exam_2018(), q)[:3, 3],
                [(wrong, "anticlockwise"), ((0.2, -0.2, 0.5), "away")])


def o_2(degrees):
    """O₂ of the modified frames: from (0, 0, 0.5) by L_off = 0.2 along z₁ = -y."""
    return Held((0, -0.2, 0.5), [(exam(2, 0, degrees, 0.4)[:3, 3], "the standard O₂"),
                                 ((0.2, -0.2, 0.8), "away")])


def right_hand(about, start, end):
    """Degrees from one direction to another about an axis."""
    return np.degrees(np.arctan2(np.dot(np.cross(start, end), about), np.dot(start, end)))


X, Y, Z = np.eye(3)
PREDICTED = {
    "dh_practice.table": [Held(["*c00", "c*0c", "0*00"], [
        (["*000", "c*0c", "0*00"], "11 of 12"), (["*c00", "0*0c", "0*00"], "11 of 12")])],
    "dh_practice.x2": [x_2(90), x_2(-45), x_2(135)],
    "dh_practice.height": [height(0.5, 0.4, (0, 0, 0.5), "height d₁ counts"),
                           height(0.2, 0.6, (0.6, 0, 0.6), "That is O₃")],
    "dh_practice.textbook": [textbook(0, 0), textbook(30, 30), textbook(180, 180)],
    "dh_practice.z1": [z_1(60), z_1(180), z_1(-45)],
    "dh_practice.tip": [tip(90, 0.4, (0.4, -0.2, 0.1)), tip(90, 0.7, (0.4, -0.2, -0.2)),
                        tip(-90, 0.4, (-0.4, -0.2, 0.9))],
    "dh_practice.first": [
        Held("about x₁", [("about z₁", "standard order"), ("about x₂", "still on frame 1")]),
        Held("z₂", [("z₁", "in the standard order"), ("z₃", "axis of joint 3")])],
    "dh_practice.o2": [o_2(90), o_2(-90)],
    "dh_practice.row": [
        Held("row 2", [("row 1", "It is right"), ("row 3", "It is right")]),
        Held("row 1", [("row 2", "90°, and the length"), ("row 3", "a₂ = 0.4")]),
        Held("row 3", [("row 1", "there is nothing"), ("row 2", "It is right")])],
    "dh_practice.turned": [
        Held(right_hand(X, Z, Y), [(90, "of the view"), (0, "off")]),
        Held(np.dot((0, -0.2, 0), Y), [(0.2, "away from O₂"), (0.4, "too much")]),
        Held(right_hand(Z, Y, X), [(90, "Thumb along x₂"), (180, "off")])],
}
