// Numbers as they are typed into a field: what kinlab/tables/numbers.py and cells.py read in a
// cell, and a decimal comma where it can mean nothing else. Nothing is evaluated as code.

/** @typedef {{ value: number, angle: boolean }} Part of a formula, and whether it has a unit */

export const LARGEST = 1e100;
const MOST_CHARACTERS = 200, LARGEST_POWER = 100, DEGREE = Math.PI / 180;
const LARGEST_ANGLE = 1e4;                          // rad, some 1,600 turns
const SMALLEST_LENGTH = 1e-9, LARGEST_LENGTH = 1e9;
const UNITS = new Map([["deg", DEGREE], ["rad", 1]]);
const KNOWN = new Map([["pi", Math.PI], ...UNITS]);
const FUNCTIONS = new Map([["sqrt", Math.sqrt], ["sin", Math.sin], ["cos", Math.cos]]);
// What keyboards and word processors write for the same signs.
const SPELLINGS = [["°", " deg "], ["º", " deg "], ["π", " pi "], ["−", "-"], ["–", "-"],
                   ["×", "*"], ["·", "*"], ["^", "**"]];
const NUMBER = "(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?";
const TOKEN = new RegExp(`\\s*(?:(${NUMBER})|([A-Za-z_][A-Za-z_0-9]*)|(\\*\\*|[-+*/()]))`, "y");
const PLAIN = new RegExp(`^[-+]?${NUMBER}$`);
const PI = /π|\bpi\b/;
// A comma in a number, which is no decimal one where it may stand between thousands.
const COMMA = /([0-9.]*),([0-9]+)(?=([,.]?))/g, THOUSANDS = /^[1-9][0-9]{0,2}$/;

class Refused extends Error {}

/** @type {(condition: boolean, reason: string) => void} */
function refuseIf(condition, reason) {
  if (condition) throw new Refused(reason);
}

/**
 * The number that a student typed, in the field's unit, or why it is none, in one sentence.
 *
 * Numbers, pi, + - * / **, brackets, sqrt sin cos, and deg, ° and rad behind what they belong to.
 * An angle without a unit is in the field's, but in radians where pi stands in it.
 * @param {string} text
 * @param {{ angle: boolean, unit: string }} field its unit is "°" or "rad" if it holds an angle
 * @returns {{ value: number, reason?: undefined } | { value?: undefined, reason: string }}
 */
export function read(text, { angle, unit }) {
  try {
    return { value: angle ? angleIn(unit, text) : lengthIn(unit, text) };
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    const such = angle ? "-90 deg or pi/2" : "177.8 or 3/4";
    return { reason: `${quoted(text)}: expected a number such as ${such}; ${error.message}` };
  }
}

/** @type {(unit: string, text: string) => number} */
function angleIn(unit, text) {
  const part = formula(text), ofPi = PI.test(text), radians = part.angle || ofPi;
  refuseIf(unit !== "rad" && ofPi && !part.angle && !scalesWithPi(text, part.value),
           "pi is in radians and other numbers are in degrees; " +
           "write pi/2 rad + 90 deg, or write pi as 180");
  const scale = unit === "rad" ? 1 : DEGREE, value = radians ? part.value : part.value * scale;
  refuseIf(Math.abs(value) > LARGEST_ANGLE,
           "an angle has at most 1,600 turns, look for a slip in a unit or an exponent");
  return radians && scale !== 1 ? degrees(value) : part.value;
}

/**
 * Whether a formula is a multiple of pi, so that all of it is in radians.
 * @param {string} text
 * @param {number} once its value
 */
function scalesWithPi(text, once) {
  try {
    const { value: twice } = formula(text, 2 * Math.PI);
    return Math.abs(twice - 2 * once) <= 1e-12 * Math.max(Math.abs(twice), 1);
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    return false;
  }
}

/**
 * The shortest number of degrees that is this angle: 45 deg must come back as 45.
 * @param {number} angle in radians
 */
function degrees(angle) {
  for (let digits = 6; digits < 17; digits++) {
    const value = Number((angle / DEGREE).toPrecision(digits));
    if (Math.abs(value * DEGREE - angle) <= 1e-15 * Math.abs(angle)) return value;
  }
  return angle / DEGREE;
}

/** @type {(unit: string, text: string) => number} */
function lengthIn(unit, text) {
  const { value, angle } = formula(text), size = Math.abs(value);
  refuseIf(angle, "no angle belongs here, leave out deg and rad");
  if (size < SMALLEST_LENGTH && value && !PLAIN.test(pointed(text))) return 0;   // cos(pi/2)
  refuseIf(value !== 0 && !(size >= SMALLEST_LENGTH && size <= LARGEST_LENGTH),
           `between 1e-9 and 1e9${unit && " "}${unit}, or 0; look for a slip in the exponent`);
  return value;
}

/**
 * The text with its decimal commas as points.
 * @param {string} text
 */
function pointed(text) {
  return text.replace(COMMA, (whole, before, after, then) => {
    refuseIf(then !== "" || before === "" || before.includes("."),
             "write the decimal point as . and nothing between thousands");
    refuseIf(after.length === 3 && THOUSANDS.test(before),
             `${whole} may be ${before}.${after} or ${before}${after}, write it without the comma`);
    return `${before}.${after}`;
  });
}

/**
 * The value of the text, angles with a unit in radians.
 * @param {string} text
 * @param {number} pi what stands for pi in it
 */
