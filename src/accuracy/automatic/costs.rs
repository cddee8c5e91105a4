//! Costs of each method on this machine, as far as they are known: measured in passing, else expected.

use relativity_render::{Geometry, Gpu, Method};

/// The hardware that a machine draws with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Machine {
    /// Processors alone.
    Cpu,
    /// A GPU that is software.
    SoftwareGpu,
    /// A real GPU.
    Gpu,
}

impl Machine {
    /// Returns the machine with this `gpu`, or without any.
    #[must_use]
    pub fn from_gpu(gpu: Option<&Gpu>) -> Self {
        match gpu {
            None => Self::Cpu,
            Some(gpu) if gpu.is_software() => Self::SoftwareGpu,
            Some(_) => Self::Gpu,
        }
    }
}

/// Number of the last measurements that count: their median, which one hiccup does not move.
const KEPT: usize = 5;
/// Drawings that are not measured: the first makes what the others use.
const UNMEASURED: u32 = 1;
/// Measurements after which a cost is known.
const ENOUGH: usize = 3;
/// Time from one measurement to the next, once the cost is known, milliseconds.
const INTERVAL_MS: f64 = 500.0;
/// Pixels of a megapixel.
const MEGAPIXEL: f64 = 1e6;

/// The costs of a scene's pictures.
#[derive(Debug, Clone)]
pub struct Costs {
    /// The kind of hardware that draws, on which expected costs depend.
    pub machine: Machine,
    /// Rays per pixel of the reference are the square of this.
    samples: u32,
    records: Vec<CostRecord>,
}

/// The measurements of one method in views of one kind.
#[derive(Debug, Clone)]
struct CostRecord {
    method: Method,
    geometry: Geometry,
    /// Drawings, measured or not.
    drawings: u32,
    /// The last of them, milliseconds per megapixel.
    recent: Vec<f64>,
    /// When the last was measured, milliseconds.
    at_ms: f64,
}

impl CostRecord {
    /// The median of the last few, milliseconds per megapixel.
    fn median(&self) -> Option<f64> {
        let mut sorted = self.recent.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }
}

impl Costs {
    /// Nothing is measured yet.
    #[must_use]
    pub const fn new(machine: Machine, samples: u32) -> Self {
        Self { machine, samples, records: Vec::new() }
    }

    /// Forgets all: another scene costs another time.
    pub fn forget(&mut self) {
        self.records.clear();
    }

    fn record(&self, method: Method, geometry: Geometry) -> Option<&CostRecord> {
        self.records.iter().find(|record| (record.method, record.geometry) == (method, geometry))
    }

    /// Whether the next drawing by `method` is to be measured.
    #[must_use]
    pub fn is_due(&self, method: Method, geometry: Geometry, now_ms: f64) -> bool {
        self.record(method, geometry).is_some_and(|record| {
            let is_known = record.recent.len() >= ENOUGH && now_ms - record.at_ms < INTERVAL_MS;
            record.drawings >= UNMEASURED && !is_known
        })
    }

    /// Notes that `method` has drawn, and how many milliseconds it took for how many `pixels` where that was
    /// measured.
    pub fn note(&mut self, method: Method, geometry: Geometry, measured: Option<(f64, f64)>, now_ms: f64) {
        if self.record(method, geometry).is_none() {
            let recent = Vec::new();
            self.records.push(CostRecord { method, geometry, drawings: 0, recent, at_ms: now_ms });
        }
        let is_it = |record: &&mut CostRecord| (record.method, record.geometry) == (method, geometry);
        let Some(record) = self.records.iter_mut().find(is_it) else { return };
        record.drawings = record.drawings.saturating_add(1);
        let Some((ms, pixels)) = measured.filter(|(ms, pixels)| ms.is_finite() && *pixels > 0.0) else {
            return;
        };
        if record.recent.len() == KEPT {
            record.recent.remove(0);
        }
        record.recent.push(ms * MEGAPIXEL / pixels);
        record.at_ms = now_ms;
    }

    /// Returns the measured cost of `method` for this number of `pixels`, milliseconds.
    #[must_use]
    pub fn measured_ms(&self, method: Method, geometry: Geometry, pixels: f64) -> Option<f64> {
        Some(self.record(method, geometry)?.median()? * pixels / MEGAPIXEL)
    }

    /// When that was, milliseconds.
    #[must_use]
    pub fn measured_at(&self, method: Method, geometry: Geometry) -> Option<f64> {
        let record = self.record(method, geometry)?;
        (!record.recent.is_empty()).then_some(record.at_ms)
    }

    /// Returns the known or expected cost: by the cost here of other methods of the same processor, relative
    /// to their usual ones.
    #[must_use]
    pub fn expected_ms(&self, method: Method, geometry: Geometry, pixels: f64) -> f64 {
        self.measured_ms(method, geometry, pixels).unwrap_or_else(|| {
            // A GPU that is software is the same processors.
            let is_alike =
                |other: Method| self.machine != Machine::Gpu || other.is_on_cpu() == method.is_on_cpu();
            let beside = |record: &&CostRecord| record.geometry == geometry && is_alike(record.method);
            let newest = self
                .records
                .iter()
                .filter(beside)
                .filter_map(|record| Some((record, record.median()?)))
                .max_by(|(a, _), (b, _)| a.at_ms.total_cmp(&b.at_ms));
            let default = |method| usual_ms(self.machine, self.samples, method);
            let scale = newest.map_or(1.0, |(record, ms)| ms / default(record.method));
            scale * default(method) * pixels / MEGAPIXEL
        })
    }
}

/// Returns the cost of a method before anything is measured, milliseconds per megapixel: that of the presets
/// on two cores, or with a GPU of a desk's computer. Only their order and their ratios count.
fn usual_ms(machine: Machine, samples: u32, method: Method) -> f64 {
    let is_real = machine == Machine::Gpu;
    match method {
        Method::Packets => 20.0,
        Method::Reference => 150.0 * f64::from(samples * samples),
        Method::Rays => {
            if is_real {
                0.5
            } else {
                45.0
            }
        }
        Method::Mesh => {
            if is_real {
                2.0
            } else {
                200.0
            }
        }
    }
}
