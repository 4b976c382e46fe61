use flockproof::arithmetic::*; use std::hint::black_box; use std::time::Instant;
fn main(){ let p=163; let x=Interval::from_rational(&rational(1,3),p).sqrt().unwrap(); let y=Interval::from_rational(&rational(-1,7),p).exp().unwrap();
 let n=200000u32;
 let t=Instant::now(); for _ in 0..n {black_box(black_box(x.clone())*black_box(&y));} println!("mul {:?}",t.elapsed()/n);
 let t=Instant::now(); for _ in 0..n {black_box(black_box(x.clone())+black_box(&y));} println!("add {:?}",t.elapsed()/n);
 let t=Instant::now(); for _ in 0..n {black_box(black_box(&x).square());} println!("sq {:?}",t.elapsed()/n);
 let t=Instant::now(); for _ in 0..n {black_box(black_box(&x).clone());} println!("clone {:?}",t.elapsed()/n);
 let t=Instant::now(); for _ in 0..n {black_box(black_box(&x).over(&y).unwrap());} println!("div {:?}",t.elapsed()/n);
 let q=rational(-1,1); let t=Instant::now(); for _ in 0..n {black_box(black_box(&x).rational(&q));} println!("rat {:?}",t.elapsed()/n);
 let a=x.lo().mantissa().clone(); let b=y.lo().mantissa().clone();
 let t=Instant::now(); for _ in 0..n {black_box(black_box(&a)*black_box(&b));} println!("bigmul {:?}",t.elapsed()/n);
 let c=&a*&b; let t=Instant::now(); for _ in 0..n {black_box(black_box(&c)>>163);} println!("bigshr {:?}",t.elapsed()/n);
}
