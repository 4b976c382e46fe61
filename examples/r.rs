use flockproof::platoon::*; use flockproof::arithmetic::*;
fn main(){ let a:Vec<String>=std::env::args().collect();
 let m:u64=a[1].parse().unwrap(); let g=Gains{f:parse_rational(&a[2]).unwrap(),g:parse_rational(&a[3]).unwrap()};
 let d:u32=a[4].parse().unwrap();
 let t=std::time::Instant::now(); let r=resonance(&g,m,d); let e=t.elapsed();
 match r { Ok(r)=>println!("{:?} {:?} {:?} digits {} {} {:?}", decimals(&r.omega,d+2), decimals(&r.amplitude,d+2), r.uniqueness, significant_digits(&r.omega), significant_digits(&r.amplitude), e), Err(e)=>println!("{e}")}
 let n=200; let t=std::time::Instant::now(); for _ in 0..n { let _=std::hint::black_box(resonance(&g,m,d)); } println!("avg {:?}", t.elapsed()/n);
}
