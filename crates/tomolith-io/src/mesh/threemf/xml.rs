//! Elements of XML one after the other, by their local names: prefixes are the choice of the writer.

use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;
use std::borrow::Cow;
use std::str::FromStr;

/// A text that is walked from its first element to its last.
pub(super) struct Xml<'a> {
    reader: Reader<&'a [u8]>,
    text: &'a str,
    depth: usize,
}

/// An element that has begun.
pub(super) struct Tag<'a>(BytesStart<'a>);

/// Looks at a child.
type Look<'f, 'a> = &'f mut dyn FnMut(&mut Xml<'a>, &Tag<'a>) -> Result<(), String>;

impl<'a> Xml<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let mut reader = Reader::from_str(text);
        reader.config_mut().expand_empty_elements = true;
        Xml {
            reader,
            text,
            depth: 0,
        }
    }

    /// Begins the root element, which must have this name.
    pub(super) fn root(&mut self, name: &str) -> Result<Tag<'a>, String> {
        loop {
            match self.event()? {
                Event::Start(tag) if tag.local_name().as_ref() == name => return Ok(Tag(tag)),
                Event::Start(tag) => {
                    return Err(format!(
                        "a `{}` in place of a `{name}`",
                        tag.local_name().as_ref()
                    ));
                }
                Event::Eof => return Err(format!("no `{name}`")),
                _ => {}
            }
        }
    }

    /// Shows every child of the element that has just begun; what is not looked at of a child is skipped.
    pub(super) fn children(&mut self, look: Look<'_, 'a>) -> Result<(), String> {
        let depth = self.depth;
        loop {
            match self.event()? {
                Event::Start(tag) => {
                    look(self, &Tag(tag))?;
                    while self.depth > depth {
                        self.inner_event()?;
                    }
                }
                Event::End(_) => return Ok(()),
                Event::Eof => return Err(self.truncated()),
                _ => {}
            }
        }
    }

    fn inner_event(&mut self) -> Result<Event<'a>, String> {
        match self.event()? {
            Event::Eof => Err(self.truncated()),
            event => Ok(event),
        }
    }

    fn event(&mut self) -> Result<Event<'a>, String> {
        let event = self.reader.read_event().map_err(|e| self.at(&e))?;
        match event {
            Event::Start(_) => self.depth += 1,
            Event::End(_) => self.depth = self.depth.saturating_sub(1),
            _ => {}
        }
        Ok(event)
    }

    fn truncated(&self) -> String {
        self.at(&"truncated: the text ends within an element")
    }

    /// What was found, and on which line.
    pub(super) fn at(&self, found: &dyn std::fmt::Display) -> String {
        let end = usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX);
        let read = &self.text.as_bytes()[..end.min(self.text.len())];
        let line = 1 + read.iter().filter(|b| **b == b'\n').count();
        format!("{found}, line {line}")
    }
}

impl Tag<'_> {
    /// The name without prefix.
    pub(super) fn name(&self) -> &str {
        self.0.name().0.rsplit(':').next().unwrap_or_default()
    }

    /// The value of an attribute, by its name without prefix.
    pub(super) fn get(&self, name: &str) -> Result<Option<Cow<'_, str>>, String> {
        for attribute in self.0.attributes() {
            let attribute = attribute.map_err(|e| format!("{e} in a `{}`", self.name()))?;
            if attribute.key.local_name().as_ref() == name {
                let value = attribute.normalized_value(XmlVersion::Implicit1_0);
                return value
                    .map(Some)
                    .map_err(|e| format!("{e} in {name} of a `{}`", self.name()));
            }
        }
        Ok(None)
    }

    /// The number in an attribute; blanks round it do not count.
    pub(super) fn number<T: FromStr>(&self, name: &str) -> Result<Option<T>, String> {
        let Some(text) = self.get(name)? else {
            return Ok(None);
        };
        let read = text.trim().parse().map(Some);
        read.map_err(|_| format!("{name} = `{text}`"))
    }

    /// The number in an attribute that must be there.
    pub(super) fn needed<T: FromStr>(&self, name: &str) -> Result<T, String> {
        self.number(name)?
            .ok_or_else(|| format!("{name} = `missing`"))
    }

    /// The truth of an attribute: xs:boolean has two words for each.
    pub(super) fn truth(&self, name: &str) -> Result<Option<bool>, String> {
        match self.get(name)?.as_deref().map(str::trim) {
            None => Ok(None),
            Some("1" | "true") => Ok(Some(true)),
            Some("0" | "false") => Ok(Some(false)),
            Some(other) => Err(format!("{name} = `{other}`")),
        }
    }

    /// All attributes with their whole names.
    pub(super) fn all(&self) -> Result<Vec<(String, String)>, String> {
        let pair = |attribute: quick_xml::events::attributes::Attribute<'_>| {
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            let value = value.map_err(|e| e.to_string())?.into_owned();
            Ok((attribute.key.0.to_owned(), value))
        };
        let attributes = self.0.attributes();
        attributes
            .map(|attribute| pair(attribute.map_err(|e| e.to_string())?))
            .collect()
    }
}
