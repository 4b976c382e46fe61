//! Where a file can be altered, and how: signs, factors, comparisons, indices, constants, conditions, statements.
//!
//! The altered copy computes each operand once, whatever is altered: `a + b` becomes
//! `match (a, b) { (l, r) => if altered::at(17) { l - r } else { l + r } }`.

use crate::swaps::{COMMUTATIVE, DROPPED, FIELDS, METHODS, PATHS, other};
use proc_macro2::Span;
use std::collections::BTreeMap;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Lit, Member, Stmt, UnOp};

/// One alteration.
#[derive(Clone)]
pub struct Alteration {
    pub file: usize,
    pub line: usize,
    pub column: usize,
    pub original: String,
    pub altered: String,
}

/// A part of the text of a site.
#[derive(Clone)]
pub enum Piece {
    Text(String),
    /// The source of this range, itself altered.
    Hole(Range<usize>),
}

/// One of the texts between which a site chooses.
pub struct Choice {
    pub number: u32,
    pub pieces: Vec<Piece>,
}

/// A range of the source that is written anew.
pub struct Site {
    pub range: Range<usize>,
    pub before: Vec<Piece>,
    /// The first one that compiles is kept where `one` is set; a choice without pieces is a switch within `original`.
    pub choices: Vec<Choice>,
    pub one: bool,
    pub original: Vec<Piece>,
    pub after: Vec<Piece>,
}

/// All sites of a file in the order of the source, and the ranges of its functions.
pub struct Found {
    pub sites: Vec<Site>,
    pub functions: Vec<Range<usize>>,
}

struct Finder<'a> {
    file: usize,
    source: &'a str,
    alterations: &'a mut Vec<Alteration>,
    found: Found,
    /// Scalar constants of the file, with the number and the altered text of each.
    constants: BTreeMap<String, (u32, String)>,
    /// Within the left side of an assignment.
    place: bool,
}

/// Finds the sites of a file; its alterations are numbered from `alterations.len() + 1` on.
pub fn find(file: usize, source: &str, alterations: &mut Vec<Alteration>) -> Result<Found, String> {
    let syntax = syn::parse_file(source).map_err(|error| error.to_string())?;
    let found = Found { sites: Vec::new(), functions: Vec::new() };
    let mut finder = Finder { file, source, alterations, found, constants: BTreeMap::new(), place: false };
    Constants(&mut finder).visit_file(&syntax);
    finder.visit_file(&syntax);
    Ok(finder.found)
}

fn range(node: &impl Spanned) -> Range<usize> {
    // The span of a whole node ends with its last token.
    node.span().byte_range()
}

fn text(text: impl Into<String>) -> Piece {
    Piece::Text(text.into())
}

/// The switch of an alteration.
fn at(k: u32) -> String {
    format!("::altered::at({k})")
}

/// In one line, its middle left out where it is long.
fn short(source: &str, most: usize) -> String {
    let words: Vec<&str> = source.split_whitespace().collect();
    let line: Vec<char> = words.join(" ").chars().collect();
    if line.len() <= most {
        return line.into_iter().collect();
    }
    let half = (most - 4) / 2;
    let (start, end) = (&line[..half], &line[line.len() - half..]);
    format!("{} .. {}", start.iter().collect::<String>(), end.iter().collect::<String>())
}

