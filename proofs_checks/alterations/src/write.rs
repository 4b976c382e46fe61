//! The text of an altered file, and which alteration stands where in it.

use crate::sites::{Found, Piece, Site};
use std::collections::BTreeSet;
use std::ops::Range;

/// A file as the compiler sees it.
pub struct Written {
    pub text: String,
    /// Ranges of the text with the alterations that an error within them rules out: those of alternatives, of whole sites, of functions.
    pub regions: Vec<(Range<usize>, Vec<u32>)>,
}

struct Writer<'a> {
    source: &'a str,
    sites: &'a [Site],
    /// The sites directly within each site, then those within none.
    children: Vec<Vec<usize>>,
    dropped: &'a BTreeSet<u32>,
    out: String,
    regions: Vec<(Range<usize>, Vec<u32>)>,
}

/// Writes a file with all alterations but the dropped ones.
pub fn write(source: &str, found: &Found, dropped: &BTreeSet<u32>) -> Written {
    let sites = &found.sites;
    let mut order: Vec<usize> = (0..sites.len()).collect();
    order.sort_by_key(|&k| (sites[k].range.start, usize::MAX - sites[k].range.end, k));
    let mut children = vec![Vec::new(); sites.len() + 1];
    let mut open: Vec<usize> = Vec::new();
    for &k in &order {
        while open.last().is_some_and(|&top| sites[top].range.end < sites[k].range.end) {
            open.pop();
        }
        while open.last().is_some_and(|&top| sites[top].range.end <= sites[k].range.start) {
            open.pop();
        }
        children[open.last().copied().unwrap_or(sites.len())].push(k);
        open.push(k);
    }
    let mut writer = Writer { source, sites, children, dropped, out: String::new(), regions: Vec::new() };
    // The pieces between functions, so that each function is a region.
    let mut at = 0;
    let mut functions = found.functions.clone();
    functions.sort_by_key(|range| range.start);
    for function in functions {
        if function.start < at {
            continue;
        }
        writer.source_range(sites.len(), at..function.start);
        let start = writer.out.len();
        writer.source_range(sites.len(), function.clone());
        let numbers = sites
            .iter()
            .filter(|site| function.start <= site.range.start && site.range.end <= function.end)
            .flat_map(|site| site.choices.iter().map(|choice| choice.number));
        let numbers = numbers.filter(|k| !dropped.contains(k)).collect();
        writer.regions.push((start..writer.out.len(), numbers));
        at = function.end;
    }
    writer.source_range(sites.len(), at..source.len());
    Written { text: writer.out, regions: writer.regions }
}

impl Writer<'_> {
    /// A range of the source, with the sites directly within `parent` written anew.
    fn source_range(&mut self, parent: usize, range: Range<usize>) {
        let mut at = range.start;
        for k in self.children[parent].clone() {
            let site = self.sites[k].range.clone();
            if site.start < range.start || site.end > range.end {
                continue;
            }
            self.out.push_str(&self.source[at..site.start]);
            self.site(k);
            at = site.end;
        }
        self.out.push_str(&self.source[at..range.end]);
    }

    fn site(&mut self, k: usize) {
        let site = &self.sites[k];
        let mut live: Vec<_> = site.choices.iter().filter(|choice| !self.dropped.contains(&choice.number)).collect();
        let is_switch = site.choices.iter().all(|choice| choice.pieces.is_empty());
        if live.is_empty() || is_switch && live.len() < site.choices.len() {
            return self.source_range(k, site.range.clone());
        }
        if site.one {
            live.truncate(1);
        }
        let start = self.out.len();
        self.pieces(k, &site.before);
        if is_switch {
            self.pieces(k, &site.original);
        } else {
            for choice in &live {
                self.out.push_str(&format!("if ::altered::at({}) {{ ", choice.number));
                let inner = self.out.len();
                self.pieces(k, &choice.pieces);
                self.regions.push((inner..self.out.len(), vec![choice.number]));
                self.out.push_str(" } else ");
            }
            self.out.push_str("{ ");
            self.pieces(k, &site.original);
            self.out.push_str(" }");
        }
        self.pieces(k, &site.after);
        self.regions.push((start..self.out.len(), live.iter().map(|choice| choice.number).collect()));
    }

    fn pieces(&mut self, k: usize, pieces: &[Piece]) {
        for piece in pieces {
            match piece {
                Piece::Text(text) => self.out.push_str(text),
                Piece::Hole(range) => self.source_range(k, range.clone()),
            }
        }
    }
}
