//! JPEG in.

use std::io::Cursor;

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Returns width and height of the picture in `bytes`, pixels, and its pixels row by row, once its size is
/// approved by `check`.
///
/// # Errors
/// What is wrong with the bytes, or with the size.
pub fn decode(
    bytes: &[u8],
    check: impl FnOnce([u32; 2]) -> Result<(), String>,
) -> Result<([u32; 2], Vec<[u8; 4]>), String> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(|error| error.to_string())?;
    let info = decoder.info().ok_or("it has no size")?;
    let size = [info.width, info.height].map(u32::from);
    check(size)?;
    let parts = decoder.decode().map_err(|error| error.to_string())?;
    let pixels: Vec<_> =
        parts.as_chunks().0.iter().map(|&[red, green, blue]| [red, green, blue, u8::MAX]).collect();
    if pixels.len() as u64 != size.map(u64::from).iter().product::<u64>() {
        return Err("it has colours of a kind that is not known here".to_owned());
    }
    Ok((size, pixels))
}
