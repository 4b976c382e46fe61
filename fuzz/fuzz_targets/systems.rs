#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flockproof_fuzz::read("systems", data));
