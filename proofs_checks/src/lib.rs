//! What is proved outside the program: the Coq development, and exact results as certificates for a separate checker.
//!
//! A factorisation `A = L D L^T` as a certificate, and a development in Coq that would assume what it should prove:
//!
//! ```
//! # use algebra as flockproof_algebra;
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_algebra::matrix::RationalMatrix;
//! use flockproof_arithmetic::rational;
//! use flockproof_proofs::{certificates::Inertia, kernel::scan};
//!
//! let row = |a: i64, b: i64| vec![rational(a, 1), rational(b, 1)];
//! let matrix = RationalMatrix::from_rows(&[row(2, 3), row(3, 2)]).unwrap();
//! // The signs of D are those of the eigenvalues 5 and -1.
//! assert_eq!(Inertia::new(&matrix).unwrap().counts(), (1, 1, 0));
//!
//! assert!(scan("Good", "Lemma two : 1 + 1 = 2. Proof. reflexivity. Qed.").is_ok());
//! assert!(scan("Bad", "Axiom two : 1 + 1 = 3.").is_err());
//! ```

pub mod certificates;
pub mod kernel;