impl Finder<'_> {
    fn source_of(&self, range: &Range<usize>) -> &str {
        &self.source[range.clone()]
    }

    fn number(&mut self, span: Span, original: &str, altered: &str) -> u32 {
        let start = span.start();
        self.alterations.push(Alteration {
            file: self.file,
            line: start.line,
            column: start.column + 1,
            original: short(original, 90),
            altered: short(altered, 90),
        });
        self.alterations.len() as u32
    }

    /// A site with choices; each is its pieces and how it is shown.
    fn choose(
        &mut self,
        span: Span,
        before: Vec<Piece>,
        choices: Vec<(Vec<Piece>, String)>,
        original: Vec<Piece>,
        after: Vec<Piece>,
        one: bool,
    ) {
        let source = self.source_of(&span.byte_range()).to_string();
        let choices = choices
            .into_iter()
            .map(|(pieces, shown)| Choice { number: self.number(span, &source, &shown), pieces })
            .collect();
        self.found.sites.push(Site { range: span.byte_range(), before, choices, one, original, after });
    }

    /// A site whose switches stand within its text.
    fn switch(&mut self, range: Range<usize>, numbers: &[u32], pieces: Vec<Piece>) {
        let choices = numbers.iter().map(|&number| Choice { number, pieces: Vec::new() }).collect();
        self.found.sites.push(Site {
            range,
            before: Vec::new(),
            choices,
            one: false,
            original: pieces,
            after: Vec::new(),
        });
    }

    fn binary(&mut self, e: &syn::ExprBinary) {
        let (a, b) = (range(&*e.left), range(&*e.right));
        let (left, right) = (short(self.source_of(&a), 40), short(self.source_of(&b), 40));
        let operator = self.source_of(&range(&e.op)).to_string();
        match e.op {
            BinOp::And(_) | BinOp::Or(_) => return self.connective(e, &a, &b, &left, &right),
            BinOp::AddAssign(_)
            | BinOp::SubAssign(_)
            | BinOp::MulAssign(_)
            | BinOp::DivAssign(_)
            | BinOp::RemAssign(_)
            | BinOp::BitAndAssign(_)
            | BinOp::BitOrAssign(_)
            | BinOp::BitXorAssign(_)
            | BinOp::ShlAssign(_)
            | BinOp::ShrAssign(_) => {
                let others = arithmetic(operator.trim_end_matches('='));
                let choices = others
                    .iter()
                    .map(|op| {
                        (vec![Piece::Hole(a.clone()), text(format!(" {op}= r_"))], format!("{left} {op}= {right}"))
                    })
                    .collect();
                let before = vec![text("(match "), Piece::Hole(b.clone()), text(" { r_ => ")];
                let original = vec![Piece::Hole(a.clone()), text(format!(" {operator} r_"))];
                return self.choose(e.span(), before, choices, original, vec![text(" })")], true);
            }
            _ => {}
        }
        let others = comparison(&operator);
        let is_comparison = !others.is_empty();
        let others = if is_comparison { others } else { arithmetic(&operator) };
        let star = if is_comparison { "*" } else { "" };
        let by = if is_comparison { "&" } else { "" };
        let pieces = |op: &str| vec![text(format!("{star}l_ {op} {star}r_"))];
        let choices = others.iter().map(|op| (pieces(op), format!("{left} {op} {right}"))).collect();
        let before = vec![
            text(format!("(match ({by}(")),
            Piece::Hole(a),
            text(format!("), {by}(")),
            Piece::Hole(b),
            text(")) { (l_, r_) => "),
        ];
        self.choose(e.span(), before, choices, pieces(&operator), vec![text(" })")], !is_comparison);
    }

    /// `&&` and `||`: the other one, the left side alone, the right side alone; each side is still evaluated at most once.
    fn connective(&mut self, e: &syn::ExprBinary, a: &Range<usize>, b: &Range<usize>, left: &str, right: &str) {
        if has_let(&e.left) || has_let(&e.right) {
            return;
        }
        let is_and = matches!(e.op, BinOp::And(_));
        let other = if is_and { "||" } else { "&&" };
        let source = self.source_of(&range(e)).to_string();
        let span = e.span();
        let k = self.number(span, &source, &format!("{left} {other} {right}"));
        let only_left = self.number(span, &source, left);
        let only_right = self.number(span, &source, right);
        let (a, b) = (Piece::Hole(a.clone()), Piece::Hole(b.clone()));
        let (join, sense, first, last) = if is_and { ("||", "!=", "", "") } else { ("&&", "==", "!", "!") };
        let pieces = vec![
            text("(if (("),
            a,
            text(format!(") {join} {first}{}) {sense} {} {{ (", at(only_right), at(k))),
            b,
            text(format!(") {join} {first}{} }} else {{ {last}{} }})", at(only_left), at(k))),
        ];
        self.switch(range(e), &[k, only_left, only_right], pieces);
    }

    /// A condition that always or never holds.
    fn condition(&mut self, cond: &Expr, always: bool) {
        if has_let(cond) {
            return;
        }
        let inner = range(cond);
        let source = self.source_of(&inner).to_string();
        let never = self.number(cond.span(), &source, "false");
        let mut numbers = vec![never];
        let mut pieces = vec![text("(("), Piece::Hole(inner.clone()), text(format!(") && !{}", at(never)))];
        if always {
            let k = self.number(cond.span(), &source, "true");
            numbers.push(k);
            pieces.push(text(format!(" || {}", at(k))));
        }
        pieces.push(text(")"));
        self.switch(inner, &numbers, pieces);
    }

    fn literal(&mut self, e: &syn::ExprLit) {
        let span = e.span();
        let source = self.source_of(&span.byte_range()).to_string();
        let altered = match &e.lit {
            Lit::Int(n) => match n.base10_parse::<u128>() {
                Ok(value) => format!("{}{}", value + 1, n.suffix()),
                Err(_) => return,
            },
            Lit::Float(x) => match x.base10_parse::<f64>() {
                Ok(value) if value.fract() == 0.0 && value.abs() < 1e6 => format!("{:?}{}", value + 1.0, x.suffix()),
                Ok(value) => format!("{:?}{}", 2.0 * value, x.suffix()),
                Err(_) => return,
            },
            Lit::Bool(b) => {
                let k = self.number(span, &source, &(!b.value).to_string());
                let not = if b.value { "!" } else { "" };
                return self.switch(span.byte_range(), &[k], vec![text(format!("({not}{})", at(k)))]);
            }
            _ => return,
        };
        let original = vec![text(source)];
        self.choose(
            span,
            vec![text("(")],
            vec![(vec![text(altered.clone())], altered)],
            original,
            vec![text(")")],
            true,
        );
    }

    fn unary(&mut self, e: &syn::ExprUnary) {
        let inner = range(&*e.expr);
        let shown = self.source_of(&inner).to_string();
        let sign = match e.op {
            UnOp::Neg(_) => "-",
            UnOp::Not(_) => "!",
            _ => return,
        };
        let before = vec![text("(match "), Piece::Hole(inner), text(" { v_ => ")];
        let original = vec![text(format!("{sign}v_"))];
        self.choose(e.span(), before, vec![(vec![text("v_")], shown)], original, vec![text(" })")], true);
    }

    /// The end of a range that is no literal and no formula: one less.
    fn range_end(&mut self, end: &Expr) {
        if !matches!(end, Expr::Path(_) | Expr::Field(_) | Expr::MethodCall(_) | Expr::Call(_)) {
            return;
        }
        let inner = range(end);
        let shown = format!("{} - 1", self.source_of(&inner));
        let before = vec![text("(match "), Piece::Hole(inner), text(" { e_ => ")];
        let choices = vec![(vec![text("e_ - 1")], shown)];
        self.choose(end.span(), before, choices, vec![text("e_")], vec![text(" })")], true);
    }

    fn method(&mut self, e: &syn::ExprMethodCall) {
        let whole = range(e);
        let receiver = range(&*e.receiver);
        let name = e.method.to_string();
        let name_range = e.method.span().byte_range();
        let shown_receiver = short(self.source_of(&receiver), 40);
        let call = self.source[name_range.end..whole.end].to_string();
        let rest = name_range.end..whole.end;
        let as_it_is = || vec![Piece::Hole(receiver.clone()), text(format!(".{name}")), Piece::Hole(rest.clone())];
        let mut choices = Vec::new();
        if let Some(other) = other(METHODS, &name) {
            let pieces = vec![Piece::Hole(receiver.clone()), text(format!(".{other}")), Piece::Hole(rest.clone())];
            choices.push((pieces, format!("{shown_receiver}.{other}{}", short(&call, 40))));
        }
        if e.args.is_empty() && DROPPED.contains(&name.as_str()) {
            let pieces = vec![text("("), Piece::Hole(receiver.clone()), text(").clone()")];
            choices.push((pieces, shown_receiver.clone()));
        }
        if e.args.len() == 2 && e.args.iter().all(is_simple) && !COMMUTATIVE.contains(&name.as_str()) {
            let (a, b) = (range(&e.args[0]), range(&e.args[1]));
            let (first, second) = (self.source_of(&a).to_string(), self.source_of(&b).to_string());
            let head = vec![Piece::Hole(receiver.clone()), text(format!(".{name}("))];
            let pieces = [head, vec![Piece::Hole(b), text(", "), Piece::Hole(a), text(")")]].concat();
            choices.push((pieces, format!("{shown_receiver}.{name}({second}, {first})")));
        }
        if !choices.is_empty() {
            self.choose(e.span(), vec![text("(")], choices, as_it_is(), vec![text(")")], false);
        }
    }

    fn call(&mut self, e: &syn::ExprCall) {
        let Expr::Path(function) = &*e.func else { return };
        let name = function.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        let whole = range(e);
        let as_it_is = || {
            let (f, args) = (range(&*e.func), range(&*e.func).end..whole.end);
            vec![Piece::Hole(f), Piece::Hole(args)]
        };
        if name == "Some" && e.args.len() == 1 {
            let choices = vec![(vec![text("None")], "None".to_string())];
            return self.choose(e.span(), vec![text("(")], choices, as_it_is(), vec![text(")")], true);
        }
        if e.args.len() == 2 && e.args.iter().all(is_simple) && !COMMUTATIVE.contains(&name.as_str()) {
            let (f, a, b) = (range(&*e.func), range(&e.args[0]), range(&e.args[1]));
            let shown = format!("{}({}, {})", self.source_of(&f), self.source_of(&b), self.source_of(&a));
            let pieces = vec![Piece::Hole(f), text("("), Piece::Hole(b), text(", "), Piece::Hole(a), text(")")];
            self.choose(e.span(), vec![text("(")], vec![(pieces, shown)], as_it_is(), vec![text(")")], true);
        }
    }

    fn path(&mut self, e: &syn::ExprPath) {
        let Some(last) = e.path.segments.last() else { return };
        let name = last.ident.to_string();
        let span = e.span();
        let whole = span.byte_range();
        if let Some((k, altered)) = self.constants.get(&name).cloned() {
            let source = self.source_of(&whole).to_string();
            let pieces = vec![text(altered.replace("CONSTANT", &source))];
            self.found.sites.push(Site {
                range: whole,
                before: vec![text("(")],
                choices: vec![Choice { number: k, pieces }],
                one: false,
                original: vec![text(source)],
                after: vec![text(")")],
            });
            return;
        }
        if e.path.segments.len() > 1
            && e.qself.is_none()
            && let Some(other) = other(PATHS, &name)
        {
            let start = &self.source[whole.start..last.ident.span().byte_range().start];
            let altered = format!("{start}{other}");
            let original = vec![text(self.source_of(&whole))];
            self.choose(span, vec![text("(")], vec![(vec![text(&altered)], altered)], original, vec![text(")")], true);
        }
    }

    fn field(&mut self, e: &syn::ExprField) {
        let name = match &e.member {
            Member::Named(name) => name.to_string(),
            Member::Unnamed(index) => index.index.to_string(),
        };
        let Some(other) = other(FIELDS, &name) else { return };
        let base = range(&*e.base);
        let shown = format!("{}.{other}", short(self.source_of(&base), 40));
        let pieces = |name: &str| vec![text("&("), Piece::Hole(base.clone()), text(format!(").{name}"))];
        let original = pieces(&name);
        self.choose(e.span(), vec![text("(*(")], vec![(pieces(other), shown)], original, vec![text("))")], true);
    }

    /// A statement whose value nobody uses: left out.
    fn statement(&mut self, e: &Expr, whole: Range<usize>) {
        let is_dropped = match e {
            Expr::MethodCall(_) | Expr::Call(_) | Expr::Try(_) => true,
            Expr::Assign(assign) => !matches!(&*assign.left, Expr::Path(_) | Expr::Tuple(_) | Expr::Infer(_)),
            Expr::Binary(_) => true,
            _ => false,
        };
        if !is_dropped {
            return;
        }
        let source = self.source_of(&whole).to_string();
        let k = self.number(e.span(), &source, "(left out)");
        let pieces = vec![text(format!("if !{} {{ ", at(k))), Piece::Hole(whole.clone()), text(" }")];
        self.switch(whole, &[k], pieces);
    }

    fn within_macro(&mut self, mac: &syn::Macro) {
        if !mac.path.is_ident("vec") {
            return;
        }
        type List = syn::punctuated::Punctuated<Expr, syn::Token![,]>;
        if let Ok(list) = mac.parse_body_with(List::parse_terminated) {
            list.iter().for_each(|e| self.visit_expr(e));
        } else if let Ok(e) = mac.parse_body_with(|input: syn::parse::ParseStream| {
            let e: Expr = input.parse()?;
            let _: syn::Token![;] = input.parse()?;
            let _: Expr = input.parse()?;
            Ok(e)
        }) {
            self.visit_expr(&e);
        }
    }
}

