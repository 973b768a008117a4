//! Reads what is derived for a type from a [`Value`], and says where in the value it failed and what was accepted there.
//!
//! *Why not serde's own.* `serde_json` knows no place in a value and tells what it expected as a sentence. A wrapper that follows the path
//! (`serde_path_to_error`) is compiled anew around every type of every job key: 0.75 of 8.8 MB of code of our crates.
//!
//! **Limits** Keys of tables are text. A struct is read from a table only, never from a list of its fields.

use serde::de::value::BorrowedStrDeserializer;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, EnumAccess, Error as _, Expected, MapAccess,
    SeqAccess, Unexpected, VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use serde_json::{Map, Value};
use std::fmt;

/// Reads a value.
///
/// # Errors
/// [`Failure`], with where.
// One copy for each type in each crate
#[inline(never)]
pub(super) fn read<T: DeserializeOwned>(value: &Value) -> Result<T, Failure> {
    T::deserialize(Located(value))
}

/// A step from a value into what it holds.
#[derive(Clone, Debug, PartialEq)]
enum Step {
    Key(String),
    Place(usize),
}

/// What is wrong with a value.
#[derive(Debug, PartialEq)]
pub(super) enum Fault {
    /// A key or a name that is none of these.
    Unknown {
        word: String,
        known: &'static [&'static str],
    },
    /// A key is missing.
    Missing(&'static str),
    /// Something else was found than what serde expects, in serde's words.
    Unfit { found: String, expected: String },
    /// Neither one of these names nor a table with one of them.
    Unnamed { names: &'static [&'static str] },
    /// What a type says of its own.
    Other(String),
}

/// A value that could not be read.
#[derive(Debug)]
pub(super) struct Failure {
    pub(super) fault: Fault,
    /// From the value at fault outwards.
    steps: Vec<Step>,
}

impl Failure {
    /// Where, as in a job: `light[0].pixels`; empty for the whole value.
    pub(super) fn path(&self) -> String {
        let mut path = String::new();
        for step in self.steps.iter().rev() {
            match step {
                Step::Key(key) if path.is_empty() => path.push_str(key),
                Step::Key(key) => path.extend([".", key]),
                Step::Place(i) => path.push_str(&format!("[{i}]")),
            }
        }
        path
    }

    /// The value at fault; None where the path ends before.
    pub(super) fn value<'v>(&self, root: &'v Value) -> Option<&'v Value> {
        (self.steps.iter().rev()).try_fold(root, |value, step| match step {
            Step::Key(key) => value.get(key),
            Step::Place(i) => value.get(i),
        })
    }

    #[cold]
    fn new(fault: Fault) -> Self {
        Failure {
            fault,
            steps: Vec::new(),
        }
    }

    #[cold]
    fn at_key(mut self, key: &str) -> Self {
        self.steps.push(Step::Key(key.to_owned()));
        self
    }

    #[cold]
    fn at_place(mut self, i: usize) -> Self {
        self.steps.push(Step::Place(i));
        self
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.fault)
    }
}

impl std::error::Error for Failure {}

impl serde::de::Error for Failure {
    #[cold]
    fn custom<T: fmt::Display>(message: T) -> Self {
        Failure::new(Fault::Other(message.to_string()))
    }

    #[cold]
    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Failure::new(Fault::Unfit {
            found: in_job(found),
            expected: expected.to_string(),
        })
    }

    #[cold]
    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    #[cold]
    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        Failure::new(Fault::Unfit {
            found: match length {
                0 => "an empty list".to_owned(),
                length => format!("a list of {length}"),
            },
            expected: expected.to_string(),
        })
    }

    #[cold]
    fn unknown_variant(word: &str, known: &'static [&'static str]) -> Self {
        let word = word.to_owned();
        Failure::new(Fault::Unknown { word, known })
    }

    #[cold]
    fn unknown_field(word: &str, known: &'static [&'static str]) -> Self {
        Self::unknown_variant(word, known)
    }

    #[cold]
    fn missing_field(key: &'static str) -> Self {
        Failure::new(Fault::Missing(key))
    }
}

