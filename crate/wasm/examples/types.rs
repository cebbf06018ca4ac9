//! Prints the TypeScript declarations of the npm package.

fn main() {
    print!("{}", vcgpdm_wasm::declarations());
}
