//! Numbers as people read them.

/// A power of ten.
#[must_use]
pub fn exponent(power: i32) -> String {
    let digits: String = power
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or('⁰'),
        })
        .collect();
    format!("10{digits}")
}

/// A number with `digits` significant digits: plain between 10⁻³ and 10⁶, as a power of ten beyond. A true minus sign,
/// thousands set apart.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let rounded = format!("{:.*e}", digits.saturating_sub(1), value.abs());
    let (mantissa, power) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    let size = if (-3..6).contains(&power) {
        let decimals = (digits as i32 - 1 - power).max(0) as usize;
        let magnitude: f64 = rounded.parse().unwrap_or(0.0);
        trimmed(&format!("{magnitude:.decimals$}"))
    } else if trimmed(mantissa) == "1" {
        exponent(power)
    } else {
        format!("{}·{}", trimmed(mantissa), exponent(power))
    };
    format!("{}{size}", if value < 0.0 { "−" } else { "" })
}

/// By how much a number has changed, with a sign and so many decimals.
#[must_use]
pub fn change(value: f64, decimals: usize) -> String {
    let size = trimmed(&format!("{:.decimals$}", value.abs()));
    match size.as_str() {
        "0" => size,
        _ if value.is_nan() => "–".to_owned(),
        _ if value < 0.0 => format!("−{size}"),
        _ => format!("+{size}"),
    }
}

/// Numbers of one row, with `digits` significant digits, or as many more, up to 7, as it takes to print different numbers differently.
#[must_use]
pub fn told_apart(values: &[f64], digits: usize) -> Vec<String> {
    let texts_at =
        |digits: usize| -> Vec<String> { values.iter().map(|v| significant(*v, digits)).collect() };
    let is_clear = |texts: &[String]| {
        let pairs = (0..values.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
        pairs
            .into_iter()
            .all(|(a, b)| values[a] == values[b] || texts[a] != texts[b])
    };
    (digits..7)
        .map(texts_at)
        .find(|texts| is_clear(texts))
        .unwrap_or_else(|| texts_at(digits.max(7)))
}

/// Without zeros at the end, and with commas between thousands.
fn trimmed(text: &str) -> String {
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    };
    let (whole, rest) = text.split_at(text.find('.').unwrap_or(text.len()));
    let mut out = String::new();
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i) % 3 == 0 {
            out.push(',');
        }
        out.push(digit);
    }
    out + rest
}

/// Text for HTML and SVG, quotes included.
#[must_use]
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// Seconds as hours, minutes and seconds.
pub(crate) fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{} s", significant(seconds, 3)),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_signs_and_sizes() {
        for (value, digits, text) in [
            (0.0, 3, "0"),
            (1.0, 3, "1"),
            (0.998_76, 4, "0.9988"),
            (12345.6, 3, "12,300"),
            (0.000_021, 2, "2.1·10⁻⁵"),
            (-0.0635, 2, "−0.064"),
            (0.99996, 4, "1"),
            (0.0009996, 2, "0.001"),
            (999_999.0, 3, "10⁶"),
            (123_456.0, 6, "123,456"),
            (1e-12, 3, "10⁻¹²"),
            (2.5e7, 3, "2.5·10⁷"),
            (f64::NAN, 3, "–"),
        ] {
            assert_eq!(significant(value, digits), text, "{value}");
        }
        let changes = [change(0.00123, 4), change(-0.25, 1), change(-1e-9, 4)];
        assert_eq!(changes, ["+0.0012", "−0.2", "0"]);
        let apart = told_apart(&[99.96, 100.0, 103.2], 3);
        assert_eq!(apart, ["99.96", "100", "103.2"]);
        assert_eq!(told_apart(&[42.5, 44.21], 3), ["42.5", "44.2"]);
    }

    #[test]
    fn nothing_gets_out_of_a_text() {
        assert_eq!(
            escape("<a href=\"x\">&'"),
            "&lt;a href=&quot;x&quot;&gt;&amp;&#39;"
        );
    }
}
