//! Order statistics without sorting, exact: the buckets of a [`Scan`] know where every rank lies.

use super::super::scan::Scan;

/// Percentiles of the part (class 0) and the void (1): α and 100 − α of the part, 100 − α of the void.
fn wanted(alpha: f64) -> [(usize, f64); 3] {
    [(0, alpha), (0, 100.0 - alpha), (1, 100.0 - alpha)]
}

/// Percentile α and 100 − α of the part, and 100 − α of the void; linear between order statistics.
#[must_use]
pub fn percentiles(scan: &Scan<'_>, alpha: f64) -> [Option<f64>; 3] {
    wanted(alpha).map(|(class, percent)| percentile(scan, class, percent))
}

/// The ranks that [`percentiles`] asks for.
pub(super) fn ranks(scan: &Scan<'_>, alpha: f64) -> Vec<(usize, u64)> {
    let places = wanted(alpha).map(|(class, percent)| (class, place(scan, class, percent)));
    let found = places.into_iter().filter_map(|(c, p)| Some((c, p?)));
    found
        .flat_map(|(class, (low, high, _))| [(class, low), (class, high)])
        .collect()
}

/// The ranks below and above a percentile, and how far it is from the one to the other.
fn place(scan: &Scan<'_>, class: usize, percent: f64) -> Option<(u64, u64, f64)> {
    let last = scan.totals()[class].checked_sub(1)?;
    let place = last as f64 * percent / 100.0;
    let below = place.floor() as u64;
    Some((below, (below + 1).min(last), place.fract()))
}

/// The percentile of a class; none when it is empty.
fn percentile(scan: &Scan<'_>, class: usize, percent: f64) -> Option<f64> {
    let (below, above, share) = place(scan, class, percent)?;
    let low = f64::from(scan.value_at(class, below)?);
    if share == 0.0 {
        return Some(low);
    }
    let high = f64::from(scan.value_at(class, above)?);
    Some(low + share * (high - low))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;
    use tomolith_core::target::label::{PART, VOID};

    #[test]
    fn percentiles_are_those_of_a_sorted_list() {
        for n in [1usize, 2, 3, 10, 997] {
            let values: Vec<f32> = (0..n)
                .map(|i| ((i * 7919) % 1009) as f32 * 0.013 - 3.0)
                .collect();
            let labels: Vec<u8> = (0..n)
                .map(|i| if i % 3 == 2 { VOID } else { PART })
                .collect();
            let mut sorted: Vec<f64> = values
                .iter()
                .zip(&labels)
                .filter(|(_, l)| **l == PART)
                .map(|(v, _)| f64::from(*v))
                .collect();
            sorted.sort_by(f64::total_cmp);
            let scan = Scan::new(&labels, &values).unwrap();
            for percent in [0.0, 0.025, 1.0, 37.5, 50.0, 99.0, 100.0] {
                let place = (sorted.len() - 1) as f64 * percent / 100.0;
                let (i, share) = (place.floor() as usize, place.fract());
                let next = sorted[(i + 1).min(sorted.len() - 1)];
                let expected = sorted[i] + share * (next - sorted[i]);
                let found = percentile(&scan, 0, percent).unwrap();
                near!(found, expected, 1e-12, "{n} values, {percent} %");
            }
        }
        let void = Scan::new(&[VOID], &[1.0]).unwrap();
        assert_eq!(percentile(&void, 0, 50.0), None);
    }
}
