"""A view of every kind that the lessons show, and of every arm, by a short name."""
import kinlab as kl

LESSONS = kl.lessons
ARMS = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
        kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
KNOWN = [kl.robots.puma_560_craig, kl.robots.stanford, kl.robots.panda, kl.robots.puma_560,
         kl.robots.scara, kl.robots.ur5, kl.robots.kr210]
RARE = {"puma_560", "scara", "ur5", "kr210"}  # much like others: seen by the thorough tests alone
EXAM = [-0.35, -0.6, 0.4]


def path_view():
    """Two links along a line, whose joints break limits of all three kinds."""
    arm = kl.Arm([kl.revolute(a=1, limits=(-1.5, 2), speed=1.2, acceleration=2.5),
                  kl.revolute(a=1, limits=(-2.6, 1.9), speed=1.2)], name="Two links")
    return kl.PathView(arm, kl.straight_path(arm, [1.2, 0.9, 0], [-0.5, 1.2, 0], 2, q0=[0, 1.2]))


VIEWS = {robot.__name__: lambda robot=robot: kl.ArmView(
    robot(), closed_form=True, show=("frames", "labels", "axes")) for robot in ARMS} | {
    "reach": LESSONS.start_here.reach_view,
    "sliding": LESSONS.translation.sliding_view,
    "riding": LESSONS.translation.riding_view,
    "two slides": LESSONS.translation.chain_view,
    "axes": LESSONS.rotation.axes_view,
    "turning": LESSONS.rotation.riding_view,
    "still": LESSONS.rotation.still_view,
    "mirror": LESSONS.rotation.mirror_view,
    "two turns": LESSONS.rotation.two_turns_view,
    "books": LESSONS.rotation.book_view,
    "about x": lambda: LESSONS.rotation.spatial_view("x"),
    "combined": LESSONS.homogeneous.combined,
    "chain": lambda: LESSONS.homogeneous.chain(3),
    "seen back": LESSONS.homogeneous.seen_back,
    "pose": LESSONS.notation.pose_view,
    "order": LESSONS.homogeneous.order,
    "fixed": LESSONS.homogeneous.fixed,
    "spatial": LESSONS.homogeneous.spatial,
    "both methods": LESSONS.two_link.both_methods,
    "n links": lambda: LESSONS.two_link.n_links(4),
    "parameters": lambda: LESSONS.dh_recipe.parameters_view(kl.robots.exam_2018(), 2, EXAM),
    "stages": lambda: kl.link_view(kl.robots.exam_2018(), 2, EXAM),
    "all frames": lambda: kl.frames_view(kl.robots.cylindrical(), [-0.25, 0.35, 0.4]),
    "stages, modified": lambda: kl.link_view(kl.robots.practical_six_link(), 3),
    "rules": LESSONS.dh_recipe.rules_view,
    "four numbers": LESSONS.dh_recipe.numbers_view,
    "misread": lambda: LESSONS.n_link.misread(kl.robots.practical_six_link()),
    "both conventions": lambda: LESSONS.n_link.both_conventions(kl.robots.two_link(), 1, 2),
    "zyz": LESSONS.n_link.zyz_view,
    "pressed flat": LESSONS.n_link.flat_view,
    "four motions": lambda: LESSONS.n_link.four_motions("modified"),
    "uvw": LESSONS.intelledex.plane_view,
    "wrist": LESSONS.intelledex.wrist_view,
    "meeting": LESSONS.intelledex.meeting_view,
    "yaw": LESSONS.intelledex.yaw_view,
    "ring": LESSONS.workspace.ring_view,
    "dexterous": LESSONS.workspace.dexterous_view,
    "limits": LESSONS.workspace.limits_view,
    "eight ways": LESSONS.inverse.eight_view,
    "leap": LESSONS.inverse.leap_view,
    "tilt": LESSONS.inverse.tilt_view,
    "four books": LESSONS.turns.books_view,
    "attitude": LESSONS.turns.attitude_view,
    "gimbal": LESSONS.turns.gimbal_view,
    "one axis": LESSONS.turns.axis_view,
    "dots": LESSONS.motion.dots_view,
    "race": LESSONS.motion.race_view,
    "target": lambda: kl.TargetView(kl.robots.alpha_ii()),
    "velocity": lambda: kl.velocity_view(kl.robots.intelledex_660t()),
    "solve": lambda: kl.solve_view(kl.robots.two_link(), [0.5, 0.5, 0],
                                   weights=[1, 1, 0]),
    "path": path_view,
} | {robot.__name__: lambda robot=robot: kl.ArmView(
    robot(), show=("frames", "labels", "axes")) for robot in KNOWN}
