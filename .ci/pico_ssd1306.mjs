// An SSD1306 with its glass of 128 × 64 pixels, at an I²C bus, as the data sheet (Solomon Systech, rev. 1.1) has it.
//
// Strict: what a real one would ignore, or do something surprising for, is a problem that is written down. Wired as on
// the usual modules: the picture is upright with segments remapped (A1h) and rows scanned backwards (C8h).

export const WIDTH = 128;
export const HEIGHT = 64;
const PAGES = HEIGHT / 8;

// Each command: first and last byte, the values that each argument may have, and what it does.
const any = () => true;
const upTo = (most) => (value) => value <= most;
const oneOf = (...values) => (value) => values.includes(value);

const COMMANDS = [
  [0x00, 0x0f, [], (s, op) => s.inPageMode(op) && (s.column = (s.column & 0x70) | op)],
  [0x10, 0x17, [], (s, op) => s.inPageMode(op) && (s.column = (s.column & 0x0f) | ((op & 7) << 4))],
  [0x20, 0x20, [upTo(2)], (s, _, mode) => (s.mode = ['horizontal', 'vertical', 'page'][mode])],
  [0x21, 0x21, [upTo(WIDTH - 1), upTo(WIDTH - 1)], (s, op, first, last) => s.window(op, 'column', first, last)],
  [0x22, 0x22, [upTo(PAGES - 1), upTo(PAGES - 1)], (s, op, first, last) => s.window(op, 'page', first, last)],
  [0x2e, 0x2e, [], () => {}], // Scrolling off.
  [0x40, 0x7f, [], (s, op) => (s.startLine = op & 0x3f)],
  [0x81, 0x81, [any], (s, _, contrast) => (s.contrast = contrast)],
  [0x8d, 0x8d, [oneOf(0x10, 0x14)], (s, _, pump) => (s.chargePump = pump === 0x14)],
  [0xa0, 0xa1, [], (s, op) => (s.segmentsRemapped = op === 0xa1)],
  [0xa4, 0xa5, [], (s, op) => (s.allOn = op === 0xa5)],
  [0xa6, 0xa7, [], (s, op) => (s.inverse = op === 0xa7)],
  [0xa8, 0xa8, [(rows) => rows >= 15 && rows <= 63], (s, _, rows) => (s.multiplex = rows + 1)],
  [0xae, 0xaf, [], (s, op) => s.turn(op === 0xaf)],
  [0xb0, 0xb7, [], (s, op) => s.inPageMode(op) && (s.page = op & 7)],
  [0xc0, 0xc0, [], (s) => (s.rowsBackwards = false)],
  [0xc8, 0xc8, [], (s) => (s.rowsBackwards = true)],
  [0xd3, 0xd3, [upTo(63)], (s, _, rows) => (s.offset = rows)],
  [0xd5, 0xd5, [any], () => {}], // Clock.
  [0xd9, 0xd9, [(phases) => (phases & 0x0f) > 0 && phases >> 4 > 0], () => {}], // Precharge.
  [0xda, 0xda, [oneOf(0x02, 0x12, 0x22, 0x32)], (s, _, pins) => (s.rowPins = pins)],
  [0xdb, 0xdb, [oneOf(0x00, 0x10, 0x20, 0x30, 0x40, 0x50, 0x60, 0x70)], () => {}], // Deselect level.
  [0xe3, 0xe3, [], () => {}], // Nothing.
];

const hex = (byte) => `${byte.toString(16).toUpperCase().padStart(2, '0')}h`;

export class Ssd1306 {
  // As it is after a reset.
  mode = 'page';
  column = 0;
  page = 0;
  columns = [0, WIDTH - 1];
  pages = [0, PAGES - 1];
  startLine = 0;
  offset = 0;
  contrast = 0x7f;
  multiplex = 64;
  rowPins = 0x12;
  segmentsRemapped = false;
  rowsBackwards = false;
  inverse = false;
  allOn = false;
  chargePump = false;
  on = false;

  // What is in its memory after power-up is anything: noise here. By segments, not by columns.
  memory = Uint8Array.from({ length: WIDTH * PAGES }, (_, at) => (at * 0x9e3779b1) >>> 24);
  pending = [];
  problems = new Set();
  transfer = null;
  // Called when all of the window is written, in horizontal or vertical mode.
  onFrame = () => {};

