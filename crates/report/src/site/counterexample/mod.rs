//! A counterexample drawn from its own sentence: what is not said there is not drawn, and no number is written twice.

mod curves;
mod draw;
mod numbers;
mod read;

use super::Site;
use crate::page::Links;
use maud::{Markup, html};
use read::Scene;

/// Parts of a sentence that are looked at; the further ones repeat the first in other cases.
const PARTS: usize = 3;

/// The drawings of a sentence; nothing where it holds nothing that can be drawn.
pub(super) fn drawings(site: &Site, sentence: &str, links: Links) -> Markup {
    let scenes: Vec<Scene> = read::parts(sentence).take(PARTS).flat_map(read::scenes).collect();
    html! {
        @if !scenes.is_empty() {
            div.drawings {
                @for (k, scene) in (1..).zip(&scenes) {
                    @let (drawn, about) = draw::draw(scene, k);
                    figure.shown { (drawn) figcaption { (site.names.rich(&about, links)) } }
                }
            }
        }
    }
}