function formula(text, pi = Math.PI) {
  refuseIf(text.length > 2 * MOST_CHARACTERS || [...text].length > MOST_CHARACTERS,
           `it has more than ${MOST_CHARACTERS} characters, work part of it out first`);
  const { value, angle } = valueOf(tokensOf(pointed(text)), pi);
  refuseIf(!(Math.abs(value) <= LARGEST), "it is too large");
  return { value: value + 0, angle };               // no -0
}

/**
 * What a grammar of operators and brackets can read; a unit multiplies what stands before it.
 * @param {string} typed
 */
function tokensOf(typed) {
  const text = SPELLINGS.reduce((so, [written, meant]) => so.replaceAll(written, meant), typed)
    .trimEnd();
  refuseIf(!text, "the field is empty");
  /** @type {string[]} */
  const tokens = [];
  let before = "";
  for (TOKEN.lastIndex = 0; TOKEN.lastIndex < text.length;) {
    const start = TOKEN.lastIndex, match = TOKEN.exec(text);
    if (!match) {
      const [strange] = text.slice(start).trimStart();
      throw new Refused(strange === "," ? "write the decimal point as . and not as ,"
        : `${quoted(strange)} has no place in a number`);
    }
    const [, number, name, sign] = match, token = number ?? name ?? sign;
    checkToken(number, name, token, before);
    tokens.push(...(UNITS.has(token) ? ["*", token] : [token]));
    before = token;
  }
  return tokens;
}

/**
 * Refuse a token that cannot stand behind the one before it.
 * @param {string | undefined} number
 * @param {string | undefined} name
 * @param {string} token
 * @param {string} before
 */
function checkToken(number, name, token, before) {
  const ended = /[)A-Za-z0-9._]$/.test(before), unit = UNITS.has(token);
  refuseIf(number != null && !Number.isFinite(Number(number)), "it is too large");
  refuseIf(name != null && !KNOWN.has(token) && !FUNCTIONS.has(token),
           `${quoted(token)} is not known; known are ${[...KNOWN.keys()].join(", ")}`);
  refuseIf(unit && !ended, `put a number before ${token}`);
  refuseIf(ended && !unit && (name != null || token === "(") && !FUNCTIONS.has(before),
           `put an operator before ${token}`);
}

/**
 * The value of a formula, by recursive descent: sums of products of signed powers.
 * @param {string[]} tokens
 * @param {number} pi
 * @returns {Part}
 */
function valueOf(tokens, pi) {
  let at = 0;
  const missing = "look for a missing operator or bracket";
  const expect = (/** @type {string} */ token) => refuseIf(tokens[at++] !== token, missing);
  /** @type {(operators: string[], operand: () => Part) => Part} */
  const chain = (operators, operand) => {
    let value = operand();
    while (operators.includes(tokens[at])) value = combined(tokens[at++], value, operand());
    return value;
  };
  const sum = () => chain(["+", "-"], product);
  const product = () => chain(["*", "/"], signed);
  /** @type {() => Part} */
  const signed = () => {
    if (tokens[at] === "+") { at += 1; return signed(); }
    if (tokens[at] !== "-") return power();
    at += 1;
    const { value, angle } = signed();
    return { value: -value, angle };
  };
  const power = () => {
    const base = single();
    if (tokens[at] !== "**") return base;
    at += 1;
    return combined("**", base, signed());
  };
  /** @type {() => Part} */
  const single = () => {
    const token = tokens[at++], call = FUNCTIONS.get(token);
    const known = token === "pi" ? pi : KNOWN.get(token);
    if (known != null) return { value: known, angle: UNITS.has(token) };
    if (call) return applied(token, call, bracketed());
    if (token === "(") { at -= 1; return bracketed(); }
    refuseIf(token == null || !/[0-9]/.test(token), missing);
    return { value: Number(token), angle: false };
  };
  const bracketed = () => {
    expect("(");
    const value = sum();
    expect(")");
    return value;
  };
  const whole = sum();
  refuseIf(at < tokens.length, missing);
  return whole;
}

/** @type {(name: string, call: (x: number) => number, argument: Part) => Part} */
function applied(name, call, { value, angle }) {
  refuseIf(name === "sqrt" && angle, "an angle has no square root");
  refuseIf(name === "sqrt" && value < 0, "a root of a negative number is not real");
  return { value: call(value), angle: false };
}

/** @type {Record<string, (a: number, b: number) => number>} */
const OPERATORS = { "+": (a, b) => a + b, "-": (a, b) => a - b, "*": (a, b) => a * b,
                    "/": (a, b) => a / b, "**": (a, b) => a ** b };

/** @type {(sign: string, left: Part, right: Part) => Part} */
function combined(sign, left, right) {
  const a = left.value, b = right.value;
  if (sign === "+" || sign === "-") {
    refuseIf(left.angle !== right.angle, "give every angle of the sum its unit: deg or rad");
  } else {
    refuseIf(right.angle && (left.angle || sign !== "*"),
             "an angle may be multiplied or divided only by a number");
  }
  if (sign === "**") {
    refuseIf(left.angle || Math.abs(b) > LARGEST_POWER,
             `expected a power of a number, up to ${LARGEST_POWER}`);
    refuseIf(a < 0 && !Number.isInteger(b), "a root of a negative number is not real");
  }
  refuseIf((sign === "/" && b === 0) || (sign === "**" && a === 0 && b < 0), "it divides by zero");
  const value = OPERATORS[sign](a, b);
  refuseIf(!(Math.abs(value) <= LARGEST), "it is too large");   // nor is it NaN
  return { value, angle: left.angle || right.angle };
}

/** @type {(text: string) => string} */
function quoted(text) {
  const start = [...text.slice(0, 82)];
  const brief = start.length > 40 ? `${start.slice(0, 40).join("")}…` : text;
  return `'${brief}'`;
}
