//! Text of others, such as names in a job or a file, where it must do nothing but be read: on a terminal, in a comment, as a
//! file's name. (In pages it is escaped by the report.)
//!
//! ```
//! use tomolith_core::text::{file_name, one_line, printable};
//! assert_eq!(printable("a\u{1b}[31mb\nc"), "a\\u{1b}[31mb\nc");
//! assert_eq!(one_line("a\nb"), "a\\nb");
//! assert_eq!(file_name("a/b gear", '_'), "a_b_gear");
//! ```

use std::borrow::Cow;

/// The text with everything that would steer a terminal, or turn the direction of reading, written out as an escape. Lines and
/// tabs stay.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    written_out(text, |c| steers(c) && !matches!(c, '\n' | '\t'))
}

/// Printable text as one line, for a comment.
#[must_use]
pub fn one_line(text: &str) -> Cow<'_, str> {
    written_out(text, |c| steers(c) || matches!(c, '\u{2028}' | '\u{2029}'))
}

fn steers(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn written_out(text: &str, is_written_out: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_written_out) {
        return Cow::Borrowed(text);
    }
    let mut written = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match is_written_out(c) {
            true => written.extend(c.escape_default()),
            false => written.push(c),
        }
    }
    Cow::Owned(written)
}

/// Bytes of a name that a file can have besides its prefix and suffix: systems take 255.
const LONGEST: usize = 120;

/// The text as a part of a file's name: of letters, digits, `-`, `_` and `.`, others being replaced, and cut where it is too
/// long for a name.
#[must_use]
pub fn file_name(text: &str, replacement: char) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_.".contains(c);
    let plain = |c: char| if is_plain(c) { c } else { replacement };
    let mut name = String::new();
    for c in text.chars().map(plain) {
        if name.len() + c.len_utf8() > LONGEST {
            break;
        }
        name.push(c);
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_is_written_out_and_all_else_stays() {
        let text = "µm: größe\t1\n2 ≤ 3 – ✓";
        assert!(matches!(printable(text), Cow::Borrowed(same) if same == text));
        let title = "\u{1b}]0;pwn\u{7}\r\u{9b}31m\u{202e}";
        let expected = "\\u{1b}]0;pwn\\u{7}\\r\\u{9b}31m\\u{202e}";
        assert_eq!(printable(title), expected);
        assert_eq!(one_line("x\n[motion]\r\n#"), "x\\n[motion]\\r\\n#");
    }

    #[test]
    fn names_are_cut_between_characters() {
        assert_eq!(file_name(&"n".repeat(250), '_'), "n".repeat(LONGEST));
        assert_eq!(
            file_name(&format!("x{}", "ü".repeat(124)), '_'),
            format!("x{}", "ü".repeat(59))
        );
        assert_eq!(file_name("../a\u{1b}b", '-'), "..-a-b");
    }
}
