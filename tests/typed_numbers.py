"""Numbers as students type them, good and bad, and random texts that are hardly numbers."""
import math
import random

NAMES = {"d2": 500, "a2": 0.3, "L_off": 0.2}
PIECES = ["1", "90", ".5", "1e3", "9" * 40, "1e308", "1e-320", "pi", "π", "d2", "a2", "x", "deg",
          "°", " rad", "+", "-", "*", "/", "**", "^", "//", "%", "(", ")", "sqrt(", "sin(", "cos",
          "(1e99*1e99)", "(9e307*9-9e307*9)",
          ",", ".", "_", "j", "0x", "lambda:", "__import__('os')", "[", "{", "'", '"', "\\", "\n",
          "\x00", "\ud800", "١", "²", "−", " if ", " for ", "None", "True", "=", ":=", "@", "~",
          "!", "🦾", "9**9**9**9", "((((", "----", "e", "E5", "inf", "nan", "await ", "#", ";"]
GOOD = {
    "-90 deg": -math.pi / 2, "90°": math.pi / 2, "90º": math.pi / 2, "90deg": math.pi / 2,
    "−45 °": -math.pi / 4, "pi/2": math.pi / 2, "π/2": math.pi / 2, "-pi": -math.pi,
    "2*pi rad": 2 * math.pi,
    "177.8": 177.8, ".5": 0.5, "5.": 5, "007": 7, "1e3": 1000, "-1.5E-2": -0.015, "+3": 3,
    "-d2": -500, "d2/2 + a2": 250.3, "L_off": 0.2, "sqrt(2)/2": math.sqrt(2) / 2,
    "2^3": 8, "2**-1": 0.5, "-2**2": -4, "(-2)**2": 4, "2**0.5": 1.4142135623730951,
    "3*(1+2)": 9, "sin(30 deg)": math.sin(math.pi / 6),
    "cos (pi)": -1, "(30+15) deg": math.pi / 4, "45 deg + pi/4 rad": math.pi / 2,
    "2 * 45 deg": math.pi / 2, "180 deg/2": math.pi / 2, "-0": 0, " 7 \t": 7,
}
BAD = {
    "": "empty", "   ": "empty", "1,5": "decimal point as .", "45 + 45 deg": "its unit",
    "pi + 90 deg": "its unit", "deg": "put a number before deg", "2*deg": "put a number before",
    "2pi": "put an operator before pi", "2 d2": "put an operator before d2",
    "2(3)": r"put an operator before \(", "(1)(2)": r"put an operator before \(",
    "1 2": "missing operator", "(1": "bracket", "1)": "bracket", "1.5.2": "missing operator",
    "sqrt 2": "bracket", "sqrt": "brackets", "sqrt()": "brackets", "()": "brackets",
    "sqrt(-1)": "not real", "(-8)**(1/3)": "not real", "sqrt(4 deg)": "no square root",
    "1/0": "divides by zero", "0**-1": "divides by zero", "1e999": "too large",
    "9**9**9**9": "power", "99**99": "too large", "sin(1e308*10)": "too large",
    "1/(1e308*10)": "too large",
    "(-1)**(1e308*10 - 1e308*10)": "too large", "1e99*1e99": "too large", "2**(2 deg)": "number",
    "1 deg * 1 deg": "multiplied", "x": "'x' is not known; known are d2",
    "0x10": "'x10' is not known", "1_000": "'_000' is not known", "1j": "'j' is not known",
    "None": "not known", "inf": "not known", "nan": "not known", "lambda: 1": "not known",
    "__import__('os').system('ls')": "not known",
    "3 // 2": "missing operator", "3 % 2": "no place", "a2 = 3": "no place", "[1]": "no place",
    "'1'": "no place", "1\x00": "no place", "١": "no place", "2²": "no place", "\ud800": "no place",
    "1;2": "no place", "1 # one": "no place", "(" * 100 + "1": "bracket",
    "1" * 201: "200 characters", "x" * 10 ** 6: "got 1000000",
}


def formula(rng, depth=0):
    """A formula that the grammar allows, of numbers at the edge of what a double holds."""
    if depth > 4 or rng.random() < 0.2:
        return rng.choice(["1e308", "1e-320", "0", "-1", "0.5", "100", "pi", "d2", "9 deg", "1e99"])
    left, right = formula(rng, depth + 1), formula(rng, depth + 1)
    return rng.choice([f"({left}){rng.choice(['+', '-', '*', '/', '**'])}({right})",
                       f"{rng.choice(['sin', 'cos', 'sqrt', '-', ''])}({left})"])


def strings(count):
    """Random pieces, characters and formulas, and good numbers with one character changed."""
    rng = random.Random(1)
    for turn in range(count):
        if turn % 4 == 0:
            yield "".join(rng.choices(PIECES, k=rng.choice((1, 2, 3, 5, 8, 30))))
        elif turn % 4 == 1:
            yield formula(rng)
        elif turn % 4 == 2:
            yield "".join(map(chr, rng.choices(range(0x110000 if rng.random() < 0.5 else 128),
                                               k=rng.choice((1, 3, 10, 150)))))
        else:
            text = rng.choice(list(GOOD))
            at = rng.randrange(len(text) + 1)
            yield text[:at] + rng.choice(PIECES) + text[at + rng.randrange(2):]
