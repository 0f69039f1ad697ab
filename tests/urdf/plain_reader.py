"""A second reader of URDF, written apart from kinlab's: products of matrices, as the format says.

https://wiki.ros.org/urdf/XML/joint: the child's frame is the parent's, moved by xyz, turned by rpy
about the fixed axes x, y, z, and then about or along the axis (x if there is none) by q.
"""
import xml.etree.ElementTree as ET

import numpy as np


def chain(text, tip):
    """The joints above a link, from the root."""
    joints = {joint.find("child").get("link"): joint
              for joint in ET.fromstring(text).findall("joint")}
    way = []
    while tip in joints:
        way.insert(0, joints[tip])
        tip = joints[tip].find("parent").get("link")
    return way


def movable(text, tip):
    """Names of the joints that q has values for."""
    return [joint.get("name") for joint in chain(text, tip) if joint.get("type") != "fixed"]


def pose(text, tip, q):
    """Pose of the tip in the root, (4, 4)."""
    T, values = np.eye(4), iter(q)
    for joint in chain(text, tip):
        origin, axis = joint.find("origin"), joint.find("axis")
        moved, turned = ([float(v) for v in (origin.get(name) or "0 0 0").split()]
                         if origin is not None else [0, 0, 0] for name in ("xyz", "rpy"))
        T = T @ place(rpy(*turned), moved)
        u = np.array([float(v) for v in axis.get("xyz").split()] if axis is not None else [1, 0, 0])
        u = u / (np.sqrt(u @ u) or 1)
        if joint.get("type") in ("revolute", "continuous"):
            T = T @ place(about(u, next(values)), [0, 0, 0])
        elif joint.get("type") == "prismatic":
            T = T @ place(np.eye(3), u * next(values))
    return T


def place(R, o):
    return np.block([[R, np.reshape(o, (3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])


def about(u, angle):
    """Rodrigues: I + sin K + (1 - cos) K K."""
    K = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def rpy(roll, pitch, yaw):
    x, y, z = np.eye(3)
    return about(z, yaw) @ about(y, pitch) @ about(x, roll)
