/**
 * What Python sends to the browser (kinlab/drawing/scene.py, kinlab/views), and what modules hand
 * each other. TypeScript reads this when the JavaScript is checked; nothing of it is loaded.
 */

/** Python's None: null, or undefined where Python runs in the browser itself. */
export type Nothing = null | undefined;

/** Three coordinates. */
export type Triple = number[];

/** The directions x, y and z of a frame and its origin, in the room. */
export type Frame = Triple[];

/** A point of a frame: the frame's number, then x, y, z there. */
export type Point = number[];

/** A turn about, or a slide along, one of the frame's own axes; what is usual is left out. */
export interface Elementary {
  kind: "rotate" | "translate";
  axis: number;
  amount?: number;
  joint?: number | Nothing;
  gain?: number;
  start?: number | Nothing;
  parent?: number | Nothing;
  scrub?: { knob: number; start: number } | Nothing;
  track?: number[] | Nothing;
}

/** A column of the Jacobian, or without a joint the ellipsoid of all velocities, of an origin. */
export interface Velocity {
  kind: "velocity";
  of: number;
  rates: number[];
  joint?: number | Nothing;
  parent?: Nothing;
}

export type Motion = Elementary | Velocity;

export type Shape = "line" | "trace" | "face" | "arrow" | "hull" | "text" | "tube" | "ball" |
  "box" | "axis" | "name" | "sweep" | "patch" | "way" |
  "area" | "cloud";

/**
 * One drawn thing; Item in kinlab/drawing/scene.py says what `points` and `size` are in each
 * shape. `part`, `frame`, `joint` (from 1) and `link` (from 0, the base) say what it is a picture
 * of, `when` for which values of a knob it is there. What is usual is left out.
 */
export interface Item {
  gid: string;
  shape: Shape;
  style: string;
  points: Point[];
  body?: number;
  layer?: string;
  text?: string;
  lift?: number;
  size?: number[];
  part?: string;
  frame?: string;
  joint?: number | Nothing;
  link?: number | Nothing;
  when?: [knob: number, low: number, high: number] | Nothing;
}

/**
 * The ground at a height: lines `step` apart as far as `reach`, and frames from whose origins a
 * line is dropped on it, with numbers of so many decimals.
 */
export interface Floor {
  height: number;
  step: number;
  reach: number;
  drops: number[];
  decimals: number;
}

/** A ball round the arm at home, the radius of its joints, and what has to be seen besides. */
export interface Fit { middle: Triple; radius: number; thick: number; points: Point[] }

/**
 * How a style is painted: attributes of SVG; a solid's ramps go from shade by a middle to light.
 */
export interface Paint extends Record<string, unknown> {
  fill?: string;
  words?: string;
  stroke?: string;
  ramp?: string[];
  hub?: string[];
  cap?: boolean;
  /** Whether it always steps back into the paper. */
  faded?: boolean;
}

export interface Vector {
  kind: "vector";
  tail: Point;
  head: Point;
  frame: number;
  size: number;
  scale: number;
}
export interface Distance { kind: "distance"; tail: Point; head: Point }
export interface Amount { kind: "amount"; step: number }
export interface Volume { kind: "volume"; ellipsoid: number; size: number; scale: number }
export interface Entry { kind: "entry"; knob: number; texts: string[] }
/** How a frame is turned from the room. */
export interface Turned { kind: "quaternion" | "axis" | "angle" | "rpy"; frame: number }
export type Part = Vector | Distance | Amount | Volume | Entry | Turned;

/** A formula under the picture: words before, between and after its parts. */
export interface Reading {
  name: string;
  words: string[];
  parts: Part[];
}

/** What one slider drives, in the scene's units; shown divided by `scale`. */
export interface Knob {
  name: string;
  label: string;
  title: string;
  quantity: string;
  unit: string;
  suffix: string;
  low: number;
  high: number;
  home: number;
  scale: number;
  step: number;
  digits: number;
  /** Its whole numbers are stages: steps and Play go from one to the next. */
  whole?: boolean;
  /** What two knobs that are the two ends of one range share; the lower end comes first. */
  pair?: string;
  /** What its whole numbers are called, each on a button. */
  names?: string[];
}

/** Whole steps between limits, in the slider's units. */
export interface Stops { low: number; high: number; step: number }

/** A switch of the picture. */
export interface Layer { layer: string; label: string; title: string; on: boolean }

