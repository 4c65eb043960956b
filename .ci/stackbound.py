#!/usr/bin/env python3
"""The deepest that the stack of a Cortex-M firmware can get, from its disassembly.

    .ci/stackbound.py ELF [--root FUNCTION]... [--handler FUNCTION]...

A function's frame is what it pushes and takes off the stack pointer; the bound is the heaviest
path of calls from the root (the reset handler), plus the heaviest of the interrupt handlers with
the registers that the core stacks for it (one handler at a time: all have the same priority).
Recursion and calls through pointers make the bound incomplete; both are named, and the exit
code is then 1. The first line printed is the bound alone: `bound N`. With several roots there is a line
`bound N FUNCTION` for each, and no path.

Needs binutils-arm-none-eabi and Python 3 with its standard library.
"""

import argparse
import bisect
import re
import shutil
import subprocess
import sys

OBJDUMP = "arm-none-eabi-objdump"
NM = "arm-none-eabi-nm"

# What the core stacks for an exception, with up to 4 bytes to align it: 8 words, and with a
# floating-point unit room for 18 more.
EXCEPTION, EXCEPTION_WITH_FLOATS = 36, 108

FUNCTION = re.compile(r"([0-9a-f]+) <(.*)>:$")
LITERAL = re.compile(r"\s*([0-9a-f]+):\t\.word\t0x([0-9a-f]+)")
INSTRUCTION = re.compile(r"\s*[0-9a-f]+:\t(\S+)\t?(.*)")
CALL = re.compile(r"(bl?|blx)(\.[nw])?$")
BRANCH_IF = re.compile(r"b[a-z]{2}(\.[nw])?$")
TARGET = re.compile(r"([0-9a-f]+) <")


class Function:
    """Frame size in bytes, the addresses it calls, and whether it calls through a pointer."""

    def __init__(self, name):
        self.name = name
        self.frame = 0
        self.calls = set()
        self.branches = set()
        self.indirect = False


def disassemble(elf):
    command = [OBJDUMP, "-d", "-C", "--no-show-raw-insn", elf]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


def addresses(elf):
    """Where each function begins. Functions with the same code may be at the same address."""
    lines = subprocess.run([NM, "-C", elf], capture_output=True, text=True, check=True).stdout.splitlines()
    symbols = [line.split(" ", 2) for line in lines if line[0] != " "]
    return {name: int(value, 16) & ~1 for value, kind, name in symbols if kind in "tTwW"}


def pushed_words(registers):
    """Words in a register list such as `r4-r7, lr` or `d8-d11`."""
    words = 0
    for item in registers.split(","):
        first, last = re.fullmatch(r"\D*(\d*)(?:-\D*(\d+))?", item.strip()).groups()
        count = int(last) - int(first) + 1 if last else 1
        words += count * (2 if item.strip().startswith("d") else 1)
    return words


def stack_taken(operation, operands, comment, constants, literals):
    """Bytes by which one instruction lowers the stack pointer.

    Thumbv6m has no immediate for a large frame: it loads a negative constant from a literal and
    adds it, so `constants` follows what the registers hold.
    """
    if operation in ("push", "push.w", "vpush") or operation.startswith("stmdb") and operands.startswith("sp!"):
        return 4 * pushed_words(re.search(r"\{(.*)\}", operands)[1])
    if operation.startswith("str") and (found := re.search(r"\[sp, #-(\d+)\]!", operands)):
        return int(found[1])
    if operation.startswith("sub") and (found := re.match(r"sp, (?:sp, )?#(\d+)", operands)):
        return int(found[1])
    if operation.startswith("ldr") and (found := re.match(r"(r\d+), \[pc", operands)):
        where = re.search(r"\(([0-9a-f]+) <", comment)
        constants[found[1]] = literals.get(int(where[1], 16), 0) if where else 0
    elif operation == "add" and (found := re.match(r"sp, (r\d+)$", operands)):
        constant = constants.get(found[1], 0)
        return (1 << 32) - constant if constant >> 31 else 0
    return 0