  problem(what) {
    this.problems.add(what);
  }

  // ------------------------------------------------------------------------ the bus

  start() {
    this.transfer = { kind: 'control' };
  }

  stop() {
    if (this.transfer?.kind === 'one command' || this.transfer?.kind === 'one data byte') {
      this.problem('a transfer ends behind its control byte');
    }
    this.transfer = null;
  }

  write(byte) {
    switch (this.transfer?.kind) {
      case 'control':
        return this.control(byte);
      case 'commands':
        return this.command(byte);
      case 'data':
        return this.data(byte);
      case 'one command':
        this.transfer.kind = 'control';
        return this.command(byte);
      case 'one data byte':
        this.transfer.kind = 'control';
        return this.data(byte);
      default:
        this.problem('a byte outside of a transfer');
    }
  }

  control(byte) {
    const kinds = { 0x00: 'commands', 0x40: 'data', 0x80: 'one command', 0xc0: 'one data byte' };
    if (!(byte in kinds)) this.problem(`control byte ${hex(byte)}`);
    this.transfer.kind = kinds[byte] ?? 'ignored';
  }

  // ------------------------------------------------------------------------ commands

  command(byte) {
    this.pending.push(byte);
    const [op, ...values] = this.pending;
    const command = COMMANDS.find(([first, last]) => first <= op && op <= last);
    if (!command) {
      this.problem(`unknown command ${hex(op)}`);
      this.pending = [];
      return;
    }
    const [, , checks, act] = command;
    if (values.length < checks.length) return;
    this.pending = [];
    if (checks.every((check, at) => check(values[at]))) act(this, op, ...values);
    else this.problem(`command ${hex(op)} with ${values.map(hex).join(', ')}`);
  }

  inPageMode(op) {
    if (this.mode !== 'page') this.problem(`command ${hex(op)}, which is of the page mode, in ${this.mode} mode`);
    return this.mode === 'page';
  }

  window(op, what, first, last) {
    if (this.mode === 'page') return this.problem(`command ${hex(op)} in page mode`);
    if (first > last) return this.problem(`command ${hex(op)}: from ${first} to ${last}`);
    this[`${what}s`] = [first, last];
    this[what] = first;
  }

  turn(on) {
    if (on && !this.chargePump) this.problem('switched on before its charge pump');
    this.on = on;
  }

  // ------------------------------------------------------------------------ data

  data(byte) {
    if (this.pending.length > 0) {
      this.problem(`data before the arguments of command ${hex(this.pending[0])}`);
      this.pending = [];
    }
    // "Only affects subsequent data input": the remap is where data go, not where they are read.
    const segment = this.segmentsRemapped ? WIDTH - 1 - this.column : this.column;
    this.memory[this.page * WIDTH + segment] = byte;
    if (this.mode === 'page') this.column = (this.column + 1) % WIDTH;
    else if (this.mode === 'horizontal') this.advance('column', 'page');
    else this.advance('page', 'column');
  }

  advance(inner, outer) {
    for (const axis of [inner, outer]) {
      const [first, last] = this[`${axis}s`];
      this[axis] += 1;
      if (this[axis] <= last) return;
      this[axis] = first;
    }
    this.onFrame();
  }

  // ------------------------------------------------------------------------ the glass

  // Whether a pixel is lit.
  pixel(x, y) {
    if (!this.on || !this.chargePump) return false;
    if (this.allOn) return true;
    const line = ((this.rowsBackwards ? y : HEIGHT - 1 - y) + this.startLine + this.offset) % HEIGHT;
    const bit = (this.memory[(line >> 3) * WIDTH + (WIDTH - 1 - x)] >> (line & 7)) & 1;
    return (bit === 1) !== this.inverse;
  }

  // What the glass shows, a string of # and . for each row.
  glass() {
    const row = (y) => Array.from({ length: WIDTH }, (_, x) => (this.pixel(x, y) ? '#' : '.')).join('');
    return Array.from({ length: HEIGHT }, (_, y) => row(y));
  }

  // How it is set up.
  state() {
    const { on, chargePump, multiplex, rowPins, contrast, inverse, allOn, mode } = this;
    return { on, chargePump, multiplex, rowPins, contrast, inverse, allOn, mode };
  }
}
