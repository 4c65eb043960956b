// Runs the firmware of an RP2040 under rp2040js, with an SSD1306 at its I²C bus 0.
//
//   node .ci/pico.mjs FOLDER ELF FRAMES
//
// FOLDER has rp2040js in its node_modules. There is no file of the chip's ROM: what it does for a start is done here,
// and what is called of it in pico_rom.mjs. Prints one object of JSON: `frames`, what the glass showed after each flush,
// `times` in milliseconds, `state` of the panel, and `problems`, which should be empty.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { call, install, isInRom } from './pico_rom.mjs';
import { Ssd1306 } from './pico_ssd1306.mjs';

const [folder, elf, wanted] = process.argv.slice(2);
const { RP2040 } = createRequire(`${resolve(folder)}/`)('rp2040js');

const FLASH = 0x10000000;
const RAM = 0x20000000;
const BOOT2 = 0x20041f00;
const ADDRESS = 0x3c;
const I2C_FUNCTION = 3;
const [SDA, SCL] = [4, 5];
// Far more than a frame takes.
const MOST_CYCLES_A_FRAME = 125e6;

const problems = new Set();
const chip = new RP2040();
const clock = chip.clock;
// What the emulator says that it has not, and this firmware can do without: times on the wires of the bus.
const UNNEEDED = 'I2C0: Unimplemented write to IC_SDA_HOLD';
const note = (component, message) => {
  const what = `${component}: ${message}`;
  if (what !== UNNEEDED) problems.add(what);
};
chip.logger = { debug() {}, info() {}, warn: note, error: note };
chip.onBreak = (code) => problems.add(`breakpoint ${code}`);

// ---------------------------------------------------------------------------- start

// Puts all that is loaded where its load address says.
function load(image) {
  const [headers, size, count] = [image.readUInt32LE(28), image.readUInt16LE(42), image.readUInt16LE(44)];
  for (let at = headers; at < headers + count * size; at += size) {
    const [kind, offset, , address, length] = [0, 4, 8, 12, 16].map((word) => image.readUInt32LE(at + word));
    if (kind !== 1 || length === 0) continue;
    if (address < FLASH || address - FLASH + length > chip.flash.length) throw new Error(`not in flash: ${address}`);
    chip.flash.set(image.subarray(offset, offset + length), address - FLASH);
  }
}

// The ROM runs the first 256 bytes of flash only if their last four are the CRC-32 of the others.
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) crc = (crc << 1) ^ (crc < 0 ? 0x04c11db7 : 0);
  }
  return crc >>> 0;
}

function start() {
  const first = Buffer.from(chip.flash.subarray(0, 256));
  if (crc32(first.subarray(0, 252)) !== first.readUInt32LE(252)) problems.add('the checksum of boot2 is wrong');
  // It runs in RAM, makes the flash readable, and without a caller goes on to the vector table behind itself.
  chip.sram.set(first, BOOT2 - RAM);
  chip.core.SP = BOOT2;
  chip.core.LR = 0;
  chip.core.PC = BOOT2;
}

// ---------------------------------------------------------------------------- the bus

const panel = new Ssd1306();
const bus = chip.i2c[0];
const period = () => ((bus.sclHighPeriod + bus.sclLowPeriod) * 1e9) / chip.clkSys;

// Every byte takes as long as on the wires: eight bits and one to acknowledge.
function after(bits, action) {
  clock.createAlarm(action).schedule(bits * period());
}

function checkWires() {
  for (const pin of [chip.gpio[SDA], chip.gpio[SCL]]) {
    if (pin.functionSelect !== I2C_FUNCTION) problems.add(`GP${pin.index} is not at the bus`);
    if (!pin.pullupEnabled) problems.add(`GP${pin.index} is not pulled up`);
  }
  // The data sheet's t_cycle, less what rounding may take.
  if (period() < 2499) problems.add(`the bus is too fast: ${Math.round(period())} ns a bit`);
}

bus.onStart = () => {
  panel.start();
  after(1, () => bus.completeStart());
};
bus.onConnect = (address, mode) => {
  checkWires();
  const isThere = address === ADDRESS && mode === 0;
  if (!isThere) problems.add(`nobody ${mode === 0 ? 'listens' : 'answers'} at address ${address}`);
  after(9, () => bus.completeConnect(isThere));
};
bus.onWriteByte = (byte) => {
  panel.write(byte);
  after(9, () => bus.completeWrite(true));
};
bus.onStop = () => {
  panel.stop();
  after(1, () => bus.completeStop());
};

// ---------------------------------------------------------------------------- run

const frames = [];
const times = [];
panel.onFrame = () => {
  frames.push(panel.glass());
  times.push(Math.round(clock.nanos / 1e4) / 100);
};

load(readFileSync(elf));
install(chip);
start();
let cycles = 0;
while (frames.length < Number(wanted)) {
  const wrong = isInRom(chip.core.PC) ? call(chip) : null;
  if (wrong) problems.add(`${wrong}, called from ${chip.core.LR.toString(16)}`);
  if (cycles > MOST_CYCLES_A_FRAME * (frames.length + 1)) problems.add(`hangs at ${chip.core.PC.toString(16)}`);
  if (problems.size > 0 || panel.problems.size > 8) break;
  const taken = chip.core.executeInstruction();
  cycles += taken;
  clock.tick((taken * 1e9) / chip.clkSys);
}
console.log(JSON.stringify({ frames, times, state: panel.state(), problems: [...problems, ...panel.problems] }));