def note_branch(function, operation, operands):
    target = TARGET.match(operands)
    if target and CALL.match(operation):
        function.calls.add(int(target[1], 16))
    elif target and BRANCH_IF.match(operation):
        function.branches.add(int(target[1], 16))
    elif operation == "blx" or operation == "bx" and operands != "lr":
        function.indirect = True


def read_functions(lines):
    """All functions by address."""
    literals = {int(m[1], 16): int(m[2], 16) for m in map(LITERAL.match, lines) if m}
    functions, function = {}, None
    for line in lines:
        if heading := FUNCTION.match(line):
            function = functions[int(heading[1], 16)] = Function(heading[2])
            constants = {}
        elif function and (found := INSTRUCTION.match(line)):
            operation, rest = found.groups()
            operands = re.split(r"[;@]", rest)[0].strip()
            function.frame += stack_taken(operation, operands, rest, constants, literals)
            note_branch(function, operation, operands)
    resolve(functions)
    return functions


def resolve(functions):
    """Turns branch targets into the functions they belong to."""
    starts = sorted(functions)

    def owner(address):
        return starts[bisect.bisect_right(starts, address) - 1]

    for start, function in functions.items():
        # A conditional branch to another function's first instruction is a tail call. To the
        # middle of one it is the linker's filler (0xd4d4), which reads as a branch.
        tails = {address for address in function.branches if address in functions}
        function.calls = {owner(address) for address in function.calls | tails} - {start}


class Walk:
    """Follows the calls from a function: the heaviest path, and what makes it incomplete."""

    def __init__(self, functions):
        self.functions = functions
        self.known = {}
        self.active = set()
        self.recursive = set()

    def deepest(self, start):
        """Bytes and path of the heaviest chain of calls."""
        if start in self.active:
            self.recursive.add(self.functions[start].name)
            return 0, []
        if start not in self.known:
            function = self.functions[start]
            self.active.add(start)
            below = max(map(self.deepest, sorted(function.calls)), default=(0, []), key=lambda found: found[0])
            self.active.discard(start)
            self.known[start] = function.frame + below[0], [start, *below[1]]
        return self.known[start]

    def indirect(self):
        """Names of the functions met that call through a pointer."""
        return {self.functions[start].name for start in self.known if self.functions[start].indirect}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("elf")
    parser.add_argument("--root", action="append", help="where calls begin (Reset)")
    parser.add_argument("--handler", action="append", default=[], help="an interrupt handler to add")
    return parser.parse_args()


def print_bound(functions, found, extra):
    """The bound of the only root, and how it comes about."""
    print(f"bound {found[0] + extra[0]}")
    for start in found[1]:
        print(f"{functions[start].frame:6} {functions[start].name}")
    if extra[0]:
        print(f"{extra[0]:6} interrupt by {extra[1]}")


def main():
    options = arguments()
    roots = options.root or ["Reset"]
    if shutil.which(OBJDUMP) is None:
        sys.exit(f"stackbound: {OBJDUMP} is not installed; on Debian: apt-get install binutils-arm-none-eabi")
    lines = disassemble(options.elf)
    functions = read_functions(lines)
    address = addresses(options.elf)
    if missing := [name for name in (*roots, *options.handler) if address.get(name) not in functions]:
        sys.exit(f"stackbound: no function {missing[0]} in {options.elf}")

    floats = any("\tvldr" in line or "\tvmov" in line or "\tvpush" in line for line in lines)
    stacked = EXCEPTION_WITH_FLOATS if floats else EXCEPTION
    walk = Walk(functions)
    found = {name: walk.deepest(address[name]) for name in roots}
    handlers = [(stacked + walk.deepest(address[name])[0], name) for name in options.handler]
    extra = max(handlers, default=(0, ""))

    if len(roots) == 1:
        print_bound(functions, found[roots[0]], extra)
    else:
        for name, (depth, _) in found.items():
            print(f"bound {depth + extra[0]} {name}")
    for what, names in ("recursion", walk.recursive), ("calls through pointers", walk.indirect()):
        print(f"{what}: {', '.join(sorted(names)) or 'none'}")
    return 1 if walk.recursive or walk.indirect() else 0


if __name__ == "__main__":
    sys.exit(main())
