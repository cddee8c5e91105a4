//! The colours and textures of glTF materials.

use std::iter;

use gltf::material::AlphaMode;
use gltf::mesh::Semantic;
use gltf::texture::WrappingMode;
use gltf::{Material, Primitive};
use relativity_core::math;
use relativity_render::{RawModel, Wrap};

use super::super::accessor::{COLOURS, TEXTURE_PLACES, data_of, read};
use super::super::textures::{HALF_OPAQUE, cutoff};
use super::ModelReader;
use super::document::data_at;
use super::extensions::{TextureInfo, TextureTransform};

/// The remark on materials that let light through.
const BLENDED: &str =
    "transparency is left out: a surface is drawn where its picture is at least half opaque";

/// The paint that a material gives its triangles.
pub(super) struct Coat {
    /// The base colour, linear sRGB, and the opacity.
    factor: [f32; 4],
    /// The texture that multiplies it.
    texture: Option<TextureInfo>,
    /// The least opacity of that, in parts of 65535, at which there is a surface.
    cutoff: u16,
}

impl ModelReader<'_> {
    /// Whether triangles of `material`, which has this `coat`, are masked wherever they are.
    pub(super) fn is_unseen(material: &Material<'_>, coat: &Coat) -> bool {
        let opacity = coat.factor[3];
        material.alpha_mode() == AlphaMode::Mask && opacity < material.alpha_cutoff().unwrap_or(HALF_OPAQUE)
    }

    /// The coat of `material`: its base colour, or its diffuse colour beside a specular one; where that is
    /// black, its own light instead.
    pub(super) fn coat(&self, material: &Material<'_>) -> Coat {
        let base = material.pbr_metallic_roughness();
        let texture = || base.base_color_texture().map(TextureInfo::from);
        let (factor, texture) = match self.extended.glossiness(material.index()) {
            Some(diffuse) => (diffuse.factor, diffuse.texture.clone()),
            None => (base.base_color_factor(), texture()),
        };
        let own = Coat { factor, texture, cutoff: cutoff_of(material, factor[3]) };
        let strength = self.extended.strength(material.index());
        let light = material.emissive_factor().map(|part| part * strength);
        if light.iter().all(|part| *part <= 0.0) {
            return own;
        }
        let picture = material.emissive_texture();
        let [red, green, blue, opacity] = own.factor;
        if [red, green, blue] == [0.0; 3] {
            self.companions.remark("materials that give light are drawn as paint".to_owned());
            let [red, green, blue] = light;
            let texture = picture.map(TextureInfo::from);
            return Coat { factor: [red, green, blue, opacity], texture, cutoff: 0 };
        }
        self.companions.remark("light of materials that have a colour, too, is left out".to_owned());
        own
    }

    /// Adds the colours of the `count` corners of `primitive`, by the `coat` of its material, and their
    /// places in its texture, and returns the number of that.
    pub(super) fn add_colours(
        &mut self,
        primitive: &Primitive<'_>,
        count: usize,
        coat: &Coat,
    ) -> Result<u32, String> {
        if primitive.material().alpha_mode() == AlphaMode::Blend {
            self.companions.remark(BLENDED.to_owned());
        }
        self.add_paints(primitive, count, coat.factor)?;
        self.add_texture_places(primitive, count, coat)
    }

    /// Adds the paints of the `count` corners of `primitive`: its material's, times their own.
    fn add_paints(
        &mut self,
        primitive: &Primitive<'_>,
        count: usize,
        factor: [f32; 4],
    ) -> Result<(), String> {
        let paint = |own: [f32; 3]| std::array::from_fn(|part| (own[part] * factor[part]).clamp(0.0, 1.0));
        let Some(colours) = primitive.get(&Semantic::Colors(0)) else {
            self.model.paints.extend(iter::repeat_n(paint([1.0; 3]), count));
            return Ok(());
        };
        let colours = read::<3>(&colours, &COLOURS, &self.buffers, true)?;
        if colours.len() != count {
            return Err("a mesh has not as many colours as corners".to_owned());
        }
        self.model.paints.extend(colours.into_iter().map(paint));
        Ok(())
    }

    /// Adds the places of the `count` corners of `primitive` in the texture of its `coat`, and returns the
    /// number of that.
    fn add_texture_places(
        &mut self,
        primitive: &Primitive<'_>,
        count: usize,
        coat: &Coat,
    ) -> Result<u32, String> {
        let found = coat
            .texture
            .as_ref()
            .and_then(|info| Some((primitive.get(&Semantic::TexCoords(info.set()))?, info)));
        let Some((places, info)) = found else {
            self.model.texture_places.extend(iter::repeat_n([0.0; 2], count));
            return Ok(RawModel::NO_TEXTURE);
        };
        // Beside this extension bytes and shorts are parts of the whole, whatever the file says.
        let is_part = !self.document.extensions_used().any(|name| name == "KHR_mesh_quantization");
        let places = read::<2>(&places, &TEXTURE_PLACES, &self.buffers, is_part)?;
        if places.len() != count {
            return Err("a mesh has not as many places in its texture as corners".to_owned());
        }
        let transform = info.transform();
        self.model.texture_places.extend(places.into_iter().map(|place| transformed(transform, place)));
        Ok(self.texture(info.index, coat.cutoff))
    }

    /// Returns the number of the texture that the file gives this `number`, with this cutoff; it is read
    /// unless it was before.
    fn texture(&mut self, number: usize, cutoff: u16) -> u32 {
        let (document, buffers, companions) = (self.document, &self.buffers, self.companions);
        let Some(texture) = document.textures().nth(number) else {
            companions.remark(format!("a picture is left out: there is no texture {number}"));
            return RawModel::NO_TEXTURE;
        };
        let sampler = texture.sampler();
        let wrap = [sampler.wrap_s(), sampler.wrap_t()].map(|mode| match mode {
            WrappingMode::Repeat => Wrap::Repeat,
            WrappingMode::MirroredRepeat => Wrap::Mirror,
            WrappingMode::ClampToEdge => Wrap::Clamp,
        });
        self.textures.number((number, cutoff), wrap, cutoff, companions, || {
            // The crate takes for granted that a texture has an image, and that says where it is.
            let root = document.as_json();
            let number = root.textures[number].source.value();
            let image = root.images.get(number).ok_or("a texture has no PNG or JPEG")?;
            let name = format!("image {number}");
            match (&image.uri, image.buffer_view) {
                (Some(uri), _) if uri.starts_with("data:") => {
                    Ok((data_at(uri, "an image", companions)?, name))
                }
                (Some(uri), _) => Ok((data_at(uri, "an image", companions)?, uri.clone())),
                (None, Some(view)) => {
                    let view = document.views().nth(view.value());
                    let data = view.and_then(|view| data_of(&view, buffers));
                    Ok((data.ok_or_else(|| format!("{name} reaches beyond its data"))?.to_vec(), name))
                }
                (None, None) => Err(format!("{name} has no data")),
            }
        })
    }
}

/// The least opacity of the texture of a `material` with this opacity, in parts of 65535, at which there is a
/// surface: of one that lets light through, one half.
fn cutoff_of(material: &Material<'_>, opacity: f32) -> u16 {
    cutoff(match material.alpha_mode() {
        AlphaMode::Opaque => 0.0,
        AlphaMode::Mask => material.alpha_cutoff().unwrap_or(HALF_OPAQUE) / opacity,
        AlphaMode::Blend => HALF_OPAQUE,
    })
}

/// Returns a place in a texture, as `KHR_texture_transform` moves it.
///
/// The rotation is that of Khronos's own viewer: as seen on the picture, it turns the places
/// counter-clockwise.
fn transformed(transform: Option<TextureTransform>, place: [f32; 2]) -> [f32; 2] {
    let Some(transform) = transform else { return place };
    let ([du, dv], [width, height]) = (transform.offset, transform.scale);
    let (sine, cosine) = math::sin_cos(f64::from(transform.rotation));
    let [u, v] = [place[0] * width, place[1] * height].map(f64::from);
    [(cosine * u + sine * v) as f32 + du, (cosine * v - sine * u) as f32 + dv]
}
