//! `bindgen FILE.wasm FOLDER`: writes into FOLDER the wasm with its JavaScript and its types, for browsers. It
//! gives the same bytes as the program `wasm-bindgen`, which has five times as much to compile. With `--tests`
//! before FILE.wasm, the JavaScript is for Node, and exports the tests in the wasm (scripts/wasm-tests.mjs).

use std::{env, error::Error};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let mut bindgen = Bindgen::new();
    let (file, folder) = match arguments.as_slice() {
        [tests, file, folder] if tests == "--tests" => {
            bindgen.nodejs(true)?.typescript(false).export_wasm(true).emit_start(false);
            (file, folder)
        }
        [file, folder] => {
            bindgen.web(true)?.typescript(true).omit_default_module_path(true);
            (file, folder)
        }
        _ => return Err("expected [--tests] FILE.wasm FOLDER".into()),
    };
    bindgen.input_path(file).out_name("vcgpdm").generate(folder)?;
    Ok(())
}
