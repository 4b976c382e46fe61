pub mod arithmetic;
pub mod matrix;
pub mod platoon;
