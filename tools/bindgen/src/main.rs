//! `bindgen FILE.wasm FOLDER`: writes into FOLDER the wasm with its JavaScript and its types, for browsers. It
//! gives the same bytes as the program `wasm-bindgen`, which has five times as much to compile.

use std::{env, error::Error};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [file, folder] = arguments.as_slice() else {
        return Err("expected FILE.wasm FOLDER".into());
    };
    let mut bindgen = Bindgen::new();
    bindgen.web(true)?.typescript(true).omit_default_module_path(true);
    bindgen.input_path(file).out_name("vcgpdm").generate(folder)?;
    Ok(())
}
