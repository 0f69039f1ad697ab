"""DH tables of arms as published by authors, makers and sites from M to Z: data only.

Numbers are typed anew from the sources, in the sources' own layout; what they mean was typed by
hand. Where a source names lengths without their values, `lengths` gives values of our own. No
copy of the books, of the MathWorks page and of the last row for the UR10e was at hand: these are as
commonly quoted, and so is their layout. Poses are the source's own, or read off the stretched arm.
"""
from __future__ import annotations

from math import atan2, degrees, hypot

from published import KR210, KR210_AT_ZERO, Published

_GITHUB = "https://github.com/"

_ELBOW = degrees(atan2(0.245, 0.06))  # of the WidowX AI, whose table names it so

TABLES: tuple[Published, ...] = (
    # ---- Markdown, as repositories have it ----
    Published(
        name="UR3, course in Spanish",
        source=_GITHUB + "ManuelFBas/6dof-robot-kinematics, README",
        text="""
| Junta | θᵢ | dᵢ (m)   | aᵢ (m)     | αᵢ      |
|-------|-----|----------|------------|---------|
| 1     | q1  | 0.1519   | 0          | π/2     |
| 2     | q2  | 0        | −0.243665  | 0       |
| 3     | q3  | 0        | −0.21325   | 0       |
| 4     | q4  | 0.11235  | 0          | π/2     |
| 5     | q5  | 0.08535  | 0          | −π/2    |
| 6     | q6  | 0.0819   | 0          | 0       |
""",
        rows=((0, 0.1519, 0, 90), (0, 0, -0.243665, 0), (0, 0, -0.21325, 0), (0, 0.11235, 0, 90),
              (0, 0.08535, 0, -90), (0, 0.0819, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (-0.456915, -0.19425, 0.06655)),)),
    Published(
        name="arm of five joints, millimetres in the heads",
        source=_GITHUB + "M-Refaie/5dof-robot-arm, README",
        text="""
| Joint | θ | d (mm) | a (mm) | α |
|------:|:--:|:------:|:------:|:----:|
| 1 | θ₁ | 65 | 277 | 90° |
| 2 | θ₂ | −37.5 | 192 | 0° |
| 3 | θ₃ | 17.5 | 172 | −90° |
| 4 | θ₄ | 0 | 62.5 | 90° |
| 5 | θ₅ | 0 | 45 | 0° |
""",
        unit="mm",
        rows=((0, 65, 277, 90), (0, -37.5, 192, 0), (0, 17.5, 172, -90), (0, 0, 62.5, 90),
              (0, 0, 45, 0))),
    Published(
        name="PRRR, values behind the symbols",
        source=_GITHUB + "MrRox1337/manipulator-kinematics, README",
        text=r"""
| Link ($i$) |  $a_i$ (Length)  | $\alpha_i$ (Twist) | $d_i$ (Offset) | $\theta_i$ (Angle) |
| :--------: | :--------------: | :----------------: | :------------: | :----------------: |
|     1      |        0         |         0          |    $d_1^*$     |         0          |
|     2      | $L_{base}$ (1.0) |      -90&deg;      |       0        |    $\theta_2^*$    |
|     3      | $L_{arm1}$ (2.0) |         0          |       0        |    $\theta_3^*$    |
|     4      | $L_{arm2}$ (2.0) |         0          |       0        |    $\theta_4^*$    |
""",
        rows=((0, 0, 0, 0), (0, 0, 1, -90), (0, 0, 2, 0), (0, 0, 2, 0)), kinds="PRRR",
        poses=(((0, 0, 0, 0), (5, 0, 0)), ((3, 0, 0, 0), (5, 0, 3)))),
    Published(
        name="OpenManipulator-X, degrees in mathematics",
        source=_GITHUB + "samdvies/RoboticManipulationB8V2, Reference.md",
        text=r"""
| Link ($i$) | $\alpha_{i-1}$ (deg) | $a_{i-1}$ (mm) | $d_i$ (mm) | $\theta_i$ (deg) |
| :---: | :---: | :---: | :---: | :---: |
| 1     | 0      | 0       | 77      | $\theta_1$ |
| 2     | -90    | 0       | 0       | $\theta_2 - 90^\circ$ * |
| 3     | 0      | 128     | 0       | $\theta_3 + 90^\circ$ * |
| 4     | 0      | 124     | 0       | $\theta_4$ |
| End   | 0      | 126     | 0       | 0          |
""",
        unit="mm", convention="modified", kinds="RRRRF",
        rows=((0, 77, 0, 0), (-90, 0, 0, -90), (90, 0, 128, 0), (0, 0, 124, 0), (0, 0, 126, 0)),
        poses=(((0, 0, 0, 0), (250, 0, 205)),)),
    Published(
        name="myCobot, an offset beside the variable",
        source=_GITHUB + "takeshiD/urdf2dh, README",
        text="""
| Joint | alpha[rad] | a[mm] | d[mm]    | theta   | offset[rad] |
|:-----:|:----------:|:-----:|:--------:|:-------:|:-----------:|
| 1     | 0          | 0     | 131.56   | theta_1 | 0           |
| 2     | PI/2       | 0     | 0        | theta_2 | -PI/2       |
| 3     | 0          | -110.4| 0        | theta_3 | 0           |
| 4     | 0          | -96   | 66.39    | theta_4 | -PI/2       |
| 5     | PI/2       | 0     | 73.18    | theta_5 | PI/2        |
| 6     | -PI/2      | 0     | 43.6     | theta_6 | 0           |
""",
        unit="mm", convention="modified", choices={"convention": "modified"},
        rows=((0, 131.56, 0, 0), (-90, 0, 0, 90), (0, 0, -110.4, 0), (-90, 66.39, -96, 0),
              (90, 73.18, 0, 90), (0, 43.6, 0, -90))),
    Published(
        name="Pincher, subscripts, offset and minus signs",
        source=_GITHUB + "sfrodriguezma/Lab5_Forward_kinematics_Phantomx100, README",
        text="""
| Junta i | θᵢ  | dᵢ  | aᵢ  | αᵢ   | Offset |
|--------|-----|-----|-----|------|--------|
| 1      | θ₁  | L₁  | 0   | −90° | −90°   |
| 2      | θ₂  | 0   | L₂  | 0°   | −80°   |
| 3      | θ₃  | 0   | L₃  | 0°   | 0°     |
| 4      | θ₄  | 0   | L₄  | 0°   | 0°     |
""",
        lengths={"L1": 0.045, "L2": 0.107, "L3": 0.107, "L4": 0.1088},
        rows=((-90, 0.045, 0, -90), (-80, 0, 0.107, 0), (0, 0, 0.107, 0), (0, 0, 0.1088, 0))),
    Published(
        name="Pincher, tabs among the bars",
        source=_GITHUB + "Rocosso/lab4_Robotica, README (lengths: a picture there, round here)",
        text="""
| Link |	alpha |	a	| d |	theta	| offset |
| -- | -- | -- | -- | -- | -- |
| 1	| 90°	| 0	| L1	| q1	| 0 |
| 2	| 0	| L2	| 0	| q2	| 90° |
| 3	| 0	| L3	| 0	| q3	| 0 |
| 4	| 0	| L4	| 0	| q4	| 0 |
""",
        lengths={"L1": 0.14, "L2": 0.1, "L3": 0.1, "L4": 0.07},
        rows=((0, 0.14, 0, 90), (90, 0, 0.1, 0), (0, 0, 0.1, 0), (0, 0, 0.07, 0)),
        poses=(((0, 0, 0, 0), (0, 0, 0.41)), ((0, -90, 0, 0), (0.27, 0, 0.14)))),
    Published(
        name="Pincher, variables with a blank in their name",
        source=_GITHUB + "psmedinadi22/Robotica-LAB4, README",
        text="""
| Theta |	d |	a |	alpha |	Offset |
| --- | --- | --- | --- | --- |
| Theta 1	| L1	| 0 |	90 |	0° |
| Theta 2 |	0 |	L2 |	0° |	90° |
| Theta 3 |	0 |	L3 |	0° |	0° |
| Theta 4 |	0 |	0 |	90° |	90° |
| Theta 5	| L4 |	0 |	0° |	0° |
""",
        lengths={"L1": 14, "L2": 10.5, "L3": 10.5, "L4": 8.5},
        rows=((0, 14, 0, 90), (90, 0, 10.5, 0), (0, 0, 10.5, 0), (90, 0, 0, 90), (0, 8.5, 0, 0)),
        poses=(((0, 0, 0, 0, 0), (0, 0, 43.5)),)),
    Published(
        name="Pincher, quarter turns rounded to three decimals",
        source=_GITHUB + "Robotica-2022-I/Lab4_Robotica, README",
        text="""
| j |     theta |         d |         a |     alpha |    offset |
|:-:|:---------:|:---------:|:---------:|:---------:|:---------:|
|  1|         q1|       14.5|          0|      1.571|          0|
|  2|         q2|          0|       10.7|          0|      1.571|
|  3|         q3|          0|       10.7|          0|          0|
|  4|         q4|          0|          0|          0|          0|
""",
        angles="rad", choices={"angles": "rad"}, asks=True,
        rows=((0, 14.5, 0, 1.571), (1.571, 0, 10.7, 0), (0, 0, 10.7, 0), (0, 0, 0, 0)),
        poses=(((0, 0, 0, 0), (0, 0, 35.9)),), within=0.01),
    Published(
        name="Pincher, heads without a mark for their index",
        source=_GITHUB + "Sr0AF/Robotica-2025-I---Laboratorio-No.-4, README",
        text="""
   | i | θi | di | ai | α |
   | :---         |     :---:      |          :---: |          :---: |          :---: |
   | 1 | q1 | 113 | 0 | π/2 |
   | 2 | q2 | 0 | 100.7 | 0 |
   | 3 | q3 | 0 | 100.7 | 0 |
   | 4 | q4 | 0 | 85 | π/2 |
""",
        rows=((0, 113, 0, 90), (0, 0, 100.7, 0), (0, 0, 100.7, 0), (0, 0, 85, 90)),
        poses=(((0, 0, 0, 0), (286.4, 0, 113)),)),
    Published(
        name="erobo10, limits as one cell",
        source=_GITHUB + "SocialHardwareInternational/cobotbackend, docs/DH_PARAMETERS.md",
        text="""
| Joint | a (m) | alpha (rad) | d (m) | theta0 (rad) | limit (rad) | v_max (rad/s) | tau_max (Nm) |
|---|---|---|---|---|---|---|---|
| 1 | 0.000001 | 1.570799 | 0.123000 | 0.807906 | [-3.140, 3.140] | 1.57 | 140 |
| 2 | 0.611996 | 3.141585 | -0.000000 | 1.583038 | [-3.140, 3.140] | 1.57 | 110 |
| 3 | 0.590001 | -0.000007 | -0.000000 | -0.219999 | [-3.140, 3.140] | 1.57 | 110 |
| 4 | 0.000000 | 1.570794 | -0.128600 | 1.547938 | [-3.140, 3.140] | 1.57 | 107 |
| 5 | 0.000003 | 1.570795 | 0.098000 | 3.111059 | [-3.140, 3.140] | 1.57 | 87 |
| 6 | 0.000000 | 0.000000 | 0.000000 | 0.000000 | [-3.140, 3.124] | 1.57 | 57 |
""",
        angles="rad",
        rows=((0.807906, 0.123, 0.000001, 1.570799), (1.583038, 0, 0.611996, 3.141585),
              (-0.219999, 0, 0.590001, -0.000007), (1.547938, -0.1286, 0, 1.570794),
              (3.111059, 0.098, 0.000003, 1.570795), (0, 0, 0, 0))),
    Published(
        name="OpenManipulator-P, entities and an angle of the motor",
        source="https://emanual.robotis.com/docs/en/platform/openmanipulator_p/specification/, "
               "D-H Configuration",
        text="""
| Link | Link Length(mm) | Link Twist(rad) | Joint Offset(mm) | Joint Angle(rad) | DXL Angle(rad) |
|:----:|:---------------:|:---------------:|:----------------:|:----------------:|:--------------:|
|  1   |        0        |     -&pi;/2     |        0         |        0         |       0        |
|  2   |     265.69      |        0        |        0         |        0         | ![](eq_001.gif) |
|  3   |       30        |     -&pi;/2     |        0         |        0         | ![](eq_002.gif) |
|  4   |        0        |     -&pi;/2     |       258        |        0         |       0        |
|  5   |        0        |     -&pi;/2     |        0         |        0         |       0        |
|  6   |        0        |        0        |        0         |        0         |       0        |
""",
        unit="mm",
        rows=((0, 0, 0, -90), (0, 0, 265.69, 0), (0, 0, 30, -90), (0, 258, 0, -90),
              (0, 0, 0, -90), (0, 0, 0, 0))),
    Published(
        name="PUMA 560, mathematics in every cell",
        source=_GITHUB + "virtual-labs/exp-forward-kinematics-iitk, experiment/theory.md "
               "(lengths: a picture there, round here)",
        text=r"""
| $$ Link_i $$ | $$	\\alpha_{i-1} $$ | $$ a_{i-1}(m) $$ | $$ d_i (m) $$ | $$ \\theta_i $$ |
| :-- | :-- | :-- | :-- | :-- |
| $$ 1 $$ | $$ 0 $$ | $$ 0 $$ | $$ 0 $$ | $$ \\theta_1 $$ |
| $$ 2 $$ | $$ -90 $$ | $$ 0 $$ | $$ 0 $$ | $$ \\theta_2 $$ |
| $$ 3 $$ | $$ 0 $$ | $$ a_2 $$ | $$ d_3 $$ | $$ \\theta_3 $$ |
| $$ 4 $$ | $$ -90 $$ | $$ a_3 $$ | $$ d_4 $$ | $$ \\theta_4 $$ |
| $$ 5 $$ | $$ 90 $$ | $$ 0 $$ | $$ 0 $$ | $$ \\theta_5 $$ |
| $$ 6 $$ | $$ -90 $$ | $$ 0 $$ | $$ 0 $$ | $$ \\theta_6 $$ |
""",
        convention="modified", lengths={"a_2": 0.43, "a_3": 0.02, "d_3": 0.12, "d_4": 0.44},
        rows=((0, 0, 0, 0), (0, 0, 0, -90), (0, 0.12, 0.43, 0), (0, 0.44, 0.02, -90),
              (0, 0, 0, 90), (0, 0, 0, -90)),
        poses=(((0, 0, 0, 0, 0, 0), (0.45, 0.12, -0.44)),)),
    Published(
        name="myCobot Pro 600, rows named by the frames they join",
        source=_GITHUB + "sszxc/RAS-545-Robotic-Systems-I, hw2/README.md",
        text="""
    | Joint | θ | d | a | α |
    |-------|---|---|---|----|
    | 1-2 | θ1 | 219.34 | 0 | π/2 |
    | 2-3 | θ2 - π/2 | 0 | -250 | 0 |
    | 3-4 | θ3 | 0 | -250 | 0 |
    | 4-5 | θ4 + π/2 | -108 | 0 | -π/2 |
    | 5-6 | θ5 | 109.10 | 0 | π/2 |
    | 6-END | θ6 | -75.86 | 0 | π |
""",
        rows=((0, 219.34, 0, 90), (-90, 0, -250, 0), (0, 0, -250, 0), (90, -108, 0, -90),
              (0, 109.1, 0, 90), (0, -75.86, 0, 180))),
    Published(
        name="printed arm, bold lengths and remarks",
        source=_GITHUB + "mustafaberatyilmaz/6-DOF-robot-arm, 02_model_DH_dinamik.md",
        text=r"""
| Link $i$ | $\theta_i$ | $d_i$ (mm) | $a_i$ (mm) | $\alpha_i$ (rad) | Kaynak |
|:---:|:---:|---:|---:|:---:|:---|
| 1 | $\theta_1$ | **100** | 0 | $-\pi/2$ | Base 60 + J1 motor merkezi 40 |
| 2 | $\theta_2$ | 0 | **138** | 0 | J2 bracket Y span 138 (pivot→dirsek) |
| 3 | $\theta_3$ | 0 | 0 | $-\pi/2$ | (Bağlantı, mesafesiz) |
| 4 | $\theta_4$ | **130** | 0 | $+\pi/2$ | J3 → wrist merkez (90 + bracket yarısı 40) |
| 5 | $\theta_5$ | 0 | 0 | $-\pi/2$ | Küresel bilek varsayımı |
| 6 | $\theta_6$ | **50** | 0 | 0 | J6 part Z bbox 55 ≈ 50 (TCP'ye) |
""",
        unit="mm",
        rows=((0, 100, 0, -90), (0, 0, 138, 0), (0, 0, 0, -90), (0, 130, 0, 90), (0, 0, 0, -90),
              (0, 50, 0, 0))),
    # ---- the KR 210 of one course, six habits ----
    Published(
        name="KR 210, links as arrows",
        source=_GITHUB + "TheoKanning/RoboND-Kinematics-Project, writeup.md",
        text="""
Links | alpha(i-1) | a(i-1) | d(i-1) | theta(i)
--- | --- | --- | --- | ---
0->1 | 0 | 0 | 0.75 | q1
1->2 | - pi/2 | 0.35 | 0 | -pi/2 + q2
2->3 | 0 | 1.25 | 0 | q3
3->4 | - pi/2 | -0.054 | 1.5 | q4
4->5 | pi/2 | 0 | 0 | q5
5->6 | - pi/2 | 0 | 0 | q6
6->EE | 0 | 0 | 0.303 | 0
""",
        convention="modified", kinds="RRRRRRF", rows=KR210, poses=KR210_AT_ZERO),
    Published(
        name="KR 210, q(i) as head",
        source=_GITHUB + "NitishPuri/RoboND-Kinematics-Project, writeup.md (its p1 in row 4 is pi)",
        text="""
Link(i) | alpha(i-1) | a(i-1) | d(i) | q(i)
--- | --- | --- | --- | ---
1 | 0 | 0 | 0.75 | q1
2 | -pi/2 | 0.35 | 0 | q2 - pi/2
3 | 0 | 1.25 | 0 | q3
4 | -pi/2 | -0.054 | 1.50 | q4
5 | pi/2 | 0 | 0 | q5
6 | -pi/2 | 0 | 0 | q6
7(G) | 0 | 0 | 0.303 | 0
""",
        convention="modified", kinds="RRRRRRF", rows=KR210, poses=KR210_AT_ZERO),
    Published(
        name="KR 210, entities for Greek and subscripts",
        source=_GITHUB + "yycho0108/RoboND-Kinematics-Project, writeup.md",
        text="""
&alpha;   | a      | d    | &theta;
:--------:|:------:|:----:|:-------:
0         | 0      | 0.75 | q&#8321;
-&pi;/2   | 0.35   | 0    | q&#8322;-&pi;/2
0         | 1.25   | 0    | q&#8323;
-&pi;/2   | -0.054 | 1.50 | q&#8324;
&pi;/2    | 0      | 0    | q&#8325;
-&pi;/2   | 0      | 0    | q&#8326;
0         | 0      | 0.303| 0
""",
        convention="modified", choices={"convention": "modified"}, kinds="RRRRRRF", rows=KR210,
        poses=KR210_AT_ZERO),
    Published(
        name="KR 210, capitals, and two signs of its own",
        source=_GITHUB + "tiedyedguy/RoboND-Kinematics-Project, README",
        text="""
Alpha | A | D | Theta
--- | --- | --- | ---
0| 0| 0.75 | Q1
PI/2| 0.35| 0| Q2- PI/2
0| 1.25|0|Q3
-PI/2|-0.054| 1.50|Q4
PI/2| 0|0|Q5
PI/2|  0|   0|Q6
0|   0| 0.303|0
""",
        convention="modified", choices={"convention": "modified"}, kinds="RRRRRRF",
        rows=((0, 0.75, 0, 0), (-90, 0, 0.35, 90), (0, 0, 1.25, 0), (0, 1.5, -0.054, -90),
              (0, 0, 0, 90), (0, 0, 0, 90), (0, 0.303, 0, 0))),
    Published(
        name="KR 210, symbol and value in one cell",
        source=_GITHUB + "samindaa/RoboND-Kinematics-Project, writeup.md",
        text="""
Links | alpha(i-1) | a(i-1) | theta(i) | d(i)
--- | --- | --- | --- | ---
0->1 | 0 | 0 | theta1 | d1 = 0.75
1->2 | -pi/2 | a1 = 0.35 | theta2 - pi/2| 0
2->3 | 0 | a2 = 1.25 | theta3 | 0
3->4 | -pi/2 | a3 = -0.054 | theta4 | d4 = 1.50
4->5 | +pi/2 | 0 | theta5 | 0
5->6 | -pi/2 | 0 | theta6 | 0
6->G | 0 | 0 | 0 | dG = 0.303
""",
        convention="modified", kinds="RRRRRRF", rows=KR210, poses=KR210_AT_ZERO),
    Published(
        name="KR 210, subscripts as HTML",
        source=_GITHUB + "theayoad/RoboND-Kinematics-Project, README",
        text="""
Links | α<sub>i-1</sub> | a<sub>i-1</sub> | d<sub>i-1</sub> | Θ<sub>i</sub>
--- | --- | --- | --- | ---
0->1 | 0 | 0 | 0.75 | Θ<sub>1</sub>
1->2 | - pi/2 | 0.35 | 0 | Θ<sub>2</sub> - pi/2
2->3 | 0 | 1.25 | 0 | Θ<sub>3</sub>
3->4 |  -pi/2 | -0.054 | 1.50 | Θ<sub>4</sub>
4->5 | pi/2 | 0 | 0 | Θ<sub>5</sub>
5->6 | -pi/2 | 0 | 0 | Θ<sub>6</sub>
6->EE | 0 | 0 | 0.303 | 0
""",
        convention="modified", kinds="RRRRRRF", rows=KR210, poses=KR210_AT_ZERO),
    # ---- pages and manuals, as a browser hands them over ----
    Published(
        name="UR10e, masses beside the lengths",
        source="https://www.universal-robots.com/articles/ur/application-installation/"
               "dh-parameters-for-calculations-of-kinematics-and-dynamics/",
        text="""
UR10e
Kinematics	theta [rad]	a [m]	d [m]	alpha [rad]	Dynamics	Mass [kg]	Center of Mass [m]
Joint 1	0	0	0.1807	π/2	Link 1	7.369	[0.021, 0.000, 0.027]
Joint 2	0	-0.6127	0	0	Link 2	13.051	[0.38, 0.000, 0.158]
Joint 3	0	-0.57155	0	0	Link 3	3.989	[0.24, 0.000, 0.068]
Joint 4	0	0	0.17415	π/2	Link 4	2.1	[0.000, 0.007, 0.018]
Joint 5	0	0	0.11985	-π/2	Link 5	1.98	[0.000, 0.007, 0.018]
Joint 6	0	0	0.11655	0	Link 6	0.615	[0, 0, -0.026]
""",
        rows=((0, 0.1807, 0, 90), (0, 0, -0.6127, 0), (0, 0, -0.57155, 0), (0, 0.17415, 0, 90),
              (0, 0.11985, 0, -90), (0, 0.11655, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (-1.18425, -0.2907, 0.06085)),)),
    Published(
        name="UFACTORY 850, theta offset as one head",
        source="https://docs.supportarticle.ufactory.cc/support_articles/developer/"
               "kinematic-and-dynamic-parameters/ufactory-850.html, Standard D-H Parameters",
        text="""
| Kinematics | theta offset(deg) | d(mm) | alpha(deg) | a(mm) |
|---|---|---|---|---|
| Joint1 | 0 | 364 | 90 | 0 |
| Joint2 | 90 | 0 | 180 | 390 |
| Joint3 | 90 | 0 | -90 | 150 |
| Joint4 | 0 | 426 | -90 | 0 |
| Joint5 | 0 | 0 | 90 | 0 |
| Joint6 | 0 | 90 | 0 | 0 |
""",
        unit="mm",
        rows=((0, 364, 0, 90), (90, 0, 390, 180), (90, 0, 150, -90), (0, 426, 0, -90),
              (0, 0, 0, 90), (0, 90, 0, 0))),
    Published(
        name="xArm 6, offsets named in the table and told below it",
        source="https://docs.ufactory.cc/support_articles/developer/"
               "kinematic-and-dynamic-parameters/xarm-series/xarm-6, Standard D-H Parameters",
        text="""
Kinematics	theta(rad)	d(mm)	alpha(rad)	a(mm)	offset(rad)
Joint1	0	267	-pi/2	0	0
Joint2	0	0	0	a2	T2_offset
Joint3	0	0	-pi/2	77.5	T3_offset
Joint4	0	342.5	pi/2	0	0
Joint5	0	0	-pi/2	76	0
Joint6	0	97	0	0	0
""",
        unit="mm", lengths={"a2": 0.28948866}, marked=((2, "theta"), (3, "theta")),
        rows=((0, 267, 0, -90), (-79.34995, 0, 289.48866, 0), (79.34995, 0, 77.5, -90),
              (0, 342.5, 0, 90), (0, 0, 76, -90), (0, 97, 0, 0))),
    Published(
        name="RM65-B, the last length a symbol",
        source="https://develop.realman-robotics.com/en/robot/robotParameter/"
               "RM65OntologyParameters, MDH parameters",
        text="""
joint_id(i)	a_i−1(mm)	α_i−1(°)	d_i(mm)	θ_i / offset_i(°)
1	0	0	240.5	0
2	0	90	0	90
3	256	0	0	90
4	0	90	210	0
5	0	-90	0	0
6	0	90	d6	0
""",
        unit="mm", convention="modified", lengths={"d6": 0.144},
        rows=((0, 240.5, 0, 0), (90, 0, 0, 90), (90, 0, 256, 0), (0, 210, 0, 90), (0, 0, 0, -90),
              (0, 144, 0, 90)),
        poses=(((0, 0, 0, 0, 0, 0), (0, 0, 850.5)),)),
    Published(
        name="WidowX AI, arcs as formulas",
        source="https://docs.trossenrobotics.com/trossen_arm/, Specifications, "
               "Denavit-Hartenberg parameters, Classic",
        text="""
Transformation	d [m]	θ [rad]	a [m]	α [rad]
baseT0	0.1035	θ0	0.02	−π/2
0T1	0.0	θ1+π	0.264	π
1T2	0.0	θ2−π/2−arctan(0.245/0.06)	√(0.245²+0.06²)	0.0
2T3	0.0	θ3−arctan(0.06/0.245)	0.06775	π/2
3T4	0.0	θ4+π/2	0.0	π/2
4T5	0.02895	θ5	0.0	π/2
5TFlange	0.0	π/2	0.0	0.0
FlangeTTool, default	0.0	0.0	0.154	0.0
""",
        kinds="RRRRRRFF",
        rows=((0, 0.1035, 0.02, -90), (180, 0, 0.264, 180),
              (-90 - _ELBOW, 0, hypot(0.245, 0.06), 0),
              (_ELBOW - 90, 0, 0.06775, 90), (90, 0, 0, 90), (0, 0.02895, 0, 90), (90, 0, 0, 0),
              (0, 0, 0.154, 0))),
    Published(
        name="arm with an offset wrist, minus signs of two kinds",
        source="https://www.nature.com/articles/s41598-025-19054-y, Table 1 (lengths round here)",
        text="""
i	ai(mm)	αi(rad)	di(mm)	θi(rad)
1	0	0	d1	θ1
2	a2	-π/2	d2	θ2
3	a3	0	d3	θ3
4	a4	−π/2	d4	θ4
5	0	π/2	0	θ5
6	0	−π/2	0	θ6
""",
        unit="mm",
        lengths={"d1": 0.4, "a2": 0.05, "d2": 0.02, "a3": 0.5, "d3": 0.03, "a4": 0.06,
                 "d4": 0.45},
        rows=((0, 400, 0, 0), (0, 20, 50, -90), (0, 30, 500, 0), (0, 450, 60, -90), (0, 0, 0, 90),
              (0, 0, 0, -90))),
    # ---- what programs print ----
    Published(
        name="Stanford arm, a box of heavy lines",
        source=_GITHUB + "petercorke/robotics-toolbox-python, docs/notebooks/ets.ipynb",
        text="""
┏━━━━━━━┳━━━━━━━┳━━━━━━━━┳━━━━━━━━┳━━━━━━━━━━━━━━━━━━━━━┳━━━━━━━━┓
┃  θⱼ   ┃  dⱼ   ┃   aⱼ   ┃   ⍺ⱼ   ┃         q⁻          ┃   q⁺   ┃
┣━━━━━━━╋━━━━━━━╋━━━━━━━━╋━━━━━━━━╋━━━━━━━━━━━━━━━━━━━━━╋━━━━━━━━┫
┃ q1    ┃ 0.412 ┃      0 ┃ -90.0° ┃             -170.0° ┃ 170.0° ┃
┃ q2    ┃ 0.154 ┃    0.0 ┃  90.0° ┃             -170.0° ┃ 170.0° ┃
┃-90.0° ┃    q3 ┃ 0.0203 ┃   0.0° ┃ 0.30479999999999996 ┃   1.27 ┃
┃ q4    ┃     0 ┃      0 ┃ -90.0° ┃             -170.0° ┃ 170.0° ┃
┃ q5    ┃     0 ┃      0 ┃  90.0° ┃              -90.0° ┃  90.0° ┃
┃ q6    ┃     0 ┃      0 ┃   0.0° ┃             -170.0° ┃ 170.0° ┃
┗━━━━━━━┻━━━━━━━┻━━━━━━━━┻━━━━━━━━┻━━━━━━━━━━━━━━━━━━━━━┻━━━━━━━━┛
""",
        kinds="RRPRRR",
        rows=((0, 0.412, 0, -90), (0, 0.154, 0, 90), (-90, 0, 0.0203, 0), (0, 0, 0, -90),
              (0, 0, 0, 90), (0, 0, 0, 0))),
    Published(
        name="six joints, a box of light lines and an empty one",
        source=_GITHUB + "williamjroche/6-DOF-Robotic-Arm, numerical_end_effector_solver.ipynb",
        text="""
DHRobot: test1, 6 joints (RRRRRR), dynamics, standard DH parameters
┌─────┬────────┬────────┬────────┐
│ θⱼ  │   dⱼ   │   aⱼ   │   ⍺ⱼ   │
├─────┼────────┼────────┼────────┤
│  q1 │ 0.1035 │      0 │   0.0° │
│  q2 │ 0.0626 │      0 │ -90.0° │
│  q3 │      0 │  0.115 │   0.0° │
│  q4 │ 0.0123 │  0.115 │   0.0° │
│  q5 │      0 │  0.036 │ -90.0° │
│  q6 │      0 │ 0.0783 │   0.0° │
└─────┴────────┴────────┴────────┘

┌──┬──┐
└──┴──┘
""",
        rows=((0, 0.1035, 0, 0), (0, 0.0626, 0, -90), (0, 0, 0.115, 0), (0, 0.0123, 0.115, 0),
              (0, 0, 0.036, -90), (0, 0, 0.0783, 0))),
    Published(
        name="six joints, printed with its offsets",
        source="https://robotics.stackexchange.com, Is there any fault in my kinematic diagram? "
               "(row 6 after the formula above it)",
        text="""
myrobot:: 6 axis, RRRRRR, stdDH, fastRNE
+---+-----------+-----------+-----------+-----------+-----------+
| j |     theta |         d |         a |     alpha |    offset |
+---+-----------+-----------+-----------+-----------+-----------+
|  1|         q1|       1.33|        0.4|    -1.5708|          0|
|  2|         q2|          0|       -1.1|          0|     1.5708|
|  3|         q3|          0|      -0.23|     1.5708|          0|
|  4|         q4|       1.11|          0|    -1.5708|          0|
|  5|         q5|          0|          0|     1.5708|    3.14159|
|  6|         q6|      0.244|          0|    -1.5708|     1.5708|
+---+-----------+-----------+-----------+-----------+-----------+
""",
        angles="rad", choices={"angles": "rad"}, asks=True,
        rows=((0, 1.33, 0.4, -1.5708), (1.5708, 0, -1.1, 0), (0, 0, -0.23, 1.5708),
              (0, 1.11, 0, -1.5708), (3.14159, 0, 0, 1.5708), (1.5708, 0.244, 0, -1.5708))),
    Published(
        name="Mico, a number that begins with its point",
        source=_GITHUB + "maxsvetlik/mico_sim, dh.txt",
        text="""
+---+-----------+-----------+-----------+-----------+-----------+
| j |     theta |         d |         a |     alpha |    offset |
+---+-----------+-----------+-----------+-----------+-----------+
|  1|         q1|     0.2755|          0|       pi/2|          0|
|  2|         q2|          0|        .29|         pi|      -pi/2|
|  3|         q3|     -0.007|          0|       pi/2|       pi/2|
|  4|         q4|-0.16608165|          0|       pi/3|          0|
|  5|         q5|-0.85563310|          0|       pi/3|        -pi|
|  6|         q6|-0.20278164|          0|         pi|       pi/2|
+---+-----------+-----------+-----------+-----------+-----------+
""",
        rows=((0, 0.2755, 0, 90), (-90, 0, 0.29, 180), (90, -0.007, 0, 90),
              (0, -0.16608165, 0, 60), (-180, -0.8556331, 0, 60), (90, -0.20278164, 0, 180))),
    Published(
        name="snake of nine links, bars below a head of tabs",
        source=_GITHUB + "pringithub/567-path-planning, dh_params.txt",
        text="""
       a	alpha	  d	    theta

1-0  | -0.0869 | 0.0000  | 0.3774  | 0.0000  |
------------------------------------------------
2-1  | 0.1195  | 0.0000  | 0.3486  | 0.0000  |
------------------------------------------------
3-2  | 0.1170  | -1.5708 | 0.0600  | 3.1416  |
------------------------------------------------
4-3  | 0.2190  | -1.5708 | 0.0000  | 1.5708  |
------------------------------------------------
5-4  | 0.1330  | 1.5708  | 0.0000  | 3.1416  |
------------------------------------------------
6-5  | 0.1970  | -1.5708 | 0.0000  | 1.5708  |
------------------------------------------------
7-6  | 0.1245  | 1.5708  | 0.0000  | 3.1416  |
------------------------------------------------
8-7  | 0.1385  | -1.5708 | 0.0000  | 1.5708  |
------------------------------------------------
9-8  | 0.0000  | 0.0000  | 0.1665  | 0.0000  |
------------------------------------------------
""",
        angles="rad", choices={"angles": "rad"}, asks=True,
        rows=((0, 0.3774, -0.0869, 0), (0, 0.3486, 0.1195, 0), (3.1416, 0.06, 0.117, -1.5708),
              (1.5708, 0, 0.219, -1.5708), (3.1416, 0, 0.133, 1.5708),
              (1.5708, 0, 0.197, -1.5708), (3.1416, 0, 0.1245, 1.5708),
              (1.5708, 0, 0.1385, -1.5708), (0, 0.1665, 0, 0))),
    # ---- files and comments ----
    Published(
        name="TEO, right arm, capitals D and A",
        source=_GITHUB + "roboticslab-uc3m/teo-developer-manual, csv/dh-rightArm.csv",
        text="Link,θ,D,A,α\n1,q15,0,0,90\n2,-90+q16,0,0,90\n3,-90+q17,l6,0,90\n4,q18,0,0,-90\n"
             "5,q19,l7,0,90\n6,90+q20,0,l8,0\n",
        lengths={"l6": 0.32901, "l7": 0.202, "l8": 0.187496},
        rows=((0, 0, 0, 90), (-90, 0, 0, 90), (-90, 0.32901, 0, 90), (0, 0, 0, -90),
              (0, 0.202, 0, 90), (90, 0, 0.187496, 0))),
    Published(
        name="right leg, thi for theta",
        source=_GITHUB + "mitkof6/LowerLimbModeling, DH.txt",
        text="""Right Leg
alpha a thi d
0 0.2 0 -0.2
-pi/2 0 0 0
pi/2 0 pi/2 0
0 0.5 0 0
0 0.5 0 0
0 0.2 pi/2 0
""",
        rows=((0, -0.2, 0.2, 0), (0, 0, 0, -90), (90, 0, 0, 90), (0, 0, 0.5, 0), (0, 0, 0.5, 0),
              (90, 0, 0.2, 0))),
    Published(
        name="Sixi, rules between the rows",
        source=_GITHUB + "MarginallyClever/Makelangelo-firmware, DH-Params-Sixi.txt",
        text="""
    | theta |   d   |   a   | alpha
----|-------|-------|-------|-------
J0  | t0+0  |19.7452|   0   | -90°
----|-------|-------|-------|-------
J1  | t1-90 |   0   |35.796 |   0°
----|-------|-------|-------|-------
J2  | t2+0  |   0   |6.4259 | -90°
----|-------|-------|-------|-------
J3  | t3+0  |38.705 |   0   |  90°
----|-------|-------|-------|-------
J4  | t4+0  |   0   |   0   | -90°
----|-------|-------|-------|-------
J5  | t5+0  | 3.795 |   0   |   0°
----|-------|-------|-------|-------
""",
        rows=((0, 19.7452, 0, -90), (-90, 0, 35.796, 0), (0, 0, 6.4259, -90), (0, 38.705, 0, 90),
              (0, 0, 0, -90), (0, 3.795, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (42.5, 0, 61.9671)),)),
    Published(
        name="PUMA 560, bars in a comment",
        source=_GITHUB + "Z-G-Zhou/PUMA560-kinematics-and-trajectory_planning, "
               "Kinematics_of_PUMA560/p560_fkine.m",
        text="""
% |  number  | alpha  |   a   |   d   | theta  | min | max |
% |     1    |   90   |     0 |   0   | theta1 |-160 | 160 |
% |     2    |   0    | 0.4318|   0   | theta2 | -45 | 225 |
% |     3    |  -90   | 0.0203|0.15005| theta3 |-225 |  45 |
% |     4    |   90   |     0 | 0.4318| theta4 |-110 | 170 |
% |     5    |  -90   |     0 |   0   | theta5 |-100 | 100 |
% |     6    |    0   |     0 |   0   | theta6 |-266 | 266 |
""",
        rows=((0, 0, 0, 90), (0, 0, 0.4318, 0), (0, 0.15005, 0.0203, -90), (0, 0.4318, 0, 90),
              (0, 0, 0, -90), (0, 0, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (0.4521, -0.15, 0.4318)),), within=1e-4),
    Published(
        name="KR 6, blanks in a comment",
        source=_GITHUB + "pulkitmehta09/Kuka-KR6, scripts/kr6fk.py",
        text="""
# A         Alpha       d       Theta
# 0.350     -90         815     theta1
# 0.850     0           0       theta2
# 0.145     90          0       theta3
# 0.0       -90         820     theta4
# 0.0       90          0       theta5
# 0.0       0           170     theta6
""",
        rows=((0, 815, 0.35, -90), (0, 0, 0.85, 0), (0, 0, 0.145, 90), (0, 820, 0, -90),
              (0, 0, 0, 90), (0, 170, 0, 0))),
    Published(
        name="OpenManipulator-X, sums with blanks in a comment",
        source=_GITHUB + "xw2519/60030-Robotic-Manipulation-OpenManipulatorX, Task 1, "
               "forward_kinematics.m",
        text="""
% Frame     alpha_{i-1}     a_{i-1}     d_i           theta_i
% -----------------------------------------------------------------
%   1            0             0       0.077          theta_1
%   2            90            0         0      theta_2 + 90 - 10.6
%   3            0           0.130       0      theta_3 - 90 + 10.6
%   4            0           0.124       0            theta_4
%   5            0           0.126       0               0
""",
        convention="modified", kinds="RRRRF",
        rows=((0, 0.077, 0, 0), (79.4, 0, 0, 90), (-79.4, 0, 0.13, 0), (0, 0, 0.124, 0),
              (0, 0, 0.126, 0)),
        poses=(((0, 0, 0, 0), (0.274, 0, 0.205)),), within=1e-3),
    Published(
        name="six joints, sums of lengths and a stray mark",
        source=_GITHUB + "RobertGCNiu/6-DoF-Robot-Arm-Matlab-and-Arduino, forwardKinematics.m",
        text="""
%   i       a_i         alpha_i         d_i        theta_i       Ti_i-1
%   1        0           90            l1          theta_1* `     T1_0
%   2        l2            0            d2         theta_2*      T2_1
%   3        l3          -90             0         theta_3*      T3_2
%   4        0            90          d3 + l4      theta_4*      T4_3
%   5        0           -90             0         theta_5*      T5_4
%   6        0            0           l5 + l6      theta_6*      T6_5
""",
        lengths={"l1": 6, "l2": 6, "d2": 6, "l3": 6, "d3": 6, "l4": 6, "l5": 6, "l6": 6},
        rows=((0, 6, 0, 90), (0, 6, 6, 0), (0, 0, 6, -90), (0, 12, 0, 90), (0, 0, 0, -90),
              (0, 12, 0, 0))),
    Published(
        name="Pincher, a table within a docstring",
        source=_GITHUB + "MateoKGR/Lab-05-Robotica-2025-2, src/pincher_controller_gui.txt",
        text="""
        i   θ_i   d_i   a_i   α_i
        1   q1    L1    0    -pi/2
        2   q2     0    L2    0
        3   q3     0    L3    0
        4   q4     0    0    -pi/2
""",
        lengths={"L1": 0.0415, "L2": 0.107, "L3": 0.107},
        rows=((0, 0.0415, 0, -90), (0, 0, 0.107, 0), (0, 0, 0.107, 0), (0, 0, 0, -90)),
        poses=(((0, 0, 0, 0), (0.214, 0, 0.0415)),)),
    Published(
        name="RRR on a post, a matrix below its comment",
        source=_GITHUB + "rahul-r-joshua/Advanced-Robotic-Manipulator-Kinematics-Dynamics-and-"
               "Hardware-Interface, advanced_robot_manipulator.m",
        text="""
% DH Table [alpha, a, theta, d]
DH = [ 0,    0,   th1, d1;
       pi/2, 0,   th2, 0;
       0,    l2,  th3, 0;
       0,    l3,   0,  0];
""",
        convention="modified", choices={"convention": "modified"}, kinds="RRRF",
        lengths={"d1": 0.03, "l2": 0.8, "l3": 0.82},
        rows=((0, 0.03, 0, 0), (0, 0, 0, 90), (0, 0, 0.8, 0), (0, 0, 0.82, 0)),
        poses=(((0, 0, 0), (1.62, 0, 0.03)),)),
    Published(
        name="PUMA 560, two joints that count the other way",
        source=_GITHUB + "OpenRobotSL/PUMA560, puma560_fk.m",
        text="""
%     theta        d       a-1     alpha-1
MDH=[theta1        0       0        0;
     -theta2-pi/2  0       L6      -pi/2;
     -theta3       L7      L2       0;
     theta4        L4      L3      -pi/2;
     theta5        0       0       -pi/2;
     theta6        0       0        pi/2;
      0            L5      0        pi/2  ];
""",
        convention="modified", kinds="RRRRRRF", flips=(2, 3),
        lengths={"L2": 0.2, "L3": 0, "L4": 0.248, "L5": 0.262, "L6": 0, "L7": 0},
        rows=((0, 0, 0, 0), (-90, 0, 0, -90), (0, 0, 0.2, 0), (0, 0.248, 0, -90), (0, 0, 0, -90),
              (0, 0, 0, 90), (0, 0.262, 0, 90))),
    Published(
        name="Lego KUKA, tabs and blanks in a matrix",
        source=_GITHUB + "SinaPourSoltani/LEGO_KUKA, MATLAB/lego_kuka_kinematic_modelling.m",
        text="""
% a, alpha, d, theta
dhparams = [0   	0       0.0438	0;
            0.0159  -pi/2   0.0877  0;
            0.1116 	pi      0	    0;
            0.0399 	pi/2    0	    0;
            0    	0     	0.0956 	0;
            0	    pi/2    0.0638  0;
            0       -pi/2   0       0;
            0   	0       0.0478  0;
            0   	0       0       0;];
""",
        rows=((0, 0.0438, 0, 0), (0, 0.0877, 0.0159, -90), (0, 0, 0.1116, 180), (0, 0, 0.0399, 90),
              (0, 0.0956, 0, 0), (0, 0.0638, 0, 90), (0, 0, 0, -90), (0, 0.0478, 0, 0),
              (0, 0, 0, 0))),
    # ---- matrices of programs ----
    Published(
        name="Pincher, bars over a matrix of Python",
        source=_GITHUB + "YasserSalem1/Inverse-Forward-kinematics, new_ik_final.py",
        text="""
    # |  d  |  a  |  alpha  |  theta  |
    dh_params = np.array([[0.04, 0., 0.5 * pi, 0.],
                          [0., 0.105, pi, 0.5 * pi],
                          [0., 0.105, pi, pi],
                          [0, 0.105, pi/2, 0]
                          ])
""",
        rows=((0, 0.04, 0, 90), (90, 0, 0.105, 180), (180, 0, 0.105, 180), (0, 0, 0.105, 90))),
    Published(
        name="Stanford arm, a call for each link, the fifth number its kind",
        source=_GITHUB + "petercorke/robotics-toolbox-matlab, models/mdl_stanford.m",
        text="""
%             th    d       a    alpha
L(1) = Link([ 0     0.412   0   -pi/2     0]);
L(2) = Link([ 0     0.154   0    pi/2     0]);
L(3) = Link([ -pi/2 0       0    0        1]);  % PRISMATIC link
L(4) = Link([ 0     0       0   -pi/2     0]);
L(5) = Link([ 0     0       0    pi/2     0]);
L(6) = Link([ 0     0.263   0    0        0]);
""",
        kinds="RRPRRR",
        rows=((0, 0.412, 0, -90), (0, 0.154, 0, 90), (-90, 0, 0, 0), (0, 0, 0, -90),
              (0, 0, 0, 90), (0, 0.263, 0, 0)),
        poses=(((0, 0, 0.5, 0, 0, 0), (0, 0.154, 1.175)),)),
    Published(
        name="KR 5 arc, a call for each link",
        source=_GITHUB + "ros-industrial/kuka_experimental/issues/130",
        text="""
%            theta    d           a       alpha
L(1) = Link([0        0.4         0.18    pi/2]);
L(2) = Link([0        0.135       0.60    pi]);
L(3) = Link([0        0.135       0.12   -pi/2]);
L(4) = Link([0        0.62        0       pi/2]);
L(5) = Link([0        0           0      -pi/2]);
L(6) = Link([0 0 0 0]);
""",
        rows=((0, 0.4, 0.18, 90), (0, 0.135, 0.6, 180), (0, 0.135, 0.12, -90), (0, 0.62, 0, 90),
              (0, 0, 0, -90), (0, 0, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (0.9, 0, -0.22)),)),
    Published(
        name="PUMA 560, a matrix whose words say the order of its columns",
        source="https://www.mathworks.com/help/robotics/ug/"
               "build-manipulator-robot-using-kinematic-dh-parameters.html",
        text="""
dhparams = [0       pi/2    0       0;
            0.4318  0       0       0
            0.0203  -pi/2   0.15005 0;
            0       pi/2    0.4318  0;
            0       -pi/2   0       0;
            0       0       0       0];
""",
        choices={"columns": "a alpha d theta"}, asks=True,
        rows=((0, 0, 0, 90), (0, 0, 0.4318, 0), (0, 0.15005, 0.0203, -90), (0, 0.4318, 0, 90),
              (0, 0, 0, -90), (0, 0, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (0.4521, -0.15005, 0.4318)),)),
    Published(
        name="arm of four joints, commas left at the ends",
        source=_GITHUB + "Matricule17060/RoboticsLab, dh_table.m (lengths round here)",
        text="""
    table = [-90 , 0   , 6.3 , tet1;
             0   , a2  , 0   , tet2;
             0   , a3  , 0   , tet3;
             0   , a4  , 0   , tet4;];
""",
        choices={"columns": "alpha a d theta"}, lengths={"a2": 10, "a3": 8, "a4": 5},
        rows=((0, 6.3, 0, -90), (0, 0, 10, 0), (0, 0, 8, 0), (0, 0, 5, 0)),
        poses=(((0, 0, 0, 0), (23, 0, 6.3)),)),
    Published(
        name="KR 240, the order of the columns behind the first row",
        source=_GITHUB + "mikelg996-code/KUKA-KR240-R2500-Kinematics, "
               "KUKA_KR240_R2500_kinematics.py",
        text="""
dh_nominales =  np.array([
    (-90,     350,      0,      675),  # J1 [alpha, a, theta, d]
    (  0,    1150,    -90,        0),  # J2
    (-90,     -41,      0,        0),  # J3
    ( 90,       0,      0,     1000),  # J4
    (-90,       0,    180,        0),  # J5
    (  0,       0,      0,      240),  # J6
])
""",
        choices={"columns": "alpha a theta d"},
        rows=((0, 675, 350, -90), (-90, 0, 1150, 0), (0, 0, -41, -90), (0, 1000, 0, 90),
              (180, 0, 0, -90), (0, 240, 0, 0))),
    # ---- LaTeX and books ----
    Published(
        name="IRB 1400, a tabular with rules",
        source=_GITHUB + "tdyang/rbe500, homework/hw3/hw3.tex, Task 2",
        text=r"""
\begin{table}[h]
\centering
\caption{D-H Parameters for the ABB IRB1400 (all distances in mm)}
\renewcommand{\arraystretch}{1.3}
\begin{tabular}{ccccc}
\toprule
Joint $i$ & $\theta_i$ & $d_i$ (mm) & $a_i$ (mm) & $\alpha_i$ \\
\midrule
1 & $q_1$   & 475 & 150 & $+90^\circ$ \\
2 & $q_2$   &   0 & 600 &   $0^\circ$ \\
3 & $q_3$   &   0 & 120 & $+90^\circ$ \\
4 & $q_4$   & 720 &   0 & $-90^\circ$ \\
5 & $q_5$   &   0 &   0 & $+90^\circ$ \\
6 & $q_6$   & 255 &   0 &   $0^\circ$ \\
\bottomrule
\end{tabular}
\end{table}
""",
        unit="mm",
        rows=((0, 475, 150, 90), (0, 0, 600, 0), (0, 0, 120, 90), (0, 720, 0, -90), (0, 0, 0, 90),
              (0, 255, 0, 0)),
        poses=(((0, 75, 30, 135, -45, 60), (1110.87, 127.50, 1526.64)),), within=0.01),
    Published(
        name="Stanford manipulator, stars for the variables",
        source="Spong, Hutchinson, Vidyasagar: Robot Dynamics and Control, 2nd ed., 2004, "
               "DH parameters for the Stanford Manipulator",
        text="""
Link   d_i   a_i   α_i   θ_i
1      0     0     −90   ⋆
2      d2    0     +90   ⋆
3      ⋆     0     0     0
4      0     0     −90   ⋆
5      0     0     +90   ⋆
6      d6    0     0     ⋆
""",
        kinds="RRPRRR", lengths={"d2": 0.154, "d6": 0.263},
        rows=((0, 0, 0, -90), (0, 0.154, 0, 90), (0, 0, 0, 0), (0, 0, 0, -90), (0, 0, 0, 90),
              (0, 0.263, 0, 0)),
        poses=(((0, 0, 0.5, 0, 0, 0), (0, 0.154, 0.763)),)),
    Published(
        name="Stanford manipulator, the variable in a column of its own",
        source="Paul: Robot Manipulators, 1981, link parameters for the Stanford manipulator",
        text="""
Link   Variable   α      a   d    cos α   sin α
1      θ1         −90°   0   0    0       −1
2      θ2         90°    0   d2   0       1
3      d3         0°     0   d3   1       0
4      θ4         −90°   0   0    0       −1
5      θ5         90°    0   0    0       1
6      θ6         0°     0   0    1       0
""",
        kinds="RRPRRR", lengths={"d2": 0.154},
        rows=((0, 0, 0, -90), (0, 0.154, 0, 90), (0, 0, 0, 0), (0, 0, 0, -90), (0, 0, 0, 90),
              (0, 0, 0, 0)),
        poses=(((0, 0, 0.5, 0, 0, 0), (0, 0.154, 0.5)),)),
    Published(
        name="anthropomorphic arm, cursive theta",
        source="Siciliano, Sciavicco, Villani, Oriolo: Robotics, 2009, section 2.9.5",
        text=r"""
\begin{array}{c|cccc}
\text{Link} & a_i & \alpha_i & d_i & \vartheta_i \\ \hline
1 & 0   & \pi/2 & 0 & \vartheta_1 \\
2 & a_2 & 0     & 0 & \vartheta_2 \\
3 & a_3 & 0     & 0 & \vartheta_3
\end{array}
""",
        lengths={"a_2": 0.5, "a_3": 0.4},
        rows=((0, 0, 0, 90), (0, 0, 0.5, 0), (0, 0, 0.4, 0)),
        poses=(((0, 0, 0), (0.9, 0, 0)), ((0, 90, 0), (0, 0, 0.9)))),
    Published(
        name="articulated arm, a hash as head of its labels",
        source="Niku: Introduction to Robotics, 2nd ed., 2011, section 2.12",
        text="""
#	θ	d	a	α
0–1	θ1	0	0	90
1–2	θ2	0	a2	0
2–3	θ3	0	a3	0
3–4	θ4	0	a4	−90
4–5	θ5	0	0	90
5–6	θ6	0	0	0
""",
        lengths={"a2": 0.4, "a3": 0.3, "a4": 0.1},
        rows=((0, 0, 0, 90), (0, 0, 0.4, 0), (0, 0, 0.3, 0), (0, 0, 0.1, -90), (0, 0, 0, 90),
              (0, 0, 0, 0)),
        poses=(((0, 0, 0, 0, 0, 0), (0.8, 0, 0)),)),
    Published(
        name="Adept One, a column of home values",
        source="Schilling: Fundamentals of Robotics, 1990, kinematic parameters of a four-axis "
               "SCARA robot",
        text="""
Axis   θ    d    a    α    Home
1      q1   d1   a1   π    0
2      q2   0    a2   0    0
3      0    q3   0    0    100
4      q4   d4   0    0    π/2
""",
        kinds="RRPR", lengths={"d1": 877, "a1": 425, "a2": 375, "d4": 200},
        rows=((0, 877, 425, 180), (0, 0, 375, 0), (0, 0, 0, 0), (0, 200, 0, 0)),
        poses=(((0, 0, 100, 90), (800, 0, 577)),)),
)