fn arithmetic(operator: &str) -> &'static [&'static str] {
    match operator {
        "+" => &["-", "*"],
        "-" => &["+"],
        "*" => &["/", "+"],
        "/" => &["*"],
        "%" => &["/"],
        "<<" => &[">>"],
        ">>" => &["<<"],
        "&" => &["|"],
        "|" => &["&"],
        "^" => &["|"],
        _ => &[],
    }
}

fn comparison(operator: &str) -> &'static [&'static str] {
    match operator {
        "<" => &["<=", ">="],
        "<=" => &["<", ">"],
        ">" => &[">=", "<="],
        ">=" => &[">", "<"],
        "==" => &["!="],
        "!=" => &["=="],
        _ => &[],
    }
}

fn has_let(e: &Expr) -> bool {
    struct Lets(bool);
    impl Visit<'_> for Lets {
        fn visit_expr(&mut self, e: &Expr) {
            match e {
                Expr::Let(_) => self.0 = true,
                Expr::Binary(b) if matches!(b.op, BinOp::And(_)) => visit::visit_expr(self, e),
                _ => {}
            }
        }
    }
    let mut lets = Lets(false);
    lets.visit_expr(e);
    lets.0
}

/// A name, a field of a name, or a reference to one.
fn is_simple(e: &Expr) -> bool {
    match e {
        Expr::Path(_) => true,
        Expr::Field(field) => is_simple(&field.base),
        Expr::Reference(reference) => is_simple(&reference.expr),
        _ => false,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("test") || attribute.path().is_ident("cfg"))
}

