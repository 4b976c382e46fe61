fn main() {
    let file = std::env::args().nth(1).expect("a file");
    let digits = std::env::args().nth(2).map_or(10, |d| d.parse().expect("digits"));
    let system = flockproof_reach::System::read(&std::fs::read_to_string(file).expect("readable")).unwrap_or_else(|e| panic!("{e}"));
    flockproof_reach::trial(&system, digits);
}