/// What was found, as it stands in a job.
fn in_job(found: Unexpected<'_>) -> String {
    match found {
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Unsigned(value) => value.to_string(),
        Unexpected::Signed(value) => value.to_string(),
        Unexpected::Float(value) => format!("{value:?}"),
        Unexpected::Str(text) => format!("{text:?}"),
        Unexpected::Unit => "null".to_owned(),
        Unexpected::Seq => "a list".to_owned(),
        Unexpected::Map => "a table".to_owned(),
        other => other.to_string(),
    }
}

#[derive(Clone, Copy)]
struct Located<'v>(&'v Value);

impl<'v> Located<'v> {
    #[cold]
    fn unfit(self, expected: &dyn Expected) -> Failure {
        Failure::invalid_type(
            match self.0 {
                Value::Null => Unexpected::Unit,
                Value::Bool(value) => Unexpected::Bool(*value),
                Value::Number(number) => match (number.as_u64(), number.as_i64()) {
                    (Some(value), _) => Unexpected::Unsigned(value),
                    (None, Some(value)) => Unexpected::Signed(value),
                    (None, None) => Unexpected::Float(number.as_f64().unwrap_or(f64::NAN)),
                },
                Value::String(text) => Unexpected::Str(text),
                Value::Array(_) => Unexpected::Seq,
                Value::Object(_) => Unexpected::Map,
            },
            expected,
        )
    }

    fn number<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::Number(number) => match (number.as_u64(), number.as_i64(), number.as_f64()) {
                (Some(value), ..) => visitor.visit_u64(value),
                (None, Some(value), _) => visitor.visit_i64(value),
                (None, None, Some(value)) => visitor.visit_f64(value),
                (None, None, None) => Err(self.unfit(&visitor)),
            },
            _ => Err(self.unfit(&visitor)),
        }
    }

    fn text<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::String(text) => visitor.visit_borrowed_str(text),
            _ => Err(self.unfit(&visitor)),
        }
    }

    /// Reads a list; of a type that has a length, one of this length.
    fn list<V: Visitor<'v>>(self, length: Option<usize>, visitor: V) -> Result<V::Value, Failure> {
        let Value::Array(items) = self.0 else {
            return Err(self.unfit(&visitor));
        };
        if length.is_some_and(|length| length < items.len()) {
            return Err(Failure::invalid_length(items.len(), &visitor));
        }
        let mut left = Items { items, next: 0 };
        let read = visitor.visit_seq(&mut left)?;
        match left.next == items.len() {
            true => Ok(read),
            false => Err(Failure::invalid_length(items.len(), &"a shorter list")),
        }
    }

    fn table<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::Object(map) => visitor.visit_map(Entries::of(map)),
            _ => Err(self.unfit(&visitor)),
        }
    }
}

/// Methods of a deserializer that one of [`Located`]'s serves.
macro_rules! read_by {
    ($read:ident: $($method:ident)*) => {$(
        fn $method<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
            self.$read(visitor)
        }
    )*};
}

impl<'v> Deserializer<'v> for Located<'v> {
    type Error = Failure;

    read_by! { number:
        deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_f32 deserialize_f64
    }
    read_by! { text: deserialize_str deserialize_string deserialize_identifier }
    read_by! { table: deserialize_map }

    fn deserialize_any<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(value) => visitor.visit_bool(*value),
            Value::Number(_) => self.number(visitor),
            Value::String(_) => self.text(visitor),
            Value::Array(_) => self.list(None, visitor),
            Value::Object(_) => self.table(visitor),
        }
    }

    fn deserialize_seq<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        self.list(None, visitor)
    }

    fn deserialize_bool<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::Bool(value) => visitor.visit_bool(*value),
            _ => Err(self.unfit(&visitor)),
        }
    }

    fn deserialize_option<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'v>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Failure> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_tuple<V: Visitor<'v>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, Failure> {
        self.list(Some(length), visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'v>>(
        self,
        _name: &'static str,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, Failure> {
        self.list(Some(length), visitor)
    }

    fn deserialize_struct<V: Visitor<'v>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Failure> {
        self.table(visitor)
    }

    fn deserialize_enum<V: Visitor<'v>>(
        self,
        _name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Failure> {
        let (name, content) = match self.0 {
            Value::String(name) => (name, None),
            Value::Object(map) if map.len() == 1 => match map.iter().next() {
                Some((name, content)) => (name, Some(content)),
                None => return Err(Failure::new(Fault::Unnamed { names })),
            },
            _ => return Err(Failure::new(Fault::Unnamed { names })),
        };
        visitor.visit_enum(Variant { name, content })
    }

    fn deserialize_ignored_any<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Failure> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        <W: Visitor<'v>>
        char bytes byte_buf unit unit_struct
    }
}