/// Collects the scalar constants of a file.
struct Constants<'a, 'b>(&'a mut Finder<'b>);

impl Visit<'_> for Constants<'_, '_> {
    fn visit_item_const(&mut self, item: &syn::ItemConst) {
        self.add(&item.ident, &item.ty, &item.expr, item.ident.span());
    }

    fn visit_impl_item_const(&mut self, item: &syn::ImplItemConst) {
        self.add(&item.ident, &item.ty, &item.expr, item.ident.span());
    }
}

impl Constants<'_, '_> {
    fn add(&mut self, name: &syn::Ident, ty: &syn::Type, value: &Expr, span: Span) {
        let syn::Type::Path(path) = ty else { return };
        let Some(ty) = path.path.get_ident().map(ToString::to_string) else { return };
        let altered = match ty.as_str() {
            "f64" | "f32" => "CONSTANT * 2.0",
            "u8" | "u16" | "u32" | "u64" | "u128" | "usize" | "i8" | "i16" | "i32" | "i64" | "i128" => "CONSTANT + 1",
            _ => return,
        };
        let original = format!("{name} = {}", self.0.source_of(&range(value)));
        let shown = altered.replace("CONSTANT", &original);
        let k = self.0.number(span, &original, &shown);
        self.0.constants.insert(name.to_string(), (k, altered.to_string()));
    }
}