/** The matrix of the tool's frame. */
export interface Pose {
  title: string;
  columns: { name: string; title?: string }[];
  rows?: number | Nothing;
  base?: number | Nothing;
  decimals: number;
  unit: string;
  said?: string | Nothing;
}

/** A target that the first `joints` joints follow with the frame `tip`. */
export interface Target {
  frame: number;
  tip: number;
  joints: number;
  knobs: number[];
  unit: string;
}

/**
 * A point that a hand drags: the knobs with these numbers bring it to the hand. Its place is told
 * in `unit`.
 */
export interface Handle {
  name: string;
  point: Point;
  knobs: number[];
  unit: string;
}

/** Curves over counted steps, as Chart in kinlab/drawing/chart.py. */
export interface ChartScene {
  curves: { name: string; style: string; marker: string; values: number[] }[];
  across: string;
  up: string;
  knob: number;
  last: number;
  low: number;
  high: number;
}

/** A curve on the picture: gone, still to come, and markers on the steps that are gone (px). */
export interface Track { gone: number[][]; markers: number[][] }

/** A chart laid out on a picture, in px. */
export interface Plot {
  box: [left: number, top: number, right: number, bottom: number];
  across: [right: number, text: string][];
  up: [down: number, text: string][];
  tracks: Track[];
  legend: [right: number, text: string][];
}

/** Curves of one kind over the same times, as Panel in kinlab/drawing/timed.py. */
export interface Panel {
  title: string;
  layer: string;
  low: number;
  high: number;
  courses: { name: string; style: string; values: number[]; unit: string;
             joint: number | Nothing }[];
  bounds: { level: number; style: string; joint: number }[];
  bands: { start: number; end: number; joint: number }[];
}

/** Panels over the times that the first knob runs through, and what is said under the picture. */
export interface Timed {
  times: number[];
  panels: Panel[];
  remarks: { text: string; joint: number }[];
}

/** A panel laid out on a picture, in px. */
export interface PanelPlot {
  box: [left: number, top: number, right: number, bottom: number];
  across: [right: number, text: string][];
  up: [down: number, text: string][];
  zero: number | null;
  whole: number[][][];
  gone: number[][][];
  bounds: number[];
  bands: [from: number, to: number][];
  signs: [right: number, down: number][];
  now: number;
}

export interface Scene {
  name: string;
  motions: Motion[];
  items: Item[];
  paints: Record<string, Paint>;
  readings: Reading[];
  tip: number;
  center: Triple;
  focus: number | Nothing;
  scale: number;
  radius: number;
  size: [width: number, height: number];
  wide: boolean;
  presets: Record<string, [azimuth: number, elevation: number]>;
  preset: string;
  /** Axes that one looks along by a button: "z₁". */
  sights?: string[];
  decimals: number;
  knobs: Knob[];
  layers: Layer[];
  pose: Pose | Nothing;
  target: Target | Nothing;
  handles: Handle[];
  home: number[];
  /** Where Zero moves the knobs; one that is no joint stays. */
  zero: (number | null)[] | Nothing;
  poses: number[][];
  floor: Floor | Nothing;
  fit: Fit | Nothing;
  chart: ChartScene | Nothing;
  timed?: Timed | Nothing;
  /** The axis across the plane in which its first handle comes to the pointer from anywhere. */
  across?: number;
}

/** A scene whose joints follow a target. */
export type TargetScene = Scene & { target: Target };

/** What a hand, a focus or a word points at: joints and links by number, frames by name. */
export interface Spot { joints?: number[]; frames?: string[]; links?: number[] }

/** All that lights up then: a joint with its link, its frame and the one before. */
export interface Pointed { joints: Set<number>; frames: Set<string>; links: Set<number> }

/** Where a picture is seen from, angles in degrees. */
export interface Camera {
  azimuth: number;
  elevation: number;
  zoom: number;
  perspective?: boolean;
}

/**
 * What a camera makes of the room at one pose: `see` takes a point to [right, down] on the picture
 * (px) and the size of things there (1 without perspective), `eye` gives the direction from a
 * point to the viewer, `turn` a direction's components to the right, up and towards the viewer.
 */
export interface Lens {
  right: Triple;
  up: Triple;
  near: Triple;
  scale: number;
  shrunk: number;
  see(point: Triple): Triple;
  eye(point: Triple): Triple;
  turn(direction: Triple): Triple;
}

