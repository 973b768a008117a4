//! The lexical layer that all text formats share: encodings, lines, words, numbers.
//!
//! Files come in UTF-8, ASCII with names and comments in any code page, or UTF-16; with or without a byte order mark. A
//! line ends with LF, CR or both. Readers of formats see words and the number of their line.

use std::borrow::Cow;
use std::str::FromStr;

/// The content without byte order mark, UTF-16 turned into UTF-8; other bytes as they are.
pub(super) fn decoded(bytes: &[u8]) -> Cow<'_, [u8]> {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        // ASCII in UTF-16 without a mark: every other byte is zero
        [a, 0, b, 0, ..] if *a > 0 && *b > 0 => utf16(bytes, u16::from_le_bytes),
        [0, a, 0, b, ..] if *a > 0 && *b > 0 => utf16(bytes, u16::from_be_bytes),
        _ => Cow::Borrowed(bytes),
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Cow<'_, [u8]> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let text = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
    Cow::Owned(text.collect::<String>().into_bytes())
}

/// The first line and what follows it.
pub(super) fn split_line(text: &[u8]) -> (&[u8], &[u8]) {
    let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
    let (line, rest) = text.split_at(text.iter().position(is_end).unwrap_or(text.len()));
    match rest {
        [b'\r', b'\n', rest @ ..] | [_, rest @ ..] => (line, rest),
        [] => (line, rest),
    }
}

/// All lines with their numbers, from 1.
pub(super) fn lines(text: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut rest = text;
    (1..).map_while(move |number| {
        if rest.is_empty() {
            return None;
        }
        let line;
        (line, rest) = split_line(rest);
        Some((number, line))
    })
}

pub(super) fn words_of(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// A word and the number of its line.
#[derive(Clone, Copy)]
pub(super) struct Word<'a> {
    pub(super) text: &'a [u8],
    pub(super) line: usize,
}

impl Word<'_> {
    pub(super) fn is(&self, name: &str) -> bool {
        self.text.eq_ignore_ascii_case(name.as_bytes())
    }
}

/// All words, wherever lines end.
pub(super) fn words(text: &[u8]) -> impl Iterator<Item = Word<'_>> {
    lines(text).flat_map(|(line, content)| words_of(content).map(move |text| Word { text, line }))
}

/// A number, or None for what is none.
pub(super) fn number<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A word or the beginning of a text for messages, on one line.
pub(super) fn shown(text: &[u8]) -> String {
    let start = String::from_utf8_lossy(&text[..text.len().min(24)]);
    let line = start.trim_start().lines().next().unwrap_or_default().trim();
    line.replace(|c: char| c.is_control(), "?")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_line_end_and_encoding_gives_the_same_words() {
        let text = "one  two\n\n\tthree\n";
        let found = |bytes: &[u8]| -> Vec<(String, usize)> {
            let text = decoded(bytes);
            let word = |w: Word<'_>| (String::from_utf8_lossy(w.text).into_owned(), w.line);
            words(&text).map(word).collect()
        };
        let expected = found(text.as_bytes());
        assert_eq!(expected[0], ("one".to_owned(), 1));
        assert_eq!(expected[2], ("three".to_owned(), 3));
        assert_eq!(found(text.replace('\n', "\r").as_bytes()), expected);
        assert_eq!(found(text.replace('\n', "\r\n").as_bytes()), expected);
        let units = || text.encode_utf16();
        let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
        let marked = |mark: &[u8], bytes: &[u8]| found(&[mark, bytes].concat());
        assert_eq!(found(&little), expected);
        assert_eq!(found(&big), expected);
        assert_eq!(marked(&[0xff, 0xfe], &little), expected);
        assert_eq!(marked(&[0xfe, 0xff], &big), expected);
        assert_eq!(marked(&[0xef, 0xbb, 0xbf], text.as_bytes()), expected);
    }
}
