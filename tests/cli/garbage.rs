//! `eval` of garbage: it may refuse, in one line, but never panics and never writes what is not a number.

use super::{eval, gamow, run};

/// Pieces that CSV files and their accidents are made of.
const PIECES: [&[u8]; 32] = [
    b"beta",
    b"gamma",
    b"rapidity",
    b"d",
    b"y",
    b"z",
    b"T",
    b"x0",
    b"dphi",
    b"note",
    b",",
    b",",
    b",",
    b"\n",
    b"\r\n",
    b"\r",
    b"\"",
    b"\"\"",
    b" ",
    b"\t",
    b"0",
    b"0.9",
    b"-1",
    b"1e308",
    b"5e-324",
    b"nan",
    b"inf",
    b"\xff\xfe",
    b"\0",
    b"\xef\xbb\xbf",
    b"#",
    b"1e60",
];

/// Numbers at the edges of what is allowed, and just beyond.
const EDGES: [&str; 16] = [
    "0",
    "-0",
    "5e-324",
    "1e-300",
    "1e-160",
    "1e-14",
    "0.5",
    "0.9999999999999999",
    "1",
    "1e12",
    "1e30",
    "1e60",
    "-1e60",
    "-1",
    "1.1e60",
    "",
];

/// A linear congruential generator (D. E. Knuth's MMIX): its high bits are random enough for garbage.
struct Garbage(u64);

impl Garbage {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count
    }

    fn soup(&mut self) -> Vec<u8> {
        (0..self.below(60)).flat_map(|_| PIECES[self.below(PIECES.len())].to_vec()).collect()
    }

    /// A good header, rows of edge values, and sometimes a piece of garbage in them.
    fn rows(&mut self) -> Vec<u8> {
        let speed = ["beta", "gamma", "rapidity"][self.below(3)];
        let mut file = format!("{speed},d,y,z,T,x0\n").into_bytes();
        for _ in 0..self.below(4) {
            let row = [(); 6].map(|()| EDGES[self.below(EDGES.len() - 1)]).join(",");
            file.extend(row.bytes());
            if self.below(8) == 0 {
                file.extend(PIECES[self.below(PIECES.len())]);
            }
            file.push(b'\n');
        }
        file
    }
}

#[test]
fn garbage_is_evaluated_or_refused_in_one_line() {
    let mut garbage = Garbage(1940); // the year of Mr Tompkins
    for case in 0..400 {
        let file = if case % 2 == 0 { garbage.soup() } else { garbage.rows() };
        let outcome = eval(&file);
        let shown = String::from_utf8_lossy(&file);
        match outcome.status {
            Some(0) => assert_eq!(outcome.stderr, "", "{shown:?}"),
            _ => assert!(outcome.complaint().starts_with("gamow: standard input:"), "{shown:?}"),
        }
    }
}

/// A file that a fuzzer damaged: in builds with their assertions its inflater ended the program.
#[test]
fn damaged_measurements_are_refused_in_one_line() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cli/damaged.exr");
    let complaint = run(gamow().args(["measure", "--object", "0", file]), b"").complaint();
    assert!(complaint.contains("damaged.exr: ") && complaint.contains("malformed"), "{complaint}");
}

#[test]
fn every_edge_of_the_domain_gives_finite_numbers() {
    let mut garbage = Garbage(2020); // the year of the paper
    for model in ["exact", "one-cone", "published", "published-text"] {
        for (speed, values) in [
            ("beta", &["0", "-0", "5e-324", "1e-14", "0.9", "0.9999999999999999"][..]),
            ("gamma", &["1", "1.0000000000000002", "2", "1e12", "1e30"]),
            ("rapidity", &["0", "5e-324", "30", "69.77"]),
        ] {
            let mut file = format!("{speed},d,y,z,T,x0\n");
            for _ in 0..2000 {
                let place = || ["0", "-0", "5e-324", "1e-160", "1e-12", "1", "-3", "1e30", "1e60", "-1e60"];
                let d = ["0", "5e-324", "1e-12", "0.1", "1e60"][garbage.below(5)];
                let rest = [(); 4].map(|()| place()[garbage.below(10)]).join(",");
                let value = values[garbage.below(values.len())];
                file.extend([value, ",", d, ",", &rest, "\n"]);
            }
            let table = run(gamow().args(["eval", "--model", model]), file.as_bytes()).table();
            assert_eq!(table.rows.len(), 2000);
            assert!(table.rows.iter().flatten().all(|value| value.is_finite()));
        }
    }
}
