// What an RP2040 has in its ROM, as far as its HAL for Rust calls it: no file of the ROM is needed.
//
// RP2040 data sheet, 2.8.3: the half-words at 14h and 18h point to a table and to the function that looks codes up in
// it. Calls are seen by their addresses, and done here, in no time.

const TABLE = 0x100;
const LOOKUP = 0x200;
const FUNCTIONS = 0x300;
const END = 0x4000;

const bytes = (chip, address, length) => Array.from({ length }, (_, at) => chip.readUint8(address + at));
const store = (chip, address, values) => values.forEach((value, at) => chip.writeUint8(address + at, value));
const fill = (chip, [to, value, length]) => store(chip, to, Array(length).fill(value & 0xff));
const copy = (chip, [to, from, length]) => store(chip, to, bytes(chip, from, length));

// By its code, what each function does with its first three arguments. Gives what it gives back.
const KNOWN = {
  MS: (chip, args) => (fill(chip, args), args[0]),
  S4: (chip, args) => (fill(chip, args), args[0]),
  MC: (chip, args) => (copy(chip, args), args[0]),
  C4: (chip, args) => (copy(chip, args), args[0]),
  L3: (_, [value]) => Math.clz32(value),
};
const CODES = Object.keys(KNOWN);

// Points the half-words to what is here.
export function install(chip) {
  chip.bootrom[0x14 / 4] = TABLE;
  chip.bootrom[0x18 / 4] = LOOKUP | 1;
}

export const isInRom = (address) => address < END;

// Does the function that the chip is about to run, and returns from it. Gives what is wrong, if something is.
export function call(chip) {
  const { core } = chip;
  const [at, args] = [core.PC & ~1, [...core.registers.subarray(0, 3)]];
  if (at === LOOKUP) {
    const code = String.fromCharCode(args[1] & 0xff, args[1] >> 8);
    if (!CODES.includes(code)) return `no function ${code} in ROM`;
    core.registers[0] = (FUNCTIONS + 4 * CODES.indexOf(code)) | 1;
  } else {
    const code = CODES[(at - FUNCTIONS) / 4];
    if (!code) return `a jump to ${at.toString(16)}`;
    core.registers[0] = KNOWN[code](chip, args);
  }
  core.PC = core.LR & ~1;
  return null;
}
