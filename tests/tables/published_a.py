"""DH tables of arms as published by authors, makers and sites from A to L: data only.

Numbers are typed anew from the sources, in the sources' own layout; what they mean was typed by
hand. Where a source names lengths without their values, `lengths` gives values of our own. No
copy of the books, of the two papers by Gaz and of the guide of the Gen3 was at hand: these are as
commonly quoted, and so is their layout. Poses are the source's own, or read off the drawn arm.
"""
from published import KR210, KR210_AT_ZERO, Published

TABLES = (
    # ---- Markdown ----
    Published(
        "KR 210 with subscripts in HTML and names before the numbers",
        "https://github.com/hmirzaei/RoboND-Kinematics-Project README.md",
        """
i   | α<sub>i-1</sub> | a<sub>i-1</sub>      | d<sub>i-1</sub>    | θ<sub>i</sub>
:---|:----------------|:---------------------|:-------------------|:---------------
1   | 0               | 0                    | d<sub>1</sub>=0.75 | θ<sub>1</sub>
2   | - π/2           | a<sub>1</sub>=0.35   | 0                  | θ<sub>2</sub> - π/2
3   | 0               | a<sub>2</sub>=1.25   | 0                  | θ<sub>3</sub>
4   | - π/2           | a<sub>3</sub>=-0.054 | d<sub>4</sub>=1.5  | θ<sub>4</sub>
5   | π/2             | 0                    | 0                  | θ<sub>5</sub>
6   | - π/2           | 0                    | 0                  | θ<sub>6</sub>
G*  | 0               | 0                    | d<sub>G</sub>=0.303| 0
""", KR210, convention="modified", kinds="RRRRRRF", poses=KR210_AT_ZERO),
    Published(
        "KR 210 with empty cells where nothing is added to the variable",
        "https://github.com/kjames88/RoboND-Kinematics-Project README.md",
        """
| Links | alpha(i-1) | a(i-1) | d(i) | theta(i) |
|:---|:---|:---|:---|:---|
| 0->1    | 0 | 0 | 0.75 |   |
| 1->2    | -pi/2 | 0.35 | 0 | q2-pi/2 |
| 2->3 | 0 | 1.25 | 0 |   |
| 3->4 | -pi/2 | -0.054 | 1.50 |   |
| 4->5 | pi/2 | 0 | 0 |   |
| 5->6 | -pi/2 | 0 | 0 |   |
| 6->EE | 0 |0 | 0.303 | 0 |
""", KR210, convention="modified", kinds="RRRRRRF", poses=KR210_AT_ZERO),
    Published(
        "KR 210 with variables of a program, to the wrist",
        "https://github.com/dimaga/RoboND-Kinematics-Project README.md",
        """
Transformations | alpha(i-1) | a(i-1) | d(i) | theta(i)
--- | --- | --- | --- | ---
1->0 | 0 | 0 | 0.75 | JOINTS[0]
2->1 | -pi/2 | 0.35 | 0 | -pi/2 + JOINTS[1]
3->2 | 0 | 1.25 | 0 | pi + JOINTS[2]
4->3 |  pi/2 | 0.054 | 1.5 | pi + JOINTS[3]
5->4 | pi/2 | 0 | 0 | JOINTS[4]
6->5 | -pi/2 | 0 | 0 | JOINTS[5]
""", ((0, 0.75, 0, 0), (-90, 0, 0.35, -90), (180, 0, 1.25, 0), (180, 1.5, 0.054, 90),
      (0, 0, 0, 90), (0, 0, 0, -90)), convention="modified",
        poses=(((0, 0, 0, 0, 0, 0), (1.85, 0, 1.946)),)),
    Published(
        "KR 210 in dollars, zeros left out",
        "https://github.com/Frugchivore/RoboND-Kinematics-Project notebooks/WriteUp Notebook.ipynb",
        r"""
|i         |$\alpha_{i-1}$|$a_{i-1}$|$d_i$  |$\theta_i$ |
|:--------:|:------------:|:-------:|:----: |:--------: |
|$T_0^1$   |   $0$        |   $0$   |$0.75$ |   $q_1$   |
|$T_1^2$   |   $-\pi/2$   |$0.35$   |$0$    |$q_2 - \pi/2$|
|$T_2^3$   |   $0$        |$1.25$   |$0$    |   $q_3$   |
|$T_3^4$   |   $-\pi/2$   |$-0.054$ |$1.50$ |   $q_4$   |
|$T_4^5$   |   $\pi/2$    |   $0$   |       |   $q_5$   |
|$T_5^6$   |   $-\pi/2$   |   $0$   |       |   $q_6$   |
|$T_6^7$   |   $0$        |   $0$   |$0.303$|   $0$     |
""", KR210, convention="modified", kinds="RRRRRRF", poses=KR210_AT_ZERO),
    Published(
        "KR 210 in bold letters, angles as equations",
        "https://github.com/jfjensen/RoboND-Kinematics-Project writeup.md",
        r"""
| $\mathbf i$ | $\mathbf \alpha_{i-1}$ | $\mathbf a_{i-1}$ | $\mathbf d_i$ | $\mathbf \theta_{i}$                 |
| ----------- | ---------------------- | ----------------- | ------------- | ------------------------------------ |
| 1           | 0                      | 0                 | 0.75          |                                      |
| 2           | $-\frac{\pi}{2}$       | 0.35              | 0             | $\theta_2 = \theta_2 -\frac{\pi}{2}$ |
| 3           | 0                      | 1.25              | 0             |                                      |
| 4           | $-\frac{\pi}{2}$       | -0.054            | 1.50          |                                      |
| 5           | $\frac{\pi}{2}$        | 0                 | 0             |                                      |
| 6           | $-\frac{\pi}{2}$       | 0                 | 0             |                                      |
| 7           | 0                      | 0                 | 0.303         | $\theta_7 = 0$                       |
""", KR210, convention="modified", kinds="RRRRRRF", poses=KR210_AT_ZERO),  # noqa: E501
    Published(
        "PhantomX Pincher, parts of pi beside millimetres",
        "https://github.com/EdoCuadros/Lab5 README.md",
        """
| Joint | Theta | d | a | alpha |
| -------- | -------- | -------- | -------- | -------- |
| 1  | q1     | 0    | 0 | pi/2 |
| 2  | q2     | 0    | 100 | 0 |
| 3  | q3     | 0    | 100 | 0 |
| 4  | q4     | 0    | 100 | 0 |
""", ((0, 0, 0, 90), (0, 0, 100, 0), (0, 0, 100, 0), (0, 0, 100, 0)),
        poses=(((0, 0, 0, 0), (300, 0, 0)),)),
    Published(
        "PhantomX Pincher with a column for the offset",
        "https://github.com/Andhec98/Laboratorio-No.-4-Cinem-atica-Directa--Phantom-X--ROS "
        "README.md",
        """
| Articulación | a [m]   | α [rad]  | d [m]    | θ [rad] (variable) | Offset [rad] |
|--------------|---------|----------|----------|---------------------|--------------|
| 1            | 0       | π/2      | 0.15205  | θ₁                  | 0            |
| 2            | 0.13682 | 0        | 0        | θ₂                  | π/2          |
| 3            | 0.07412 | 0        | 0        | θ₃                  | 0            |
| 4            | 0.1084  | 0        | 0        | θ₄                  | 0            |
""", ((0, 0.15205, 0, 90), (90, 0, 0.13682, 0), (0, 0, 0.07412, 0), (0, 0, 0.1084, 0)),
        poses=(((0, 0, 0, 0), (0, 0, 0.47139)),)),  # it stands upright
    Published(
        "PhantomX Pincher, quarter turns as 1.57",
        "https://github.com/isamendo17/Laboratorio-No.-4-Cinem-tica-Directa---Phantom-X---ROS "
        "README.md (radians and centimetres, says the text above it)",
        """
| Link | θ_i     | d_i   | a_i   | α_i   | θ offset |
|:----:|:-------:|:-----:|:-----:|:-----:|:--------:|
| 0    | θ₁      | 4.00  | 0.00  | 1.57  | 0.00     |
| 1    | θ₂      | 0.00  | 10.50 | 0.00  | 1.57     |
| 2    | θ₃      | 0.00  | 10.50 | 0.00  | 0.00     |
| 3    | θ₄      | 0.00  | 0.00  | -1.57 | -1.57    |
| 4    | θ₅      | 7.50  | 0.00  | 0.00  | 0.00     |
""", ((0, 4, 0, 1.57), (1.57, 0, 10.5, 0), (0, 0, 10.5, 0), (-1.57, 0, 0, -1.57), (0, 7.5, 0, 0)),
        angles="rad", choices={"angles": "rad"}, asks=True,
        poses=(((0, 0, 0, 0, 0), (0, 0, 32.5)),), within=0.1),  # upright
    Published(
        "PhantomX Pincher in Spanish, capital letters",
        "https://github.com/anhernadezdu/Laboratorio4_Cinematica-Directa_PhantomX_ROS README.md",
        """
|Articulacion| Theta    | D    | Alpha | A    |
| :---:      | :---:    |:---: |:---:  |:--:  |
| 1          |Q1        | L1   |pi/2   |0     |
| 2          |Q2+pi/2   | 0    |0      |L2    |
| 3          |Q3        | 0    |0      |L3    |
| 4          |Q4        | 0    |0      |L4    |
""", ((0, 14.5, 0, 90), (90, 0, 10.7, 0), (0, 0, 10.6, 0), (0, 0, 9, 0)),
        lengths={"L1": 14.5, "L2": 10.7, "L3": 10.6, "L4": 9},
        poses=(((0, 0, 0, 0), (0, 0, 44.8)),)),
    Published(
        "PhantomX Pincher in centimetres",
        "https://github.com/gsua080/Laboratorio-No.-4-Cinematica-Directa README.md",
        """
| i | θᵢ (variable) | dᵢ (cm) | aᵢ (cm) | αᵢ (rad) |
|---|---------------|---------|---------|----------|
| 1 | θ₁            | 11.04   | 0       | π/2      |
| 2 | θ₂            | 0       | 10.3    | 0        |
| 3 | θ₃            | 0       | 10.33   | 0        |
| 4 | θ₄            | 0       | 9.12    | 0        |
| 5 | θ₅            | 0       | 9.12    | 0        |
""", ((0, 11.04, 0, 90), (0, 0, 10.3, 0), (0, 0, 10.33, 0), (0, 0, 9.12, 0), (0, 0, 9.12, 0)),
        unit="cm", poses=(((0, 0, 0, 0, 0), (38.87, 0, 11.04)),)),
    Published(
        "PUMA 560 without its last joint, heads half in dollars",
        "https://github.com/haijunsu-osu/ik_puma560_notes README.md",
        r"""
| Joint | $a$ (m)   | $\alpha$ (deg) | $d$ (m)    | $\theta$ (variable) |
|-------|---------|-------------|----------|------------------|
| 1     | $0.0$     | $-90$         | $0.0$      | $\theta_1$               |
| 2     | $0.4318$  | $0$           | $0.0$      | $\theta_2$               |
| 3     | $0.0203$  | $-90$         | $0.14909$  | $\theta_3$               |
| 4     | $0.0$     | $90$          | $0.43307$  | $\theta_4$               |
| 5     | $0.0$     | $-90$         | $0.0$      | $\theta_5$               |
""", ((0, 0, 0, -90), (0, 0, 0.4318, 0), (0, 0.14909, 0.0203, -90), (0, 0.43307, 0, 90),
      (0, 0, 0, -90))),
    Published(
        "SCARA with starred variables",
        "https://github.com/Clip2004/scara-robot-rrp README.md",
        """
| Link | θᵢ | dᵢ | aᵢ | αᵢ |
|---|---|---|---|---|
| 1 | θ₁* | 0 | L₁ | 0 |
| 2 | θ₂* | 0 | L₂ | 0 |
| 3 | 0 | d₃* | 0 | 0 |
""", ((0, 0, 0.2, 0), (0, 0, 0.15, 0), (0, 0, 0, 0)), kinds="RRP",
        lengths={"L1": 0.2, "L2": 0.15},
        poses=(((90, 90, 0.05), (-0.15, 0.2, 0.05)),)),
    Published(
        "Kinova Gen3 lite, TeX words outside of dollars",
        "https://github.com/Lgx521/EE368_Project scripts/README.md",
        r"""
| Links | \alpha_{i-1} | a_{i-1} | \theta_i | d_i
| -- | -- | -- | -- | -- |
|1| 0 | 0 | \theta_1 | 243.3 |
|2| 90 | 0 | 90 + \theta_2 | 30 |
|3| 180| 280 | 90 + \theta_3 | 20 |
|4| 90 | 0 | 90 + \theta_4 | 245 |
|5| 90 | 0 | 180 + \theta_5 | 57 |
|6| 90 | 0 | 90 + \theta_6 | 235 |
""", ((0, 243.3, 0, 0), (90, 30, 0, 90), (90, 20, 280, 180), (90, 245, 0, 90), (180, 57, 0, 90),
      (90, 235, 0, 90)), convention="modified"),
    Published(
        "exercise with the angles of one pose",
        "https://github.com/chcordova/robot-kinematics-solver docs/KINEMATICS_ANALYSIS.md",
        """
| i | θᵢ       | dᵢ  | aᵢ | αᵢ  |
|---|----------|-----|----|-----|
| 1 | 40°      | 10  | 0  | 90° |
| 2 | 60°      | 0   | 12 | 0°  |
| 3 | −50°     | 0   | 8  | 0°  |
""", ((40, 10, 0, 90), (60, 0, 12, 0), (-50, 0, 8, 0)),
        poses=(((0, 0, 0), (10.632, 8.921, 21.781)),), within=1e-3),  # printed below its table
    Published(
        "KUKA without a column of names, l for the length",
        "https://github.com/alexandrosdms/kuka_path_planning_rmrc README.md",
        """
|α<sub>i-1</sub>|l<sub>i-1</sub> |d<sub>i</sub>|θ<sub>i</sub>|
| ------------- |:--------------:|:-------:| ---------------:|
|0              |0               |0        |θ_1              |
|-90            |160             |0        |θ_2              |
|0              |780             |0        |θ_3              |
|-90            |150             |655      |θ_4              |
|90             |0               |0        |θ_5              |
|-90            |0               |0        |θ_6              |
""", ((0, 0, 0, 0), (0, 0, 160, -90), (0, 0, 780, 0), (0, 655, 150, -90), (0, 0, 0, 90),
      (0, 0, 0, -90)), convention="modified",
        poses=(((0, 0, 0, 0, 0, 0), (160 + 780 + 150, 0, -655)),)),
    Published(
        "arm of a printed kit, two columns of words",
        "https://github.com/Harish-Ram-R-V/RoboArm-M1 README.md",
        """
| Joint | Maps to URDF | θ | d (m) | a (m) | α (rad) | Description |
|-------|-------------|---|--------|--------|---------|-------------|
| 1 | Revolute_1 | q₁ | 0.042 | 0.000 | π/2 | Waist rotation |
| 2 | Revolute_2 | q₂ | 0.000 | 0.365 | 0 | Shoulder pitch |
| 3 | Revolute_3 | q₃ | 0.246 | 0.048 | π/2 | Elbow pitch |
| 4 | Revolute_5 | q₄ | 0.115 | 0.000 | 0 | Wrist pitch |
""", ((0, 0.042, 0, 90), (0, 0, 0.365, 0), (0, 0.246, 0.048, 90), (0, 0.115, 0, 0))),
    Published(
        "3R arm, letters with their words",
        "https://github.com/Hector-Cornejo/Applied_robotics docs/inverse_kinematics.md",
        """
| Link | α (alpha)  | a (link length) | d (link offset) | θ (joint angle) |
|------|------------|-----------------|-----------------|-----------------|
| 1    | -π/2       | 0               | L1              | q1              |
| 2    | 0          | L2              | 0               | q2              |
| 3    | 0          | L3              | 0               | q3              |
""", ((0, 0.3, 0, -90), (0, 0, 0.25, 0), (0, 0, 0.2, 0)),
        lengths={"L1": 0.3, "L2": 0.25, "L3": 0.2}, poses=(((0, 0, 0), (0.45, 0, 0.3)),)),
    Published(
        "Arctos, variables and sines in columns of their own",
        "https://github.com/BU-Robotics-ARCTOS-ARM/BU-robotics-club-arctos "
        "docs/arctos_arm_specifications.md",
        """
| Joint (i) | q_i | α_i (°) | a_i (mm) | θ_i (°) | d_i (mm) | sin α_i | cos α_i |
| ---------- | --- | ------- | -------- | ------- | -------- | ------- | ------- |
| 1          | q₁  | 0       | 0        | 0       | 287.87   | 0       | 1       |
| 2          | q₂  | -90     | 20.174   | -90     | 0        | -1      | 0       |
| 3          | q₃  | 0       | 260.986  | 0       | 0        | 0       | 1       |
| 4          | q₄  | 0       | 19.219   | 0       | 260.753  | 0       | 1       |
| 5          | q₅  | 90      | 0        | 0       | 0        | 1       | 0       |
| 6          | q₆  | -90     | 0        | 180     | 74.745   | -1      | 0       |
""", ((0, 287.87, 0, 0), (-90, 0, 20.174, -90), (0, 0, 260.986, 0), (0, 260.753, 19.219, 0),
      (0, 0, 0, 90), (180, 74.745, 0, -90)), unit="mm"),
    Published(
        "iCub's right leg, ranges in the cells of theta",
        "https://github.com/icub-tech-iit/documentation "
        "docs/icub_kinematics/icub-forward-kinematics/icub-forward-kinematics-legs.md, version 2.5",
        r"""
| Link i / H – D | a\_i (mm) | d\_i (mm) | alpha\_i (rad) | theta\_{i} + (ang. range) (deg) |
|----------------|-----------|-----------|----------------|---------------------------------|
| i = 0          | 0         | 0         | -pi/2          | 90 + (-44 -> +132)              |
| i = 1          | 0         | 0         | -pi/2          | 90 + (-119 -> +17)              |
| i = 2          | -0.9175   | -234.545  | pi/2           | -90 + (-79 -> +79)              |
| i = 3          | -200.5    | 0         | pi             | 90 + (-125 -> +0)               |
| i = 4          | 0         | 0         | -pi/2          | 0 + (-42 -> +21)                |
| i = 5          | -68.05    | -3.5      | 0              | 0 + (-24 -> +24)                |
""", ((90, 0, 0, -90), (90, 0, 0, -90), (-90, -234.545, -0.9175, 90), (90, 0, -200.5, 180),
      (0, 0, 0, -90), (0, -3.5, -68.05, 0)), unit="mm"),

    # ---- LaTeX ----
    Published(
        "KR 210 as a tabular, links as transforms",
        "https://github.com/ClancyUmphrey/RoboND-Kinematics-Project images/DH_table/DH_table.tex",
        r"""
\begin{center}
\renewcommand{\arraystretch}{1.4}
\begin{tabular}{ l c c c c }
\hline
$^{i-1}_{i}T$ & $\alpha_{i-1}$ & $a_{i-1}$ & $d_{i}$ & $\theta_{i}$ \\
\hline\hline
$^{0}_{1}T$   & $0$            & $0$       & $0.75$  & $\theta_{1}$         \\
$^{1}_{2}T$   & $-\pi/2$       & $0.35$    & $0$     & $\theta_{2} - \pi/2$ \\
$^{2}_{3}T$   & $0$            & $1.25$    & $0$     & $\theta_{3}$         \\
$^{3}_{4}T$   & $-\pi/2$       & $-0.054$  & $1.50$  & $\theta_{4}$         \\
$^{4}_{5}T$   & $ \pi/2$       & $0$       & $0$     & $\theta_{5}$         \\
$^{5}_{6}T$   & $-\pi/2$       & $0$       & $0$     & $\theta_{6}$         \\
$^{6}_{7}T$   & $0$            & $0$       & $0.303$ & $0$                  \\
\hline
\end{tabular}
\end{center}
""", KR210, convention="modified", kinds="RRRRRRF", poses=KR210_AT_ZERO),
    Published(
        "mobile fruit picker of nine joints, one flipped, one sliding",
        "https://github.com/brunofavs/TP2_RI-Robot-Kinematics docs/paper/main.tex, table 1",
        r"""
\begin{tabular}{|c|c|c|c|c|}
    \hline
    Joint & $\theta_i$                 & $l_i$ & $d_i$                  & $\alpha_i$       \\
    \hline
    1     & $\theta_1$                 & 0     & $La$                   & $-\frac{\pi}{2}$ \\
    \hline
    2     & $-\theta_2$                & $Lb$  & 0                      & 0                \\
    \hline
    3     & $\theta_3 - \frac{\pi}{2}$ & $Lc$  & 0                      & 0                \\
    \hline
    4     & $\theta_4 - \frac{\pi}{2}$ & $Ld$  & 0                      & 0                \\
    \hline
    5     & $\theta_5 + \frac{\pi}{2}$ & $Le$  & 0                      & 0                \\
    \hline
    6     & $\theta_6$                 & 0     & 0                      & $-\frac{\pi}{2}$ \\
    \hline
    7     & 0                          & 0     & $Lf_{\text{min}} + d7$ & $\frac{\pi}{2}$  \\
    \hline
    8     & $\frac{\pi}{2} + \theta_8$ & $Lg$  & 0                      & $\frac{\pi}{2}$  \\
    \hline
    9     & $\theta_9$                 & $Lh$  & 0                      & 0                \\
    \hline
\end{tabular}
""", ((0, 0.8, 0, -90), (0, 0, 0.5, 0), (-90, 0, 0.4, 0), (-90, 0, 0.35, 0), (90, 0, 0.2, 0),
      (0, 0, 0, -90), (0, 0.3, 0, 90), (90, 0, 0.1, 90), (0, 0, 0.15, 0)),
        kinds="RRRRRRPRR", flips=(2,),
        lengths={"La": 0.8, "Lb": 0.5, "Lc": 0.4, "Ld": 0.35, "Le": 0.2, "Lf_min": 0.3,
                 "Lg": 0.1, "Lh": 0.15}),
    Published(
        "gantry with a wrist, degrees as a small o",
        "https://github.com/AkshitKumar/id6040 assignment.tex, solution 2",
        r"""
\begin{tabular}{|c|c|c|c|c|}
\hline
S.No & $d$ & $a$ & $\theta$ & $\alpha$\tabularnewline
\hline
\hline
1 & $d_{1}$ & $0$ & $0^{o}$ & $-90^{o}$\tabularnewline
\hline
2 & $d_{2}$ & $0$ & $90^{o}$ & $-90^{o}$\tabularnewline
\hline
3 & $d_{3}$ & $0$ & $0^{o}$ & $0^{o}$\tabularnewline
\hline
4 & $0$ & $0$ & $\theta_{4}$ & $-90^{o}$\tabularnewline
\hline
5 & $0$ & $0$ & $\theta_{5}$ & $90^{o}$\tabularnewline
\hline
6 & $1$ & $0$ & $\theta_{6}$ & $0^{o}$\tabularnewline
\hline
\end{tabular}
""", ((0, 0, 0, -90), (90, 0, 0, -90), (0, 0, 0, 0), (0, 0, 0, -90), (0, 0, 0, 90), (0, 1, 0, 0)),
        kinds="PPPRRR"),
    Published(
        "PUMA 560 by Craig, lengths as letters",
        "J. J. Craig, Introduction to Robotics: Mechanics and Control, chapter 3, "
        "link parameters of the PUMA 560",
        r"""
\begin{array}{c|cccc}
i & \alpha_{i-1} & a_{i-1} & d_i & \theta_i \\ \hline
1 & 0 & 0 & 0 & \theta_1 \\
2 & -90^\circ & 0 & 0 & \theta_2 \\
3 & 0 & a_2 & d_3 & \theta_3 \\
4 & -90^\circ & a_3 & d_4 & \theta_4 \\
5 & 90^\circ & 0 & 0 & \theta_5 \\
6 & -90^\circ & 0 & 0 & \theta_6
\end{array}
""", ((0, 0, 0, 0), (0, 0, 0, -90), (0, 0.1254, 0.4318, 0), (0, 0.4318, 0.0191, -90), (0, 0, 0, 90),
      (0, 0, 0, -90)), convention="modified",
        lengths={"a2": 0.4318, "a3": 0.0191, "d3": 0.1254, "d4": 0.4318},
        poses=(((0, 0, 0, 0, 0, 0), (0.4509, 0.1254, -0.4318)),)),
    Published(
        "KUKA LWR 4+",
        "C. Gaz, F. Flacco, A. De Luca, Identifying the dynamic model used by the KUKA LWR, "
        "ICRA 2014, Denavit-Hartenberg parameters",
        r"""
\begin{tabular}{ccccc}
$i$ & $a_i$ & $\alpha_i$ & $d_i$ & $\theta_i$ \\
\hline
1 & 0 & $\pi/2$ & 0 & $q_1$ \\
2 & 0 & $-\pi/2$ & 0 & $q_2$ \\
3 & 0 & $-\pi/2$ & $d_1$ & $q_3$ \\
4 & 0 & $\pi/2$ & 0 & $q_4$ \\
5 & 0 & $\pi/2$ & $d_2$ & $q_5$ \\
6 & 0 & $-\pi/2$ & 0 & $q_6$ \\
7 & 0 & 0 & 0 & $q_7$ \\
\end{tabular}
""", ((0, 0, 0, 90), (0, 0, 0, -90), (0, 0.4, 0, -90), (0, 0, 0, 90), (0, 0.39, 0, 90),
      (0, 0, 0, -90), (0, 0, 0, 0)), lengths={"d1": 0.4, "d2": 0.39},
        poses=(((0,) * 7, (0, 0, 0.79)),)),  # it stands upright

    # ---- other marks ----
    Published(
        "Franka Research 3 in reStructuredText, with its flange",
        "https://github.com/frankaemika/docs source/control_parameters.rst "
        "(Craig's convention, says the text above it)",
        r"""
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
|    Joint    | :math:`a\;(\text{m})` | :math:`d\;(\text{m})` | :math:`\alpha\;(\text{rad})` | :math:`\theta\;(\text{rad})` |
+=============+=======================+=======================+==============================+==============================+
| Joint 1     | 0                     | 0.333                 | 0                            | :math:`\theta_1`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 2     | 0                     | 0                     | :math:`-\frac{\pi}{2}`       | :math:`\theta_2`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 3     | 0                     | 0.316                 | :math:`\frac{\pi}{2}`        | :math:`\theta_3`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 4     | 0.0825                | 0                     | :math:`\frac{\pi}{2}`        | :math:`\theta_4`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 5     | -0.0825               | 0.384                 | :math:`-\frac{\pi}{2}`       | :math:`\theta_5`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 6     | 0                     | 0                     | :math:`\frac{\pi}{2}`        | :math:`\theta_6`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Joint 7     | 0.088                 | 0                     | :math:`\frac{\pi}{2}`        | :math:`\theta_7`             |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
| Flange      | 0                     | 0.107                 | 0                            | 0                            |
+-------------+-----------------------+-----------------------+------------------------------+------------------------------+
""", ((0, 0.333, 0, 0), (0, 0, 0, -90), (0, 0.316, 0, 90), (0, 0, 0.0825, 90),  # noqa: E501
      (0, 0.384, -0.0825, -90), (0, 0, 0, 90), (0, 0, 0.088, 90), (0, 0.107, 0, 0)),
        convention="modified", kinds="RRRRRRRF", choices={"convention": "modified"},
        poses=(((0,) * 7, (0.088, 0, 0.926)),)),  # upright, the hand hanging down
    Published(
        "PUMA 560 as the toolbox for MATLAB prints it",
        "P. Corke, Robotics Toolbox for MATLAB, the display of mdl_puma560; pose p560.fkine(qz)",
        """
Puma 560 [Unimation]:: 6 axis, RRRRRR, stdDH, fastRNE
+---+-----------+-----------+-----------+-----------+-----------+
| j |     theta |         d |         a |     alpha |    offset |
+---+-----------+-----------+-----------+-----------+-----------+
|  1|         q1|          0|          0|     1.5708|          0|
|  2|         q2|          0|     0.4318|          0|          0|
|  3|         q3|    0.15005|     0.0203|    -1.5708|          0|
|  4|         q4|     0.4318|          0|     1.5708|          0|
|  5|         q5|          0|          0|    -1.5708|          0|
|  6|         q6|          0|          0|          0|          0|
+---+-----------+-----------+-----------+-----------+-----------+
""", ((0, 0, 0, 1.5708), (0, 0, 0.4318, 0), (0, 0.15005, 0.0203, -1.5708), (0, 0.4318, 0, 1.5708),
      (0, 0, 0, -1.5708), (0, 0, 0, 0)),
        angles="rad", choices={"angles": "rad"}, asks=True,
        poses=(((0, 0, 0, 0, 0, 0), (0.4521, -0.1500, 0.4318)),), within=1e-4),
    Published(
        "one link as a command prints it",
        "https://github.com/CharFranR/bombolab book/src/cli/dh-solve.md",
        """
   i | α          | a          | d          | θ
  --+------------+------------+------------+------------
   1 | 0          | L1         | 0          | theta1
""", ((0, 0, 1, 0),), lengths={"L1": 1},
        poses=(((45,), (0.7071, 0.7071, 0)),), within=1e-4),  # printed above it

    # ---- comments and matrices of programs ----
    Published(
        "arm of a lab in a comment of Python",
        "https://github.com/likesh525/6dof-manipulator-kinematics src/robot.py",
        """
#   i | alpha_{i-1} | a_{i-1} (m) | d_i (m) | theta_i offset
#   1 |     0       |    0        | 0.3035  |    180 deg
#   2 |    90       |    0        | 0.082   |     90 deg
#   3 |   180       |   0.49      | 0.082   |     90 deg
#   4 |    90       |    0        | 0.4703  |      0 deg
#   5 |    90       |    0        |  0      |    180 deg
#   6 |    90       |    0        |  0      |      0 deg
""", ((180, 0.3035, 0, 0), (90, 0.082, 0, 90), (90, 0.082, 0.49, 180), (0, 0.4703, 0, 90),
      (180, 0, 0, 90), (0, 0, 0, 90)), convention="modified"),
    Published(
        "Panda as a list of Python",
        "https://github.com/leihui6/DH-Parameters-RobotArm DHParameters.py",
        """
# modified DH parameters [a, alpha, d, theta]
[0, 0, 333 / 1000.0, joints[0]],
[0, -np.pi / 2, 0, joints[1]],
[0, np.pi / 2, 316 / 1000.0, joints[2]],
[82.5 / 1000.0, np.pi / 2, 0, joints[3]],
[-82.5 / 1000.0, -np.pi / 2, 384 / 1000.0, joints[4]],
[0, np.pi / 2, 0, joints[5]],
[88 / 1000.0, np.pi / 2, 107 / 1000.0, joints[6]],
""", ((0, 0.333, 0, 0), (0, 0, 0, -90), (0, 0.316, 0, 90), (0, 0, 0.0825, 90),
      (0, 0.384, -0.0825, -90), (0, 0, 0, 90), (0, 0.107, 0.088, 90)), convention="modified",
        poses=(((0,) * 7, (0.088, 0, 0.926)),)),
    Published(
        "PUMA 560 as a matrix of MATLAB",
        "https://github.com/liamgoss/Puma560 MATLAB/forwardKinematics.m",
        """
% [theta, d, a, alpha]
DH_params = [
    theta1, d1, 0, -pi/2;
    theta2, 0, a2, 0;
    theta3, 0, a3, -pi/2;
    theta4, d4, 0, pi/2;
    theta5, 0, 0, -pi/2;
    theta6, d6, 0, 0;
];
""", ((0, 0.6, 0, -90), (0, 0, 0.43, 0), (0, 0, 0.02, -90), (0, 0.4, 0, 90), (0, 0, 0, -90),
      (0, 0.05, 0, 0)), lengths={"d1": 0.6, "a2": 0.43, "a3": 0.02, "d4": 0.4, "d6": 0.05}),
    Published(
        "Kinova Gen3 as a matrix of MATLAB, comments behind the rows",
        "https://github.com/BanaanKiamanesh/Kinova-Gen3-Control utils/CreateRobot.m",
        """
% Column Order:  a | alpha |  d | theta
dh = [0,   pi, -0.2848,   0   % Joint 1 – Actuator 1
      0, pi/2, -0.0118,  pi   % Joint 2
      0, pi/2, -0.4208,  pi   % Joint 3
      0, pi/2, -0.0128,  pi   % Joint 4
      0, pi/2, -0.3143,  pi   % Joint 5
      0, pi/2,  0.0000,  pi   % Joint 6
      0,   pi, -0.1674,  pi]; % Joint 7  - Interface
""", ((0, -0.2848, 0, 180), (180, -0.0118, 0, 90), (180, -0.4208, 0, 90), (180, -0.0128, 0, 90),
      (180, -0.3143, 0, 90), (180, 0, 0, 90), (180, -0.1674, 0, 180))),
    Published(
        "arm of four joints without headings",
        "https://github.com/freshleesh/Bumblebee dh_params.txt",
        """
theta1, 11.3, 0, 90
theta2 + 90, 0, 13, 0
theta3, 0, 13, 0
theta4, -4, 0, 0
""", ((0, 11.3, 0, 90), (90, 0, 13, 0), (0, 0, 13, 0), (0, -4, 0, 0)),
        choices={"columns": "theta d a alpha"},
        poses=(((0, 0, 0, 0), (0, 4, 37.3)),)),  # upright, the last part beside it
    Published(
        "arm of a course as a matrix of MATLAB, v for the angle",
        "https://github.com/FranciscoVPinto/Lab_G11_RMan "
        "Robotics_Symbolic_Matlab_Toolbox/Robotics_Symbolic_Matlab_Toolbox/RobotX/RobotX.m",
        """
%   Robot=[d v a alpha offset;
Robot = [ 0    q1   0      pi/2   0;
          0    q2  .5      pi/2   pi/2;
          q3   0    0      0     .5];
""", ((0, 0, 0, 90), (90, 0, 0.5, 90), (0, 0.5, 0, 0)), kinds="RRP"),
    Published(
        "UR5 as tuples of Python, the angle left out",
        "https://github.com/dennisgol1/ur5-kinematics-project task1_fk_validation.py",
        """
# Each row: (d_i, a_i, alpha_i).  θ_i is the variable supplied at runtime.
    (0.089159,  0.0,      math.pi / 2),   # Joint 1
    (0.0,      -0.425,    0.0),            # Joint 2
    (0.0,      -0.39225,  0.0),            # Joint 3
    (0.10915,   0.0,      math.pi / 2),   # Joint 4
    (0.09465,   0.0,     -math.pi / 2),   # Joint 5
    (0.0823,    0.0,      0.0),            # Joint 6
""", ((0, 0.089159, 0, 90), (0, 0, -0.425, 0), (0, 0, -0.39225, 0), (0, 0.10915, 0, 90),
      (0, 0.09465, 0, -90), (0, 0.0823, 0, 0)),
        poses=(((0,) * 6, (-0.81725, -0.19145, -0.005491)),), within=1e-6),  # known of the UR5
    Published(
        "PUMA 560 as tuples of Python, units in the names",
        "https://github.com/AdityaSuresh27/puma560-inverse-kinematics-ai "
        "puma560_3dof/train_puma560.py",
        """
# Notation: (a_mm, d_mm, alpha_deg)
DH = [
    (0.0,       671.83,  -90.0),   # Link 1
    (431.8,     139.70,    0.0),   # Link 2
    (-20.32,      0.0,   90.0),   # Link 3
    (0.0,       431.8,   -90.0),   # Link 4
    (0.0,         0.0,   90.0),   # Link 5
    (0.0,        56.5,    0.0),   # Link 6
]
""", ((0, 671.83, 0, -90), (0, 139.7, 431.8, 0), (0, 0, -20.32, 90), (0, 431.8, 0, -90),
      (0, 0, 0, 90), (0, 56.5, 0, 0)), unit="mm"),

    # ---- blanks and tabs: manuals, papers, books ----
    Published(
        "Alpha arm as a matrix in a comment of MATLAB, with an angle by name",
        "https://github.com/hkolano/arm-kinematics-dynamics alphaSetup.m",
        """
    % dhparams in order: [a alpha d theta]
    % dhparams = [20   \tpi/2\t46.2    pi;
    %            150.71\tpi      0       -theta_a;
    %             20      -pi/2\t0   \t-theta_a;
    %             0   \tpi/2\t-180\tpi/2;
    %             0       0       0   \t-pi/2];
""", ((180, 46.2, 20, 90), (0, 0, 150.71, 180), (0, 0, 20, -90), (90, -180, 0, 90), (-90, 0, 0, 0)),
        marked=((2, "theta"), (3, "theta"))),
    Published(
        "KUKA KR 16 with the joints of its controller",
        "https://github.com/kochendoerfer/Denavit-Hartenberg data/DHP-bho.txt",
        """
No    Theta     a    d    alpha
1    -A1    \t260  675 -90
2     A2    \t680  0    0
3     A3 -90   -35   0    90
4     A4   \t\t0   -670 -90
5     A5    \t0    0    90
6     A6    \t0   -158  180
""", ((0, 675, 260, -90), (0, 0, 680, 0), (-90, 0, -35, 90), (0, -670, 0, -90), (0, 0, 0, 90),
      (0, -158, 0, 180)), flips=(1,)),
    Published(
        "WAM of four joints with its tool row",
        "Barrett Technology, WAM Arm User's Manual D1001, table 4",
        """
i   a_i      α_i    d_i    θ_i
1   0        −π/2   0      θ_1
2   0        π/2    0      θ_2
3   0.045    −π/2   0.55   θ_3
4   −0.045   π/2    0      θ_4
T   0        0      0.35   −
""", ((0, 0, 0, -90), (0, 0, 0, 90), (0, 0.55, 0.045, -90), (0, 0, -0.045, 90), (0, 0.35, 0, 0)),
        kinds="RRRRF", poses=(((0, 0, 0, 0), (0, 0, 0.9)),)),  # it stands upright
    Published(
        "Gen3 of seven joints with a row for its base",
        "Kinova, Gen3 Ultra lightweight robot User Guide, 7 DoF spherical classical DH parameters",
        """
i\tαi (radians)\tai (m)\tdi (m)\tθi (radians)
0 (from base)\tπ\t0.0\t0.0\t0
1\tπ/2\t0.0\t−(0.1564 + 0.1284)\tq1
2\tπ/2\t0.0\t−(0.0054 + 0.0064)\tq2 + π
3\tπ/2\t0.0\t−(0.2104 + 0.2104)\tq3 + π
4\tπ/2\t0.0\t−(0.0064 + 0.0064)\tq4 + π
5\tπ/2\t0.0\t−(0.2084 + 0.1059)\tq5 + π
6\tπ/2\t0.0\t0.0\tq6 + π
7 (to interface)\tπ\t0.0\t−(0.1059 + 0.0615)\tq7 + π
""", ((0, 0, 0, 180), (0, -0.2848, 0, 90), (180, -0.0118, 0, 90), (180, -0.4208, 0, 90),
      (180, -0.0128, 0, 90), (180, -0.3143, 0, 90), (180, 0, 0, 90), (180, -0.1674, 0, 180)),
        kinds="FRRRRRRR",
        poses=(((0,) * 7, (0, -0.0246, 1.1873)),)),  # upright, as its drawing has it
    Published(
        "Panda with lengths as letters, two of them by the flange",
        "C. Gaz, M. Cognetti, A. Oliva, P. Robuffo Giordano, A. De Luca, Dynamic identification of "
        "the Franka Emika Panda robot, RA-L 4(4), 2019, modified Denavit-Hartenberg parameters",
        """
i   a_i   α_i     d_i   θ_i
1   0     0       d_1   q_1
2   0     −π/2    0     q_2
3   0     π/2     d_3   q_3
4   a_4   π/2     0     q_4
5   a_5   −π/2    d_5   q_5
6   0     π/2     0     q_6
7   a_7   π/2     0     q_7
8   0     0       d_f   0
""", ((0, 0.333, 0, 0), (0, 0, 0, -90), (0, 0.316, 0, 90), (0, 0, 0.0825, 90),
      (0, 0.384, -0.0825, -90), (0, 0, 0, 90), (0, 0, 0.088, 90), (0, 0.107, 0, 0)),
        convention="modified", kinds="RRRRRRRF", choices={"convention": "modified"},
        lengths={"d1": 0.333, "d3": 0.316, "d5": 0.384, "df": 0.107, "a4": 0.0825, "a5": -0.0825,
                 "a7": 0.088},
        poses=(((0,) * 7, (0.088, 0, 0.926)),)),
    Published(
        "NAO's left leg",
        "N. Kofinas, Forward and Inverse Kinematics for the NAO Humanoid Robot, thesis, "
        "Technical University of Crete 2012, DH parameters for the left leg",
        """
Frame (Joint)\ta\tα\td\tθ
LHipYawPitch\t0\t−3π/4\t0\tθ1 − π/2
LHipRoll\t0\t−π/2\t0\tθ2 + π/4
LHipPitch\t0\tπ/2\t0\tθ3
LKneePitch\t−ThighLength\t0\t0\tθ4
LAnklePitch\t−TibiaLength\t0\t0\tθ5
LAnkleRoll\t0\t−π/2\t0\tθ6
""", ((-90, 0, 0, -135), (45, 0, 0, -90), (0, 0, 0, 90), (0, 0, -100, 0), (0, 0, -102.9, 0),
      (0, 0, 0, -90)), convention="modified", choices={"convention": "modified"},
        lengths={"ThighLength": 100, "TibiaLength": 102.9}),
    Published(
        "arm of the rescue robot Karo, ranges and variables in columns",
        "S. Habibian et al., Design and implementation of a maxi-sized mobile robot (Karo) for "
        "rescue missions, ROBOMECH Journal 8 (2021), table 2, doi:10.1186/s40648-020-00188-9",
        """
Link\tJoint Variable\tri\tαi\tdi\tθi\tRange
1\tθ1\t0\t − 90°\td1\tθ1\t − 80° to 80°
2\tθ3\td2\t − 180°\t0\tθ3− 180°\t0° to 180°
3\tθ3\t0\t − 90°\td3\tθ3− 90°\t0° to 180°
4\td4\t0\t0\td4\t0\t0 m to 0.4 m
5\tθ5\t0\t − 90°\td5\tθ5\t0° to 360°
6\tθ6\td6\t90°\t0\tθ6− 90°\t − 90° to 90°
""", ((0, 0.2, 0, -90), (-180, 0, 0.5, -180), (-90, 0.1, 0, -90), (0, 0, 0, 0), (0, 0.3, 0, -90),
      (-90, 0, 0.06, 90)), kinds="RRRPRR",
        marked=((2, "theta"),),  # a misprint: this row names another row's variable
        lengths={"d1": 0.2, "d2": 0.5, "d3": 0.1, "d5": 0.3, "d6": 0.06}),
    Published(
        "3R arm with Chinese heads",
        "https://html.hanspub.org/file/_1-2340691_3_hanspub.htm",
        """
关节序号\t连杆扭转α\t连杆长度a\t连杆偏移d\t关节转角θ
1\t90\tl0\t0\tθ1
2\t0\tl1\t0\tθ2
3\t0\tl2\t0\tθ3
""", ((0, 0, 0.1, 90), (0, 0, 0.25, 0), (0, 0, 0.2, 0)), lengths={"l0": 0.1, "l1": 0.25, "l2": 0.2},
        poses=(((0, 90, 0), (0.1, 0, 0.45)),)),
    Published(
        "surgical arm of eight joints, blanks in the heads",
        "Pneumatic-type surgical robot end-effector for laparoscopic surgical-operation-by-wire, "
        "BioMedical Engineering OnLine 13:130 (2014), table 1, doi:10.1186/1475-925X-13-130",
        """
Joint\tα i- 1\ta i- 1\td i\tθ i
1\t0\t0\t335\tθ1
2\t‒ π/2\t75\t0\tθ 2 - π/2
3\t0\t270\t0\tθ 3
4\t‒ π/2\t90\t295\tθ 4
5\tπ/2\t0\t0\tθ 5
6\t‒ π/2\t0\t296\tθ 6 + π/2
7\tπ/2\t0\t0\tθ 7 + π
8\t‒ π/2\t58\t0\tθ 8
""", ((0, 335, 0, 0), (-90, 0, 75, -90), (0, 0, 270, 0), (0, 295, 90, -90), (0, 0, 0, 90),
      (90, 296, 0, -90), (180, 0, 0, 90), (0, 0, 58, -90)), convention="modified"),
    Published(
        "PUMA 560 by Armstrong, Khatib and Burdick",
        "B. Armstrong, O. Khatib, J. Burdick, The explicit dynamic model and inertial parameters "
        "of the PUMA 560 arm, ICRA 1986, modified Denavit-Hartenberg parameters",
        """
Link i   α_{i-1} (degrees)   θ_i   a_{i-1} (meters)   d_i (meters)
1        0                   q1    0                  0
2        -90                 q2    0                  0.2435
3        0                   q3    0.4318             -0.0934
4        90                  q4    -0.0203            0.4331
5        -90                 q5    0                  0
6        90                  q6    0                  0
""", ((0, 0, 0, 0), (0, 0.2435, 0, -90), (0, -0.0934, 0.4318, 0), (0, 0.4331, -0.0203, 90),
      (0, 0, 0, -90), (0, 0, 0, 90)), convention="modified",
        poses=(((0,) * 6, (0.4115, 0.1501, 0.4331)),)),
    Published(
        "PUMA 560 by Fu, Gonzalez and Lee, units in its cells",
        "K. S. Fu, R. C. Gonzalez, C. S. G. Lee, Robotics: Control, Sensing, Vision, and "
        "Intelligence, 1987, chapter 2, link coordinate parameters; its check of the arm matrix",
        """
Joint i\tθi\tαi\tai\tdi\tJoint range
1\t90\t−90\t0\t0\t−160 to +160
2\t0\t0\t431.8 mm\t149.09 mm\t−225 to 45
3\t90\t90\t−20.32 mm\t0\t−45 to 225
4\t0\t−90\t0\t433.07 mm\t−110 to 170
5\t0\t90\t0\t0\t−100 to 100
6\t0\t0\t0\t56.25 mm\t−266 to 266
""", ((90, 0, 0, -90), (0, 149.09, 431.8, 0), (90, 0, -20.32, 90), (0, 433.07, 0, -90),
      (0, 0, 0, 90), (0, 56.25, 0, 0)), unit="mm",
        poses=(((0,) * 6, (-149.09, 921.12, 20.32)),)),
    Published(
        "PUMA by Angeles, b for the offset",
        "J. Angeles, Fundamentals of Robotic Mechanical Systems, chapter 5, "
        "DH parameters of a PUMA robot",
        """
i   a_i (m)   b_i (m)   α_i    θ_i
1   0         0.660     90°    θ_1
2   0.432     0         0°     θ_2
3   0.020     0.149     90°    θ_3
4   0         0.432     90°    θ_4
5   0         0         90°    θ_5
6   0         0.056     0°     θ_6
""", ((0, 0.66, 0, 90), (0, 0, 0.432, 0), (0, 0.149, 0.02, 90), (0, 0.432, 0, 90), (0, 0, 0, 90),
      (0, 0.056, 0, 0))),
    Published(
        "Stanford arm by Jazar",
        "R. N. Jazar, Theory of Applied Robotics, chapter 5, DH parameters of the Stanford arm",
        """
Frame No.\tai\tαi\tdi\tθi
1\t0\t−90 deg\tl1\tθ1
2\t0\t90 deg\tl2\tθ2
3\t0\t0\td3\t0
4\t0\t−90 deg\t0\tθ4
5\t0\t90 deg\t0\tθ5
6\t0\t0\tl6\tθ6
""", ((0, 0.412, 0, -90), (0, 0.154, 0, 90), (0, 0, 0, 0), (0, 0, 0, -90), (0, 0, 0, 90),
      (0, 0.263, 0, 0)), kinds="RRPRRR", lengths={"l1": 0.412, "l2": 0.154, "l6": 0.263},
        poses=(((0, 0, 0.5, 0, 0, 0), (0, 0.154, 1.175)),)),
    Published(
        "Stanford arm by Kucuk and Bingul",
        "S. Kucuk, Z. Bingul, Robot Kinematics: Forward and Inverse Kinematics, in Industrial "
        "Robotics, 2006, D-H parameters of the Stanford manipulator, doi:10.5772/5015",
        """
i   θi   αi-1   ai-1   di
1   θ1   0      0      h1
2   θ2   90     0      d2
3   0    -90    0      d3
4   θ4   0      0      0
5   θ5   90     0      0
6   θ6   -90    0      0
""", ((0, 0.412, 0, 0), (0, 0.154, 0, 90), (0, 0, 0, -90), (0, 0, 0, 0), (0, 0, 0, 90),
      (0, 0, 0, -90)), kinds="RRPRRR", convention="modified", lengths={"h1": 0.412, "d2": 0.154},
        poses=(((0, 0, 0.5, 0, 0, 0), (0, -0.154, 0.912)),)),
    Published(
        "Stäubli RX-90 in the notation of Khalil and Kleinfinger, d along x and r along z",
        "W. Khalil, E. Dombre, Modeling, Identification and Control of Robots, chapter 3, "
        "geometric parameters of the Stäubli RX-90",
        """
j   σj   αj     dj   θj   rj
1   0    0      0    θ1   0
2   0    π/2    0    θ2   0
3   0    0      D3   θ3   0
4   0    −π/2   0    θ4   RL4
5   0    π/2    0    θ5   0
6   0    −π/2   0    θ6   0
""", ((0, 0, 0, 0), (0, 0, 0, 90), (0, 0, 0.45, 0), (0, 0.45, 0, -90), (0, 0, 0, 90),
      (0, 0, 0, -90)), convention="modified", lengths={"D3": 0.45, "RL4": 0.45},
        poses=(((0,) * 6, (0.45, 0, 0.45)),)),
    Published(
        "arm for drilling before its calibration, L for the length",
        "An optimization technique for identifying robot manipulator parameters under uncertainty, "
        "SpringerPlus 5:1771 (2016), table 5, its rows 'Original', doi:10.1186/s40064-016-3417-5",
        """
i\tModel\tdi (m)\tθi\tLi (m)\tαi
1\tOriginal\t0.076\tθ1\t0\t90°
2\tOriginal\t0\t90° + θ2\t0.4\t0°
3\tOriginal\t−0.012\tθ3\t0\t90°
4\tOriginal\t0.3543\t0°\t0\t90°
""", ((0, 0.076, 0, 90), (90, 0, 0.4, 0), (0, -0.012, 0, 90), (0, 0.3543, 0, 90)), kinds="RRRF"),
    Published(
        "wrist for rehabilitation with its last frame",
        "Design and development of a modular wrist rehabilitation robot with impedance control and "
        "gravity compensation, Scientific Reports (2025), table 3, doi:10.1038/s41598-025-31185-w",
        """
i\tαi−1(deg)\tai−1(mm)\tdi(mm)\tθi(deg)
1\t−90\t0\t0\t−90+θ1
2\t90\t0\t0\t90+θ2
3\t90\t0\t0\t180+θ3
EE\t0\ta3\t0\t0
""", ((-90, 0, 0, -90), (90, 0, 0, 90), (180, 0, 0, 90), (0, 0, 120, 0)),
        convention="modified", kinds="RRRF", unit="mm", lengths={"a3": 0.12}),
)
