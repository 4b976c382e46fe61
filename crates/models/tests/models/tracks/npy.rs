//! Arrays of NumPy against the same positions as a table.

use models::tracks::{Form, Format, Tracks};

/// An array as `numpy.save` writes it.
fn saved(descr: &str, fortran: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let mut header = format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}");
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let length = u16::try_from(header.len()).expect("short").to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), data].concat()
}

/// Four frames of three fish; the second is missing once.
fn positions() -> Vec<f64> {
    (0..24).map(|i| if i == 8 { f64::NAN } else { f64::from(i * i) / 4.0 - 7.0 }).collect()
}

/// The same in the order of Fortran: frames run fastest, then fish.
fn transposed() -> Vec<f64> {
    let rows = positions();
    (0..24).map(|i| rows[((i % 4) * 3 + (i / 4) % 3) * 2 + i / 12]).collect()
}

fn bytes(values: &[f64], one: impl Fn(f64) -> Vec<u8>) -> Vec<u8> {
    values.iter().flat_map(|x| one(*x)).collect()
}

fn at_25() -> Format {
    Format::new::<&str>(&[], Some(25.0)).expect("a rate")
}

fn read(file: &[u8]) -> Result<Tracks, String> {
    assert!(Tracks::is_npy(file));
    Tracks::from_npy(file, &at_25()).map_err(|error| error.to_string())
}

#[test]
fn every_way_of_saving_gives_the_positions_of_the_table() {
    let mut table = String::from("t,id,x,y\n");
    for (row, place) in positions().chunks(2).enumerate() {
        if !place[0].is_nan() {
            table += &format!("{},{},{},{}\n", row / 3, row % 3 + 1, place[0], place[1]);
        }
    }
    let table = Tracks::from_table(&table, &at_25()).expect("a table");
    let shape = "(4, 3, 2)";
    let little = |x: f64| x.to_le_bytes().to_vec();
    for file in [
        saved("<f8", "False", shape, &bytes(&positions(), little)),
        saved(">f8", "False", shape, &bytes(&positions(), |x| x.to_be_bytes().to_vec())),
        saved("<f4", "False", shape, &bytes(&positions(), |x| (x as f32).to_le_bytes().to_vec())),
        saved(">f4", "False", shape, &bytes(&positions(), |x| (x as f32).to_be_bytes().to_vec())),
        saved("<f8", "True", shape, &bytes(&transposed(), little)),
    ] {
        let array = read(&file).expect("an array");
        assert_eq!(array.form, Form::Array);
        assert_eq!(Tracks { form: Form::Rows, ..array }, table);
    }
}

#[test]
fn what_is_no_recording_is_refused_with_a_reason() {
    let whole = saved("<f8", "False", "(4, 3, 2)", &bytes(&positions(), |x| x.to_le_bytes().to_vec()));
    let refused = |file: &[u8], why: &str| {
        let error = read(file).expect_err(why);
        assert!(error.contains(why), "{error}");
    };
    for cut in 6..whole.len() {
        assert!(read(&whole[..cut]).is_err(), "cut at {cut}");
    }
    refused(&saved("|O", "False", "(4, 3, 2)", &[]), "flockproof.tracks in Python");
    refused(&saved("<i8", "False", "(4, 3, 2)", &[]), "its numbers are `<i8`");
    refused(&saved("<f8", "False", "(4, 3, 3)", &[]), "its shape is (4, 3, 3)");
    refused(&saved("<f8", "False", "(4, 3)", &[]), "its shape is (4, 3)");
    refused(&saved("<f8", "False", "(99999999999, 99999999999, 2)", &[]), "0 bytes are no array");
    refused(&saved("<f8", "False", "(4, 3, 2)", &[0; 8]), "8 bytes are no array");
    let infinite = bytes(&positions(), |x| (if x > 20.0 { f64::INFINITY } else { x }).to_le_bytes().to_vec());
    refused(&saved("<f8", "False", "(4, 3, 2)", &infinite), "beyond 1e100");
    let nobody = bytes(&[f64::NAN; 24], |x| x.to_le_bytes().to_vec());
    refused(&saved("<f8", "False", "(4, 3, 2)", &nobody), "no fish was seen");
    refused(&saved("<f8", "False", "(0, 0, 2)", &[]), "no fish was seen");
    let unnamed = Tracks::from_npy(&whole, &Format::default()).expect_err("no rate").to_string();
    assert!(unnamed.contains("(fps)"), "{unnamed}");
    // Objects are not read with a rate either, so that nobody is asked for one.
    let objects = Tracks::from_npy(&saved("|O", "False", "()", &[]), &Format::default()).expect_err("objects");
    assert!(objects.to_string().contains("flockproof.tracks in Python"), "{objects}");
    let parts = at_25().of_parts(Some("nose".to_string()), 0.0);
    assert!(Tracks::from_npy(&whole, &parts).is_err_and(|error| error.to_string().contains("no body parts")));
}
