//! Arithmetic on named numbers: conditions that runs must meet, and keys that follow from others.
//!
//! Numbers, names (with dots and indices, as in `limits[0].loss_in_iou`), `+ - * / ( )`; a condition compares two of them by one of
//! `< <= > >= == !=`. A name without a number makes a value undefined, and a condition false; so does a value that is not finite.

use std::str::FromStr;

/// Parentheses and signs in each other, at most.
const DEEPEST: usize = 64;

/// An arithmetic expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expression {
    Number(f64),
    /// What has a number elsewhere.
    Name(String),
    /// Two, joined by one of `+ - * /`.
    Joined(Box<Expression>, char, Box<Expression>),
}

impl Expression {
    /// Its value, where all its names have one.
    pub(crate) fn value(&self, value_of: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        match self {
            Expression::Number(number) => Some(*number),
            Expression::Name(name) => value_of(name),
            Expression::Joined(left, sign, right) => {
                let (left, right) = (left.value(value_of)?, right.value(value_of)?);
                Some(match sign {
                    '+' => left + right,
                    '-' => left - right,
                    '*' => left * right,
                    _ => left / right,
                })
            }
        }
    }

    pub(crate) fn names(&self) -> Vec<&str> {
        match self {
            Expression::Number(_) => Vec::new(),
            Expression::Name(name) => vec![name],
            Expression::Joined(left, _, right) => [left.names(), right.names()].concat(),
        }
    }
}

impl FromStr for Expression {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut reader = Reader::new(text)?;
        let expression = reader.sum(0)?;
        reader.end()?;
        Ok(expression)
    }
}

/// A comparison of two expressions.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Condition {
    /// As it is written.
    pub(crate) text: String,
    left: Expression,
    sign: String,
    right: Expression,
}

impl Condition {
    pub(crate) fn is_met(&self, value_of: &dyn Fn(&str) -> Option<f64>) -> bool {
        let (Some(left), Some(right)) = (self.left.value(value_of), self.right.value(value_of))
        else {
            return false;
        };
        // What was divided by 0 is no number to compare
        if !(left.is_finite() && right.is_finite()) {
            return false;
        }
        match self.sign.as_str() {
            "<" => left < right,
            "<=" => left <= right,
            ">" => left > right,
            ">=" => left >= right,
            "==" => left == right,
            _ => left != right,
        }
    }

    /// The value of a side that is not finite though all its names have numbers: what was divided by 0.
    pub(crate) fn undefined(&self, value_of: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        let sides = [&self.left, &self.right].into_iter();
        let mut values = sides.filter_map(|side| side.value(value_of));
        values.find(|value| !value.is_finite())
    }

    pub(crate) fn names(&self) -> Vec<&str> {
        [self.left.names(), self.right.names()].concat()
    }
}

impl FromStr for Condition {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut reader = Reader::new(text)?;
        let left = reader.sum(0)?;
        let sign = match reader.next() {
            Some(Token::Compare(sign)) => sign,
            Some(other) => return Err(format!("{} where a comparison is due", other.text())),
            None => return Err("no comparison".to_owned()),
        };
        let right = reader.sum(0)?;
        reader.end()?;
        Ok(Condition {
            text: text.trim().to_owned(),
            left,
            sign,
            right,
        })
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Name(String),
    /// One of `+ - * / ( )`.
    Sign(char),
    Compare(String),
}

impl Token {
    fn text(&self) -> String {
        match self {
            Token::Number(number) => format!("`{number}`"),
            Token::Name(text) | Token::Compare(text) => format!("`{text}`"),
            Token::Sign(sign) => format!("`{sign}`"),
        }
    }
}

/// How far a text is a token of letters that go on as `goes_on` says.
fn run_of(text: &str, goes_on: impl Fn(&str, char) -> bool) -> usize {
    let mut end = 0;
    for (at, letter) in text.char_indices() {
        if !goes_on(&text[..at], letter) {
            break;
        }
        end = at + letter.len_utf8();
    }
    end
}

fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let (mut rest, mut found) = (text.trim_start(), Vec::new());
    while let Some(first) = rest.chars().next() {
        let (token, length) = match first {
            '+' | '-' | '*' | '/' | '(' | ')' => (Token::Sign(first), 1),
            '<' | '>' | '=' | '!' => {
                let length = if rest[1..].starts_with('=') { 2 } else { 1 };
                let sign = &rest[..length];
                if ["=", "!"].contains(&sign) {
                    return Err(format!("`{sign}` where `{sign}=` may be meant"));
                }
                (Token::Compare(sign.to_owned()), length)
            }
            '0'..='9' | '.' => {
                let length = run_of(rest, |before, letter| {
                    let is_sign = matches!(letter, '+' | '-') && before.ends_with(['e', 'E']);
                    letter.is_ascii_digit() || matches!(letter, '.' | 'e' | 'E') || is_sign
                });
                let number = rest[..length].parse();
                let number =
                    number.map_err(|_| format!("`{}`, which is no number", &rest[..length]))?;
                (Token::Number(number), length)
            }
            letter if letter.is_alphabetic() || letter == '_' => {
                let length = run_of(rest, |_, letter| {
                    letter.is_alphanumeric() || "_.[]".contains(letter)
                });
                (Token::Name(rest[..length].to_owned()), length)
            }
            other => return Err(format!("`{other}`")),
        };
        found.push(token);
        rest = rest[length..].trim_start();
    }
    Ok(found)
}

