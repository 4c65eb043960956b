//! Buses and pins that record, in one list, what a driver does with them.

use std::{cell::RefCell, convert::Infallible, rc::Rc};

use embassy_futures::yield_now;
use embedded_hal::{
    delay::DelayNs,
    digital::{self, InputPin, OutputPin},
    i2c::{self, I2c},
    spi::{self, SpiBus, SpiDevice},
};

/// One thing that happened on the wires.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A pin was set; `CS` by an `SpiDevice` itself.
    Pin(&'static str, bool),
    /// I²C: start condition and address.
    Start(u8),
    /// I²C: stop condition.
    Stop,
    /// Bytes went out.
    Write(Write),
    /// Nanoseconds.
    Delay(u32),
}

/// What one call to write had: the bytes, and where in memory they were.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Write {
    pub bytes: Vec<u8>,
    address: *const u8,
}

/// What a display with a D/C pin understands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Packet {
    Command(Vec<u8>),
    Data(Vec<u8>),
}

/// What a flush costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Calls to the bus, or operations in them.
    pub writes: usize,
    /// Without the address byte of I²C.
    pub bytes: usize,
    /// Writes that the bus took straight from the frame's memory.
    pub in_place: usize,
}

/// Every bus, and what drives its pins; clones share the list.
#[derive(Clone, Default)]
pub struct Bus {
    events: Rc<RefCell<Vec<Event>>>,
}

/// A pin of the microcontroller's. Read, it is low: no panel here is ever busy.
pub struct Pin {
    bus: Bus,
    name: &'static str,
}

impl Bus {
    pub fn pin(&self, name: &'static str) -> Pin {
        Pin { bus: self.clone(), name }
    }

    /// Forgets what happened: the initialisation, mostly.
    pub fn forget(&self) {
        self.events.borrow_mut().clear();
    }

    pub fn events(&self) -> Vec<Event> {
        self.events.borrow().clone()
    }

    pub fn writes(&self) -> Vec<Write> {
        let write = |event| if let Event::Write(write) = event { Some(write) } else { None };
        self.events().into_iter().filter_map(write).collect()
    }

    /// All bytes, one write after the other.
    pub fn bytes(&self) -> Vec<u8> {
        self.writes().into_iter().flat_map(|write| write.bytes).collect()
    }

    /// The writes, told apart by the level of `D/C`: low for commands, high for data.
    pub fn packets(&self) -> Vec<Packet> {
        let mut is_data = None;
        let mut packets = Vec::new();
        for event in self.events() {
            match event {
                Event::Pin("D/C", level) => is_data = Some(level),
                Event::Write(Write { bytes, .. }) => packets.push(match is_data {
                    Some(true) => Packet::Data(bytes),
                    Some(false) => Packet::Command(bytes),
                    None => panic!("D/C is not set"),
                }),
                _ => {}
            }
        }
        packets
    }

    /// What went out, and how much of it straight from `memory`.
    pub fn cost(&self, memory: &[u8]) -> Cost {
        let writes = self.writes();
        Cost {
            writes: writes.len(),
            bytes: writes.iter().map(|write| write.bytes.len()).sum(),
            in_place: writes.iter().filter(|write| write.is_inside(memory)).count(),
        }
    }

    fn record(&self, event: Event) {
        self.events.borrow_mut().push(event);
    }

    fn record_write(&self, bytes: &[u8]) {
        self.record(Event::Write(Write { bytes: bytes.to_vec(), address: bytes.as_ptr() }));
    }

    fn run(&self, operations: &[spi::Operation<'_, u8>]) {
        for operation in operations {
            match operation {
                spi::Operation::Write(bytes) => self.record_write(bytes),
                spi::Operation::DelayNs(time) => self.record(Event::Delay(*time)),
                _ => panic!("displays are only written to"),
            }
        }
    }
}

impl Write {
    /// Whether the bytes *are* `memory`: not a copy of it.
    pub fn is(&self, memory: &[u8]) -> bool {
        self.address == memory.as_ptr() && self.bytes.len() == memory.len()
    }

    fn is_inside(&self, memory: &[u8]) -> bool {
        let range = memory.as_ptr_range();
        !self.bytes.is_empty() && range.contains(&self.address)
    }
}

impl spi::ErrorType for Bus {
    type Error = Infallible;
}

impl i2c::ErrorType for Bus {
    type Error = Infallible;
}

impl SpiDevice for Bus {
    fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Infallible> {
        self.record(Event::Pin("CS", false));
        self.run(operations);
        self.record(Event::Pin("CS", true));
        Ok(())
    }
}

/// A transfer by DMA: others run until it is done.
impl embedded_hal_async::spi::SpiDevice for Bus {
    async fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Infallible> {
        self.record(Event::Pin("CS", false));
        self.run(operations);
        yield_now().await;
        self.record(Event::Pin("CS", true));
        Ok(())
    }
}

impl SpiBus for Bus {
    fn write(&mut self, words: &[u8]) -> Result<(), Infallible> {
        self.record_write(words);
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn read(&mut self, _words: &mut [u8]) -> Result<(), Infallible> {
        panic!("displays are only written to")
    }

    fn transfer(&mut self, _read: &mut [u8], _write: &[u8]) -> Result<(), Infallible> {
        panic!("displays are only written to")
    }

    fn transfer_in_place(&mut self, _words: &mut [u8]) -> Result<(), Infallible> {
        panic!("displays are only written to")
    }
}

/// As the contract of [`I2c::transaction`] has it: adjacent writes go out without a new start.
impl I2c for Bus {
    fn transaction(&mut self, address: u8, operations: &mut [i2c::Operation<'_>]) -> Result<(), Infallible> {
        self.record(Event::Start(address));
        for operation in operations {
            match operation {
                i2c::Operation::Write(bytes) => self.record_write(bytes),
                i2c::Operation::Read(_) => panic!("displays are only written to"),
            }
        }
        self.record(Event::Stop);
        Ok(())
    }
}

impl DelayNs for Bus {
    fn delay_ns(&mut self, time: u32) {
        self.record(Event::Delay(time));
    }
}

impl digital::ErrorType for Pin {
    type Error = Infallible;
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.bus.record(Event::Pin(self.name, false));
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.bus.record(Event::Pin(self.name, true));
        Ok(())
    }
}

impl InputPin for Pin {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(false)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(true)
    }
}
