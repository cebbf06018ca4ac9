//! `bindgen FILE.wasm FOLDER TARGET`: writes into FOLDER the wasm with its JavaScript and its types, for the
//! target `web` or `nodejs`. It gives the same bytes as the program `wasm-bindgen`, which has five times as
//! much to compile.

use std::{env, error::Error};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [file, folder, target] = arguments.as_slice() else {
        return Err("expected FILE.wasm FOLDER TARGET".into());
    };
    let web = target == "web";
    let mut bindgen = Bindgen::new();
    bindgen.web(web)?.nodejs(!web)?.typescript(true).omit_default_module_path(false);
    bindgen.input_path(file).out_name("vcgpdm").generate(folder)?;
    Ok(())
}