/// Reads tokens, the last of the list first.
struct Reader(Vec<Token>);

impl Reader {
    fn new(text: &str) -> Result<Self, String> {
        let mut tokens = tokens(text)?;
        tokens.reverse();
        Ok(Reader(tokens))
    }

    fn next(&mut self) -> Option<Token> {
        self.0.pop()
    }

    /// Takes the next sign if it is one of these.
    fn sign(&mut self, signs: &str) -> Option<char> {
        match self.0.last() {
            Some(Token::Sign(sign)) if signs.contains(*sign) => {
                let sign = *sign;
                self.0.pop();
                Some(sign)
            }
            _ => None,
        }
    }

    fn sum(&mut self, depth: usize) -> Result<Expression, String> {
        let mut sum = self.product(depth)?;
        while let Some(sign) = self.sign("+-") {
            sum = Expression::Joined(Box::new(sum), sign, Box::new(self.product(depth)?));
        }
        Ok(sum)
    }

    fn product(&mut self, depth: usize) -> Result<Expression, String> {
        let mut product = self.factor(depth)?;
        while let Some(sign) = self.sign("*/") {
            product = Expression::Joined(Box::new(product), sign, Box::new(self.factor(depth)?));
        }
        Ok(product)
    }

    fn factor(&mut self, depth: usize) -> Result<Expression, String> {
        if depth > DEEPEST {
            return Err(format!("more than {DEEPEST} parentheses in each other"));
        }
        match self.next() {
            Some(Token::Number(number)) => Ok(Expression::Number(number)),
            Some(Token::Name(name)) => Ok(Expression::Name(name)),
            Some(Token::Sign('-')) => {
                let (zero, inner) = (Expression::Number(0.0), self.factor(depth + 1)?);
                Ok(Expression::Joined(Box::new(zero), '-', Box::new(inner)))
            }
            Some(Token::Sign('(')) => {
                let inner = self.sum(depth + 1)?;
                match self.sign(")") {
                    Some(_) => Ok(inner),
                    None => Err("a parenthesis that is not closed".to_owned()),
                }
            }
            Some(other) => Err(format!("{} where a number or name is due", other.text())),
            None => Err("an end where a number or name is due".to_owned()),
        }
    }

    fn end(&mut self) -> Result<(), String> {
        match self.next() {
            Some(token) => Err(format!("{} after its end", token.text())),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value_of(name: &str) -> Option<f64> {
        match name {
            "a" => Some(2.0),
            "limits[0].loss" => Some(0.5),
            _ => None,
        }
    }

    #[test]
    fn arithmetic_has_its_usual_order() {
        for (text, value) in [
            ("1 - a*3 + 4/a", -3.0),
            ("(1 - a)*-3", 3.0),
            ("1e-1 + .5", 0.6),
            ("10 - 3 - 2", 5.0),
            ("8/4/2", 1.0),
            ("2*limits[0].loss", 1.0),
        ] {
            let found = text
                .parse::<Expression>()
                .unwrap()
                .value(&value_of)
                .unwrap();
            assert!((found - value).abs() < 1e-12, "{text}: {found}");
        }
        assert_eq!(
            "a + b".parse::<Expression>().unwrap().value(&value_of),
            None
        );
        assert_eq!("a < 2*b".parse::<Condition>().unwrap().names(), ["a", "b"]);
    }

    #[test]
    fn conditions_compare_and_what_is_undefined_meets_none() {
        for (text, met) in [
            ("a < 3", true),
            ("a<=2", true),
            ("a > 2", false),
            ("a >= 2", true),
            ("a == 2", true),
            ("a != 2", false),
            ("b != 2", false),
            ("a < 1/0", false),
        ] {
            assert_eq!(
                text.parse::<Condition>().unwrap().is_met(&value_of),
                met,
                "{text}"
            );
        }
    }

    #[test]
    fn a_division_by_zero_is_told_from_a_name_without_a_number() {
        let undefined = |text: &str| text.parse::<Condition>().unwrap().undefined(&value_of);
        assert_eq!(undefined("1/(a - 2) < 3"), Some(f64::INFINITY));
        assert!(undefined("3 > (a - 2)/(a - 2)").unwrap().is_nan());
        assert_eq!((undefined("1/b < 3"), undefined("a < 3")), (None, None));
    }

    #[test]
    fn slips_are_named_and_never_panic() {
        for (text, found) in [
            ("a", "no comparison"),
            ("a = 2", "`==` may be meant"),
            ("a < ", "an end where a number or name is due"),
            ("a < 2 < 3", "`<` after its end"),
            ("(a < 2", "`<`"),
            ("a < 1.2.3", "`1.2.3`, which is no number"),
            ("a § 2", "`§`"),
            ("", "an end where"),
        ] {
            let message = text.parse::<Condition>().unwrap_err();
            assert!(
                message.contains(found.trim_matches('`')) || message.contains("closed"),
                "{text}: {message}"
            );
        }
        assert!(
            format!("{}1", "(".repeat(100_000))
                .parse::<Expression>()
                .is_err()
        );
        assert!("-".repeat(100_000).parse::<Expression>().is_err());
        assert!("<ä=".parse::<Condition>().is_err());
    }
}