/// Entries of a list that are still to be read.
struct Items<'v> {
    items: &'v [Value],
    next: usize,
}

impl<'v> SeqAccess<'v> for &mut Items<'v> {
    type Error = Failure;

    fn next_element_seed<S: DeserializeSeed<'v>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Failure> {
        let i = self.next;
        let Some(item) = self.items.get(i) else {
            return Ok(None);
        };
        self.next += 1;
        match seed.deserialize(Located(item)) {
            Ok(read) => Ok(Some(read)),
            Err(failure) => Err(failure.at_place(i)),
        }
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len() - self.next)
    }
}

/// Entries of a table that are still to be read.
struct Entries<'v> {
    left: serde_json::map::Iter<'v>,
    now: Option<(&'v str, &'v Value)>,
}

impl<'v> Entries<'v> {
    fn of(map: &'v Map<String, Value>) -> Self {
        Entries {
            left: map.iter(),
            now: None,
        }
    }

    fn step(&mut self) -> Option<&'v str> {
        self.now = self.left.next().map(|(key, value)| (key.as_str(), value));
        self.now.map(|(key, _)| key)
    }
}

impl<'v> MapAccess<'v> for Entries<'v> {
    type Error = Failure;

    fn next_key_seed<S: DeserializeSeed<'v>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Failure> {
        match self.step() {
            Some(key) => seed
                .deserialize(BorrowedStrDeserializer::new(key))
                .map(Some),
            None => Ok(None),
        }
    }

    fn next_value_seed<S: DeserializeSeed<'v>>(&mut self, seed: S) -> Result<S::Value, Failure> {
        let Some((key, value)) = self.now else {
            return Err(Failure::custom("a value is asked for before its key"));
        };
        match seed.deserialize(Located(value)) {
            Ok(read) => Ok(read),
            Err(failure) => Err(failure.at_key(key)),
        }
    }
}

/// One of several names, and what it holds.
struct Variant<'v> {
    name: &'v str,
    content: Option<&'v Value>,
}

impl<'v> EnumAccess<'v> for Variant<'v> {
    type Error = Failure;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'v>>(self, seed: S) -> Result<(S::Value, Self), Failure> {
        let name = seed.deserialize(BorrowedStrDeserializer::<Failure>::new(self.name))?;
        Ok((name, self))
    }
}

impl<'v> Variant<'v> {
    /// What it holds.
    fn held(&self, expected: &str) -> Result<Located<'v>, Failure> {
        let content = self.content.map(Located);
        content.ok_or_else(|| Failure::invalid_type(Unexpected::Str(self.name), &expected))
    }
}

impl<'v> VariantAccess<'v> for Variant<'v> {
    type Error = Failure;

    fn unit_variant(self) -> Result<(), Failure> {
        match self.content {
            None | Some(Value::Null) => Ok(()),
            Some(content) => Err(Located(content).unfit(&"the name alone").at_key(self.name)),
        }
    }

    fn newtype_variant_seed<S: DeserializeSeed<'v>>(self, seed: S) -> Result<S::Value, Failure> {
        let held = self.held("a table with this name")?;
        seed.deserialize(held)
            .map_err(|failure| failure.at_key(self.name))
    }

    fn tuple_variant<V: Visitor<'v>>(self, length: usize, visitor: V) -> Result<V::Value, Failure> {
        let held = self.held("a list under this name")?;
        held.list(Some(length), visitor)
            .map_err(|failure| failure.at_key(self.name))
    }

    fn struct_variant<V: Visitor<'v>>(
        self,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Failure> {
        let held = self.held("a table with this name")?;
        held.table(visitor)
            .map_err(|failure| failure.at_key(self.name))
    }
}
