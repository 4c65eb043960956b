//! Memory-mapped registers, named as in the LM3S6965 and ARMv7-M manuals.

/// Where a peripheral's 4 KiB of registers begin.
#[derive(Clone, Copy, Debug)]
#[repr(usize)]
pub enum Peripheral {
    GpioPortA = 0x4000_4000,
    GpioPortB = 0x4000_5000,
    GpioPortC = 0x4000_6000,
    Ssi0 = 0x4000_8000,
    I2c = 0x4002_0000,
    SystemControl = 0x400F_E000,
    /// `SysTick` and the interrupt controller, inside the core.
    CoreControl = 0xE000_E000,
}

/// One 32-bit register.
#[derive(Clone, Copy, Debug)]
pub struct Register(usize);

impl Register {
    /// For constants only, so that a wrong offset is an error of the build.
    pub const fn new(peripheral: Peripheral, offset: usize) -> Self {
        assert!(offset < 0x1000 && offset.is_multiple_of(4));
        Self(peripheral as usize + offset)
    }

    #[inline]
    pub fn read(self) -> u32 {
        // SAFETY: `new` keeps the address aligned and inside a peripheral, where no Rust object is.
        unsafe { (self.0 as *const u32).read_volatile() }
    }

    #[inline]
    pub fn write(self, value: u32) {
        // SAFETY: as in `read`; no peripheral used here writes to memory by itself.
        unsafe { (self.0 as *mut u32).write_volatile(value) }
    }

    /// Sets `bits` and leaves the others.
    pub fn set(self, bits: u32) {
        self.write(self.read() | bits);
    }

    /// Clears `bits` and leaves the others.
    pub fn clear(self, bits: u32) {
        self.write(self.read() & !bits);
    }
}