/** Levels from one place on the picture (px) straight to another; OFFSETS says where. */
export interface Across { from: number[]; to: number[]; levels: number[] }

/** Levels from a place on the picture (px) outwards. */
export interface Round { center: number[]; radius: number; levels: number[] }

/**
 * A part of a solid on the picture: its closed outline (px), of a mark an open line, with one
 * level of its ramp (a hub's own) or a gradient. A mark is a plain line.
 */
export interface Face {
  role: "side" | "cap" | "hub" | "mark" | "face";
  points: number[][];
  level: number | null;
  gradient: Across | Round | null;
}

/** Values of the knobs in the scene's units: to read and write, and to hear of. */
export interface Drive { read(): number[]; write(q: number[]): void }
export interface Joints extends Drive {
  listen(callback: () => void): () => void;
  /** Names of the joints whose sliders a hand holds: nobody else moves them meanwhile. */
  gripped?: Set<string>;
}

/** What a solve came to; the error is in the scene's length. */
export interface Solved { q: number[]; steps: number; error: number }

/** What a view tells its next one, so that it is looked at in the same way. */
export interface Looks {
  began: string;
  preset: string;
  camera: Camera;
  shown: Record<string, boolean>;
  controls: import("./controls.js").Controls;
  plan: import("./plan.js").Plan;
}

/** One case of a prediction, as kinlab/answers/prediction.py and kinlab/views/prediction.py. */
export interface Asked {
  kind: "choice" | "several" | "number" | "signs" | "mark" | "direction";
  ask: string;
  why: string;
  seen: string;
  /** All knobs while it is open; the view's own once it is answered, and the mark's place then. */
  start: number[];
  shows: number[];
  origin: number[];
  /** Where the mark belongs, or the degrees of the arrow. */
  truth: any;
  /** These belong to some kinds only. */
  right: any;
  options: [text: string, said: string][];
  tolerance: number;
  unit: string;
  slips: [wrong: any, said: string][];
  turn: number;
  rows: string[];
  columns: string[];
  among: [letter: string, meaning: string][];
  axes: string;
  about: string;
  of: string;
}

/** A prediction: its cases, and the number of the first knob of the mark. */
export interface Question { name: string; first: number; cases: Asked[] }

/** What is said to an answer. */
export interface Told { ok: boolean; said: string }

/** An answer that was committed, null for no guess. */
export interface Answer { case: number; answer: any }

/** What is asked now and what has been answered: to read and write, and to hear of. */
export interface Sheet {
  question: Question;
  /** Whether the answers come from before this view: its knobs do not know of them. */
  restored?: boolean;
  read(): { record: Answer[]; case: number };
  write(record: Answer[], now: number): void;
  listen(callback: () => void): () => void;
}

/** A view that stands in a page. */
export interface Live {
  go(q: number[]): void;
  /** Begin the trace anew. */
  clear(): void;
  note(text: string): void;
  point(spot: Spot | null, source?: import("./pointing.js").Source): void;
  leave(): Looks;
  dismount(): void;
}

/** The model that anywidget gives. */
export interface Model {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(content: unknown): void;
  on(event: string, callback: () => void): void;
  off(event: string, callback: () => void): void;
  widget_manager?: any;
}

/** What anywidget gives to show a widget. */
export interface Host { model: Model; el: HTMLElement }

/** A cell of the table editor: what is typed, why it cannot be read, what it reads as, and what is
 *  odd about it. */
export interface Cell { text: string; error: string; reads?: string; hint?: string; unit: string }

export interface Row {
  key: number;
  kind: string;
  name: string;
  variable: string | null;
  joint: number;
  flip: boolean;
  locked: boolean;
  cells: Record<string, Cell>;
}

/** The base or the tool of a table: how it is typed, and its cells. */
export interface End { form: string; cells: Record<string, Cell> }

/** What kinlab/views/table_editor.py tells of its table. */
export interface TableState {
  rows: Row[];
  columns: string[];
  convention: string;
  conventions: string[];
  angles: string;
  unit: string;
  units: string[];
  lengths: (Cell & { name: string })[];
  ends: Record<string, End | null>;
  undo: boolean;
  redo: boolean;
  open: string;
  said: string;
  question: { text: string; options: string[] } | null;
  wrong: number;
  texts: Record<string, string>;
}

/** A field that remembers the text that Python knows, and whether nobody types in it. */
export type Field = (HTMLInputElement | HTMLTextAreaElement) &
  { committed?: string; resting?: boolean };
