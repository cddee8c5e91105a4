//! Text in UTF-16 with its mark, as spreadsheets save "Unicode text", turned into UTF-8; other bytes as they
//! are.

use std::io::{self, Read};

/// Bytes that are decoded at a time.
const CHUNK_BYTES: usize = 1 << 14;

/// A reader of what `inner` gives, in UTF-8 if that begins with the mark of UTF-16.
pub(crate) struct Decoded<R> {
    inner: R,
    /// How two bytes make a unit of UTF-16; `None` for bytes that stay as they are.
    unit: Option<fn([u8; 2]) -> u16>,
    /// Bytes that are given next, from `given` on.
    ready: Vec<u8>,
    given: usize,
    /// A first byte of two, and a first unit of two.
    half: Option<u8>,
    high: Option<u16>,
}

impl<R: Read> Decoded<R> {
    /// Reads the first bytes of `inner`.
    ///
    /// # Errors
    ///
    /// Those of what is read.
    pub fn new(mut inner: R) -> io::Result<Self> {
        let mut ready = Vec::new();
        inner.by_ref().take(2).read_to_end(&mut ready)?;
        let unit: Option<fn([u8; 2]) -> u16> = match ready.as_slice() {
            [0xff, 0xfe] => Some(u16::from_le_bytes),
            [0xfe, 0xff] => Some(u16::from_be_bytes),
            _ => None,
        };
        if unit.is_some() {
            ready.clear();
        }
        Ok(Self { inner, unit, ready, given: 0, half: None, high: None })
    }

    /// Whether the text is in UTF-16.
    pub const fn is_utf16(&self) -> bool {
        self.unit.is_some()
    }

    /// Decodes the next bytes into `ready`, which stays empty at the end.
    fn decode(&mut self, unit: fn([u8; 2]) -> u16) -> io::Result<()> {
        (self.ready, self.given) = (Vec::new(), 0);
        let mut chunk = [0; CHUNK_BYTES];
        while self.ready.is_empty() {
            let count = self.inner.read(&mut chunk)?;
            let bytes = self.half.take().into_iter().chain(chunk[..count].iter().copied());
            let bytes: Vec<u8> = bytes.collect();
            let (pairs, rest) = bytes.as_chunks::<2>();
            let mut units: Vec<u16> =
                self.high.take().into_iter().chain(pairs.iter().map(|pair| unit(*pair))).collect();
            if count > 0 {
                self.half = rest.first().copied();
                self.high = units.pop_if(|unit| (0xd800..0xdc00).contains(unit));
            }
            let letters =
                char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER));
            self.ready = letters.collect::<String>().into_bytes();
            if count == 0 {
                break;
            }
        }
        Ok(())
    }
}

impl<R: Read> Read for Decoded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let (Some(unit), true) = (self.unit, self.given == self.ready.len()) {
            self.decode(unit)?;
        }
        if self.given == self.ready.len() && self.unit.is_none() {
            return self.inner.read(buffer);
        }
        let count = (&self.ready[self.given..]).read(buffer)?;
        self.given += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives one byte at a time, as a pipe may.
    struct Drops<'a>(&'a [u8]);

    impl Read for Drops<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let most = buffer.len().min(1);
            self.0.read(&mut buffer[..most])
        }
    }

    #[test]
    fn both_orders_of_bytes_are_read_in_any_pieces() {
        let text = "T,Δφ\n1,𝄞\n";
        for order in [u16::to_le_bytes, u16::to_be_bytes] {
            let bytes: Vec<u8> =
                "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(order).collect();
            let mut read = String::new();
            Decoded::new(Drops(&bytes)).expect("begins").read_to_string(&mut read).expect("is text");
            assert_eq!(read, text);
        }
        for bytes in [&b""[..], b"T", b"T,dphi\n", &[0xff, 0xfe, 0x00, 0xd8, 0x41]] {
            let mut read = Vec::new();
            Decoded::new(Drops(bytes)).expect("begins").read_to_end(&mut read).expect("ends");
            assert!(read == bytes || String::from_utf8(read).is_ok_and(|text| text.contains('\u{fffd}')));
        }
    }
}
