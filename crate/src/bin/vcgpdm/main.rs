//! The `vcgpdm` program: the library from a terminal.
fn main() {}
