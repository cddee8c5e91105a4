use gamow::accuracy::*;
use gamow::scene::Scene;
use relativity_core::Speed;
use relativity_render::*;
fn main() {
    let scene = Scene::open("cyclist").unwrap();
    let mut r = Renderers::new(&scene.bodies, Gpu::headless().ok());
    let method = Method::Mesh { bound_px: 0.5 };
    for (beta, place) in [(0.9999, Place::Approaching), (0.9999, Place::Receding), (0.9, Place::Abreast)] {
        let view = view_at(
            place,
            Speed::from_beta(beta).unwrap(),
            scene.tracked,
            0.1,
            60f64.to_radians(),
            [480, 360],
        )
        .unwrap();
        let truth = r.reference().hit_image(&view);
        let shown = r.hits(method, &view).unwrap();
        let reference = r.reference();
        let pairs = silhouette_pixels(&truth, 150);
        let points: Vec<_> =
            pairs.iter().filter_map(|p| OutlinePoint::between(p, &reference, &view)).collect();
        let mut ds = vec![];
        for p in &points {
            let d = displacement_px(&reference, &view, p, |s| r.hits_in_part(method, &view, s)).unwrap();
            ds.push(d);
            if d > 0.5 {
                let [w, _] = view.camera.size;
                let (u, v) = (p.pixel.x as usize, p.pixel.y as usize);
                print!(
                    "{d} {:?} {:?} {:?}\n  ref  ",
                    p.pixel,
                    p.outward,
                    (p.body, scene.bodies[p.body].shape)
                );
                for dv in 0..3 {
                    for du in 0..3 {
                        print!("{:?} ", truth.hits[(v + dv - 1) * w as usize + u + du - 1].map(|h| h.body));
                    }
                    print!("| ");
                }
                print!("\n  mesh ");
                for dv in 0..3 {
                    for du in 0..3 {
                        print!("{:?} ", shown.hits[(v + dv - 1) * w as usize + u + du - 1].map(|h| h.body));
                    }
                    print!("| ");
                }
                println!();
            }
        }
        println!("== {beta} {place:?} {:?}", Spread::of(ds));
        let d = Difference::new(&view, &truth, &shown);
        let mut rel = vec![];
        let mut none = 0;
        let mut n = 0;
        for (i, p) in d.pixels.iter().enumerate() {
            if *p == PixelDifference::WrongObject {
                match (truth.hits[i], shown.hits[i]) {
                    (Some(a), Some(b)) => {
                        rel.push((a.distance / b.distance - 1.).abs());
                        n += 1;
                        if n % 40 == 1 {
                            println!(
                                "   {} {} {:?} {:?} {} {}",
                                i % 480,
                                i / 480,
                                a.body,
                                b.body,
                                a.distance,
                                b.distance
                            );
                        }
                    }
                    _ => none += 1,
                }
            }
        }
        println!("   {:?}\n wrong vs none {none}; rel depth {:?}", d.figures, Spread::of(rel));
    }
}