impl Visit<'_> for Finder<'_> {
    fn visit_item_const(&mut self, _: &syn::ItemConst) {}
    fn visit_impl_item_const(&mut self, _: &syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &syn::TraitItemConst) {}
    fn visit_item_static(&mut self, _: &syn::ItemStatic) {}
    fn visit_attribute(&mut self, _: &syn::Attribute) {}
    fn visit_type(&mut self, _: &syn::Type) {}
    fn visit_pat(&mut self, _: &syn::Pat) {}
    fn visit_path(&mut self, _: &syn::Path) {}
    fn visit_item_enum(&mut self, _: &syn::ItemEnum) {}
    fn visit_item_macro(&mut self, _: &syn::ItemMacro) {}
    fn visit_expr_const(&mut self, _: &syn::ExprConst) {}

    fn visit_item_mod(&mut self, item: &syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &syn::ItemFn) {
        if item.sig.constness.is_none() && !is_test(&item.attrs) {
            self.found.functions.push(range(&*item.block));
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &syn::ImplItemFn) {
        if item.sig.constness.is_none() {
            self.found.functions.push(range(&item.block));
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_trait_item_fn(&mut self, item: &syn::TraitItemFn) {
        if let Some(block) = &item.default {
            self.found.functions.push(range(block));
            visit::visit_trait_item_fn(self, item);
        }
    }

    fn visit_stmt(&mut self, statement: &Stmt) {
        if let Stmt::Expr(e, Some(semicolon)) = statement {
            let whole = range(e).start..semicolon.span().byte_range().end;
            self.statement(e, whole);
        }
        if let Stmt::Macro(statement) = statement {
            self.within_macro(&statement.mac);
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_expr_assign(&mut self, e: &syn::ExprAssign) {
        let outside = std::mem::replace(&mut self.place, true);
        self.visit_expr(&e.left);
        self.place = outside;
        self.visit_expr(&e.right);
    }

    fn visit_expr_repeat(&mut self, e: &syn::ExprRepeat) {
        self.visit_expr(&e.expr);
    }

    fn visit_expr_macro(&mut self, e: &syn::ExprMacro) {
        self.within_macro(&e.mac);
    }

    fn visit_expr(&mut self, e: &Expr) {
        let mut place_within = false;
        match e {
            Expr::Binary(e) => {
                self.binary(e);
                let operator = self.source_of(&range(&e.op));
                if operator.ends_with('=') && !["==", "<=", ">=", "!="].contains(&operator) {
                    let outside = std::mem::replace(&mut self.place, true);
                    self.visit_expr(&e.left);
                    self.place = outside;
                    return self.visit_expr(&e.right);
                }
            }
            Expr::If(e) => self.condition(&e.cond, true),
            Expr::While(e) => self.condition(&e.cond, false),
            Expr::Match(e) => {
                for arm in &e.arms {
                    if let Some((_, guard)) = &arm.guard {
                        self.condition(guard, true);
                    }
                }
            }
            Expr::Lit(e) => self.literal(e),
            Expr::Unary(e) => self.unary(e),
            Expr::Range(e) => {
                if let Some(end) = &e.end {
                    self.range_end(end);
                }
            }
            Expr::MethodCall(e) => self.method(e),
            Expr::Call(e) => self.call(e),
            Expr::Path(e) if !self.place => self.path(e),
            Expr::Field(e) if !self.place => self.field(e),
            Expr::Reference(e) if e.mutability.is_some() => place_within = true,
            Expr::Index(e) if self.place => {
                self.visit_expr(&e.expr);
                let outside = std::mem::replace(&mut self.place, false);
                self.visit_expr(&e.index);
                self.place = outside;
                return;
            }
            _ => {}
        }
        let outside = std::mem::replace(&mut self.place, place_within);
        visit::visit_expr(self, e);
        self.place = outside;
    }
}
