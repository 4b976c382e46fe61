use flockproof::arithmetic::*; use flockproof::platoon::*; use std::hint::black_box; use std::time::Instant;
fn main(){ let g=Gains{f:rational(-1,1),g:rational(-1,1)};
 for m in [2u64,128,10000,1000000] {
 let n=2000u32; let t=Instant::now(); for _ in 0..n {black_box(resonance_uncertified_start(black_box(&g),m));} println!("start {:?}",t.elapsed()/n);
 let s=resonance_uncertified_start(&g,m).unwrap(); let r=resonance(&g,m,25).unwrap(); println!("err {:e}", (s-r.omega.to_f64())/s);
 let w=Interval::from_rational(&parse_rational(&format!("{s}")).unwrap(),163);
 let gg=g.map(|q| w.rational(q));
 let t=Instant::now(); for _ in 0..n {black_box(frequency_response(&gg,m,black_box(&w)).unwrap());} println!("resp {:?}",t.elapsed()/n);
 }
}
